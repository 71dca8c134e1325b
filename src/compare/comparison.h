// What differs between two pictures. Any thread; blocks. The pictures are read row by row.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"

namespace mapwright::compare {

/// What may differ.
struct Allowed {
  int tolerance = 0;                 // of a pixel, per channel: 0..255
  double max_differing_percent = 0;  // of all pixels that differ by more
  std::string mask = {};             // a picture: the gray of a pixel is what may differ there; empty = none
};

struct PictureSize {
  int width = 0, height = 0;
  std::int64_t pixels() const { return std::int64_t(width) * height; }
  bool operator==(const PictureSize&) const = default;
};

/// Pixels from the upper left corner.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelBox&) const = default;
};

/// Pixels that differ near each other.
struct Cluster {
  PixelBox box;
  std::int64_t pixels = 0;  // of them that differ
  bool dense = false;       // see kDenseEdge
};

/// A cluster is dense if half of the pixels in some square of this edge differ, or kDensePixels of them
/// touch: a marker, a line. It is never allowed by a share.
inline constexpr int kDenseEdge = 6;
inline constexpr int kDensePixels = 64;
/// Pixels with no more pixels than these between them belong to the same cluster.
inline constexpr int kNearPx = 6;
inline constexpr std::size_t kMostClusters = 1'000;
inline constexpr std::int64_t kMostPixels = 200'000'000;  // of a picture, as of a snapshot

struct Comparison {
  PictureSize expected, actual;
  PictureSize canvas;             // both on each other; of `actual` where that would be too large
  bool equal = true;              // nothing differs but what is allowed
  std::int64_t differing = 0;     // pixels, with those that only one of the pictures has
  int max = 0;                    // the greatest difference of a channel, except where the mask allows it
  std::vector<Cluster> clusters;  // those with the most pixels first, at most kMostClusters
  std::int64_t clusters_in_all = 0, clusters_dense = 0;
  std::vector<std::uint8_t> differs;  // 1 for each pixel of the canvas that does; empty: none

  bool sameSize() const { return expected == actual; }
  /// Of the pixels of both pictures on each other.
  double percent() const;
};

/// Channels are compared exactly, transparency among them; differences are counted in steps of 8 bits, and
/// less than one is one. The upper left corners of pictures of different sizes lie on each other; such
/// pictures are never equal.
tl::expected<Comparison, Fault> comparePictures(const std::string& expected, const std::string& actual,
                                                const Allowed& allowed);

}  // namespace mapwright::compare
