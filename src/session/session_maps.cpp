// Session: whole maps, the catalogue, and what the robot is asked to send.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QPointer>

#include "map/live_state.h"
#include "robot/map_dispatch.h"
#include "robot/picture_store.h"
#include "robot/sends_map.h"
#include "robot/waypoint_store.h"
#include "sentences/absence_sentence.h"
#include "session/faults.h"
#include "session/lacks_picture.h"
#include "session/layer_grids.h"
#include "session/makes_new_map.h"
#include "session/session.h"
#include "session/submaps.h"

namespace mapwright::session {
namespace {

constexpr double kOverviewCells = 4e6;
constexpr double kFinestOverviewM = 0.1, kCoarsestOverviewM = 5;

map::WholeMap liveMap(const map::GridMessage& message, Session& session) {
  map::WholeMap map;
  map.key = {map::MapKind::Live, {}};
  const auto& info = session.live().map_info;
  if (info && !makesNewMap(session.robot(), session.live(), session.submaps())) map.name = info->name;
  map.grid = message.grid;
  map.reading = message.reading;
  map.bytes = message.png;
  map.fingerprint = message.fingerprint;
  return map;
}

/// The current map of such a robot is loaded by region: the whole is never fetched automatically.
bool givenByRegion(robot::Robot& robot, const map::CatalogueEntry& entry) {
  return (entry.is_current || entry.key.kind == map::MapKind::Live) && robot::givesByRegion(robot);
}

}  // namespace

void Session::wireMaps() {
  const auto onProblem = [this](const map::Problem& problem) { report(problem); };
  const auto forget = [this](const map::Recovery& recovery) { recover(recovery); };
  for (MapSlot* slot : {&whole_map_, &compared_map_, &map_for_checks_}) {
    // Whoever needs the one for checks says why it lacks.
    if (slot != &map_for_checks_) {
      connect(slot, &MapSlot::problemFound, this, onProblem);
      connect(slot, &MapSlot::recovered, this, forget);
    }
    // Queued: it changes in the middle of what else it does.
    connect(
        slot, &MapSlot::changed, this,
        [this, slot] {
          if (slot->settled() && outdated_.contains(slot)) openAgain(*slot);
        },
        Qt::QueuedConnection);
  }
  for (MapSlot* slot : {&whole_map_, &compared_map_, &map_for_checks_, &overview_})
    connect(slot, &MapSlot::unreadable, this, &Session::discardPicture);
  const map::Subject overview(map::SubjectKind::Overview);
  connect(&overview_, &MapSlot::problemFound, this, [this, overview](map::Problem problem) {
    problem.subject = overview;
    report(problem);
  });
  connect(&overview_, &MapSlot::changed, this, [this, overview] {
    // Well, or not needed any more.
    if (overview_.phase() == MapSlot::Phase::Ready ? !overview_.remark()
                                                   : overview_.phase() == MapSlot::Phase::Empty) {
      recover({overview});
    }
  });
  connect(layer_grids_.get(), &LayerGrids::problemFound, this, onProblem);
  connect(layer_grids_.get(), &LayerGrids::recovered, this, forget);
  connect(layer_grids_.get(), &LayerGrids::unreadable, this, &Session::discardPicture);
  connect(robot_.get(), &robot::Robot::mapsChanged, this, [this] {
    if (maps_by_itself_ || catalogue_.asked()) catalogue_.refresh();
    if (!still_) pose_graph_.refresh();
    if (whole_map_.key().kind == map::MapKind::File) openAgain(whole_map_);
    if (compared_map_.key().kind == map::MapKind::File && !compared_aside_) openAgain(compared_map_);
  });
  const auto hearStores = [this] {
    if (robot::WaypointStore* const store = robot_->waypointStore())
      connect(store, &robot::WaypointStore::changed, this, &Session::readLivePlacesAgain,
              Qt::UniqueConnection);
    if (robot::PictureStore* const pictures = robot_->pictureStore())
      connect(pictures, &robot::PictureStore::changed, this, &Session::readPictureAgain,
              Qt::UniqueConnection);
  };
  hearStores();
  // It may begin to send its map when all that it keeps has been looked for.
  const auto followLiveMap = [this] {
    if (still_ || live_wanted_ || !robot::sendsItsMap(*robot_)) return;
    if (!map_chosen_ && maps_by_itself_) live_wanted_ = true;
    const bool may_come =
        whole_map_.phase() == MapSlot::Phase::Failed && whole_map_.failure() == map::FailureKind::Unsupported;
    if (may_come && whole_map_.remark()) recover({whole_map_.remark()->subject});
    if (may_come && !live_wanted_) openInto(whole_map_, map::MapKey(whole_map_.key()));
  };
  connect(robot_.get(), &robot::Robot::capabilitiesChanged, this, [this, hearStores, followLiveMap] {
    catalogue_.setSource(robot_->mapCatalogue());
    hearStores();
    sendWants();  // other topics may carry the wanted data
    if (!still_) pose_graph_.refresh();
    followLiveMap();
    followLivePlaces();
  });
  connect(&catalogue_, &Catalogue::changed, this, [this] {
    if (catalogue_.loading()) return;
    const bool came = catalogue_.asOf() && !catalogue_.failure();
    listed_at_ = came ? std::optional(now()) : std::nullopt;
    openFirstMap();
    followLivePlaces();
  });
  connect(this, &Session::liveHeard, this, [this](int what) {
    // What the live map is called may come later than the map itself: with the name it is shown once more.
    const auto grid = live_.grids.find(map::GridKind::WholeMap);
    if (what != map::topicIndex<map::MapInfo>() || still_ || !live_.map_info || grid == live_.grids.end())
      return;
    map::WholeMap map = liveMap(grid->second, *this);
    for (MapSlot* slot : {&whole_map_, &compared_map_}) {
      const bool live = slot->phase() != MapSlot::Phase::Empty && slot->key() == map.key;
      if (live && slot->name().toStdString() != map.name) slot->show(map);
    }
  });
  connect(this, &Session::rowsChanged, this, [this] {
    if (overview_.phase() == MapSlot::Phase::Empty) return;
    const SubmapCounts now = counts();
    if (now.list_received && now.pending == 0 && now.held > 0) overview_.clear();
  });
  no_live_map_timer_.setSingleShot(true);
  connect(&no_live_map_timer_, &QTimer::timeout, this, [this] {
    // It sends no live map: the current stored one is shown until it does.
    const map::CatalogueEntry* const current = catalogue_.current();
    if (map_chosen_ || !maps_by_itself_ || !current || live_.grids.contains(map::GridKind::WholeMap)) return;
    if (!(whole_map_.key() == current->key) && !givenByRegion(*robot_, *current))
      openInto(whole_map_, current->key);
  });
}

void Session::discardPicture(const std::string& fingerprint) {
  if (robot_->wholeMapSource()) robot_->wholeMapSource()->discardPicture(fingerprint);
}

void Session::openFirstMap() {
  // A robot that sends its map by itself needs no help; of the others the current map is shown, and follows.
  if (map_chosen_ || !maps_by_itself_ || still_ || robot::sendsItsMap(*robot_) || !robot_->wholeMapSource())
    return;
  const map::CatalogueEntry* entry = catalogue_.current();
  if (!entry && catalogue_.entries().size() == 1) entry = &catalogue_.entries().front();
  if (!entry || whole_map_.key() == entry->key || givenByRegion(*robot_, *entry)) return;
  live_wanted_ = false;
  openInto(whole_map_, entry->key);
}

void Session::openMap(const map::MapKey& key) {
  map_chosen_ = true;
  live_wanted_ = key.kind == map::MapKind::Live;
  openInto(whole_map_, key);
}

void Session::compareWith(std::optional<map::MapKey> key) {
  compared_aside_.reset();
  // Another map must not replace the one to compare.
  if (!key || !(compared_map_.shown().key == *key)) compared_map_.clear();
  if (key) openInto(compared_map_, *key);
}

void Session::compareWith(map::WholeMap map) {
  compared_map_.clear();
  map.key.id = map.path.empty() ? map.name : map.path;
  compared_aside_ = map;
  compared_map_.show(std::move(map));
}

void Session::readForChecks(const std::optional<map::MapKey>& key) {
  const bool holds = map_for_checks_.phase() != MapSlot::Phase::Empty;
  if (!key) {
    if (holds) map_for_checks_.clear();
  } else if (!still_ && !(holds && map_for_checks_.key() == *key)) {
    openInto(map_for_checks_, *key);
  }
}

void Session::keepForComparing() {
  if (!whole_map_.source()) return;
  map::WholeMap kept = *whole_map_.source();
  kept.state_of = kept.key;
  kept.key.id += kept.key.id.empty() ? "kept" : " (kept)";
  kept.notes.clear();
  compared_aside_ = kept;
  compared_map_.show(std::move(kept));
}

void Session::openInto(MapSlot& slot, const map::MapKey& key) {
  outdated_.erase(&slot);
  if (key.kind == map::MapKind::Live) {
    const auto grid = live_.grids.find(map::GridKind::WholeMap);
    if (grid == live_.grids.end()) {
      slot.expect(key, {});
    } else {
      slot.show(liveMap(grid->second, *this));
    }
    return;
  }
  const map::CatalogueEntry* const entry = catalogue_.find(key);
  const QString name = entry ? QString::fromStdString(entry->name) : QString();
  slot.expect(key, name);
  if (!robot_->wholeMapSource()) {
    constexpr auto kWhat = robot::Capability::WholeMaps;
    slot.fail({map::Severity::Error, map::subjectOf(key, name.toStdString()),
               sentences::lackOf(kWhat, robot_->unavailableReason(kWhat)), map::ProblemCode::Unavailable,
               map::FailureKind::Unsupported});
    return;
  }
  const auto stillWanted = [self = QPointer<Session>(this), &slot, key] {
    return self && !self->still_ && slot.key() == key;
  };
  robot_->wholeMapSource()->fetch(key, [this, stillWanted, &slot](robot::Outcome<map::WholeMap> answer) {
    if (!stillWanted() || slot.phase() != MapSlot::Phase::Fetching) return;
    if (answer && answer->body_bytes > 0) {
      countFetch(answer->body_bytes, answer->from_cache);
      submaps_->notifySoon();
    }
    if (answer && !(answer->key == slot.key())) {
      slot.fail({map::Severity::Error,
                 map::subjectOf(slot.key()),
                 {faultText("session", "The robot sent another map, %1. It is not shown."),
                  {map::toText(answer->key)}},
                 map::ProblemCode::Unavailable,
                 map::FailureKind::MalformedAnswer});
    } else if (answer) {
      slot.show(std::move(*answer));
    } else {
      slot.fail(map::problemOf(answer.error()));
    }
  });
  if (&slot != &map_for_checks_) askForPlaces(slot, key, stillWanted);
}

std::optional<map::MapKey> Session::placesOf(const MapSlot& slot) const {
  const bool by_region = &slot == &whole_map_ && isByRegion(*robot_, slot);
  if (by_region) return placesOfLiveMap();
  const map::MapKey key = slot.cells() ? slot.shown().state_of.value_or(slot.shown().key) : slot.key();
  return key.kind == map::MapKind::Live ? placesOfLiveMap() : key;
}

std::optional<map::MapKey> Session::placesOfLiveMap() const {
  const map::CatalogueEntry* const current = catalogue_.current();
  if (!robot_->waypointSource() || !current || current->key.kind == map::MapKind::Live) return std::nullopt;
  if (makesNewMap(*robot_, live_, submaps())) return std::nullopt;
  return current->key;
}

void Session::readLivePlacesAgain() {
  live_places_.clear();
  followLivePlaces();
}

void Session::readPictureAgain(const map::MapKey& key) {
  for (MapSlot* slot : {&whole_map_, &compared_map_, &map_for_checks_}) {
    if (slot->key() == key) openAgain(*slot);
  }
}

void Session::openAgain(MapSlot& slot) {
  if (still_ || slot.phase() == MapSlot::Phase::Empty) return;
  if (slot.settled()) {
    openInto(slot, map::MapKey(slot.key()));
  } else {
    outdated_.insert(&slot);
  }
}

void Session::followLivePlaces() {
  if (still_) return;
  for (MapSlot* slot : {&whole_map_, &compared_map_}) {
    const bool live = slot->key().kind == map::MapKind::Live && slot->phase() != MapSlot::Phase::Empty;
    const auto places = live ? placesOfLiveMap() : std::nullopt;
    const auto asked = live_places_.find(slot);
    if (!places) {
      if (live && asked != live_places_.end()) slot->setWaypoints({});
      live_places_.erase(slot);
      continue;
    }
    if (asked != live_places_.end() && asked->second == *places) continue;
    live_places_[slot] = *places;
    askForPlaces(*slot, *places, [self = QPointer<Session>(this), slot, key = *places] {
      return self && !self->still_ && slot->key().kind == map::MapKind::Live &&
             self->placesOfLiveMap() == key;
    });
  }
}

void Session::askForPlaces(MapSlot& slot, const map::MapKey& key, std::function<bool()> still_wanted) {
  if (!robot_->waypointSource()) return;
  const map::CatalogueEntry* const entry = catalogue_.find(key);
  slot.awaitWaypoints(true);
  robot_->waypointSource()->waypoints(key, [this, still_wanted = std::move(still_wanted), &slot,
                                            places = map::placesOf(key, entry ? entry->name : std::string())](
                                               robot::Outcome<map::WaypointList> answer) {
    if (!still_wanted()) return;
    slot.awaitWaypoints(false);
    if (answer) {
      slot.setWaypoints(std::move(*answer));
    } else {
      map::Problem problem = map::problemOf(answer.error());
      problem.subject = places;
      problem.code = map::ProblemCode::Unavailable;
      report(problem);
    }
  });
}

void Session::retryMaps() {
  for (MapSlot* slot : {&whole_map_, &compared_map_}) {
    if (slot->phase() != MapSlot::Phase::Failed) continue;
    if (slot == &compared_map_ && compared_aside_) {
      slot->show(*compared_aside_);
    } else {
      openInto(*slot, map::MapKey(slot->key()));
    }
  }
}

void Session::onGrid(const map::GridMessage& message, bool repeated) {
  if (message.kind != map::GridKind::WholeMap) {
    const bool shown = layer_grids_->find(message.kind) && !layer_grids_->busy();
    if (!repeated || !shown) layer_grids_->onGrid(message);
    return;
  }
  const map::MapKey live{map::MapKind::Live, {}};
  const auto showIn = [&](MapSlot& slot) {
    const bool shown = slot.key() == live && slot.phase() == MapSlot::Phase::Ready && !slot.broken();
    if (!repeated || !shown) slot.show(liveMap(message, *this));
  };
  if (live_wanted_) showIn(whole_map_);
  followLivePlaces();
  if (compared_map_.key() == live && compared_map_.phase() != MapSlot::Phase::Empty) showIn(compared_map_);
}

void Session::askForOverview() {
  overview_.clear();
  robot::OverviewSource* const source = robot_->overviewSource();
  const geometry::WorldRect bounds = contentBounds();
  if (!overview_wanted_ || !source || bounds.empty()) return;
  constexpr double kSubmapReachM = 30;  // poses are corners of what they place
  const geometry::WorldRect area = bounds.grown(kSubmapReachM);
  const double resolution_m = std::clamp(std::sqrt(area.width() * area.height() / kOverviewCells),
                                         kFinestOverviewM, kCoarsestOverviewM);
  source->fetchOverview(resolution_m, [self = QPointer<Session>(this),
                                       generation = generation_](robot::Outcome<map::WholeMap> answer) {
    if (!self || generation != self->generation_) return;
    // Without it the submaps appear all the same, one by one.
    if (!answer) return;
    if (answer->body_bytes > 0) self->countFetch(answer->body_bytes, answer->from_cache);
    if (self->counts().pending > 0) self->overview_.show(std::move(*answer));
  });
}

bool Session::listensTo(const std::string& topic) const {
  return !retired_topics_.contains(QString::fromStdString(topic));
}

void Session::onFrame() {
  layer_grids_->clear();
  const map::MapKey live_map{map::MapKind::Live, {}};
  for (MapSlot* slot : {&whole_map_, &compared_map_}) {
    if (slot->phase() == MapSlot::Phase::Empty) continue;  // it is shown when it comes
    if (!(slot->key() == live_map) || live_.grids.contains(map::GridKind::WholeMap)) continue;
    live_places_.erase(slot);
    slot->clear();  // or its picture would stay until the new one is whole
    openInto(*slot, live_map);
  }
  sendWants();
  Q_EMIT frameChanged();
}

void Session::forgetUnwanted() {
  const auto unwanted = [this](const std::string& topic) { return !listensTo(topic); };
  const bool clouds =
      std::erase_if(live_.clouds, [&](const auto& cloud) { return unwanted(cloud.first); }) > 0;
  std::vector<map::GridKind> kinds;
  for (const auto& [kind, grid] : live_.grids) {
    if (kind != map::GridKind::WholeMap && unwanted(grid.topic)) kinds.push_back(kind);
  }
  for (const map::GridKind kind : kinds) {
    live_.grids.erase(kind);
    layer_grids_->drop(kind);
  }
  if (clouds) Q_EMIT liveChanged(map::topicIndex<map::PointCloudMessage>());
}

void Session::want(const QString& owner, const map::Streams& streams, const QStringList& topics) {
  Subscription subscription{streams, topics};
  if (wants_[owner] == subscription) return;
  wants_[owner] = std::move(subscription);
  sendWants();
}

void Session::sendWants() {
  robot::LiveTopics* const live = robot_->liveTopics();
  if (!live || still_) return;
  Subscription all;
  for (const auto& [owner, subscription] : wants_) {
    all.streams.insert(subscription.streams.begin(), subscription.streams.end());
    all.topics += subscription.topics;
  }
  all.topics.removeDuplicates();
  QStringList names = all.topics;
  for (const map::Stream stream : all.streams) names += live->topicsOf(stream);
  names.removeDuplicates();
  for (const QString& topic : std::as_const(wanted_topics_)) {
    // It is no longer subscribed: whether it is readable again is unknown.
    if (names.contains(topic)) continue;
    recover({map::Subject(map::SubjectKind::Topic, topic.toStdString())});
    retired_topics_.insert(topic);
  }
  for (const QString& topic : std::as_const(names)) retired_topics_.remove(topic);
  wanted_topics_ = names;
  wanted_ = all;
  live->setWanted(all.streams, all.topics);
  forgetUnwanted();
  const bool waits =
      all.streams.contains(map::Stream::WholeMap) && !live_.grids.contains(map::GridKind::WholeMap);
  if (waits && !no_live_map_timer_.isActive()) no_live_map_timer_.start();
}

}  // namespace mapwright::session
