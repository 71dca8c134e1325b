// A frame of rosbridge, read once (rosbridge v2: JSON text frames, "png" compression, "cbor" binary frames).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include <QByteArray>

#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {

struct FrameLimits {
  std::size_t max_bytes = std::size_t(256) << 20;  // of the frame, and of the text in a picture
};

/// What was read, and what its fields look into. Does not change, may be shared among threads.
/// Memory: of JSON about twice as much as the text, nine times that if it is all small numbers; of CBOR the
/// frame itself.
class Frame {
 public:
  enum class Wire { Text, Binary };
  enum class Fault {
    None,
    TooLarge,  // longer than FrameLimits, or more than there is memory for
    TooDeep,   // objects in objects, over 128
    NotJson,   // nor nearly: NaN and infinities are read as null
    NotCbor,
    NotAPicture,  // the data of {"op":"png"} are no RGB PNG, or it holds no message
  };

  /// Never null: what cannot be read has a fault() and a null root(). A {"op":"png"} is unwrapped: the root
  /// is the message that its picture holds.
  /// `bytes` own what they hold (not QByteArray::fromRawData): a CBOR frame shares them.
  static std::shared_ptr<const Frame> read(const QByteArray& bytes, Wire wire,
                                           const FrameLimits& limits = {});
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  Field root() const { return root_; }
  Fault fault() const { return fault_; }
  Wire wire() const { return wire_; }
  qint64 bytes() const { return bytes_; }  // as they came
  /// A member of the root exactly as it came, valid as long as the frame: the text of a JSON object, or an
  /// item of CBOR; of a {"op":"png"} that of the message in it. nullopt: there is no such one. JSON is looked
  /// through for it.
  std::optional<std::string_view> rawMember(std::string_view name) const;

 private:
  struct Json;
  Frame();
  void readText(const QByteArray& utf8, const FrameLimits& limits);
  void readBinary(const QByteArray& bytes);
  Fault parse(const QByteArray& utf8);

  std::unique_ptr<Json> json_;
  QByteArray text_, cbor_;
  Field root_;
  Fault fault_ = Fault::None;
  Wire wire_ = Wire::Text;
  qint64 bytes_ = 0;
};

}  // namespace mapwright::net::rosbridge
