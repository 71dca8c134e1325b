// Finished pyramids cached in a folder, so that a picture need not be read twice. Any thread, any number of
// processes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "grids/grid_pyramid.h"
#include "grids/tile_store.h"

namespace mapwright::grids {

inline constexpr std::uint64_t kSidecarBudget = std::uint64_t(4) << 30;  // bytes per folder

/// What a side-car was made from: another picture, reading or size means another file.
struct SidecarKey {
  std::string folder;  // empty: no side-car
  std::string content;
  int width = 0, height = 0;
  CellCode code = CellCode::Gray;  // for gray ones any: the file says which
  Reduction reduction = Reduction::OccupiedWins;

  /// `content` is empty unless the options ask for a side-car.
  SidecarKey(const GridOptions& options, int picture_width, int picture_height);
  bool wanted() const { return !content.empty(); }
  std::string path() const;
  std::uint32_t salt() const;
};

/// The finished pyramid, with tiles read on demand; null: there is none. Files that are truncated, foreign or
/// of another version are removed. Damaged tiles are reported.
std::shared_ptr<const GridPyramid> openSidecar(const SidecarKey& key,
                                               std::shared_ptr<TileCache> unpacked = {});

/// A side-car under construction: tiles go to a separate file as they come. Failures (a full disk, a
/// read-only folder) are not errors: the pyramid then stays in memory and nothing is cached.
class SidecarDraft {
 public:
  explicit SidecarDraft(const SidecarKey& key);
  ~SidecarDraft();
  SidecarDraft(const SidecarDraft&) = delete;
  SidecarDraft& operator=(const SidecarDraft&) = delete;
  /// Before the first tile is stored.
  void begin(TileStore& store);
  /// Tiles are written to a file.
  bool begun() const { return begun_; }
  std::string path() const { return key_.path(); }
  /// After the last tile: gives the file its name, and removes old ones if the folder is too full.
  void keep(TileStore& store);
  /// Why nothing was cached; empty = it was, or was not wanted.
  const Fault& trouble() const { return trouble_; }

 private:
  bool writeEnds(const TileStore& store) const;
  SidecarKey key_;
  std::string aside_;  // empty: there is no file, or it has its final name
  bool begun_ = false;
  Fault trouble_;
};

/// Removes the least recently used side-cars until at most `most_bytes` are left, and abandoned drafts.
void pruneSidecars(const std::string& folder, std::uint64_t most_bytes);

}  // namespace mapwright::grids
