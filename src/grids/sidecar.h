// Finished pyramids in a folder, so that a picture need not be read twice. Any thread, any number of
// processes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "grids/grid_pyramid.h"
#include "grids/tile_store.h"

namespace mapwright::grids {

inline constexpr std::uint64_t kSidecarBudget = std::uint64_t(4) << 30;  // bytes in one folder

/// What a side-car is made of: another picture, reading or size is another file.
struct SidecarKey {
  std::string folder;  // empty: no side-car
  std::string content;
  int width = 0, height = 0;
  CellCode code = CellCode::Gray;  // of gray ones any: which, the file says
  Reduction reduction = Reduction::OccupiedWins;

  /// `content` is empty unless the options ask for a side-car.
  SidecarKey(const GridOptions& options, int picture_width, int picture_height);
  bool wanted() const { return !content.empty(); }
  std::string path() const;
  std::uint32_t salt() const;
};

/// The finished pyramid, its tiles read when asked for; null: there is none. A file that is torn, foreign or
/// of another version is removed. A tile that is damaged says so.
std::shared_ptr<const GridPyramid> openSidecar(const SidecarKey& key,
                                               std::shared_ptr<TileCache> unpacked = {});

/// A side-car while it is made: a file aside takes the tiles as they come. What goes wrong (a full disk, a
/// folder that cannot be written) is no error: the pyramid then stays in memory and nothing is kept.
class SidecarDraft {
 public:
  explicit SidecarDraft(const SidecarKey& key);
  ~SidecarDraft();
  SidecarDraft(const SidecarDraft&) = delete;
  SidecarDraft& operator=(const SidecarDraft&) = delete;
  /// Before the first tile is put.
  void begin(TileStore& store);
  /// Tiles go into a file.
  bool begun() const { return begun_; }
  std::string path() const { return key_.path(); }
  /// After the last one: the file gets its name, and old ones go when the folder is too full.
  void keep(TileStore& store);
  /// Why nothing could be kept, as a sentence; empty = it is kept, or was not to be.
  const Fault& trouble() const { return trouble_; }

 private:
  bool writeEnds(const TileStore& store) const;
  SidecarKey key_;
  std::string aside_;  // empty: there is no file, or it has its name
  bool begun_ = false;
  Fault trouble_;
};

/// Removes the side-cars that were used least recently until at most `most_bytes` are left, and drafts that
/// somebody left behind.
void pruneSidecars(const std::string& folder, std::uint64_t most_bytes);

}  // namespace mapwright::grids
