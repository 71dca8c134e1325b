// The pictures of a KABAM map manager's maps, replaced: of the map that the robot works with, which is the
// only one that it sends. On the thread of the robot. Source: docs/protocols/kabam-map-manager.md,
// "Pictures".
#pragma once

#include "robot/picture_store.h"
#include "robot/ros/ros_capabilities.h"

namespace mapwright::robot::ros {

/// An image goes without a place: size, resolution and origin are those that the map has.
class KabamPictureStore : public PictureStore {
  Q_OBJECT
 public:
  explicit KabamPictureStore(RosLink* link, QObject* parent = nullptr);

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap&) const override { return true; }
  bool holdsCell(const map::WholeMap& map, std::uint8_t cell) const override;
  /// Cancelled while it travels, it has not been applied: no part of it counts.
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  RosLink* link_;
  wire::PendingCalls<PictureReceipt> writes_;
};

}  // namespace mapwright::robot::ros
