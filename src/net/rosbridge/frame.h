// A rosbridge frame, parsed once (rosbridge v2: JSON text frames, "png" compression, "cbor" binary frames).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include <QByteArray>

#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {

/// The parsed data that its fields point into. Immutable, may be shared between threads. Memory: for JSON
/// about twice the text, nine times if it is all small numbers; for CBOR the frame itself.
class Frame {
 public:
  enum class Wire { Text, Binary };
  enum class Fault {
    None,
    TooLarge,  // too long, or not enough memory
    TooDeep,   // objects in objects, over 128
    NotJson,   // not even almost: NaN and infinities are read as null
    NotCbor,
    NotAPicture,  // the data of {"op":"png"} is not an RGB PNG, or contains no message
  };

  /// Never null: an unreadable frame has a fault() and a null root(). {"op":"png"} is unwrapped: the root is
  /// the message inside the picture. `bytes` must own its data (not QByteArray::fromRawData), since a CBOR
  /// frame shares it. `max_bytes`: of the frame, and of the text in a picture.
  static std::shared_ptr<const Frame> read(const QByteArray& bytes, Wire wire,
                                           std::size_t max_bytes = std::size_t(256) << 20);
  ~Frame();
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  Field root() const { return root_; }
  Fault fault() const { return fault_; }
  Wire wire() const { return wire_; }
  qint64 bytes() const { return bytes_; }  // as received
  /// A member of the root exactly as received, valid as long as the frame: the text of a JSON object, or a
  /// CBOR item; for {"op":"png"} that of the message inside. nullopt: missing. Scans the JSON.
  std::optional<std::string_view> rawMember(std::string_view name) const;

 private:
  struct Json;
  Frame();
  void readText(const QByteArray& utf8, std::size_t max_bytes);
  void readBinary(const QByteArray& bytes);
  Fault parse(const QByteArray& utf8);

  std::unique_ptr<Json> json_;
  QByteArray text_, cbor_;
  Field root_;
  Fault fault_ = Fault::None;
  Wire wire_ = Wire::Text;
  qint64 bytes_ = 0;
};

/// The bytes of the pixels of an RGB PNG, row by row, without the newlines that pad the last row ("png
/// compression"). nullopt: not such a picture, or more than `max` bytes. Allocates memory only for as many
/// pixels as the picture's length can contain.
std::optional<QByteArray> textOfPng(std::string_view png, std::size_t max);

}  // namespace mapwright::net::rosbridge
