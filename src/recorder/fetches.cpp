#include "recorder/fetches.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "map/live_topics.h"
#include "map/submap_version.h"
#include "recorder/layout.h"
#include "robot/sends_map.h"

namespace mapwright::recorder {
namespace {

constexpr int kLookEveryMs = 1'000;

auto stateOf(const map::CatalogueEntry& entry) {
  return std::tie(entry.key, entry.uid, entry.modified_s, entry.map_version, entry.overlays_version);
}

const char* mediaTypeOf(std::string_view picture) {
  if (picture.starts_with("\x89PNG")) return "image/png";
  if (picture.starts_with("BM")) return "image/bmp";
  if (picture.starts_with("P5") || picture.starts_with("P2")) return "image/x-portable-graymap";
  return "application/octet-stream";
}

}  // namespace

void SubmapRequests::onList(const map::SubmapList& list, std::int64_t now_ns) {
  if (which_ == Which::None) return;
  if (list.uuid != uuid_) {
    uuid_ = list.uuid;
    rows_.clear();
    due_.clear();
    asked_ = 0;
  }
  for (const map::SubmapEntry& entry : list.entries) {
    Row& row = rows_[entry.id];
    if (row.listed != entry.version) row.tries = 0;
    row.listed = entry.version;
    judge(entry.id, row, now_ns);
  }
}

void SubmapRequests::judge(map::SubmapId id, const Row& row, std::int64_t now_ns) {
  const bool newer = row.had == 0 || row.listed > row.had || row.listed == map::kNoVersion;
  if (newer && !row.asked && row.tries < kTries && now_ns >= row.not_before_ns) due_.insert(id);
}

std::vector<map::SubmapKey> SubmapRequests::next() {
  std::vector<map::SubmapKey> keys;
  while (!due_.empty() && asked_ < kAtOnce) {
    const map::SubmapId id = *due_.begin();
    due_.erase(due_.begin());
    Row& row = rows_[id];
    row.asked = true;
    ++asked_;
    keys.push_back({uuid_, id, row.listed});
  }
  return keys;
}

void SubmapRequests::answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome,
                              std::int64_t now_ns) {
  using Outcome = map::SubmapAnswer::Outcome;
  const auto found = rows_.find(key.id);
  if (key.uuid != uuid_ || found == rows_.end() || !found->second.asked) return;
  Row& row = found->second;
  row.asked = false;
  --asked_;
  if (outcome == Outcome::Ok) {
    row.had = std::max(key.version, 1);
    row.tries = 0;
    row.not_before_ns = which_ == Which::All && key.version != map::kNoVersion ? now_ns : now_ns + kAgainNs;
  } else if (outcome == Outcome::NotFound) {
    if (row.listed == key.version) row.tries = kTries;
  } else {
    ++row.tries;
    row.not_before_ns = now_ns + kRetryNs;
  }
  judge(key.id, row, now_ns);
}

void SubmapRequests::look(std::int64_t now_ns) {
  for (const auto& [id, row] : rows_) judge(id, row, now_ns);
}

std::size_t SubmapRequests::missing() const {
  std::size_t count = 0;
  for (const auto& [id, row] : rows_) count += row.had == 0;
  return count;
}

Fetches::Fetches(robot::Robot& robot, SubmapRequests::Which submaps, Keep keep,
                 std::function<std::int64_t()> now_ns)
    : robot_(&robot), submaps_(submaps), keep_(std::move(keep)), now_ns_(std::move(now_ns)) {
  connect(&robot, &robot::Robot::topicReceived, this, &Fetches::onTopic);
  connect(&robot, &robot::Robot::mapsChanged, this, &Fetches::askMaps);
  connect(&robot, &robot::Robot::capabilitiesChanged, this, &Fetches::askMaps);
  connect(&robot, &robot::Robot::connectionChanged, this, &Fetches::askMaps);
  connect(&look_, &QTimer::timeout, this, [this] {
    submaps_.look(now_ns_());
    pump();
  });
  if (submaps != SubmapRequests::Which::None) look_.start(kLookEveryMs);
  askMaps();
}

Fetches::~Fetches() {
  for (auto& [number, call] : calls_) call.cancel();
  list_.cancel();
  for (auto& [key, wanted] : wanted_) {
    wanted.map.cancel();
    wanted.places.cancel();
  }
}

void Fetches::onTopic(const map::StampedMessage& stamped) {
  if (const auto* const list = std::get_if<map::SubmapList>(&stamped.message)) onList(*list);
}

void Fetches::onList(const map::SubmapList& list) {
  submaps_.onList(list, now_ns_());
  pump();
}

void Fetches::pump() {
  robot::SubmapSource* const source = robot_ ? robot_->submapSource() : nullptr;
  if (!source) return;
  for (const map::SubmapKey& key : submaps_.next()) {
    const quint64 number = ++last_call_;
    calls_[number] =
        source->fetch(key, [self = QPointer<Fetches>(this), number](const map::SubmapAnswer& answer) {
          if (!self) return;
          self->calls_.erase(number);
          // The version that is listed is still due.
          const bool older = answer.version > 0 && answer.version < answer.key.version;
          self->submaps_.answered(answer.key, older ? map::SubmapAnswer::Outcome::Failed : answer.outcome,
                                  self->now_ns_());
          self->pump();
        });
  }
}

void Fetches::askMaps() {
  robot::MapCatalogue* const catalogue = robot_ ? robot_->mapCatalogue() : nullptr;
  if (!catalogue || robot_->connection().phase != robot::ConnectionPhase::Online) return;
  if (asking_) {
    again_ = true;
    return;
  }
  asking_ = true;
  list_ = catalogue->list(
      [self = QPointer<Fetches>(this)](const robot::Outcome<std::vector<map::CatalogueEntry>>& entries) {
        if (!self) return;
        self->asking_ = false;
        if (entries) {
          self->listed_ = *entries;
          self->onMaps(*entries);
        } else {
          Q_EMIT self->notHad(entries.error());
        }
        if (self && std::exchange(self->again_, false)) self->askMaps();
      });
}

void Fetches::wantMap(const map::MapKey& key) {
  if (key.kind == map::MapKind::Live || !wanted_.try_emplace(key).second) return;
  if (listed_) {
    onMaps(*listed_);
  } else {
    askMap(key);
  }
}

void Fetches::onMaps(const std::vector<map::CatalogueEntry>& entries) {
  for (const map::CatalogueEntry& entry : entries) {
    // Live maps come by topic.
    if (entry.is_current && entry.key.kind != map::MapKind::Live) wanted_.try_emplace(entry.key);
  }
  for (auto& [key, wanted] : wanted_) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&key = key](const auto& one) { return one.key == key; });
    const bool listed = entry != entries.end(), current = listed && entry->is_current;
    const bool same = !listed || (wanted.had && stateOf(*wanted.had) == stateOf(*entry));
    if (wanted.asked && same && wanted.current == current) continue;
    if (listed) wanted.had = *entry;
    wanted.current = current;
    askMap(key);
  }
}

void Fetches::askMap(const map::MapKey& key) {
  robot::WholeMapSource* const source = robot_ ? robot_->wholeMapSource() : nullptr;
  Wanted& wanted = wanted_[key];
  wanted.asked = true;
  // The whole map may be gigabytes; what is loaded of it by region is recorded.
  if (!source || (wanted.current && robot::givesByRegion(*robot_))) return askPlaces(key, {});
  wanted.map.cancel();
  wanted.map =
      source->fetch(key, [self = QPointer<Fetches>(this), key](const robot::Outcome<map::WholeMap>& map) {
        if (!self) return;
        if (map) {
          self->keepMap(*map);
          self->askPlaces(key, map->overlays);
        } else if (map.error().kind != map::FailureKind::Cancelled) {
          self->wanted_[key].asked = false;  // tries again at the next change
          Q_EMIT self->notHad(map.error());
        }
      });
}

void Fetches::keepMap(const map::WholeMap& map) {
  if (!map.bytes) return;
  const Wanted& wanted = wanted_[map.key];
  keep_(mapName(map.key), mediaTypeOf(*map.bytes), *map.bytes);
  keep_(mapFactsName(map.key), "application/json",
        mapFacts(map, wanted.current, wanted.had.value_or(map::CatalogueEntry())));
}

void Fetches::askPlaces(const map::MapKey& key, std::vector<map::OverlayFeature> overlays) {
  robot::WaypointSource* const source = robot_ ? robot_->waypointSource() : nullptr;
  if (!source) {
    keep_(waypointsName(key), "application/json", placesText(key, {}, overlays));
    return;
  }
  robot::Call& places = wanted_[key].places;
  places.cancel();
  places = source->waypoints(key, [self = QPointer<Fetches>(this), key, overlays = std::move(overlays)](
                                      const robot::Outcome<map::WaypointList>& told) {
    if (!self) return;
    if (told) {
      self->keep_(waypointsName(key), "application/json", placesText(key, *told, overlays));
    } else if (told.error().kind != map::FailureKind::Cancelled) {
      Q_EMIT self->notHad(told.error());
    }
  });
}

}  // namespace mapwright::recorder

#include "moc_fetches.cpp"
