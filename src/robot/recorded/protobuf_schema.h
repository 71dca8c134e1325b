// Messages of protobuf by the definition that stands in the file (MCAP: schema encoding "protobuf", a
// FileDescriptorSet), as values. One thread.
#pragma once

#include <memory>
#include <span>
#include <string>

#include <QByteArray>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "recording/message.h"

namespace mapwright::robot::recorded {

class ProtobufSchema {
 public:
  /// Of the channel's message type. The reason: its definition is not there, or does not hold together.
  static tl::expected<ProtobufSchema, Fault> of(const recording::Channel& channel);
  ProtobufSchema(ProtobufSchema&&) noexcept;
  ProtobufSchema& operator=(ProtobufSchema&&) noexcept;
  ~ProtobufSchema();

  /// As CBOR: members by their names, in the order of the definition. What has no presence is there with its
  /// zero or empty, all else where it was set. Bytes are a byte string, enumerations numbers, lists of
  /// numbers typed arrays, maps objects.
  tl::expected<QByteArray, Fault> toCbor(std::span<const std::uint8_t> bytes) const;

 private:
  struct Parts;
  explicit ProtobufSchema(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace mapwright::robot::recorded
