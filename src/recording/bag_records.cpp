#include "recording/bag_records.h"

#include <algorithm>

namespace mapwright::recording::bag {

std::optional<Fields> Fields::in(std::span<const std::uint8_t> header) {
  Fields fields;
  ByteReader in(header);
  while (in.left() > 0) {
    const std::string_view field = in.text();
    const std::size_t equals = field.find('=');
    if (!in.sound() || equals == std::string_view::npos || equals == 0) return std::nullopt;
    const auto value = field.substr(equals + 1);
    fields.fields_.emplace_back(field.substr(0, equals),
                                std::span(reinterpret_cast<const std::uint8_t*>(value.data()), value.size()));
  }
  return fields;
}

std::optional<std::span<const std::uint8_t>> Fields::find(std::string_view name) const {
  for (const auto& [known, value] : fields_) {
    if (known == name) return value;
  }
  return std::nullopt;
}

std::optional<Op> Fields::op() const {
  const auto op = number<std::uint8_t>("op");
  return op ? std::optional(Op(*op)) : std::nullopt;
}

std::optional<std::int64_t> Fields::time(std::string_view name) const {
  const auto stamp = number<std::uint64_t>(name);
  return stamp ? std::optional(timeOf(*stamp)) : std::nullopt;
}

std::string Fields::text(std::string_view name) const {
  const auto value = find(name);
  return value ? std::string(ByteReader::textOf(*value)) : std::string();
}

std::optional<Record> recordIn(ByteReader& in) {
  const auto header = in.piece();
  const auto data = in.piece();
  if (!in.sound() || header.size() > kMostHeader) return std::nullopt;
  std::optional<Fields> fields = Fields::in(header);
  if (!fields || !fields->op()) return std::nullopt;
  return Record{std::move(*fields), data};
}

std::optional<Channel> channelIn(const Record& record) {
  const auto id = record.header.number<std::uint32_t>("conn");
  const std::optional<Fields> about = Fields::in(record.data);
  if (!id || !about) return std::nullopt;
  Channel channel;
  channel.id = *id;
  channel.topic = record.header.text("topic");  // as recorded; remapped ones differ from the other's
  if (channel.topic.empty()) channel.topic = about->text("topic");
  channel.message_encoding = "ros1";
  channel.schema_name = about->text("type");
  channel.schema_encoding = "ros1msg";
  channel.schema_data = about->text("message_definition");
  for (const auto& [name, value] : about->all()) {
    if (name != "topic" && name != "type" && name != "message_definition") {
      channel.metadata.emplace(name, ByteReader::textOf(value));
    }
  }
  return channel;
}

}  // namespace mapwright::recording::bag
