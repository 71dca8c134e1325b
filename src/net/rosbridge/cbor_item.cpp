#include "net/rosbridge/cbor_item.h"

#include <bit>
#include <limits>

#include <QFloat16>

namespace mapwright::net::rosbridge {
namespace {

enum Major : std::uint8_t { kUnsigned, kNegative, kBytes, kText, kArray, kMap, kTag, kSimple };

constexpr std::uint8_t kMarkedEnd = 31, kBreak = 0xff;

struct Head {
  std::uint8_t major = 0, info = 0;
  std::uint64_t value = 0;
  const std::uint8_t* next = nullptr;  // nullptr: cut off, or invalid
  bool marked() const { return info == kMarkedEnd; }
};

std::uint64_t bigEndian(const std::uint8_t* at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | at[i];
  return value;
}

Head headAt(const std::uint8_t* at, const std::uint8_t* end) {
  Head head;
  if (at == end) return head;
  head.major = std::uint8_t(*at >> 5);
  head.info = *at & 31;
  ++at;
  if (head.info < 24) {
    head.value = head.info;
    head.next = at;
  } else if (head.info < 28) {
    const std::size_t bytes = std::size_t(1) << (head.info - 24);
    if (std::size_t(end - at) < bytes) return head;
    head.value = bigEndian(at, bytes);
    head.next = at + bytes;
  } else if (head.marked() && (head.major >= kBytes && head.major <= kMap)) {
    head.next = at;
  }
  return head;
}

bool atBreak(const std::uint8_t* at, const std::uint8_t* end) { return at != end && *at == kBreak; }

/// Checks one item; moves `at` past it.
CborFault look(const std::uint8_t*& at, const std::uint8_t* end, int depth) {
  if (depth > kMaxDepth) return CborFault::TooDeep;
  const Head head = headAt(at, end);
  if (head.next == nullptr) return CborFault::Broken;
  at = head.next;
  const auto lookAtNext = [&] { return look(at, end, depth + 1); };
  switch (head.major) {
    case kBytes:
    case kText:
      if (!head.marked()) {
        if (std::uint64_t(end - at) < head.value) return CborFault::Broken;
        at += head.value;
        return CborFault::None;
      }
      while (!atBreak(at, end)) {
        const Head chunk = headAt(at, end);
        if (chunk.next == nullptr || chunk.major != head.major || chunk.marked() ||
            std::uint64_t(end - chunk.next) < chunk.value)
          return CborFault::Broken;
        at = chunk.next + chunk.value;
      }
      ++at;
      return CborFault::None;
    case kArray:
    case kMap: {
      const std::uint64_t each = head.major == kMap ? 2 : 1;
      // Every item takes at least a byte: impossible counts are rejected before any work.
      if (!head.marked() && head.value > std::uint64_t(end - at) / each) return CborFault::Broken;
      for (std::uint64_t i = 0; head.marked() ? !atBreak(at, end) : i < head.value; ++i) {
        for (std::uint64_t part = 0; part < each; ++part) {
          if (const CborFault fault = lookAtNext(); fault != CborFault::None) return fault;
        }
      }
      at += head.marked() ? 1 : 0;
      return CborFault::None;
    }
    case kTag:
      return lookAtNext();
    default:
      return CborFault::None;
  }
}

double floatOf(std::uint64_t bits, std::size_t width) {
  if (width == 2) return double(std::bit_cast<qfloat16>(std::uint16_t(bits)));
  if (width == 4) return double(std::bit_cast<float>(std::uint32_t(bits)));
  return std::bit_cast<double>(bits);
}

/// RFC 8746, section 2.1: the tag is 0b010'f's'e'll.
std::optional<CborNumbers> numbersTagged(std::uint64_t tag) {
  if (tag < 64 || tag > 87 || tag == 76) return std::nullopt;
  const bool is_float = tag & 16;
  const bool is_signed = tag & 8;
  CborNumbers numbers;
  numbers.of = is_float    ? CborNumbers::Of::Float
               : is_signed ? CborNumbers::Of::Signed
                           : CborNumbers::Of::Unsigned;
  // For floats the sign bit is unused: 80..83 are big-endian, 84..87 little-endian.
  numbers.width = std::size_t(is_float ? 2 : 1) << (tag & 3);
  numbers.big_endian = (tag & 4) == 0;
  return numbers;
}

constexpr std::uint64_t kMostWhole = std::uint64_t(std::numeric_limits<std::int64_t>::max());

/// As std::int64_t where it fits.
CborNumber wholeNumber(std::uint64_t value) {
  return value > kMostWhole ? CborNumber(value) : CborNumber(std::int64_t(value));
}

}  // namespace

CborFault lookThrough(const std::uint8_t* at, const std::uint8_t* end) {
  const CborFault fault = look(at, end, 1);
  return fault == CborFault::None && at != end ? CborFault::Broken : fault;
}

CborNumber CborNumbers::at(std::size_t index) const {
  const std::uint8_t* from = data + index * width;
  std::uint64_t bits = 0;
  if (big_endian) {
    bits = bigEndian(from, width);
  } else {
    for (std::size_t i = width; i > 0; --i) bits = bits << 8 | from[i - 1];
  }
  if (of == Of::Float) return floatOf(bits, width);
  if (of == Of::Signed) {
    const unsigned unused = unsigned(64 - 8 * width);
    return std::int64_t(bits << unused) >> unused;
  }
  return wholeNumber(bits);
}

CborItem CborItem::at(const std::uint8_t* at, const std::uint8_t* end) {
  CborItem item;
  Head head = headAt(at, end);
  std::uint64_t tag = 0;
  while (head.major == kTag) {
    tag = head.value;
    head = headAt(head.next, end);
  }
  switch (head.major) {
    case kUnsigned:
      item.type = Type::Number;
      item.number = wholeNumber(head.value);
      break;
    case kNegative:
      item.type = Type::Number;
      if (head.value > kMostWhole) {
        item.number = -1.0 - double(head.value);
      } else {
        item.number = -1 - std::int64_t(head.value);
      }
      break;
    case kBytes: {
      constexpr std::uint64_t kBigNumber = 2, kNegativeBigNumber = 3;
      if (head.marked() || tag == kBigNumber || tag == kNegativeBigNumber) break;
      const bool typed = tag >= 64 && tag <= 87;
      const std::optional<CborNumbers> numbers = typed ? numbersTagged(tag) : CborNumbers();
      if (!numbers || numbers->width > 8 || head.value % numbers->width != 0) break;
      item.type = Type::Numbers;
      item.numbers = *numbers;
      item.numbers.data = head.next;
      item.numbers.count = std::size_t(head.value / numbers->width);
      break;
    }
    case kText:
      if (head.marked()) break;
      item.type = Type::Text;
      item.text = {reinterpret_cast<const char*>(head.next), std::size_t(head.value)};
      break;
    case kArray:
    case kMap:
      item.type = head.major == kArray ? Type::List : Type::Object;
      if (!head.marked()) item.count = head.value;
      item.inside = head.next;
      break;
    default:
      if (head.info == 20 || head.info == 21) {
        item.type = Type::Flag;
        item.flag = head.info == 21;
      } else if (head.info >= 25 && head.info <= 27) {
        item.type = Type::Number;
        item.number = floatOf(head.value, std::size_t(1) << (head.info - 24));
      }
  }
  return item;
}

const std::uint8_t* pastItem(const std::uint8_t* at, const std::uint8_t* end) {
  look(at, end, 1);
  return at;
}

void eachItem(const CborItem& list, const std::uint8_t* end,
              const std::function<bool(const std::uint8_t*)>& visit) {
  const std::uint8_t* at = list.inside;
  for (std::uint64_t i = 0; list.count ? i < *list.count : !atBreak(at, end); ++i) {
    if (!visit(at)) return;
    at = pastItem(at, end);
  }
}

void eachMember(const CborItem& object, const std::uint8_t* end,
                const std::function<bool(std::string_view, const std::uint8_t*)>& visit) {
  const std::uint8_t* at = object.inside;
  for (std::uint64_t i = 0; object.count ? i < *object.count : !atBreak(at, end); ++i) {
    const CborItem name = CborItem::at(at, end);
    const std::uint8_t* const value = pastItem(at, end);
    if (name.type == CborItem::Type::Text && !visit(name.text, value)) return;
    at = pastItem(value, end);
  }
}

}  // namespace mapwright::net::rosbridge
