// The card in the middle of an empty map: what is happening and what to do.
#pragma once

#include <map>
#include <optional>
#include <set>

#include <QFrame>

#include "robot/robot.h"
#include "session/session.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace mapwright::ui {

/// What can be done about it, each with a button.
enum class CardOffer {
  Secret,  // the robot refused because the secret is wrong or missing
  Connect,
  Demo,
  File,
  Retry,
  Cancel,
  Certificate,
  Clouds,
};

/// The content of the card. `title` and `text` may contain names from a robot: plain text.
struct EmptyState {
  enum class Kind {
    NoRobot,
    Connecting,
    WaitingForList,
    NoSubmaps,
    Loading,
    NothingDrawable,
    Failed,
    NoMap,       // no whole map is open
    LoadingMap,  // one is on its way
    MapFailed,
  };
  Kind kind = Kind::NoRobot;
  QString icon, title, text;
  bool busy = false;
  std::set<CardOffer> offers = {};
  bool operator==(const EmptyState&) const = default;
};

/// Which maps the view should show.
struct MapsInView {
  bool submaps = true, whole = false;
  bool regions = false;       // there is a map by regions, and it is shown
  bool regions_held = false;  // some of it has arrived
  bool clouds_held = false;   // clouds of points lie there
  bool scans = false;         // sensor data of the robot is drawn
};

/// nullopt while there is something on the map. `session` may be null.
std::optional<EmptyState> emptyState(session::Session* session, const MapsInView& in_view);
/// The state of the whole map alone. `stored`: there are others to choose from; `live`: the robot sends one.
std::optional<EmptyState> wholeMapState(const session::MapSlot& slot, bool stored, bool live);
/// The state of the submaps alone; `counts` null = no robot.
std::optional<EmptyState> emptyState(const QString& address, const robot::ConnectionState& connection,
                                     const session::SubmapCounts* counts);

class EmptyStateCard : public QFrame {
  Q_OBJECT
 public:
  explicit EmptyStateCard(QWidget* parent = nullptr);
  /// Shows a state, or hides the card.
  void setState(const std::optional<EmptyState>& state);
  std::optional<EmptyState::Kind> kind() const { return state_ ? std::optional(state_->kind) : std::nullopt; }

 Q_SIGNALS:
  void wanted(mapwright::ui::CardOffer offer);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void paintIcon();
  static void setRole(QPushButton* button, bool primary);
  QLabel *icon_, *title_, *text_;
  QProgressBar* progress_;
  std::map<CardOffer, QPushButton*> buttons_;
  QString icon_name_;
  std::optional<EmptyState> state_;
};

}  // namespace mapwright::ui
