#include "recording/ros_cbor.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <QCborStreamWriter>

namespace mapwright::recording {
namespace {

using Code = RosDecodeFault::Code;

constexpr std::size_t kMostValues = 20'000'000;
constexpr std::size_t kMostOfNothing = 65'536;         // items of a list that take no bytes
constexpr qsizetype kMostCbor = qsizetype(512) << 20;  // names may be many times as long as their values

class RosDecoder {
 public:
  RosDecoder(const RosSchema& schema, RosWire wire, std::span<const std::uint8_t> bytes)
      : schema_(schema), writer_(&out_), bytes_(bytes), cdr_(wire == RosWire::Cdr) {
    out_.reserve(qsizetype(bytes.size() + bytes.size() / 8 + 256));
    if (!cdr_) return;
    // Encapsulation: 0 and 1 are plain CDR, 6 and 7 plain CDR of version 2; odd ones are little-endian.
    const bool plain =
        bytes.size() >= 4 && bytes[0] == 0 && (bytes[1] <= 1 || bytes[1] == 6 || bytes[1] == 7);
    if (!plain) {
      fail(bytes.size() < 4 ? Code::CutOff : Code::NotThisEncoding);
      return;
    }
    swap_ = (bytes[1] & 1) == 0;
    most_alignment_ = bytes[1] >= 6 ? 4 : 8;
    bytes_ = bytes.subspan(4);
  }

  tl::expected<QByteArray, RosDecodeFault> decode() {
    if (!fault_) object(0);
    if (fault_) return tl::unexpected(std::move(*fault_));
    return std::move(out_);
  }

  std::size_t left() const { return bytes_.size() - at_; }

 private:
  void object(std::size_t index) {
    const RosType& type = schema_.types[index];
    writer_.startMap(type.fields.size());
    for (const RosField& field : type.fields) {
      write(field.name);
      name_ = &field.name;
      value(field);
      if (fault_) return;
    }
    if (cdr_ && type.fields.empty() && left() > 0) take(1);  // not every writer adds a byte for them
    writer_.endMap();
  }

  void value(const RosField& field) {
    if (field.many == RosField::Many::One) return one(field);
    const std::size_t count = field.many == RosField::Many::Fixed ? field.count : number<std::uint32_t>();
    if (fault_) return;
    if (const std::size_t size = sizeOf(field.kind); size != 0) {
      // An empty array is not aligned: it has no first item.
      if (count > 0) align(size);
      if (count > left() / size) return fail(Code::CutOff);
      return numbers(field.kind, take(count * size));
    }
    if (count > std::max(left(), kMostOfNothing)) return fail(Code::CutOff);
    writer_.startArray(count);
    for (std::size_t i = 0; i < count && !fault_; ++i) {
      one(field);
      name_ = &field.name;
    }
    if (!fault_) writer_.endArray();
  }

  void numbers(RosKind kind, std::span<const std::uint8_t> raw) {
    if (kind == RosKind::Flag) {  // a byte string would mean numbers
      writer_.startArray(raw.size());
      for (const std::uint8_t set : raw) writer_.append(set != 0);
      writer_.endArray();
      return;
    }
    visitNumber(kind, [&](auto zero) {
      if (kind != RosKind::Uint8) writer_.append(QCborTag(cborTagOf<decltype(zero)>(swap_)));
    });
    writer_.appendByteString(reinterpret_cast<const char*>(raw.data()), qsizetype(raw.size()));
  }

  void one(const RosField& field) {
    if (++values_ > kMostValues || out_.size() >= kMostCbor) return fail(Code::TooMany);
    const bool is_number = visitNumber(field.kind, [&](auto zero) {
      const auto value = number<decltype(zero)>();
      if (!fault_) write(value);
    });
    if (is_number) return;
    switch (field.kind) {
      case RosKind::Text: {
        const auto raw = take(number<std::uint32_t>());
        std::string_view text(reinterpret_cast<const char*>(raw.data()), raw.size());
        if (cdr_ && text.ends_with('\0'))
          text.remove_suffix(1);  // there its length includes the terminating zero
        return write(text);
      }
      case RosKind::Time:
        return time<std::uint32_t>();
      case RosKind::Duration:
        return time<std::int32_t>();
      case RosKind::WideText:  // there is no agreement on its character width
        return fail(Code::NotSupported);
      default:
        return object(field.type);
    }
  }

  template <typename Seconds>
  void time() {
    const auto seconds = number<Seconds>(), nanoseconds = number<Seconds>();
    writer_.startMap(2);
    write(std::string_view("secs"));
    write(seconds);
    write(std::string_view("nsecs"));
    write(nanoseconds);
    writer_.endMap();
  }

  void write(std::string_view text) { writer_.appendTextString(text.data(), qsizetype(text.size())); }
  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number>> write(Number value) {
    if constexpr (std::is_same_v<Number, bool> || std::is_floating_point_v<Number>) {
      writer_.append(std::conditional_t<std::is_same_v<Number, bool>, bool, double>(value));
    } else {
      writer_.append(std::conditional_t<std::is_signed_v<Number>, qint64, quint64>(value));
    }
  }

  void fail(Code code) {
    if (!fault_) fault_ = RosDecodeFault{code, name_ ? *name_ : std::string()};
  }

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
    if (raw.size() != sizeof(T)) return {};
    if constexpr (std::is_same_v<T, bool>) {
      return raw.front() != 0;
    } else {
      std::array<std::uint8_t, sizeof(T)> bytes;
      std::copy(raw.begin(), raw.end(), bytes.begin());
      if (swap_) std::reverse(bytes.begin(), bytes.end());
      return std::bit_cast<T>(bytes);
    }
  }

  const RosSchema& schema_;
  QByteArray out_;
  QCborStreamWriter writer_;
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

tl::expected<QByteArray, RosDecodeFault> rosToCbor(const RosSchema& schema, RosWire wire,
                                                   std::span<const std::uint8_t> bytes, std::size_t* left) {
  static_assert(std::endian::native == std::endian::little);
  RosDecoder decoder(schema, wire, bytes);
  auto cbor = decoder.decode();
  if (left) *left = decoder.left();
  return cbor;
}

}  // namespace mapwright::recording
