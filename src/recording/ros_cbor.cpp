#include "recording/ros_cbor.h"

#include <cstdint>

#include <QCborStreamWriter>

namespace mapwright::recording {
namespace {

constexpr qsizetype kMost = qsizetype(512) << 20;  // names may be many times as long as their values

/// RFC 8746, section 2.1: little-endian ones.
std::uint64_t tagOf(RosKind kind) {
  switch (kind) {
    case RosKind::Uint16:
      return 69;
    case RosKind::Uint32:
      return 70;
    case RosKind::Uint64:
      return 71;
    case RosKind::Int8:
      return 72;
    case RosKind::Int16:
      return 77;
    case RosKind::Int32:
      return 78;
    case RosKind::Int64:
      return 79;
    case RosKind::Float32:
      return 85;
    case RosKind::Float64:
      return 86;
    default:
      return 0;
  }
}

class CborVisitor final : public RosVisitor {
 public:
  explicit CborVisitor(QByteArray& out) : out_(out), writer_(&out) {}

  bool takesMore() const override { return out_.size() < kMost; }
  void beginObject(const RosType& type) override { writer_.startMap(type.fields.size()); }
  void endObject() override { writer_.endMap(); }
  void member(std::string_view name) override { text(name); }
  void beginList(std::size_t count) override { writer_.startArray(count); }
  void endList() override { writer_.endArray(); }
  void flag(bool value) override { writer_.append(value); }
  void whole(std::int64_t value) override { writer_.append(qint64(value)); }
  void natural(std::uint64_t value) override { writer_.append(quint64(value)); }
  void real(double value) override { writer_.append(value); }
  void text(std::string_view value) override {
    writer_.appendTextString(value.data(), qsizetype(value.size()));
  }
  void time(std::int64_t seconds, std::int64_t nanoseconds) override {
    writer_.startMap(2);
    text("secs");
    whole(seconds);
    text("nsecs");
    whole(nanoseconds);
    writer_.endMap();
  }
  void numbers(const RosNumbers& numbers) override {
    if (numbers.kind == RosKind::Flag) {  // a byte string would mean numbers
      writer_.startArray(numbers.count());
      for (const std::uint8_t set : numbers.bytes) writer_.append(set != 0);
      writer_.endArray();
      return;
    }
    constexpr std::uint64_t kBigEndian = 4;  // the bit that is not set of those
    const std::uint64_t tag = tagOf(numbers.kind);
    const bool swapped = numbers.big_endian && sizeOf(numbers.kind) > 1;
    if (tag != 0) writer_.append(QCborTag(swapped ? tag - kBigEndian : tag));
    writer_.appendByteString(reinterpret_cast<const char*>(numbers.bytes.data()),
                             qsizetype(numbers.bytes.size()));
  }

 private:
  QByteArray& out_;
  QCborStreamWriter writer_;
};

}  // namespace

tl::expected<QByteArray, RosDecodeFault> rosToCbor(const RosSchema& schema, RosWire wire,
                                                   std::span<const std::uint8_t> bytes) {
  QByteArray out;
  out.reserve(qsizetype(bytes.size() + bytes.size() / 8 + 256));
  CborVisitor visitor(out);
  if (auto fault = decodeRos(schema, wire, bytes, visitor)) return tl::unexpected(std::move(*fault));
  return out;
}

}  // namespace mapwright::recording
