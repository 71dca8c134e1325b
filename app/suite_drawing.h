// Many snapshots in one process.
#pragma once

#include <functional>
#include <vector>

#include "app/snapshot_run.h"
#include "suite/quality.h"
#include "suite/read_suite.h"

namespace mapwright::app {

/// What a view may say: the options of `snapshot` but those of its files, of access and of terminals.
suite::KnownOptions viewOptions();

/// The view as `snapshot` would be asked for it, its picture at `output`. Paths count from `folder`; `robot`
/// is that of views that name none. The error is a sentence with its place in the suite.
tl::expected<SnapshotOptions, QString> snapshotOptionsOf(const suite::View& view, const QString& folder,
                                                         const std::string& robot, const QString& output);

/// How one snapshot ended.
struct DrawnView {
  int exit_code = 0;
  QString sentence;  // why it is not complete
  double seconds = 0;
  const SnapshotRun* run = nullptr;  // null: there was no robot to ask
  suite::Examined examined = {};     // as its options ask, if it is complete
};

/// Draws all of `views`, `jobs` at a time, on the event loop of this thread: they wait for their robots
/// together and share the threads that make pixels; each has a session and a scene of its own, so that none
/// changes the bytes of another. `done` is called for each as it ends, in any order.
void drawViews(const std::vector<SnapshotOptions>& views, const RobotAccess& access, int jobs,
               const std::function<void(std::size_t view, const DrawnView& drawn)>& done);

}  // namespace mapwright::app
