#include "app/bag_mcap.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "recording/append_file.h"

namespace mapwright::app {
namespace {

constexpr double kNsPerS = 1e9;

std::string schemeOf(const QString& address) {
  const std::string text = address.toStdString();
  const std::size_t end = text.find_first_of("+:");
  const std::string scheme = end == std::string::npos ? text : text.substr(0, end);
  return scheme == "http" || scheme == "https" ? "axbot" : scheme;
}

}  // namespace

std::int64_t nanosecondsOf(double s) {
  constexpr double kMost = double(std::numeric_limits<std::int64_t>::max()) / kNsPerS;
  if (!(s > 0)) return 0;
  if (s >= kMost) return std::numeric_limits<std::int64_t>::max();
  // The whole seconds apart: a double of nanoseconds would be off by hundreds of them.
  const double whole = std::floor(s);
  return std::int64_t(whole) * 1'000'000'000 + std::llround((s - whole) * kNsPerS);
}

tl::expected<std::unique_ptr<BagMcap>, disk::Fault> BagMcap::create(const std::string& path,
                                                                    const QString& address,
                                                                    const std::string& bag,
                                                                    const TimeSpan& span) {
  std::unique_ptr<BagMcap> file(new BagMcap(path, span));
  auto target = recording::appendFile(file->aside(), recording::Existing::Replace);
  if (!target) return tl::make_unexpected(target.error());
  auto writer = recording::McapWriter::create(std::move(*target), {});
  if (!writer) return tl::make_unexpected(writer.error());
  file->writer_ = std::move(*writer);
  recording::Words about{{"version", "1"},
                         {"address", address.toStdString()},
                         {"kind", schemeOf(address)},
                         {"bag", bag},
                         {"recorded_by", "mapwright " MAPWRIGHT_VERSION}};
  for (const char* unknown : {"model", "serial", "name", "firmware"}) about[unknown];
  if (span.from_s) about["started_ns"] = std::to_string(nanosecondsOf(*span.from_s));
  if (const auto fault = file->writer_->note({"mapwright", std::move(about)}))
    return tl::make_unexpected(*fault);
  return file;
}

BagMcap::~BagMcap() {
  if (finished_) return;
  writer_.reset();
  std::error_code nothing_more_to_do;
  std::filesystem::remove(aside(), nothing_more_to_do);
}

std::optional<disk::Fault> BagMcap::take(const robot::BagMessage& message, std::string_view json) {
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

std::optional<disk::Fault> BagMcap::begin() {
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

std::optional<disk::Fault> BagMcap::write(const std::string& topic, bool before, double log_s, double stamp_s,
                                          std::string_view json) {
  recording::Channel channel;
  channel.topic = topic;
  channel.message_encoding = "json";
  if (before) channel.metadata["said"] = "before";
  const auto id = writer_->addChannel(channel);
  if (!id) return disk::systemFault(path_, ENOSPC);  // more topics than MCAP can number
  const std::uint32_t sequence = before ? 0 : ++sequences_[topic];
  return writer_->write(*id, {nanosecondsOf(log_s), nanosecondsOf(stamp_s), sequence},
                        {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
}

std::optional<disk::Fault> BagMcap::finish() {
  if (auto fault = begin()) return fault;
  recording::Metadata end{"mapwright.end",
                          {{"messages", std::to_string(messages_)}, {"lost", "0"}, {"lost_bytes", "0"}}};
  if (span_.to_s) end.words["ended_ns"] = std::to_string(nanosecondsOf(*span_.to_s));
  if (auto fault = writer_->note(end)) return fault;
  if (auto fault = writer_->close()) return fault;
  writer_.reset();
  if (std::rename(aside().c_str(), path_.c_str()) != 0) return disk::systemFault(path_, errno);
  finished_ = true;
  return std::nullopt;
}

}  // namespace mapwright::app
