#include "simulator/bag_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "simulator/stamp.h"

namespace mapwright::simulator {
namespace {

constexpr double kBagS = 600;
constexpr double kFirstBagS = -3 * kBagS;  // the robot was on before its world begins
constexpr double kKeptBags = 12;
constexpr double kCorruptBagS = -60 * kBagS;
struct OddBag {
  const char* name;
  double long_s;
  BagQuirk quirk;
};
constexpr OddBag kOddBags[] = {{"eight_hours.bag", 8 * 3600, BagQuirk::None},
                               {"clock_set_back.bag", kBagS, BagQuirk::ClockSetBack},
                               {"same_stamps.bag", kBagS, BagQuirk::SameStamps},
                               {"gap.bag", kBagS, BagQuirk::Gap},
                               {"ends_late.bag", kBagS, BagQuirk::EndsLate},
                               {"one_message.bag", kBagS, BagQuirk::OneMessage},
                               {"empty.bag", kBagS, BagQuirk::Empty}};
constexpr std::size_t kBagHeaderBytes = 4096;
constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                   "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

std::tm utcOf(double time_s) {
  const auto seconds = static_cast<std::time_t>(std::floor(stampOf(time_s)));
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return utc;
}

std::string digits(int number, std::size_t width) {
  std::string text = std::to_string(number);
  return text.size() < width ? std::string(width - text.size(), '0') + text : text;
}

std::string day(const std::tm& utc) {
  return digits(utc.tm_year + 1900, 4) + "-" + digits(utc.tm_mon + 1, 2) + "-" + digits(utc.tm_mday, 2);
}

std::string clock(const std::tm& utc, char separator) {
  return digits(utc.tm_hour, 2) + separator + digits(utc.tm_min, 2) + separator + digits(utc.tm_sec, 2);
}

/// Bags are named after when they begin.
Bag bagFrom(double from_s, BagCondition condition) {
  const std::tm utc = utcOf(from_s);
  return {day(utc) + "_" + clock(utc, '-') + ".bag", {from_s, from_s + kBagS, false}, condition};
}

/// Recordings are named after when they end, with a space and colons.
Bag recordingUntil(double until_s, double duration_s, std::string_view suffix, bool every_scan) {
  const std::tm utc = utcOf(until_s);
  std::string name = day(utc) + " " + clock(utc, ':');
  if (!suffix.empty()) name.append("_").append(suffix);
  return {name + ".bag", {until_s - duration_s, until_s, every_scan}, BagCondition::Whole};
}

void appendLittle(std::string& out, std::uint64_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xFF);
}

void appendField(std::string& out, std::string_view name, std::uint64_t number, int bytes) {
  appendLittle(out, name.size() + 1 + static_cast<std::size_t>(bytes), 4);
  out.append(name).append("=");
  appendLittle(out, number, bytes);
}

}  // namespace

std::string listedTime(double time_s) {
  const std::tm utc = utcOf(time_s);
  return digits(utc.tm_mday, 2) + "-" + kMonths[static_cast<std::size_t>(utc.tm_mon)] + "-" +
         digits(utc.tm_year + 1900, 4) + " " + clock(utc, ':');
}

std::string listedSize(std::size_t bytes) {
  const std::size_t tenths = (10 * bytes + 512) / 1024;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "KB";
}

std::string bagBytes(const Bag& bag) {
  constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
  std::string fields;
  appendField(fields, "op", 3, 1);
  appendField(fields, "index_pos", kMagic.size() + kBagHeaderBytes, 8);
  appendField(fields, "conn_count", 0, 4);
  appendField(fields, "chunk_count", 0, 4);
  std::string bytes(kMagic);
  appendLittle(bytes, fields.size(), 4);
  bytes += fields;
  // The header record is filled up with spaces, so that a recorder can write it anew in its place.
  const std::size_t padding = kBagHeaderBytes - 8 - fields.size();
  appendLittle(bytes, padding, 4);
  bytes += std::string(padding, ' ');
  if (bag.condition == BagCondition::Corrupt) bytes.resize(bytes.size() / 2);
  return bytes;
}

BagStore::BagStore(const RobotState& state, bool odd) : state_(state), odd_(odd) {
  recordings_.push_back(recordingUntil(-1013, 120, "7002", true));
  Bag corrupt = recordingUntil(-86'400, 60, "1008", false);
  corrupt.condition = BagCondition::Corrupt;
  recordings_.insert(recordings_.begin(), corrupt);
}

std::vector<Bag> BagStore::bags() const {
  const double now_s = state_.time();
  const double newest_s = kBagS * std::floor(now_s / kBagS);
  std::vector<Bag> bags{bagFrom(kCorruptBagS, BagCondition::Corrupt)};
  if (odd_) {
    for (const OddBag& odd : kOddBags)
      bags.push_back(
          {odd.name, {kFirstBagS - odd.long_s, kFirstBagS, false, odd.quirk}, BagCondition::Whole});
  }
  for (double from_s = std::max(kFirstBagS, newest_s - kKeptBags * kBagS); from_s < newest_s; from_s += kBagS)
    bags.push_back(bagFrom(from_s, BagCondition::Whole));
  bags.push_back(bagFrom(newest_s, BagCondition::Recording));
  bags.back().span.until_s = now_s;
  return bags;
}

std::vector<Bag> BagStore::list(BagFolder folder) const {
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Recordings) return recordings_;
  std::vector<Bag> kept = bags();
  std::erase_if(kept, [&](const Bag& bag) { return removed_.contains(bag.name); });
  return kept;
}

std::optional<Bag> BagStore::find(BagFolder folder, std::string_view name) const {
  for (Bag& bag : list(folder)) {
    if (bag.name == name) return std::move(bag);
  }
  return std::nullopt;
}

Bag BagStore::record(std::string_view suffix, double duration_s, bool every_scan) {
  const Bag bag = recordingUntil(state_.time(), duration_s, suffix, every_scan);
  const std::lock_guard lock(mutex_);
  std::erase_if(recordings_, [&](const Bag& known) { return known.name == bag.name; });
  recordings_.push_back(bag);
  return bag;
}

BagStore::Removal BagStore::remove(BagFolder folder, std::string_view name) {
  const std::optional<Bag> bag = find(folder, name);
  if (!bag) return Removal::Missing;
  if (bag->condition == BagCondition::Recording) return Removal::Recording;
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Bags) {
    removed_.insert(bag->name);
  } else {
    std::erase_if(recordings_, [&](const Bag& known) { return known.name == bag->name; });
  }
  return Removal::Removed;
}

void BagStore::removeAll(BagFolder folder) {
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Recordings) recordings_.clear();
  if (folder == BagFolder::Recordings) return;
  for (const Bag& bag : bags()) {
    if (bag.condition != BagCondition::Recording) removed_.insert(bag.name);
  }
}

}  // namespace mapwright::simulator
