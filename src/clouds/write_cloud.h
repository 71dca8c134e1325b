// Clouds as files: PCD 0.7 (pointclouds.org/documentation/tutorials/pcd_file_format.html), PLY 1.0, CSV.
// Pure: the bytes go to whoever takes them.
//
// Fields: x y z, intensity where any point has one (NaN where it has none), colour where any point has one.
// Nothing is lost: where a cloud lies beside an origin that is not 0, x, y and z are doubles, else floats as
// they came. Texts have as many digits as it takes to read the same number again.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "clouds/cloud_book.h"

namespace mapwright::clouds {

enum class CloudFormat {
  PcdBinary,
  PcdAscii,
  PlyBinary,  // little endian
  Csv,        // with a row of names
};
/// By the end of a file's name, in any case: .pcd (binary), .ply, .csv; nullopt = none of them.
std::optional<CloudFormat> formatOf(std::string_view path);

/// Takes bytes, a few thousand at a time; false: no more, it cannot be written.
using CloudSink = std::function<bool(std::string_view)>;

struct CloudWritten {
  std::uint64_t points = 0;
  bool doubles = false, intensity = false, rgb = false;
};
/// nullopt: the sink would not take it, or it was cancelled.
std::optional<CloudWritten> writeCloud(const map::SpatialCloud& cloud, CloudFormat format,
                                       const CloudSink& sink, const std::atomic<bool>* cancelled = nullptr);
/// The points of a set that are shown and within the heights.
std::optional<CloudWritten> writeClouds(const CloudSet& set, const HeightRange& heights, CloudFormat format,
                                        const CloudSink& sink, const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::clouds
