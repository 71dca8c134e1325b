// Writes clouds to files: PCD 0.7 (pointclouds.org/documentation/tutorials/pcd_file_format.html), PLY 1.0,
// CSV. Pure: the bytes go to a sink.
// Fields: x y z, intensity if any point has one (NaN for the others), colour if any point has one. Lossless:
// if the cloud's origin is not 0, x, y and z are doubles, otherwise floats as received. Numbers have as many
// digits as needed to read the same value back.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "clouds/newest_clouds.h"

namespace mapwright::clouds {

enum class CloudFormat {
  PcdBinary,
  PcdAscii,
  PlyBinary,  // little endian
  Csv,        // with a row of names
};
/// By the extension of a file name, in any case: .pcd (binary), .ply, .csv; nullopt = something else.
std::optional<CloudFormat> formatOf(std::string_view path);

/// Takes bytes, a few thousand at a time; false: cannot write any more.
using CloudSink = std::function<bool(std::string_view)>;

struct CloudWritten {
  std::uint64_t points = 0;
  bool doubles = false, intensity = false, rgb = false;
};
/// nullopt: the sink refused, or it was cancelled.
std::optional<CloudWritten> writeCloud(const map::SpatialCloud& cloud, CloudFormat format,
                                       const CloudSink& sink, const std::atomic<bool>* cancelled = nullptr);
/// The points of a set that are shown and within the heights.
std::optional<CloudWritten> writeClouds(const CloudSet& set, const HeightRange& heights, CloudFormat format,
                                        const CloudSink& sink, const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::clouds
