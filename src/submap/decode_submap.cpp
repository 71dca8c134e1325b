#include <algorithm>
#include <cmath>

#include "cells/decode_cells.h"
#include "submap/faults.h"
#include "submap/submap_store.h"

namespace mapwright::submap {
namespace {

Slice decodeSlice(const map::RawSlice& raw) {
  Slice slice;
  slice.slice_pose = raw.slice_pose;
  slice.z_level = raw.z_level;
  // A robot that has no such slice sends an empty texture to keep the slice ids in step.
  if (raw.cells.empty() && raw.width == 0 && raw.height == 0) return slice;
  const auto pose = geometry::toIsometry(raw.slice_pose);
  if (!pose || pose->translation().cwiseAbs().maxCoeff() > kMaxCoordinateM) {
    slice.corrupt = fault::SlicePoseUnusable;
    return slice;
  }
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(raw.cells.data()),
                                            raw.cells.size());
  auto texture = cells::decodeCells(bytes, raw.width, raw.height, raw.resolution_m, raw.cell_format);
  if (texture) {
    slice.texture = std::move(*texture);
  } else {
    slice.corrupt = std::move(texture.error());
  }
  return slice;
}

}  // namespace

DecodedSubmap decode(const map::SubmapAnswer& answer) {
  DecodedSubmap decoded;
  decoded.key = answer.key;
  decoded.version = answer.version > 0 ? answer.version : std::max(answer.key.version, 0);
  decoded.bytes = answer.bytes;
  decoded.slices.reserve(answer.slices.size());
  for (const map::RawSlice& raw : answer.slices) decoded.slices.push_back(decodeSlice(raw));
  return decoded;
}

}  // namespace mapwright::submap
