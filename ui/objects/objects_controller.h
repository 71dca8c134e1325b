// What is this? Tells about the thing under the cursor, and keeps the one that was clicked: framed on the
// map, on a card, in the dock Properties, and among all others in Objects.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QTimer>

#include "grids/cell_counts.h"
#include "ui/kit/controller.h"
#include "ui/scene/map_object.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"
#include "ui/view/map_tool.h"
#include "work/workers.h"

namespace mapwright::ui {

class ObjectCard;
class ObjectsDock;
class PropertiesDock;

class ObjectsController : public Controller {
  Q_OBJECT
 public:
  /// `wall`: the time of day.
  explicit ObjectsController(
      WindowContext& context, QObject* parent = nullptr,
      std::function<QDateTime()> wall = [] { return QDateTime::currentDateTime(); });

  ObjectCard* card() const { return card_; }
  PropertiesDock* properties() const { return properties_; }
  ObjectsDock* dock() const { return dock_; }

  /// A click on the map that no tool handles; with Alt it goes to what lies beneath.
  void clickedOnMap(const MapPoint& at);
  /// The inspector tells of it: a card of anything else is gone.
  void wentTo(map::SubmapId submap);
  void setSession(session::Session* session) override;
  bool escape() override;
  ~ObjectsController() override;

 Q_SIGNALS:
  void chose(const mapwright::ui::scene::MapObject& object);

 private:
  void addActions();
  void addToMapMenu();
  void addFindings();
  /// At the cursor, or in the middle of the map: again and again, what lies beneath.
  void identify();
  void pick(const Eigen::Vector2d& world_m, bool beneath);
  /// Frames it and says what it is. The card appears at `card_at_m`.
  void choose(const scene::ObjectId& id, const Eigen::Vector2d& card_at_m, int beneath);
  void locate(const scene::ObjectId& id);
  void letGo();
  void hover();
  void cursorMoved();
  void refreshSoon();
  void refresh();
  void list();
  void showCard(const scene::MapObject& object, const Eigen::Vector2d& at_m, int beneath, bool stays);
  void positionCard();
  void copyChosen();
  void showMap();
  void allowMap();
  /// The cells of the whole map that is chosen, in the background.
  void count();
  std::vector<scene::ObjectProperty> facts(const scene::MapObject& object) const;

  WindowContext& context_;
  std::function<QDateTime()> wall_;
  QAction* map_action_ = nullptr;
  ObjectCard* card_;
  PropertiesDock* properties_;
  ObjectsDock* dock_;
  std::optional<scene::MapObject> chosen_;  // as it was last seen
  std::vector<scene::ObjectId> here_;       // what lies where it was clicked
  std::size_t turn_ = 0;                    // which of them is chosen
  std::optional<QPointF> picked_px_;
  Eigen::Vector2d card_at_m_{0, 0};
  int card_beneath_ = 0;
  std::optional<QPointF> hovered_px_;  // where the card of the cursor was made
  std::optional<scene::MapObject> hovered_;
  int hovered_beneath_ = 0;
  QTimer hover_timer_, refresh_timer_, list_timer_, age_timer_;
  /// Which map is being counted, or was.
  std::shared_ptr<const grids::GridPyramid> counted_;
  std::optional<grids::CellCounts> counts_;
  std::shared_ptr<std::atomic<bool>> count_cancelled_;
  work::Tasks tasks_;
};

}  // namespace mapwright::ui
