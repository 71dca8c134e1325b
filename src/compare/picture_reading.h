// A picture, row by row, as colours.
#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "compare/comparison.h"
#include "grids/pixel_colours.h"

namespace mapwright::compare {

class PictureReading {
 public:
  /// The error names the file.
  static tl::expected<PictureReading, Fault> open(const std::string& path);
  PictureSize size() const { return {rows_->format().width, rows_->format().height}; }
  /// The next row from the top, width() colours, valid until the next call; null: see problem().
  const grids::Argb* next();
  /// After the last row: what was wrong although all rows came.
  bool endsWell();
  /// Names the file.
  Fault problem() const;

 private:
  PictureReading(std::string path, std::unique_ptr<grids::PictureRows> rows);
  std::string path_;
  std::unique_ptr<grids::PictureRows> rows_;
  grids::PixelColours colours_;
  std::vector<grids::Argb> row_;
  int came_ = 0;
};

}  // namespace mapwright::compare
