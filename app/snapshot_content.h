// What a snapshot is to be made of, from what was asked for and what the session has.
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

/// With a mode: where nobody chose one, what `robot` offers decides.
SnapshotOptions decided(SnapshotOptions options, robot::Robot& robot);
bool wantsSubmaps(const SnapshotOptions& options);
bool wantsWhole(const SnapshotOptions& options);
/// Of a session that asks for nothing but what is drawn.
session::Session::Options sessionFor(const SnapshotOptions& options,
                                     const std::shared_ptr<work::Workers>& workers);
/// What was asked for, or all that has come so far.
geometry::ViewTransform viewOf(const SnapshotOptions& options, const session::Session& session,
                               const MapWish& map);
/// The session stands still from before.
SnapshotContent contentOf(const SnapshotOptions& options, const session::Session& session, const MapWish& map,
                          const geometry::ViewTransform& view);

}  // namespace mapwright::app
