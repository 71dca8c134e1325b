#include "packed/png_unfilter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace mapwright::packed {

namespace {

std::uint8_t paeth(int left, int above, int corner) {
  const int to_left = std::abs(above - corner);
  const int to_above = std::abs(left - corner);
  const int to_corner = std::abs(left + above - 2 * corner);
  const int upper = to_above <= to_corner ? above : corner;
  return std::uint8_t(to_left <= to_above && to_left <= to_corner ? left : upper);
}

void subRow(const std::uint8_t* in, std::size_t bytes, std::size_t unit, std::uint8_t* out) {
  std::memcpy(out, in, std::min(unit, bytes));
  if (unit == 1) {
    std::uint8_t left = in[0];
    for (std::size_t n = 1; n < bytes; ++n) out[n] = left = std::uint8_t(left + in[n]);
    return;
  }
  for (std::size_t n = unit; n < bytes; ++n) out[n] = std::uint8_t(in[n] + out[n - unit]);
}

void paethRow(const std::uint8_t* in, const std::uint8_t* above, std::size_t bytes, std::size_t unit,
              std::uint8_t* out) {
  for (std::size_t n = 0; n < std::min(unit, bytes); ++n) out[n] = std::uint8_t(in[n] + above[n]);
  if (unit == 1) {
    int left = out[0], corner = above[0];
    for (std::size_t n = 1; n < bytes; ++n) {
      left = std::uint8_t(in[n] + paeth(left, above[n], corner));
      corner = above[n];
      out[n] = std::uint8_t(left);
    }
    return;
  }
  for (std::size_t n = unit; n < bytes; ++n) {
    out[n] = std::uint8_t(in[n] + paeth(out[n - unit], above[n], above[n - unit]));
  }
}

}  // namespace

bool unfilterRow(int filter, const std::uint8_t* in, const std::uint8_t* above, std::size_t bytes,
                 std::size_t unit, std::uint8_t* out) {
  if (bytes == 0) return filter <= 4;
  switch (filter) {
    case 0:
      std::memcpy(out, in, bytes);
      return true;
    case 1:
      subRow(in, bytes, unit, out);
      return true;
    case 2:
      for (std::size_t n = 0; n < bytes; ++n) out[n] = std::uint8_t(in[n] + above[n]);
      return true;
    case 3:
      for (std::size_t n = 0; n < std::min(unit, bytes); ++n) out[n] = std::uint8_t(in[n] + above[n] / 2);
      for (std::size_t n = unit; n < bytes; ++n) {
        out[n] = std::uint8_t(in[n] + (out[n - unit] + above[n]) / 2);
      }
      return true;
    case 4:
      paethRow(in, above, bytes, unit, out);
      return true;
    default:
      return false;
  }
}

void unpackBits(const std::uint8_t* in, std::size_t samples, int bits, std::uint8_t* out) {
  const std::uint8_t mask = std::uint8_t((1 << bits) - 1);
  const std::size_t in_byte = 8 / std::size_t(bits);
  for (std::size_t n = 0; n < samples; ++n) {
    const int shift = 8 - bits - int(n % in_byte) * bits;
    out[n] = std::uint8_t(in[n / in_byte] >> shift) & mask;
  }
}

}  // namespace mapwright::packed
