// A picture, row by row, as colours.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "compare/comparison.h"
#include "grids/pixel_colours.h"

namespace mapwright::compare {

class PictureReading {
 public:
  /// The error names the file.
  static tl::expected<PictureReading, Fault> open(const std::string& path);
  PictureSize size() const { return {rows_->format().width, rows_->format().height}; }
  /// Gray and transparency, as "snapshot --raw" writes it.
  bool isRaw() const { return !rows_->format().indexed && rows_->format().channels == 2; }
  /// The next row from the top, width() colours, valid until the next call; null: see problem().
  const grids::Argb* next() {
    return nextRow(row_, [this](auto* pixel) { return colours_.at(pixel); });
  }
  const grids::DeepArgb* nextDeep() {
    return nextRow(deep_row_, [this](auto* pixel) { return colours_.deepAt(pixel); });
  }
  /// After the last row: what was wrong although all rows came.
  bool endsWell();
  /// Names the file.
  Fault problem() const;

 private:
  PictureReading(std::string path, std::unique_ptr<grids::PictureRows> rows);
  template <typename Colour, typename ColourAt>
  const Colour* nextRow(std::vector<Colour>& row, const ColourAt& colour_at) {
    const std::uint8_t* pixel = rows_->next();
    if (pixel == nullptr) return nullptr;
    ++came_;
    row.resize(std::size_t(size().width));
    for (Colour& colour : row) {
      colour = colour_at(pixel);
      pixel += rows_->format().pixelBytes();
    }
    return row.data();
  }

  std::string path_;
  std::unique_ptr<grids::PictureRows> rows_;
  grids::PixelColours colours_;
  std::vector<grids::Argb> row_;
  std::vector<grids::DeepArgb> deep_row_;
  int came_ = 0;
};

}  // namespace mapwright::compare
