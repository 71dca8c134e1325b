// What to paint with, and the kind of a cell. Pure values.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "grids/grid_pyramid.h"

namespace mapwright::picture {

enum class Kind : std::uint8_t { Free, Occupied, Unknown };
inline constexpr int kKinds = 3;

/// The kind of every byte of a code. Occupied: 50 % or more.
std::array<Kind, 256> kindsOf(grids::CellCode code);
/// The byte to paint a kind with; nullopt: the code has none (unknown in a picture where every gray is a
/// value).
std::optional<std::uint8_t> byteOf(Kind kind, grids::CellCode code);

/// The first byte among the cells of a grid that is not one of `held`; nullopt: there is none, or it was
/// cancelled.
std::optional<std::uint8_t> firstOther(const grids::GridPyramid& cells, const std::array<bool, 256>& held,
                                       const std::atomic<bool>& cancelled);

/// A byte, or the cells of another grid of the same size and code at the same positions (to revert changes).
struct Ink {
  std::uint8_t byte = 0;
  std::shared_ptr<const grids::GridPyramid> from = {};
};

}  // namespace mapwright::picture
