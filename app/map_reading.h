// One robot (or file) for a command that reads its maps and ends: waits for answers in an event loop of its
// own.
#pragma once

#include <functional>
#include <memory>
#include <set>

#include <QString>
#include <tl/expected.hpp>

#include "render/sample_grid.h"
#include "session/session.h"

namespace mapwright::app {

/// A sentence and the exit code that it comes with.
struct CommandFailure {
  int exit_code = 0;
  QString sentence;
};
template <typename T>
using CommandResult = tl::expected<T, CommandFailure>;

class MapReading {
 public:
  /// Connects. `timeout_s` bounds every wait.
  static CommandResult<std::unique_ptr<MapReading>> open(const QString& address, const QByteArray& secret,
                                                         double timeout_s);

  session::Session& session() { return session_; }
  bool local() const;
  /// The catalogue, once it is in.
  CommandResult<const std::vector<map::CatalogueEntry>*> catalogue();
  /// Opens a map and reads it to the end. "" = the live or current one; "submaps" composes the submaps at
  /// `resolution_m`. Warnings (an odd origin, a picture that breaks off) are printed on stderr.
  CommandResult<render::PlacedGrid> map(const QString& id, double resolution_m);
  QString nameOfMap() const { return name_; }
  /// False when something that was asked for could not be had (it has been said on stderr).
  bool complete() const { return complete_; }

 private:
  MapReading(std::unique_ptr<robot::Robot> robot, QString address, double timeout_s);
  /// False when the time is up.
  bool waitUntil(const std::function<bool()>& done);
  CommandResult<render::PlacedGrid> submaps(double resolution_m);
  CommandFailure failure(int exit_code, const QString& sentence) const;
  void warnOfProblems();

  session::Session session_;
  QString address_, name_;
  double timeout_s_;
  bool complete_ = true;
  std::set<QString> warned_;
};

}  // namespace mapwright::app
