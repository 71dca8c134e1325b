// Reads protobuf messages by the definition in the file (MCAP: schema encoding "protobuf", a
// FileDescriptorSet). One thread.
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
  /// For the channel's message type. The error: its definition is missing or inconsistent.
  static tl::expected<ProtobufSchema, Fault> of(const recording::Channel& channel);
  ProtobufSchema(ProtobufSchema&&) noexcept;
  ProtobufSchema& operator=(ProtobufSchema&&) noexcept;
  ~ProtobufSchema();

  /// As CBOR: members by name, in the order of the definition. Members without presence are always included,
  /// others if set. Bytes are byte strings, enumerations numbers, lists of numbers typed arrays, maps
  /// objects.
  tl::expected<QByteArray, Fault> toCbor(std::span<const std::uint8_t> bytes) const;

 private:
  struct Parts;
  explicit ProtobufSchema(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace mapwright::robot::recorded
