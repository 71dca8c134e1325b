// The pictures of local maps, written anew. Lives on the thread of MapFiles: shares may be slow.
#pragma once

#include "robot/files/map_files.h"
#include "robot/picture_store.h"
#include "robot/wire/link_ref.h"

namespace mapwright::robot::files {

class PictureFiles : public QObject {
  Q_OBJECT
 public:
  explicit PictureFiles(FileOptions options);
  /// The map.yaml is not touched: the picture is written so that it says the right thing.
  Outcome<PictureReceipt> write(const PictureChange& change);

 private:
  FileOptions options_;
  YamlShelf yamls_;
};

/// Nothing here touches the disk: PictureFiles does, on another thread.
class FilePictureStore : public PictureStore {
  Q_OBJECT
 public:
  /// `files` lives on a thread that ends before this does, and is deleted there.
  explicit FilePictureStore(PictureFiles* files, QObject* parent = nullptr);

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap& map) const override;
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  wire::LinkRef<PictureFiles> files_;
};

}  // namespace mapwright::robot::files
