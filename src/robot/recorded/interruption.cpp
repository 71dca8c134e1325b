#include "robot/recorded/interruption.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <QDateTime>

#include "recording/seconds.h"
#include "robot/recorded/faults.h"

namespace mapwright::robot::recorded {
namespace {

constexpr const char* kMadeHere = "mapwright";
constexpr const char* kEndMark = "mapwright.end";
constexpr const char* kRepairMark = "mapwright.repaired";
constexpr const char* kBrokeOff = "broke_off_ns";
constexpr const char* kLinkMark = "mapwright.link";

std::optional<std::int64_t> numberIn(const recording::Words& words, const char* name) {
  const auto found = words.find(name);
  if (found == words.end()) return std::nullopt;
  std::int64_t value = 0;
  const char* const end = found->second.data() + found->second.size();
  const auto [stop, error] = std::from_chars(found->second.data(), end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace

bool isInterrupted(const recording::Source& file) {
  if (!file.summary().finished) return true;
  const std::vector<recording::Metadata>& all = file.metadata();
  const auto has = [&](const char* name) {
    return std::any_of(all.begin(), all.end(),
                       [&](const recording::Metadata& one) { return one.name == name; });
  };
  return has(kMadeHere) && !has(kEndMark) && !has(kRepairMark);
}

bool isEndMark(const recording::Metadata& metadata) {
  return metadata.name == kEndMark || metadata.name == kRepairMark;
}

recording::Metadata repairMark(const recording::Summary& interrupted) {
  recording::Metadata mark{kRepairMark, {}};
  if (interrupted.end_ns) mark.words[kBrokeOff] = std::to_string(*interrupted.end_ns);
  return mark;
}

std::optional<BagRepair> repairOf(const recording::Source& file) {
  std::optional<BagRepair> repair;
  for (const recording::Metadata& metadata : file.metadata()) {
    if (metadata.name != kRepairMark) continue;
    repair.emplace();  // the last one counts
    if (const auto at_ns = numberIn(metadata.words, kBrokeOff))
      repair->broke_off_s = recording::secondsOf(*at_ns);
  }
  return repair;
}

Fault interruptionOf(const recording::Summary& summary) {
  if (!summary.end_ns) return fault::RecordingNotBegun;
  return {fault::RecordingNotFinished, {timeWords(*summary.end_ns)}};
}

std::vector<BagAway> awayIn(const recording::Source& file) {
  // The record of a reconnect repeats the time of the loss.
  std::map<std::int64_t, std::optional<std::int64_t>> back_of;
  for (const recording::Metadata& metadata : file.metadata()) {
    if (metadata.name != kLinkMark) continue;
    const auto lost_ns = numberIn(metadata.words, "lost_ns");
    if (!lost_ns) continue;
    std::optional<std::int64_t>& back_ns = back_of[*lost_ns];
    if (const auto told_ns = numberIn(metadata.words, "back_ns")) back_ns = told_ns;
  }
  std::vector<BagAway> all;
  for (const auto& [lost_ns, back_ns] : back_of) {
    BagAway away{recording::secondsOf(lost_ns), std::nullopt};
    if (back_ns) away.until_s = recording::secondsOf(*back_ns);
    all.push_back(away);
  }
  return all;
}

Fault reasonOf(const BagAway& away) {
  const std::string from = timeWords(recording::nanosecondsOf(away.from_s));
  if (!away.until_s) return {fault::RecordingLinkGone, {from}};
  return {fault::RecordingLinkAway, {from, timeWords(recording::nanosecondsOf(*away.until_s))}};
}

std::string timeWords(std::int64_t epoch_ns) {
  return QDateTime::fromMSecsSinceEpoch(epoch_ns / 1'000'000, Qt::UTC)
      .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz 'UTC'"))
      .toStdString();
}

}  // namespace mapwright::robot::recorded
