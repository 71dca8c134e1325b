// Reverses the filters of PNG rows. Pure functions, any thread. Source: PNG specification (third edition),
// "Filtering".
#pragma once

#include <cstddef>
#include <cstdint>

namespace mapwright::packed {

/// Writes the row to `out` from its filtered bytes `in`; `above` is the row above (zeros for the first).
/// `unit`: bytes per pixel, at least 1. False: unknown filter.
bool unfilterRow(int filter, const std::uint8_t* in, const std::uint8_t* above, std::size_t bytes,
                 std::size_t unit, std::uint8_t* out);
/// Expands samples of 1, 2 or 4 bits to one byte each.
void unpackBits(const std::uint8_t* in, std::size_t samples, int bits, std::uint8_t* out);

}  // namespace mapwright::packed
