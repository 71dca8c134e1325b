// The classes by which submaps are tinted (render::ColorMode): of their trajectory, age and version. Pure
// functions. Private to this room.
//
// No class depends on what other submaps look like at the moment, so a map does not flicker while it grows: a
// trajectory keeps its colour; a version is compared with fixed steps; and an age is the index, in steps of a
// power of two that only grow when the trajectory has doubled.
#pragma once

#include <cstdint>
#include <set>

#include "map/submap.h"
#include "render/pixel_flags.h"
#include "submap/submap_store.h"

namespace mapwright::ui::scene {

/// Versions below this are in class 0; each further class reaches twice as far.
inline constexpr int kFirstVersionStep = 5;

/// The same colour for every kClasses-th trajectory.
int trajectoryClass(std::int32_t trajectory);
/// 0 = the oldest of its trajectory, whose newest submap has this index: 2^ageShift() indexes are one class.
int ageClass(std::int32_t index, std::int32_t newest_index);
int ageShift(std::int32_t newest_index);
/// A version counts scans; map::kNoVersion is unknown.
int versionClass(std::int32_t version);

/// Of a listed submap; the version is that of the picture on screen.
render::PixelClasses classesOf(const submap::SubmapStore& submaps, map::SubmapId id);
/// The index of the newest listed submap of a trajectory; -1 = there is none.
std::int32_t newestIndex(const submap::SubmapStore& submaps, std::int32_t trajectory);
/// The trajectories of all listed submaps.
std::set<std::int32_t> trajectoriesOf(const submap::SubmapStore& submaps);

}  // namespace mapwright::ui::scene
