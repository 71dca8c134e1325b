#include "recorder/ros_encode.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
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

bool lieTheSame(RosKind kind, const CborNumbers& numbers) {
  using Of = CborNumbers::Of;
  bool same = false;
  recording::visitNumber(kind, [&]<typename T>(T) {
    const Of of = std::is_floating_point_v<T> ? Of::Float : std::is_signed_v<T> ? Of::Signed : Of::Unsigned;
    const bool swapped = numbers.big_endian && numbers.width > 1;
    same = !std::is_same_v<T, bool> && numbers.of == of && numbers.width == sizeof(T) && !swapped;
  });
  return same;
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
    bool fine = false;
    if (recording::visitNumber(field.kind, [&]<typename T>(T) { fine = number<T>(value); })) return fine;
    switch (field.kind) {
      case RosKind::Text:
        return text(value);
      case RosKind::Time:
        return time<std::uint32_t>(value);
      case RosKind::Duration:
        return time<std::int32_t>(value);
      case RosKind::Nested:
        return object(field.type, value);
      default:  // WideText: there is no agreement on its character width
        return false;
    }
  }

  template <typename T>
  bool number(const Field& value) {
    const auto putIf = [&](const auto& read) {
      if (read) put(T(*read));
      return read.has_value();
    };
    if constexpr (std::is_same_v<T, bool>) {
      return putIf(value.flag());
    } else if constexpr (std::is_floating_point_v<T>) {
      return putIf(value.real());
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
      return value.isNumber() && putIf(value.natural());
    } else {
      const std::optional<std::int64_t> whole = value.isNumber() ? value.integer() : std::nullopt;
      return whole && std::in_range<T>(*whole) && putIf(whole);
    }
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
      if (const Field whole = value[seconds]) return number<T>(whole) && number<T>(value[nanoseconds]);
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
    out_.append(reinterpret_cast<const char*>(&value), sizeof(T));
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
