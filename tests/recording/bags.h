// Bags of ROS 1, made record by record as the format describes them.
#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <map>

#include "recordings.h"

namespace recordings {

inline std::string number32(std::uint32_t value) { return {reinterpret_cast<const char*>(&value), 4}; }
inline std::string number64(std::uint64_t value) { return {reinterpret_cast<const char*>(&value), 8}; }
inline std::string rosTime(std::int64_t ns) {
  return number32(std::uint32_t(ns / 1'000'000'000)) + number32(std::uint32_t(ns % 1'000'000'000));
}
inline std::string field(const std::string& name, const std::string& value) {
  return number32(std::uint32_t(name.size() + 1 + value.size())) + name + "=" + value;
}
inline std::string record(const std::string& header, const std::string& data) {
  return number32(std::uint32_t(header.size())) + header + number32(std::uint32_t(data.size())) + data;
}
inline std::string op(char code) { return field("op", std::string(1, code)); }

inline std::string packedBy(const std::string& compression, const std::string& bytes) {
  if (compression == "bz2") {
    std::string out(bytes.size() + bytes.size() / 100 + 700, '\0');
    auto size = static_cast<unsigned int>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()),
                             static_cast<unsigned int>(bytes.size()), 9, 0, 30);
    out.resize(size);
    return out;
  }
  if (compression == "lz4") {
    std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
    out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
    return out;
  }
  return bytes;
}

struct BagOptions {
  std::string compression = "none";
  std::size_t chunks = 4, each = 12;
  std::int64_t disorder_ns = 30'000;
  bool indexed = true;
  unsigned seed = 1;
};

inline Made makeBag(const BagOptions& options) {
  Made made;
  std::mt19937 random(options.seed);
  const std::vector<std::string> topics{"/pose", "/map", "/scan"};
  const auto connection = [&](std::size_t of) {
    return record(field("conn", number32(std::uint32_t(of))) + op(7) + field("topic", topics[of]),
                  field("callerid", "/node") + field("md5sum", std::string(32, 'a')) +
                      field("message_definition", "int32 n\n") + field("topic", topics[of]) +
                      field("type", "test/Number"));
  };
  const auto header = [&](std::uint64_t index_at, std::size_t connections, std::size_t chunks) {
    std::string fields = field("chunk_count", number32(std::uint32_t(chunks))) +
                         field("conn_count", number32(std::uint32_t(connections))) +
                         field("index_pos", number64(index_at)) + op(3);
    return record(fields, std::string(4096 - 8 - fields.size(), ' '));
  };
  std::string body, infos;
  const std::string start = "#ROSBAG V2.0\n";
  std::map<std::size_t, bool> described;
  std::int64_t now = 1'700'000'000'000'000'000;
  std::int32_t count = 0;
  for (std::size_t c = 0; c < options.chunks; ++c) {
    std::string inside;
    std::map<std::size_t, std::string> index;
    std::map<std::size_t, std::uint32_t> counts;
    std::int64_t first = std::numeric_limits<std::int64_t>::max(), last = 0;
    for (std::size_t i = 0; i < options.each; ++i) {
      const std::size_t of = random() % 3;
      if (!std::exchange(described[of], true)) inside += connection(of);
      now += 1000;
      const std::int64_t at =
          now - std::int64_t(random() % std::uint64_t(std::max<std::int64_t>(1, options.disorder_ns)));
      const Row row{topics[of], at, 0, number32(std::uint32_t(++count))};
      index[of] += rosTime(at) + number32(std::uint32_t(inside.size()));
      ++counts[of];
      inside +=
          record(field("conn", number32(std::uint32_t(of))) + op(2) + field("time", rosTime(at)), row.bytes);
      first = std::min(first, at);
      last = std::max(last, at);
      made.rows.push_back(row);
    }
    const std::uint64_t at = start.size() + 4096 + body.size();
    body += record(field("compression", options.compression) + op(5) +
                       field("size", number32(std::uint32_t(inside.size()))),
                   packedBy(options.compression, inside));
    std::string pairs;
    for (const auto& [of, rows] : index) {
      body += record(field("conn", number32(std::uint32_t(of))) + field("count", number32(counts[of])) +
                         op(4) + field("ver", number32(1)),
                     rows);
      pairs += number32(std::uint32_t(of)) + number32(counts[of]);
    }
    infos +=
        record(field("chunk_pos", number64(at)) + field("count", number32(std::uint32_t(counts.size()))) +
                   field("end_time", rosTime(last)) + op(6) + field("start_time", rosTime(first)) +
                   field("ver", number32(1)),
               pairs);
    made.chunks.emplace_back(start.size() + 4096 + body.size(), made.rows.size());
  }
  const std::uint64_t index_at = start.size() + 4096 + body.size();
  *made.bytes = start +
                header(options.indexed ? index_at : 0, options.indexed ? described.size() : 0,
                       options.indexed ? options.chunks : 0) +
                body;
  if (options.indexed) {
    for (const auto& [of, unused] : described) *made.bytes += connection(of);
    *made.bytes += infos;
  }
  return made;
}

}  // namespace recordings
