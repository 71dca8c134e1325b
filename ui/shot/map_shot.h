// The way from a source of map data to a picture of it: connect, settle, draw. A value: time is passed in, in
// seconds since the shot began.
//
// Three kinds of shots take it, and they differ in what they wait for and how long. A *snapshot* (alone, as a
// view of a suite, as a frame of a film) has a session of its own and a time limit. It waits for all that it
// draws, or collects for a while; when its time is up, or the robot is gone, it draws what there is and says
// so. A *report* of a moment has a session of its own, too, but always of a bag: nothing comes late, so it
// has no limit, but first its moment has to be found, and it also waits for the messages around that moment.
// *Compare with expected…* draws from the session of the window, which is connected and goes on: it only adds
// a subscription, freezes nothing, and its limit says when it draws what there is.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace mapwright::ui::shot {

/// In this order; Failed follows any of them but Done.
enum class Stage {
  Connecting,
  Reading,   // a bag is open, the state at the moment is not known yet
  Settling,  // connected: waits for what is drawn
  Drawing,   // what is drawn has been chosen
  Done,
  Failed,
};

/// What a picture may wait for.
enum class Awaited {
  Submaps,
  Whereabouts,
  WholeMap,
  Region,
  Topics,
  Pictures,
  Track,
  Messages,
  Cloud,
  PoseGraph
};

enum class EndOfWaiting {
  None,  // it goes on
  AllHere,
  Collected,  // the time of collecting is over
  TimeUp,
  LinkLost,  // the robot is gone, and there is just time to draw what came before
};

/// Why a picture is not complete.
enum class Lack {
  NotSettled,  // waiting ended early
  Submaps,
  WholeMap,
  Waypoints,
  Overlays,
  Region,
  Cloud,
  PoseGraph,
  PartsOfBag,
  Placement,  // data whose transforms did not arrive
  Topic,      // one that was chosen does not exist, or does not fit
  Cells,      // they could not be read
  TimeToDraw,
};

struct ShotLimits {
  std::optional<double> timeout_s = {};  // nullopt: it waits as long as it takes
  std::optional<double> collect_s = {};  // after connecting; then it draws what there is. nullopt: all
  double grace_s = 0;                    // after the timeout, for drawing
};

class MapShot {
 public:
  explicit MapShot(ShotLimits limits = {}) : limits_(limits) {}

  Stage stage() const { return stage_; }
  bool over() const { return stage_ >= Stage::Done; }
  /// What is drawn is not chosen yet.
  bool waits() const { return stage_ < Stage::Drawing; }
  /// A shot without limits needs no time.
  void enter(Stage stage, double now_s = 0);
  /// When it entered the stage; nullopt: it did not.
  std::optional<double> enteredAt(Stage stage) const;
  bool connected() const { return enteredAt(Stage::Settling).has_value(); }
  double sinceConnected(double now_s) const { return now_s - enteredAt(Stage::Settling).value_or(-1); }

  /// Adds to what is waited for, in this order; `in`: it is here.
  void await(Awaited what, std::function<bool()> in);
  void forgetAll() { conditions_.clear(); }
  bool awaits(Awaited what) const;
  /// The first that is not here yet. Those behind it are not asked.
  std::optional<Awaited> missing() const;

  /// Whether to draw now. `online`: nothing is lost by waiting; `drawable`: there would be something to see.
  EndOfWaiting end(double now_s, bool online, const std::function<bool()>& drawable) const;
  bool timeUp(double now_s) const { return limits_.timeout_s && now_s >= *limits_.timeout_s; }
  /// The time for drawing is over as well.
  bool cutOff(double now_s) const { return timeUp(now_s - limits_.grace_s); }
  /// Seconds until the next of the limits is reached; nullopt: none is ahead.
  std::optional<double> untilLimit(double now_s) const;

  void add(Lack lack) { lacks_.insert(lack); }
  void addIf(bool lacks, Lack lack) {
    if (lacks) add(lack);
  }
  const std::set<Lack>& lacks() const { return lacks_; }
  /// What it draws, or has drawn, lacks nothing.
  bool complete() const { return (stage_ == Stage::Drawing || stage_ == Stage::Done) && lacks_.empty(); }

 private:
  struct Condition {
    Awaited what;
    std::function<bool()> in;
  };
  double collectedAt() const { return enteredAt(Stage::Settling).value_or(0) + *limits_.collect_s; }

  ShotLimits limits_;
  Stage stage_ = Stage::Connecting;
  std::vector<std::pair<Stage, double>> entered_;
  std::vector<Condition> conditions_;
  std::set<Lack> lacks_;
};

}  // namespace mapwright::ui::shot
