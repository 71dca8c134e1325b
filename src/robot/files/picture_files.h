// Writes the pictures of local maps. Lives on the thread of MapFiles: network drives may be slow.
#pragma once

#include "robot/files/map_files.h"
#include "robot/picture_store.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::files {

class PictureFiles : public QObject {
  Q_OBJECT
 public:
  explicit PictureFiles(FileOptions options);
  /// Does not change the map.yaml: the picture is written to match it.
  Outcome<PictureReceipt> write(const PictureChange& change);

 private:
  FileOptions options_;
  YamlShelf yamls_;
};

/// Nothing here accesses the disk: PictureFiles does, on another thread.
class FilePictureStore : public PictureStore {
  Q_OBJECT
 public:
  /// `files` lives on a thread that ends before this object, and is deleted there.
  explicit FilePictureStore(PictureFiles* files, QObject* parent = nullptr);

  std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const override;
  bool holdsUnknown(const map::WholeMap& map) const override;
  Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) override;

 private:
  PictureFiles* files_;
  wire::PendingCalls<PictureReceipt> writes_;
};

}  // namespace mapwright::robot::files
