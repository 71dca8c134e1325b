// What to put into a snapshot, from the options and what the session has.
#pragma once

#include <memory>

#include "app/map_wish.h"
#include "app/snapshot_options.h"
#include "app/snapshot_picture.h"
#include "geometry/view_transform.h"
#include "robot/robot.h"
#include "session/session.h"
#include "work/workers.h"

namespace mapwright::app {

/// Fills in the mode if none was chosen, depending on what `robot` offers.
SnapshotOptions decided(SnapshotOptions options, robot::Robot& robot);
bool wantsSubmaps(const SnapshotOptions& options);
bool wantsWhole(const SnapshotOptions& options);
/// A session that only requests what is drawn.
session::Session::Options sessionFor(const SnapshotOptions& options,
                                     const std::shared_ptr<work::Workers>& workers);
/// The requested view, or all that has been received so far.
geometry::ViewTransform viewOf(const SnapshotOptions& options, const session::Session& session,
                               const MapWish& map);
/// The session must not change any more.
SnapshotContent contentOf(const SnapshotOptions& options, const session::Session& session, const MapWish& map,
                          const geometry::ViewTransform& view);

}  // namespace mapwright::app
