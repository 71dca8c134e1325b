#include "recorder/ros_encode.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "net/rosbridge/cbor_item.h"

namespace mapwright::recorder {
namespace {

using net::rosbridge::CborNumbers;
using net::rosbridge::Field;
using recording::RosField;
using recording::RosKind;
using recording::RosSchema;
using recording::RosType;

constexpr std::size_t kMost = std::size_t(512) << 20;
constexpr std::size_t kEncapsulation = 4;

bool isFloat(RosKind kind) { return kind == RosKind::Float32 || kind == RosKind::Float64; }

bool isUnsigned(RosKind kind) {
  return kind == RosKind::Uint8 || kind == RosKind::Uint16 || kind == RosKind::Uint32 ||
         kind == RosKind::Uint64;
}

bool lieTheSame(RosKind kind, const CborNumbers& numbers) {
  using Of = CborNumbers::Of;
  const Of of = isFloat(kind) ? Of::Float : isUnsigned(kind) ? Of::Unsigned : Of::Signed;
  const bool swapped = numbers.big_endian && numbers.width > 1;
  return kind != RosKind::Flag && numbers.of == of && numbers.width == recording::sizeOf(kind) && !swapped;
}

class Encoder {
 public:
  Encoder(const RosSchema& schema, recording::RosWire wire)
      : schema_(schema), cdr_(wire == recording::RosWire::Cdr) {
    if (cdr_) out_.assign("\0\1\0\0", kEncapsulation);
  }

  tl::expected<std::string, std::string> encode(const Field& message) {
    if (!object(0, message)) return tl::make_unexpected(name_);
    return std::move(out_);
  }

 private:
  using Member = std::pair<std::string_view, Field>;

  bool object(std::size_t index, const Field& value) {
    const RosType& type = schema_.types[index];
    if (!value.isObject()) return false;
    const std::size_t first = members_.size();
    value.members([&](std::string_view name, const Field& member) { members_.emplace_back(name, member); });
    bool fine = members_.size() - first == type.fields.size();
    for (std::size_t i = 0; fine && i < type.fields.size(); ++i) {
      const RosField& field = type.fields[i];
      const std::optional<Field> member = memberOf(type, field.name, first, i);
      fine = member && this->value(field, *member);
      if (!fine && name_.empty()) name_ = field.name;
    }
    if (fine && cdr_ && type.fields.empty()) out_ += '\0';
    members_.resize(first);
    return fine;
  }

  /// Of the object whose members begin at `first`; they are usually in the order of the schema.
  std::optional<Field> memberOf(const RosType& type, std::string_view name, std::size_t first,
                                std::size_t likely) const {
    const std::size_t count = members_.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      const Member& member = members_[first + (likely + i) % count];
      if (member.first == name || member.first == otherName(type, name)) return member.second;
    }
    return std::nullopt;
  }

  /// Both names for the parts of a time are in use.
  static std::string_view otherName(const RosType& type, std::string_view name) {
    const bool time = type.name == "builtin_interfaces/Time" || type.name == "builtin_interfaces/Duration";
    return !time ? name : name == "sec" ? "secs" : name == "nanosec" ? "nsecs" : name;
  }

  bool value(const RosField& field, const Field& value) {
    if (out_.size() > kMost) return false;
    return field.many == RosField::Many::One ? one(field, value) : many(field, value);
  }

  bool many(const RosField& field, const Field& value) {
    const std::size_t width = recording::sizeOf(field.kind);
    if (const std::optional<CborNumbers> numbers = value.typedArray();
        numbers && lieTheSame(field.kind, *numbers)) {
      if (!count(field, numbers->count)) return false;
      if (numbers->count > 0) align(width);
      out_.append(reinterpret_cast<const char*>(numbers->data), numbers->count * width);
      return true;
    }
    if (field.kind == RosKind::Uint8) {
      const std::optional<std::string> bytes = value.bytes(kMost);
      if (!bytes || !count(field, bytes->size())) return false;
      out_ += *bytes;
      return true;
    }
    if (!value.isList() || !count(field, value.size())) return false;
    bool fine = true;
    value.each([&](const Field& item) { fine = fine && out_.size() <= kMost && one(field, item); });
    return fine;
  }

  bool count(const RosField& field, std::size_t items) {
    if (items > std::numeric_limits<std::uint32_t>::max()) return false;
    if (field.many == RosField::Many::Fixed) return items == field.count;
    put(std::uint32_t(items));
    return true;
  }

  bool one(const RosField& field, const Field& value) {
    switch (field.kind) {
      case RosKind::Flag: {
        const std::optional<bool> flag = value.flag();
        if (flag) put(std::uint8_t(*flag));
        return flag.has_value();
      }
      case RosKind::Int8:
        return whole<std::int8_t>(value);
      case RosKind::Uint8:
        return whole<std::uint8_t>(value);
      case RosKind::Int16:
        return whole<std::int16_t>(value);
      case RosKind::Uint16:
        return whole<std::uint16_t>(value);
      case RosKind::Int32:
        return whole<std::int32_t>(value);
      case RosKind::Uint32:
        return whole<std::uint32_t>(value);
      case RosKind::Int64:
        return whole<std::int64_t>(value);
      case RosKind::Uint64:
        return natural(value);
      case RosKind::Float32:
        return real<float>(value);
      case RosKind::Float64:
        return real<double>(value);
      case RosKind::Text:
        return text(value);
      case RosKind::Time:
        return time<std::uint32_t>(value);
      case RosKind::Duration:
        return time<std::int32_t>(value);
      case RosKind::WideText:  // there is no agreement on its character width
        return false;
      case RosKind::Nested:
        return object(field.type, value);
    }
    return false;
  }

  template <typename T>
  bool whole(const Field& value) {
    const std::optional<std::int64_t> number = value.isNumber() ? value.integer() : std::nullopt;
    if (!number || !std::in_range<T>(*number)) return false;
    put(T(*number));
    return true;
  }

  bool natural(const Field& value) {
    const std::optional<std::uint64_t> number = value.isNumber() ? value.natural() : std::nullopt;
    if (number) put(*number);
    return number.has_value();
  }

  template <typename T>
  bool real(const Field& value) {
    const std::optional<double> number = value.real();
    if (number) put(T(*number));
    return number.has_value();
  }

  bool text(const Field& value) {
    if (!value.isText()) return false;
    const std::string text = value.text();
    put(std::uint32_t(text.size() + (cdr_ ? 1 : 0)));  // there its length includes the terminating zero
    out_ += text;
    if (cdr_) out_ += '\0';
    return true;
  }

  template <typename T>
  bool time(const Field& value) {
    for (const auto& [seconds, nanoseconds] : {std::pair("secs", "nsecs"), std::pair("sec", "nanosec")}) {
      if (const Field whole = value[seconds])
        return this->whole<T>(whole) && this->whole<T>(value[nanoseconds]);
    }
    return false;
  }

  void align(std::size_t size) {
    if (!cdr_) return;
    const std::size_t at = out_.size() - kEncapsulation;
    out_.append((size - at % size) % size, '\0');
  }

  template <typename T>
  void put(T value) {
    static_assert(std::endian::native == std::endian::little);
    align(sizeof(T));
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    out_.append(raw.data(), raw.size());
  }

  const RosSchema& schema_;
  bool cdr_;
  std::string out_, name_;
  std::vector<Member> members_;  // of the objects being written
};

}  // namespace

tl::expected<std::string, std::string> encodeRos(const RosSchema& schema, recording::RosWire wire,
                                                 const Field& message) {
  return Encoder(schema, wire).encode(message);
}

}  // namespace mapwright::recorder
