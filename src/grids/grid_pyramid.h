// A whole map in memory or in a side-car file: tiles of cells at all levels of detail. Never one big picture.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "grids/grid_cells.h"
#include "map/catalogue.h"

namespace mapwright::work {
class Workers;
}

namespace mapwright::grids {

class TileCache;

/// What pyramids are made with. Null: something of their own.
struct Means {
  std::shared_ptr<work::Workers> workers = {};  // where rows are reduced and compressed
  std::shared_ptr<TileCache> unpacked = {};     // where the cells that were looked at last are kept
};

/// How four cells become one of the next coarser level.
enum class Reduction : std::uint8_t {
  OccupiedWins,  // the highest CellMeaning::rank: thin walls stay visible
  Average,       // of the known ones; unknown when fewer than two are known
};

/// A tile: kTileEdge x kTileEdge bytes, row-major, row 0 on top; cells beyond the edge of the level are
/// unknown. Uniform tiles share one buffer per value.
struct GridTile {
  std::shared_ptr<const std::uint8_t> cells;  // kTileEdge * kTileEdge bytes; never null
  bool uniform = false;
  bool damaged = false;  // the file that it was kept in is: the cells are unknown
};

/// What became of a pyramid whose file turned out damaged.
enum class GridDamage : std::uint8_t {
  Mended,  // the picture was read again: everything is there
  Lost,    // it cannot be read any more: GridPyramid::trouble()
};

/// Cells by tile and level. Level 0 is exact; level n is ceil(size / 2^n). Tiles appear from the top row
/// downwards while the picture is being read; what is there never changes. Safe from any thread.
class GridPyramid {
 public:
  static constexpr int kTileEdge = 256;

  virtual ~GridPyramid() = default;
  virtual int width() const = 0;  // cells of level 0
  virtual int height() const = 0;
  virtual int levels() const = 0;  // >= 1; the last level fits one tile
  virtual CellCode code() const = 0;
  virtual Reduction reduction() const = 0;
  /// Of several cells the one whose byte has the highest place here wins (Reduction::OccupiedWins).
  virtual const std::array<std::uint8_t, 256>& order() const = 0;
  int levelWidth(int level) const { return (width() + (1 << level) - 1) >> level; }
  int levelHeight(int level) const { return (height() + (1 << level) - 1) >> level; }

  /// nullopt: not read yet, or a place outside the level. A tile that is only partly read is a copy of what
  /// is there, the rest of it unknown: ask again when rowsReady() has grown.
  virtual std::optional<GridTile> tile(int level, int tile_x, int tile_y) const = 0;
  /// Rows of level 0 that are there, counted from the top. height() when complete.
  virtual int rowsReady() const = 0;
  bool complete() const { return rowsReady() >= height(); }
  /// Memory held (without what the operating system caches of files).
  virtual std::size_t bytes() const = 0;

  /// Why not all that it shows is right; empty = all is.
  virtual Fault trouble() const { return {}; }

  /// The cell (column, row from the top) of level 0; unknown outside and where not read yet. Quick: for the
  /// thread that draws the window, too.
  std::uint8_t at(int column, int row) const;

 protected:
  /// tile() without long work: what would need that is not there.
  virtual std::optional<GridTile> tileAtHand(int level, int tile_x, int tile_y) const {
    return tile(level, tile_x, tile_y);
  }
};

/// Makes a pyramid row by row; the pyramid can be looked at from other threads meanwhile. One thread pushes.
class GridBuilder {
 public:
  virtual ~GridBuilder() = default;
  virtual std::shared_ptr<const GridPyramid> pyramid() const = 0;
  /// The next row of level 0, `width` bytes in the pyramid's code.
  virtual void pushRow(std::span<const std::uint8_t> cells) = 0;
  /// Rows that never came are unknown; the pyramid is complete afterwards.
  virtual void finish() = 0;
};
/// In memory (compressed). Precondition: 1 <= width, height <= kMaxGridEdge.
std::unique_ptr<GridBuilder> buildGrid(int width, int height, CellCode code, Reduction reduction,
                                       const Means& means = {});

inline constexpr int kMaxGridEdge = 400'000;
inline constexpr std::int64_t kMaxGridCells = std::int64_t(1) << 35;

struct GridOptions {
  map::CellReading reading;
  Reduction reduction = Reduction::OccupiedWins;
  std::string sidecar_folder;               // where finished pyramids are kept; empty = nowhere
  std::string fingerprint;                  // names exactly this content; empty = no side-car
  std::int64_t sidecar_from_cells = 0;      // smaller pictures are read as quickly as a side-car
  std::optional<CellCode> code;             // what grays mean, where that is known; else the picture tells
  std::function<void(GridDamage)> damaged;  // called once, on any thread, when a side-car turns out so
  Means means;
};

/// A picture that is being read into a pyramid. open() reads the header (or finds the finished side-car, and
/// is then complete at once), and of a gray picture its first rows, for what the grays mean; read() does the
/// work on the caller's thread, and says every so often that more rows are there.
class GridReading {
 public:
  virtual ~GridReading() = default;
  virtual std::shared_ptr<const GridPyramid> pyramid() const = 0;
  virtual bool complete() const = 0;
  /// Blocks until all is read, `cancelled`, or an error. After an error the rows that came stay (the rest is
  /// unknown) and the pyramid counts as complete. `progressed` is called on this thread, about 20 times a
  /// second.
  virtual std::optional<Fault> read(const std::atomic<bool>& cancelled,
                                    const std::function<void()>& progressed) = 0;
  /// After read(): the picture's later rows speak for another meaning of its grays than the first ones did.
  /// It has not been read to its end: open it again with this as GridOptions::code.
  virtual std::optional<CellCode> otherCode() const { return std::nullopt; }
  /// After read(): why no side-car could be kept; none = it is kept, or was not to be.
  virtual Fault notKept() const { return {}; }
};
/// PNG (all types, interlaced too), PGM (P2, P5), BMP, by signature. `bytes` stays alive as long as needed.
tl::expected<std::unique_ptr<GridReading>, Fault> openGrid(std::shared_ptr<const std::string> bytes,
                                                           const GridOptions& options);
/// The same from a file, read in pieces, never as a whole.
tl::expected<std::unique_ptr<GridReading>, Fault> openGridFile(const std::string& path,
                                                               const GridOptions& options);

/// A small picture in colours: its cells are indices into `palette` (0xAARRGGBB, not premultiplied). Exact up
/// to 256 colours, beyond that the nearest of a fixed set. Gray pictures: index = gray, palette empty. Costs
/// (decodeOccupancy): index = occupancy, palette empty.
struct ColoredGrid {
  std::shared_ptr<const GridPyramid>
      indices;  // code Gray (or Occupancy), reduction OccupiedWins over rank: see colored_grid.cpp
  std::vector<std::uint32_t> palette;
};
tl::expected<ColoredGrid, Fault> decodeColors(std::shared_ptr<const std::string> bytes,
                                              std::int64_t max_cells, const Means& means = {});

/// A small picture whose bytes are read as occupancy (any mode but Picture): its cells are of
/// CellCode::Occupancy, palette empty. Blocks until all is read.
tl::expected<ColoredGrid, Fault> decodeOccupancy(std::shared_ptr<const std::string> bytes,
                                                 const map::CellReading& reading, std::int64_t max_cells,
                                                 const Means& means = {});

}  // namespace mapwright::grids
