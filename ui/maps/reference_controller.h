// A local map as a layer under what a robot shows: chosen, laid by hand or by pairs of points, and remembered
// for that robot and map.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QJsonObject>
#include <QPointer>
#include <QUndoStack>
#include <tl/expected.hpp>

#include "align/align.h"
#include "map/catalogue.h"
#include "placing/align.h"
#include "render/sample_grid.h"
#include "robot/call.h"
#include "robot/robot.h"
#include "session/map_slot.h"
#include "session/session.h"
#include "ui/kit/background_run.h"
#include "ui/kit/controller.h"
#include "ui/maps/map_files.h"
#include "ui/maps/walls_off_marks.h"
#include "ui/shell/laid_map.h"
#include "ui/shell/window_context.h"

class QAction;

namespace mapwright::ui {

class ReferenceDock;
class ReferenceTool;

class ReferenceController : public Controller {
  Q_OBJECT
 public:
  /// `read`: returns a reader for the map at an address; the error is a sentence.
  using Read = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;

  ReferenceController(WindowContext& context, PicturePlacing& placing, Read read, QObject* parent = nullptr);
  ~ReferenceController() override;

  ReferenceDock* dock() const { return dock_; }
  /// Lays the map at this address ("file:/maps/a.yaml").
  void lay(const QString& address) { lay(address, false); }
  /// The same, and aligns it with the map on screen.
  void alignWith(const QString& address) { lay(address, true); }
  /// With another map of the robot.
  void alignWithMap(const map::MapKey& key);
  void removeMap();
  const geometry::Pose2& pose() const { return laid_.pose; }
  /// All of the reference map is there.
  bool isRead() const { return slot_.cells() && slot_.settled(); }
  const WallsOffMarks& wallsOff() const { return walls_off_; }

  void setSession(session::Session* session) override;

 Q_SIGNALS:
  /// Which one, or how it lies; nullopt = none, or it is still being read.
  void laidChanged(const std::optional<mapwright::ui::LaidMap>& laid);
  /// Beside the map on screen, as it lies.
  void swipeWanted(const mapwright::map::WholeMap& map);

 private:
  /// How it lies.
  struct Laid {
    geometry::Pose2 pose;
    std::vector<placing::PointPair> pairs;
    bool operator==(const Laid&) const = default;
  };
  class Step;
  /// What an alignment is about.
  struct Aligned {
    render::PlacedGrid reference;
    std::optional<render::PlacedGrid> map;  // nullopt: the submaps
    map::MapKey map_key;
    std::vector<placing::PointPair> pairs;
    std::string content;  // of the map on screen: names exactly these cells; empty: not known
    /// A file is read again when anything beside it is saved.
    bool sameCells(const Aligned& other) const {
      return map == other.map || (map && other.map && !content.empty() && content == other.content &&
                                  map->reference == other.map->reference);
    }
    /// It still is, although the map on screen may have changed.
    bool sameAs(const Aligned& other) const {
      return reference == other.reference && map_key == other.map_key && pairs == other.pairs;
    }
  };

  /// Where a map comes from.
  struct Source {
    std::unique_ptr<robot::Robot> reader;  // null: the robot itself
    robot::WholeMapSource* maps;
    map::MapKey key;
  };

  void choose(bool align);
  tl::expected<Source, QString> sourceOf(const QString& address);
  void lay(const QString& address, bool align);
  /// As soon as both maps are read.
  void align();
  void startAligning(bool submaps);
  void onAligned(const align::Alignment& found);
  void layCandidate(bool second);
  std::optional<Aligned> alignable(bool submaps) const;
  /// Rather than a whole map.
  bool showsSubmaps() const;
  void onSubmapsChanged();
  void say(const QString& sentence);
  /// Starts what waits, and ends what does not hold any more.
  void checkAlignment();
  void showAlignment();
  void forgetAlignment();
  /// The map that was to be aligned is not wanted any more.
  void stopFetching();
  void syncDifferences();
  /// One step that can be undone. `drag`: steps with the same number are one; 0 = a step of its own.
  void change(const QString& what, Laid laid, int drag = 0);
  void setPairs(const QString& what, std::vector<placing::PointPair> pairs);
  void setLaid(Laid laid);
  void forgetSteps();
  void useTool(bool on, bool pairing);
  void load(const QString& address);
  void showRead(map::WholeMap map);
  void show();
  /// The robot and the map that it is on; empty = not known.
  QString currentMap() const;
  void onCurrentMapChanged();
  void rememberForMap();
  QJsonObject kept() const;  // what is remembered for this map
  void onLaid(const QJsonObject& laid);
  void showFailure(const map::Failure& failure);

  WindowContext& context_;
  PicturePlacing& placing_;
  Read read_;
  ReferenceDock* dock_;
  ReferenceTool* tool_;
  QAction* tool_action_;
  std::unique_ptr<robot::Robot> reader_, coming_;
  session::MapSlot slot_;
  map::WholeMap read_map_;  // what slot_ shows
  QString address_;         // of the reference map; empty = none
  QString current_map_;     // for which it is remembered
  Laid laid_;
  QUndoStack steps_;
  QPointer<QUndoStack> other_steps_;  // what Ctrl+Z was about before
  int drag_ = 0;
  int coming_number_ = 0;  // answers to earlier requests do not count
  robot::Call coming_call_;
  bool fetching_ = false;           // a map, to be aligned
  bool align_next_ = false;         // when both maps are read
  std::optional<Aligned> aligned_;  // what is being aligned, or was
  geometry::Pose2 pose_before_;     // how the map lay then
  bool submaps_changed_ = false;    // since then
  std::optional<align::Alignment> found_;
  QString said_;  // instead of a result
  WallsOffMarks walls_off_;
  BackgroundRun run_;
};

}  // namespace mapwright::ui
