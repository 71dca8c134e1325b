// Numbers inside packed records, as clouds of points have them. Source: sensor_msgs/PointField.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace mapwright::robot::wire {

/// The numbers are those of PointField.
enum class NumberType : std::uint8_t { I8 = 1, U8, I16, U16, I32, U32, F32, F64 };

inline std::size_t bytesOf(NumberType type) {
  constexpr std::array<std::size_t, 9> kBytes{0, 1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[std::size_t(type)];
}

inline bool isByte(NumberType type) { return bytesOf(type) == 1; }

struct PackedNumber {
  NumberType type = NumberType::F32;
  std::size_t offset = 0;  // in the record, in which it lies whole
  bool liesIn(std::size_t record_bytes) const {
    return bytesOf(type) <= record_bytes && offset <= record_bytes - bytesOf(type);
  }
};

template <typename T>
T rawNumber(const char* at, bool big_endian) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), at, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// As it is, which may be no number.
inline double numberAt(const char* record, const PackedNumber& number, bool big_endian = false) {
  const char* const at = record + number.offset;
  switch (number.type) {
    case NumberType::I8:
      return double(rawNumber<std::int8_t>(at, big_endian));
    case NumberType::U8:
      return double(rawNumber<std::uint8_t>(at, big_endian));
    case NumberType::I16:
      return double(rawNumber<std::int16_t>(at, big_endian));
    case NumberType::U16:
      return double(rawNumber<std::uint16_t>(at, big_endian));
    case NumberType::I32:
      return double(rawNumber<std::int32_t>(at, big_endian));
    case NumberType::U32:
      return double(rawNumber<std::uint32_t>(at, big_endian));
    case NumberType::F32:
      return double(rawNumber<float>(at, big_endian));
    case NumberType::F64:
      break;
  }
  return rawNumber<double>(at, big_endian);
}

}  // namespace mapwright::robot::wire
