#include "excerpt/bag_mcap.h"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace mapwright::excerpt {
namespace {

std::string schemeOf(const std::string& text) {
  const std::size_t end = text.find_first_of("+:");
  const std::string scheme = end == std::string::npos ? text : text.substr(0, end);
  return scheme == "http" || scheme == "https" ? "axbot" : scheme;
}

}  // namespace

tl::expected<std::unique_ptr<BagMcap>, disk::FileError> BagMcap::create(const std::string& path,
                                                                        const std::string& address,
                                                                        const std::string& bag,
                                                                        const TimeSpan& span) {
  std::unique_ptr<BagMcap> file(new BagMcap(path, span));
  auto target = std::make_unique<WholeTarget>(path);
  file->target_ = target.get();
  auto writer = recording::McapWriter::create(std::move(target), wholeFileOptions());
  if (!writer) return tl::make_unexpected(writer.error());
  file->writer_ = std::move(*writer);
  recording::Words about{{"version", "1"},
                         {"address", address},
                         {"kind", schemeOf(address)},
                         {"bag", bag},
                         {"recorded_by", "mapwright " MAPWRIGHT_VERSION}};
  for (const char* unknown : {"model", "serial", "name", "firmware"}) about[unknown];
  if (span.from_s) about["started_ns"] = std::to_string(nanosecondsOf(*span.from_s));
  if (const auto fault = file->writer_->note({"mapwright", std::move(about)}))
    return tl::make_unexpected(*fault);
  return file;
}

std::optional<disk::FileError> BagMcap::take(const robot::BagMessage& message, std::string_view json) {
  const double stamp_s = message.message.received_s;
  if (span_.to_s && stamp_s > *span_.to_s) return std::nullopt;
  if (span_.from_s && stamp_s < *span_.from_s) {
    Said& said = said_[message.message.topic];
    said.stamp_s = stamp_s;
    said.json.assign(json);
    return std::nullopt;
  }
  if (auto fault = begin()) return fault;
  ++messages_;
  return write(message.message.topic, false, stamp_s, stamp_s, json);
}

std::optional<disk::FileError> BagMcap::begin() {
  if (std::exchange(begun_, true)) return std::nullopt;
  std::vector<std::pair<std::string, Said>> said(said_.begin(), said_.end());
  std::stable_sort(said.begin(), said.end(),
                   [](const auto& a, const auto& b) { return a.second.stamp_s < b.second.stamp_s; });
  for (const auto& [topic, last] : said) {
    if (auto fault = write(topic, true, *span_.from_s, last.stamp_s, last.json)) return fault;
    ++said_before_;
  }
  said_.clear();
  return std::nullopt;
}

std::optional<disk::FileError> BagMcap::write(const std::string& topic, bool before, double log_s,
                                              double stamp_s, std::string_view json) {
  recording::Channel channel;
  channel.topic = topic;
  channel.message_encoding = "json";
  channel.schema_name = "mapwright.Message";
  channel.schema_encoding = "jsonschema";
  channel.schema_data = R"({"type":"object"})";
  if (before) channel.metadata["said"] = "before";
  const auto id = writer_->addChannel(channel);
  if (!id) return disk::systemError(path_, ENOSPC);  // more topics than MCAP can number
  const std::uint32_t sequence = before ? 0 : ++sequences_[topic];
  return writer_->write(*id, {nanosecondsOf(log_s), nanosecondsOf(stamp_s), sequence},
                        {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
}

std::optional<disk::FileError> BagMcap::finish() {
  if (auto fault = begin()) return fault;
  recording::Metadata end{"mapwright.end",
                          {{"messages", std::to_string(messages_)}, {"lost", "0"}, {"lost_bytes", "0"}}};
  if (span_.to_s) end.words["ended_ns"] = std::to_string(nanosecondsOf(*span_.to_s));
  if (auto fault = writer_->note(end)) return fault;
  if (auto fault = writer_->close()) return fault;
  return target_->place();
}

}  // namespace mapwright::excerpt
