// One robot (or file) for a command that reads its maps and then exits: waits for answers in its own event
// loop.
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

/// The time limit of a command, and when it started.
struct CommandTime {
  CommandStart start;
  double timeout_s = 0;
  bool over(double grace_s = 0) const;
};

class MapReading {
 public:
  /// What the command needs; nothing else is requested.
  enum class Purpose { Maps, Submaps, Bags };
  /// Connects; for Bags only if they need a connection, since they use single requests.
  static CommandResult<std::unique_ptr<MapReading>> open(const QString& address, const Access& access,
                                                         CommandTime time, Purpose purpose,
                                                         std::shared_ptr<work::Workers> workers);

  session::Session& session() { return session_; }
  const std::shared_ptr<work::Workers>& workers() const { return workers_; }
  bool local() const;
  /// The catalogue, as soon as it has arrived.
  CommandResult<const std::vector<map::CatalogueEntry>*> catalogue();
  /// Opens a map and reads it completely. "" = the live or current one; "submaps" composes the submaps at
  /// `resolution_m`. Afterwards the session does not change any more.
  CommandResult<render::PlacedGrid> map(const QString& id, double resolution_m);
  /// A region of the map of a map dispatcher, nullopt: the whole map. It is placed where the dispatcher says.
  CommandResult<render::PlacedGrid> part(const std::optional<map::GridRegion>& region);
  /// Requests a change of one of its maps and waits for the result. When the time runs out the request is
  /// given up, and the failure says whether the change may have been made.
  CommandResult<map::CatalogueEntry> change(const robot::MapOrder& order);
  /// Sends a request and waits for its result. When the time runs out it is given up with
  /// FailureKind::TimedOut and what is known of it.
  template <typename T>
  robot::Outcome<T> ask(const std::function<robot::Call(robot::OutcomeTo<T>)>& request);
  /// False if the time is up, or `at_most_s` has passed.
  bool waitUntil(const std::function<bool()>& done, double at_most_s = 1e9);
  CommandTime time() const { return time_; }
  /// The same failure, but because of the time limit.
  map::Failure tooLate(map::Failure failure) const;
  /// A sentence about this robot, and its exit code.
  CommandFailure failure(int exit_code, const QString& sentence) const;
  CommandFailure failure(const map::Failure& failed) const;
  /// The failure for a capability that the robot lacks.
  CommandFailure lacks(robot::Capability capability) const;
  /// Adds a remark that is printed at the end.
  void note(const QString& sentence) { notes_ << sentence; }
  /// The same for something that was requested but could not be loaded; the result is incomplete then.
  void lack(const QString& sentence) {
    note(sentence);
    complete_ = false;
  }
  /// Marks the result as incomplete if anything received was unreadable.
  void insistOnReadable();
  /// Marks the result as incomplete if any part of the request could not be loaded.
  void insistOnAll() { complete_ = complete_ && problems(map::Severity::Warning).isEmpty(); }
  QString nameOfMap() const { return name_; }
  /// The local files that the map was read from.
  std::vector<std::string> sourceFiles() const;
  /// False if something that was requested could not be loaded; warnings() says what.
  bool complete() const { return complete_ && bagLosses(session_.problems()).isEmpty(); }
  /// Something is missing because the robot refused it.
  bool refused() const { return !complete() && anyRefused(session_.problems()); }
  /// One line per warning.
  QStringList warnings() const;
  /// {"map" or "submaps", "uuid", "bytes_fetched", …} of what was read, for a report.
  QJsonObject facts() const;

 private:
  MapReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time, Purpose purpose,
             std::shared_ptr<work::Workers> workers);
  /// Cancels a call; results that are delivered immediately still count.
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
  // Shared, because a result may still arrive when nobody waits for it.
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
