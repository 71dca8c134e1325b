// Commands that read from a robot, or change something there, and then exit.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "app/commands.h"
#include "app/deadline.h"
#include "app/report.h"
#include "map/map_part.h"
#include "render/compositor.h"
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

/// One robot (or file) of a command: waits for answers in an event loop of its own.
class RobotReading {
 public:
  /// What the command needs; nothing else is requested.
  enum class Purpose { Maps, Submaps, Bags };
  /// Connects; for Bags only if they need a connection, since they use single requests. `bag`: replays that
  /// one instead.
  static CommandResult<std::unique_ptr<RobotReading>> open(const QString& address, const Access& access,
                                                           CommandTime time, Purpose purpose,
                                                           std::shared_ptr<work::Workers> workers,
                                                           const std::string& bag = {});

  session::Session& session() { return session_; }
  const std::shared_ptr<work::Workers>& workers() const { return workers_; }
  bool local() const;
  /// The catalogue, as soon as it has arrived.
  CommandResult<const std::vector<map::CatalogueEntry>*> catalogue();
  /// Opens a map and reads it completely. "" = the live or current one; "submaps" composes the submaps at
  /// `resolution_m`. Afterwards the session does not change any more.
  CommandResult<render::PlacedGrid> map(const QString& id, double resolution_m);
  /// Takes a replayed bag to a time, as typed; nullopt = it is there.
  std::optional<CommandFailure> recall(const std::string& at);
  /// Waits for all submaps; those that came, at least one, in painting order. Afterwards the session does not
  /// change any more.
  CommandResult<std::vector<render::PlacedTexture>> submapTextures();
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
  /// Without secrets.
  const QString& address() const { return address_; }
  /// "ADDRESS: sentence".
  QString about(const QString& sentence) const;
  /// A sentence about this robot, and its exit code.
  tl::unexpected<CommandFailure> failure(int exit_code, const QString& sentence) const;
  tl::unexpected<CommandFailure> failure(const map::Failure& failed) const;
  /// Of what failed here: a file that cannot be read or written is wrong usage.
  int exitCodeHere(const map::Failure& failed) const;
  /// Waits until the robot has told whether it has it.
  void await(robot::Capability capability);
  /// The failure for a capability that the robot lacks.
  tl::unexpected<CommandFailure> lacks(robot::Capability capability) const;
  /// Adds a remark that is printed at the end.
  void addRemark(const QString& sentence) { notes_ << sentence; }
  /// The remark that changing this is not confirmed by the robot's maker, where that is so. It stands behind
  /// a failure, too.
  void warnOfUnconfirmed(robot::Capability capability);
  const QString& unconfirmed() const { return unconfirmed_; }
  /// The same as addRemark() for something that was requested but could not be loaded; the result is
  /// incomplete then.
  void lack(const QString& sentence) {
    lacks_ << sentence;
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
  /// One line per warning; first what keeps the result from being complete.
  QStringList warnings() const;
  /// {"map" or "submaps", "uuid", "bytes_fetched", …} of what was read, for a report.
  QJsonObject facts() const;

 private:
  RobotReading(std::unique_ptr<robot::Robot> robot, QString address, CommandTime time, Purpose purpose,
               std::shared_ptr<work::Workers> workers);
  /// Cancels a call; results that are delivered immediately still count.
  void giveUp(const robot::Call& call, const std::function<bool()>& over) const;
  CommandResult<render::PlacedGrid> submaps(double resolution_m);
  QStringList problems(map::Severity least) const;  // unresolved

  std::shared_ptr<work::Workers> workers_;
  session::Session session_;
  QString address_, name_, unconfirmed_;
  CommandTime time_;
  SteadyTime online_since_;
  bool complete_ = true;
  QStringList lacks_, notes_;  // what is missing, and everything else
  QJsonObject facts_;
};

template <typename T>
robot::Outcome<T> RobotReading::ask(const std::function<robot::Call(robot::OutcomeTo<T>)>& request) {
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

/// Common to these commands: the time limit, the robots, the one line on standard error, the report.
class RobotCommand {
 public:
  /// Outlived by `args`; --report is written to, if given.
  explicit RobotCommand(const RobotArguments& args);

  /// Connects to the robot of the options, or to another `address`; the result lives as long as this object.
  /// Of a `bag`, unless that is empty.
  CommandResult<RobotReading*> open(RobotReading::Purpose purpose = RobotReading::Purpose::Maps,
                                    const QString& address = {}, const std::string& bag = {});
  /// Sets an entry of the report, replacing an earlier one of that name; also used by commands that fail.
  void report(const QString& name, const QJsonObject& done) {
    done_name_ = name;
    done_ = done;
  }
  /// True if everything that was requested could be loaded.
  bool complete() const;
  QStringList warnings() const;
  CommandTime time() const { return time_; }

  /// Of work that connects by itself: from now on a lack of time is no lack of a connection.
  void reportConnected() { connected_->store(true); }
  /// Of work whose kIncomplete is an answer, as "not sure": when the time is over there is none.
  void answerByCode() { late_->store(kUnreachable); }

  /// Sets up an application without a display, runs `work`, prints the final messages and returns the exit
  /// code. The process ends in time whatever `work` does.
  int run(int& argc, char** argv, const std::function<CommandResult<int>(RobotCommand&)>& work);

 private:
  int end(CommandResult<int> result) const;

  const RobotArguments& args_;
  CommandTime time_;
  QString report_path_, done_name_;
  QJsonObject done_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();  // of all readings
  std::vector<std::unique_ptr<RobotReading>> readings_;
  /// Of the first robot; shared with the deadline.
  std::shared_ptr<std::atomic<bool>> connected_ = std::make_shared<std::atomic<bool>>(false);
  /// The exit code when the time is over; shared with the deadline.
  std::shared_ptr<std::atomic<int>> late_ = std::make_shared<std::atomic<int>>(int(kIncomplete));
};

/// Adds a command that reads from a robot. `prepare`: completes the options before they are used.
template <typename Arguments>
void addReading(Commands& commands, const CLI::App* command, std::shared_ptr<Arguments> args,
                std::type_identity_t<std::function<CommandResult<int>(RobotCommand&, const Arguments&)>> work,
                std::type_identity_t<std::function<void(Arguments&, const Invocation&)>> prepare = {}) {
  commands.add(command, [args = std::move(args), work = std::move(work),
                         prepare = std::move(prepare)](const Invocation& before) {
    if (prepare) prepare(*args, before);
    inherit(*args, before);
    return RobotCommand(*args).run(before.argc, before.argv,
                                   [&](RobotCommand& one) { return work(one, *args); });
  });
}

/// The same, made under `parent` with the options that all of these have. `about`, `robots`: help texts.
template <typename Arguments>
CLI::App* addReading(
    Commands& commands, CLI::App& parent, const char* name, const QString& about, const QString& robots,
    std::shared_ptr<Arguments> args,
    std::type_identity_t<std::function<CommandResult<int>(RobotCommand&, const Arguments&)>> work,
    std::type_identity_t<std::function<void(Arguments&, const Invocation&)>> prepare = {}) {
  CLI::App* const command = addRobotCommand(parent, name, about, robots, *args);
  addReading(commands, command, std::move(args), std::move(work), std::move(prepare));
  return command;
}

}  // namespace mapwright::app
