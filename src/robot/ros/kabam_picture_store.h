// Replaces the picture of a KABAM map manager's current map, the only one that it sends. On the thread of the
// robot. Source: docs/protocols/kabam-map-manager.md, "Pictures".
#pragma once

#include "robot/picture_store.h"
#include "robot/ros/ros_capabilities.h"

namespace mapwright::robot::ros {

/// An image is sent without a position: size, resolution and origin stay those of the map.
class KabamPictureStore : public PictureStore {
  Q_OBJECT
 public:
  explicit KabamPictureStore(RosLink* link, QObject* parent = nullptr);

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap&) const override { return true; }
  bool holdsCell(const map::WholeMap& map, std::uint8_t cell) const override;
  /// If it is cancelled during the upload it was not applied: partial uploads have no effect.
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  RosLink* link_;
  wire::PendingCalls<PictureReceipt> writes_;
};

}  // namespace mapwright::robot::ros
