// CBOR items in place (RFC 8949), and arrays of numbers as byte strings (RFC 8746).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <variant>

namespace mapwright::net::rosbridge {

/// Anything nested deeper is not read.
inline constexpr int kMaxDepth = 128;

enum class CborFault { None, Broken, TooDeep };
/// Whether [at, end) is exactly one valid item, with all lengths inside correct. Allocates no memory. The
/// functions below require bytes that passed this check.
CborFault lookThrough(const std::uint8_t* at, const std::uint8_t* end);

/// A whole number is std::int64_t if it fits, otherwise std::uint64_t.
using CborNumber = std::variant<std::int64_t, std::uint64_t, double>;

/// Numbers side by side.
struct CborNumbers {
  enum class Of { Unsigned, Signed, Float };
  Of of = Of::Unsigned;
  std::size_t width = 1;  // bytes of one
  bool big_endian = false;
  const std::uint8_t* data = nullptr;
  std::size_t count = 0;

  CborNumber at(std::size_t index) const;
};

struct CborItem {
  enum class Type { Null, Number, Flag, Text, Numbers, List, Object };

  /// Unknown tags are skipped. The following become Null as well: undefined, numbers beyond 64 bits, chunked
  /// strings, typed arrays of 128-bit floats or with half an element.
  static CborItem at(const std::uint8_t* at, const std::uint8_t* end);

  Type type = Type::Null;
  CborNumber number;  // may be not finite
  bool flag = false;
  std::string_view text;  // as received, may be invalid UTF-8
  CborNumbers numbers;
  std::optional<std::uint64_t> count;    // of a List or Object of definite length
  const std::uint8_t* inside = nullptr;  // the first item of a List or Object
};

/// The end of the item at `at`.
const std::uint8_t* pastItem(const std::uint8_t* at, const std::uint8_t* end);
/// Calls `visit` with the address of each item of a List, until it returns false.
void eachItem(const CborItem& list, const std::uint8_t* end,
              const std::function<bool(const std::uint8_t*)>& visit);
/// Like eachItem, for the pairs of an Object whose name is a text.
void eachMember(const CborItem& object, const std::uint8_t* end,
                const std::function<bool(std::string_view, const std::uint8_t*)>& visit);

}  // namespace mapwright::net::rosbridge
