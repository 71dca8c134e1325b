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

/// Shared resources for pyramids. Null: a private one.
struct Resources {
  std::shared_ptr<work::Workers> workers = {};  // rows are reduced and compressed here
  std::shared_ptr<TileCache> unpacked = {};     // holds recently used cells
};

/// How four cells are combined into one of the next coarser level.
enum class Reduction : std::uint8_t {
  OccupiedWins,  // the highest CellMeaning::rank: thin walls stay visible
  Average,       // of the known ones; unknown if fewer than two are known
};

/// A tile: kTileEdge x kTileEdge bytes, row-major, top row first; cells beyond the edge of the level are
/// unknown. Uniform tiles share one buffer per value.
struct GridTile {
  std::shared_ptr<const std::uint8_t> cells;  // kTileEdge * kTileEdge bytes; never null
  bool uniform = false;
  bool damaged = false;  // its file is damaged: the cells are unknown
};

/// What happened to a pyramid whose file is damaged.
enum class GridDamage : std::uint8_t {
  Mended,  // the picture was read again: nothing is missing
  Lost,    // it can no longer be read: see GridPyramid::trouble()
};

/// Cells by tile and level. Level 0 is exact; level n is ceil(size / 2^n). Tiles appear from the top down
/// while the picture is read, and never change afterwards. Safe from any thread.
class GridPyramid {
 public:
  static constexpr int kTileEdge = 256;

  virtual ~GridPyramid() = default;
  virtual int width() const = 0;  // cells of level 0
  virtual int height() const = 0;
  virtual int levels() const = 0;  // >= 1; the last level fits one tile
  virtual CellCode code() const = 0;
  virtual Reduction reduction() const = 0;
  /// Of several cells the one whose byte ranks highest wins (Reduction::OccupiedWins).
  virtual const std::array<std::uint8_t, 256>& order() const = 0;
  int levelWidth(int level) const { return (width() + (1 << level) - 1) >> level; }
  int levelHeight(int level) const { return (height() + (1 << level) - 1) >> level; }

  /// nullopt: not read yet, or outside the level. A partly read tile is a copy of what is there, the rest
  /// unknown: ask again when rowsReady() has grown.
  virtual std::optional<GridTile> tile(int level, int tile_x, int tile_y) const = 0;
  /// How many rows of level 0 have been read, from the top. height() when complete.
  virtual int rowsReady() const = 0;
  bool complete() const { return rowsReady() >= height(); }
  /// Memory in use (without the operating system's file cache).
  virtual std::size_t bytes() const = 0;

  /// Why part of the content may be wrong; empty = all is right.
  virtual Fault trouble() const { return {}; }

  /// The cell (column, row from the top) of level 0; unknown outside and where not read yet. Fast enough for
  /// the GUI thread.
  std::uint8_t at(int column, int row) const;

 protected:
  /// tile() without slow work: nullopt if it would need some.
  virtual std::optional<GridTile> tileAtHand(int level, int tile_x, int tile_y) const {
    return tile(level, tile_x, tile_y);
  }
};

/// The rows of level 0 from the top; keeps one band of tiles at a time.
class GridRows {
 public:
  explicit GridRows(const GridPyramid& cells);
  /// At least width() bytes, valid until the next call; unknown where nothing has been read.
  const std::uint8_t* row(int y);

 private:
  const GridPyramid& cells_;
  std::vector<std::optional<GridTile>> band_;
  int tile_row_ = -1;
  std::vector<std::uint8_t> row_;
};

/// Builds a pyramid row by row; other threads may read it meanwhile. One thread pushes.
class GridBuilder {
 public:
  virtual ~GridBuilder() = default;
  virtual std::shared_ptr<const GridPyramid> pyramid() const = 0;
  /// The next row of level 0, `width` bytes in the pyramid's code.
  virtual void pushRow(std::span<const std::uint8_t> cells) = 0;
  /// Missing rows become unknown; the pyramid is complete afterwards.
  virtual void finish() = 0;
};
/// In memory (compressed). Precondition: 1 <= width, height <= kMaxGridEdge.
std::unique_ptr<GridBuilder> buildGrid(int width, int height, CellCode code, Reduction reduction,
                                       const Resources& resources = {});

inline constexpr int kMaxGridEdge = 400'000;
inline constexpr std::int64_t kMaxGridCells = std::int64_t(1) << 35;

struct GridOptions {
  map::CellReading reading;
  Reduction reduction = Reduction::OccupiedWins;
  std::string sidecar_folder;           // where finished pyramids are cached; empty = nowhere
  std::string fingerprint;              // identifies exactly this content; empty = no side-car
  std::int64_t sidecar_from_cells = 0;  // smaller pictures are read as fast as a side-car
  std::optional<CellCode> code;  // the meaning of gray levels, if known; otherwise detected from the picture
  std::function<void(GridDamage)>
      damaged;  // called once, on any thread, if a side-car turns out to be damaged
  Resources resources;
};

/// Reads a picture into a pyramid. open() reads the header (or finds the finished side-car, and is then
/// complete at once), and for gray pictures the first rows, to detect the meaning of the gray levels; read()
/// does the work on the caller's thread and reports progress regularly.
class GridReading {
 public:
  virtual ~GridReading() = default;
  virtual std::shared_ptr<const GridPyramid> pyramid() const = 0;
  virtual bool complete() const = 0;
  /// Blocks until everything is read, `cancelled` is set, or an error occurs. After an error the rows read so
  /// far stay (the rest is unknown) and the pyramid counts as complete. `progressed` is called on this
  /// thread, about 20 times a second.
  virtual std::optional<Fault> read(const std::atomic<bool>& cancelled,
                                    const std::function<void()>& progressed) = 0;
  /// After read(): later rows suggest another meaning of the gray levels than the first ones. It has not been
  /// read to its end: open it again with this as GridOptions::code.
  virtual std::optional<CellCode> otherCode() const { return std::nullopt; }
  /// After read(): why no side-car could be written; none = it was written, or not wanted.
  virtual Fault notKept() const { return {}; }
};
/// PNG (all types, including interlaced), PGM (P2, P5), BMP, detected by signature. `bytes` is kept alive as
/// long as needed.
tl::expected<std::unique_ptr<GridReading>, Fault> openGrid(std::shared_ptr<const std::string> bytes,
                                                           const GridOptions& options);
/// The same from cells (any but 0..100 are unknown); there is no side-car.
tl::expected<std::unique_ptr<GridReading>, Fault> openGrid(const map::OccupancyCells& cells, int width,
                                                           int height, const GridOptions& options);
/// The same from a file, read in pieces.
tl::expected<std::unique_ptr<GridReading>, Fault> openGridFile(const std::string& path,
                                                               const GridOptions& options);

/// A small coloured picture: its cells are indices into `palette` (0xAARRGGBB, not premultiplied). Exact up
/// to 256 colours, beyond that the nearest of a fixed set. Gray pictures: index = gray, palette empty.
/// Costmaps (decodeOccupancy): index = occupancy, palette empty.
struct ColoredGrid {
  std::shared_ptr<const GridPyramid>
      indices;  // code Gray (or Occupancy), reduction OccupiedWins over rank: see colored_grid.cpp
  std::vector<std::uint32_t> palette;
};
tl::expected<ColoredGrid, Fault> decodeColors(std::shared_ptr<const std::string> bytes,
                                              std::int64_t max_cells, const Resources& resources = {});

/// A small picture whose bytes are occupancy values (any mode but Picture): its cells are
/// CellCode::Occupancy, palette empty. Blocks until all is read.
tl::expected<ColoredGrid, Fault> decodeOccupancy(std::shared_ptr<const std::string> bytes,
                                                 const map::CellReading& reading, std::int64_t max_cells,
                                                 const Resources& resources = {});

}  // namespace mapwright::grids
