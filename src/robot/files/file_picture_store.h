// The pictures of local maps behind the port.
#pragma once

#include "robot/files/map_files.h"
#include "robot/picture_store.h"
#include "robot/wire/link_ref.h"

namespace mapwright::robot::files {

/// Nothing here touches the disk: MapFiles does, on another thread.
class FilePictureStore : public PictureStore {
  Q_OBJECT
 public:
  /// `files` lives on a thread that ends before this does, and is deleted there.
  explicit FilePictureStore(MapFiles* files) : files_(files) {}

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap& map) const override;
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  wire::LinkRef<MapFiles> files_;
};

}  // namespace mapwright::robot::files
