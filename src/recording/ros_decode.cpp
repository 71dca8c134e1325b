#include "recording/ros_decode.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace mapwright::recording {
namespace {

using Code = RosDecodeFault::Code;

constexpr std::size_t kMostValues = 20'000'000;
constexpr std::size_t kMostOfNothing = 65'536;  // items of a list that take no bytes

template <typename T>
T swapped(T value) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  std::reverse(raw.begin(), raw.end());
  std::memcpy(&value, raw.data(), sizeof(T));
  return value;
}

class Decoder {
 public:
  Decoder(const RosSchema& schema, RosWire wire, std::span<const std::uint8_t> bytes, RosVisitor& visitor)
      : schema_(schema), visitor_(visitor), bytes_(bytes), cdr_(wire == RosWire::Cdr) {
    if (!cdr_) return;
    // Encapsulation: 0 and 1 are plain CDR, 6 and 7 plain CDR of version 2; odd ones are little-endian.
    const bool plain =
        bytes.size() >= 4 && bytes[0] == 0 && (bytes[1] <= 1 || bytes[1] == 6 || bytes[1] == 7);
    if (!plain) {
      fault_ = RosDecodeFault{bytes.size() < 4 ? Code::CutOff : Code::NotThisEncoding, {}};
      return;
    }
    swap_ = (bytes[1] & 1) == 0;
    most_alignment_ = bytes[1] >= 6 ? 4 : 8;
    bytes_ = bytes.subspan(4);
  }

  std::optional<RosDecodeFault> decode() {
    if (!fault_) object(0);
    return std::move(fault_);
  }

 private:
  void object(std::size_t index) {
    const RosType& type = schema_.types[index];
    visitor_.beginObject(type);
    for (const RosField& field : type.fields) {
      visitor_.member(field.name);
      name_ = &field.name;
      value(field);
      if (fault_) return;
    }
    if (cdr_ && type.fields.empty() && left() > 0) take(1);  // not every writer adds a byte for them
    if (!fault_) visitor_.endObject();
  }

  void value(const RosField& field) {
    if (field.many == RosField::Many::One) return one(field);
    const std::size_t count = field.many == RosField::Many::Fixed ? field.count : number<std::uint32_t>();
    if (fault_) return;
    if (const std::size_t size = sizeOf(field.kind); size != 0) {
      // An empty array is not aligned: it has no first item.
      if (count > 0) align(size);
      if (count > left() / size) return fail(Code::CutOff);
      visitor_.numbers({field.kind, swap_, take(count * size)});
      return;
    }
    if (count > std::max(left(), kMostOfNothing)) return fail(Code::CutOff);
    visitor_.beginList(count);
    for (std::size_t i = 0; i < count && !fault_; ++i) {
      one(field);
      name_ = &field.name;
    }
    if (!fault_) visitor_.endList();
  }

  void one(const RosField& field) {
    if (++values_ > kMostValues || !visitor_.takesMore()) return fail(Code::TooMany);
    switch (field.kind) {
      case RosKind::Flag: {
        const bool set = number<std::uint8_t>() != 0;
        return give([&] { visitor_.flag(set); });
      }
      case RosKind::Int8:
        return whole<std::int8_t>();
      case RosKind::Uint8:
        return whole<std::uint8_t>();
      case RosKind::Int16:
        return whole<std::int16_t>();
      case RosKind::Uint16:
        return whole<std::uint16_t>();
      case RosKind::Int32:
        return whole<std::int32_t>();
      case RosKind::Uint32:
        return whole<std::uint32_t>();
      case RosKind::Int64:
        return whole<std::int64_t>();
      case RosKind::Uint64: {
        const auto natural = number<std::uint64_t>();
        return give([&] { visitor_.natural(natural); });
      }
      case RosKind::Float32: {
        const auto real = double(number<float>());
        return give([&] { visitor_.real(real); });
      }
      case RosKind::Float64: {
        const auto real = number<double>();
        return give([&] { visitor_.real(real); });
      }
      case RosKind::Text: {
        const auto raw = take(number<std::uint32_t>());
        std::string_view text(reinterpret_cast<const char*>(raw.data()), raw.size());
        if (cdr_ && text.ends_with('\0'))
          text.remove_suffix(1);  // there its length includes the terminating zero
        return give([&] { visitor_.text(text); });
      }
      case RosKind::Time: {
        const auto seconds = number<std::uint32_t>();
        const auto nanoseconds = number<std::uint32_t>();
        return give([&] { visitor_.time(seconds, nanoseconds); });
      }
      case RosKind::Duration: {
        const auto seconds = number<std::int32_t>();
        const auto nanoseconds = number<std::int32_t>();
        return give([&] { visitor_.time(seconds, nanoseconds); });
      }
      case RosKind::WideText:  // there is no agreement on its character width
        return fail(Code::NotSupported);
      case RosKind::Nested:
        return object(field.type);
    }
  }

  template <typename T>
  void whole() {
    const auto value = std::int64_t(number<T>());
    give([&] { visitor_.whole(value); });
  }

  template <typename Give>
  void give(const Give& give) {
    if (!fault_) give();
  }

  void fail(Code code) {
    if (!fault_) fault_ = RosDecodeFault{code, name_ ? *name_ : std::string()};
  }

  std::size_t left() const { return bytes_.size() - at_; }

  void align(std::size_t size) {
    if (!cdr_) return;
    const std::size_t to = std::min(size, most_alignment_);
    take((to - at_ % to) % to);
  }

  std::span<const std::uint8_t> take(std::size_t count) {
    if (fault_ || count > left()) {
      fail(Code::CutOff);
      return {};
    }
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  template <typename T>
  T number() {
    align(sizeof(T));
    const auto raw = take(sizeof(T));
    T value{};
    if (raw.size() == sizeof(T)) std::memcpy(&value, raw.data(), sizeof(T));
    return swap_ ? swapped(value) : value;
  }

  const RosSchema& schema_;
  RosVisitor& visitor_;
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool cdr_ = false, swap_ = false;
  std::size_t most_alignment_ = 1;
  std::size_t values_ = 0;
  const std::string* name_ = nullptr;
  std::optional<RosDecodeFault> fault_;
};

}  // namespace

std::optional<RosWire> rosWire(std::string_view message_encoding) {
  if (message_encoding == "ros1") return RosWire::Ros1;
  if (message_encoding == "cdr") return RosWire::Cdr;
  return std::nullopt;
}

std::optional<RosDecodeFault> decodeRos(const RosSchema& schema, RosWire wire,
                                        std::span<const std::uint8_t> bytes, RosVisitor& visitor) {
  static_assert(std::endian::native == std::endian::little);
  return Decoder(schema, wire, bytes, visitor).decode();
}

}  // namespace mapwright::recording
