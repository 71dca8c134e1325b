// One robot (or file) for a command that reads its maps and ends: waits for answers in an event loop of its
// own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "app/command_failure.h"
#include "app/deadline.h"
#include "app/report.h"
#include "app/robot_access.h"
#include "map/map_part.h"
#include "render/sample_grid.h"
#include "robot/map_administration.h"
#include "session/session.h"
#include "work/workers.h"

namespace mapwright::app {

/// How long a command may take, and since when.
struct CommandTime {
  CommandStart start;
  double timeout_s = 0;
  bool over(double grace_s = 0) const;
};

class MapReading {
 public:
  /// What is going to be asked for: nothing else is.
  enum class Purpose { Maps, Submaps, Bags };
  /// Connects; for Bags only where they are not there without a link: they are asked for by requests alone.
  static CommandResult<std::unique_ptr<MapReading>> open(const QString& address, const Access& access,
                                                         CommandTime time, Purpose purpose,
                                                         std::shared_ptr<work::Workers> workers);

  session::Session& session() { return session_; }
  const std::shared_ptr<work::Workers>& workers() const { return workers_; }
  bool local() const;
  /// The catalogue, once it is in.
  CommandResult<const std::vector<map::CatalogueEntry>*> catalogue();
  /// Opens a map and reads it to the end. "" = the live or current one; "submaps" composes the submaps at
  /// `resolution_m`. From then on nothing of the session changes any more.
  CommandResult<render::PlacedGrid> map(const QString& id, double resolution_m);
  /// A region of its map from a map dispatcher, nullopt: all of it. What comes of a region is where the
  /// dispatcher says that it lies.
  CommandResult<render::PlacedGrid> part(const std::optional<map::GridRegion>& region);
  /// Asks for a change of one of its maps, and waits for what comes of it. A change that is under way when
  /// the time is over is given up, and the failure says whether it may have been made.
  CommandResult<map::CatalogueEntry> change(const robot::MapOrder& order);
  /// Asks, and waits for the outcome. A request that is under way when the time is over is given up: then it
  /// is FailureKind::TimedOut, with what is known of it.
  template <typename T>
  robot::Outcome<T> ask(const std::function<robot::Call(robot::OutcomeTo<T>)>& request);
  /// False when the time is up, or `at_most_s` is over.
  bool waitUntil(const std::function<bool()>& done, double at_most_s = 1e9);
  CommandTime time() const { return time_; }
  /// The same failure, for want of time.
  map::Failure tooLate(map::Failure failure) const;
  /// A sentence about this robot, and its exit code.
  CommandFailure failure(int exit_code, const QString& sentence) const;
  CommandFailure failure(const map::Failure& failed) const;
  /// That it has nothing of the sort.
  CommandFailure lacks(robot::Capability capability) const;
  /// Something odd, to be said in the end.
  void note(const QString& sentence) { notes_ << sentence; }
  /// The same, of something that was asked for and could not be had.
  void lack(const QString& sentence) {
    note(sentence);
    complete_ = false;
  }
  /// Nothing that came was unreadable, else it is not complete.
  void insistOnReadable();
  /// Every part of what was asked for could be had, else it is not complete.
  void insistOnAll() { complete_ = complete_ && problems(map::Severity::Warning).isEmpty(); }
  QString nameOfMap() const { return name_; }
  /// The local files that the map was read from.
  std::vector<std::string> sourceFiles() const;
  /// False when something that was asked for could not be had: warnings() say what.
  bool complete() const { return complete_ && bagLosses(session_.problems()).isEmpty(); }
  /// What is missing, or some of it, was refused.
  bool refused() const { return !complete() && anyRefused(session_.problems()); }
  /// What is odd, a line each.
  QStringList warnings() const;
  /// {"map" or "submaps", "uuid", "bytes_fetched", …} of what was read, for a report.
  QJsonObject facts() const;

 private:
  MapReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time, Purpose purpose,
             std::shared_ptr<work::Workers> workers);
  /// Nobody waits for it any more; what it has to say at once is still heard.
  void giveUp(const robot::Call& call, const std::function<bool()>& over) const;
  CommandResult<render::PlacedGrid> submaps(double resolution_m);
  QStringList problems(map::Severity least) const;  // unresolved

  std::shared_ptr<work::Workers> workers_;
  session::Session session_;
  QString address_, name_;
  CommandTime time_;
  SteadyTime online_since_;
  bool complete_ = true;
  QStringList notes_;
  QJsonObject facts_;
};

template <typename T>
robot::Outcome<T> MapReading::ask(const std::function<robot::Call(robot::OutcomeTo<T>)>& request) {
  // Shared: an outcome may still come when nobody waits for it any more.
  const auto outcome = std::make_shared<std::optional<robot::Outcome<T>>>();
  const robot::Call call = request([outcome](robot::Outcome<T> given) { *outcome = std::move(given); });
  const auto over = [&] { return outcome->has_value(); };
  const bool in_time = waitUntil(over);
  if (!in_time) giveUp(call, over);
  if (*outcome && (**outcome || in_time)) return std::move(**outcome);
  return tl::make_unexpected(
      tooLate(*outcome ? (*outcome)->error() : map::Failure{.applied = map::Applied::Maybe}));
}

}  // namespace mapwright::app
