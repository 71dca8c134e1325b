// What a composed pixel carries beside its intensity: of the topmost texture that observed it. Pure; any
// thread.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace mapwright::render {

/// The low four bits of Composition::flags.
enum PixelFlag : std::uint8_t {
  kObserved = 1,
  kIncremental = 2,  // the topmost observed texture is_incremental
  kActive = 4,       // ... is not frozen
  kNearby = 8,       // ... is_nearby
};

inline constexpr int kClasses = 8;  // of each property

/// The classes of a submap by three properties, each 0 .. kClasses - 1. Higher ones are painted later, are
/// newer, or have seen more scans.
struct PixelClasses {
  int trajectory = 0, age = 0;
  int version = 0;  // or kUnknownVersion
};
inline constexpr int kUnknownVersion = kClasses;

/// Where a class lies in Composition::flags.
struct ClassBits {
  int shift = 0;
  unsigned mask = 15;
};
inline constexpr ClassBits kVersionBits{4, 15}, kAgeBits{8, 7}, kTrajectoryBits{11, 7};

/// The high bits of Composition::flags. The highest two stay 0: processors compare signed numbers faster.
constexpr std::uint16_t flagsOf(const PixelClasses& classes) {
  return std::uint16_t(classes.trajectory << kTrajectoryBits.shift | classes.age << kAgeBits.shift |
                       classes.version << kVersionBits.shift);
}

/// The flags of two samples as one pixel: all properties of both, and the classes of the one that is painted
/// later: the higher trajectory, then the newer. Associative and commutative, so it does not matter where
/// tiles are cut and in how many steps they are halved. Many at once: `all` of them or-ed, and the `highest`.
template <std::signed_integral Flags>
constexpr Flags united(Flags all, Flags highest) {
  constexpr Flags kProperties = 15;
  return Flags(highest | (all & kProperties));
}

}  // namespace mapwright::render
