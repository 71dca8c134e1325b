// The colours of heights and intensities: from blue over green to red, told apart by people who see few
// colours by their lightness.
#pragma once

#include <array>
#include <cstdint>

namespace mapwright::clouds {

/// 0x00RRGGBB, the least first.
using Shades = std::array<std::uint32_t, 256>;
const Shades& shades();

}  // namespace mapwright::clouds
