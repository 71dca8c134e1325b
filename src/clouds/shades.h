// The colours of heights and intensities: from blue over green to red, with increasing lightness so that
// colour-blind people can tell them apart.
#pragma once

#include <array>
#include <cstdint>

namespace mapwright::clouds {

/// 0x00RRGGBB, lowest first.
using Shades = std::array<std::uint32_t, 256>;
const Shades& shades();

}  // namespace mapwright::clouds
