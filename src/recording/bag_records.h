// The records of ROS 1 bags, as stored in a file. Pure functions, any thread. Source: "ROS bag format 2.0":
// <header_len><header><data_len><data>, headers of <len>name=value.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/byte_reader.h"
#include "recording/message.h"

namespace mapwright::recording::bag {

inline constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
inline constexpr std::uint32_t kMostHeader = 1 << 20;  // bytes: the longest field is a topic

enum class Op : std::uint8_t {
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7
};

/// The fields of a record's header, views into its bytes.
class Fields {
 public:
  /// nullopt: they do not fill the bytes exactly, or one has no name.
  static std::optional<Fields> in(std::span<const std::uint8_t> header);

  std::optional<std::span<const std::uint8_t>> find(std::string_view name) const;
  /// Little-endian; nullopt if it is missing or of another size.
  template <typename T>
  std::optional<T> number(std::string_view name) const {
    const auto value = find(name);
    if (!value || value->size() != sizeof(T)) return std::nullopt;
    return ByteReader(*value).number<T>();
  }
  std::optional<Op> op() const;
  /// A ROS time in nanoseconds: seconds and nanoseconds, 32 bits each.
  std::optional<std::int64_t> time(std::string_view name) const;
  std::string text(std::string_view name) const;  // empty where absent
  const std::vector<std::pair<std::string_view, std::span<const std::uint8_t>>>& all() const {
    return fields_;
  }

 private:
  std::vector<std::pair<std::string_view, std::span<const std::uint8_t>>> fields_;
};

/// A record in memory.
struct Record {
  Fields header;
  std::span<const std::uint8_t> data;
};
/// The next record; nullopt: incomplete or invalid.
std::optional<Record> recordIn(ByteReader& in);

/// What a Connection record describes.
std::optional<Channel> channelIn(const Record& record);

inline std::int64_t timeOf(std::uint64_t stamp) {
  return std::int64_t(stamp & 0xffffffff) * 1'000'000'000 + std::int64_t(stamp >> 32);
}

}  // namespace mapwright::recording::bag
