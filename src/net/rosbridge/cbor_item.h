// Items of CBOR where they lie (RFC 8949), and arrays of numbers as byte strings (RFC 8746).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <variant>

namespace mapwright::net::rosbridge {

/// Lies deeper than this: not read.
inline constexpr int kMaxDepth = 128;

enum class CborFault { None, Broken, TooDeep };
/// Whether [at, end) is exactly one item, with every length inside of it true. Takes no memory. All that
/// follows may be asked about bytes only that this found whole.
CborFault lookThrough(const std::uint8_t* at, const std::uint8_t* end);

/// A whole number is std::int64_t where that holds it, std::uint64_t beyond.
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
  enum class Type { Null, Whole, Natural, Real, Flag, Text, Numbers, List, Object };

  /// Tags without a meaning for us are passed over. Null is also: undefined, numbers that are not finite or
  /// beyond 64 bits, strings in chunks, typed arrays of 128-bit floats or of half an element.
  static CborItem at(const std::uint8_t* at, const std::uint8_t* end);

  Type type = Type::Null;
  std::int64_t whole = 0;
  std::uint64_t natural = 0;  // beyond `whole`
  double real = 0;            // of Null, too: a number that is not finite, else 0
  bool flag = false;
  std::string_view text;  // as it came, maybe no UTF-8
  CborNumbers numbers;
  std::optional<std::uint64_t> count;    // of a List or Object, unless its end is marked
  const std::uint8_t* inside = nullptr;  // the first item of a List or Object
};

/// Behind the item at `at`.
const std::uint8_t* pastItem(const std::uint8_t* at, const std::uint8_t* end);
/// Calls `take` with the place of each item of a List, until it answers false.
void eachItem(const CborItem& list, const std::uint8_t* end,
              const std::function<bool(const std::uint8_t*)>& take);
/// As eachItem, of the pairs of an Object whose name is a text.
void eachMember(const CborItem& object, const std::uint8_t* end,
                const std::function<bool(std::string_view, const std::uint8_t*)>& take);

}  // namespace mapwright::net::rosbridge
