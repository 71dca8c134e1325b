#include "session/submaps.h"

#include <algorithm>
#include <utility>

#include <QLoggingCategory>
#include <QPointer>

#include "cells/cell_texture.h"
#include "cells/texture_store.h"
#include "map/submap_version.h"
#include "session/faults.h"
#include "submap/faults.h"

namespace mapwright::session {
namespace {

Q_LOGGING_CATEGORY(lcSubmaps, "mapwright.session", QtWarningMsg)

constexpr int kTouchedEveryMs = 100;
constexpr std::size_t kLongList = 2'000;  // from here on comparing is felt
// Bodies that wait to be decoded are held whole: so many at most, or a fast disk would fill the memory.
constexpr std::size_t kMostDecodes = 64;

std::uint64_t ownerOf(map::SubmapId id) {
  return (std::uint64_t(std::uint32_t(id.trajectory)) << 32) | std::uint32_t(id.index);
}
map::SubmapId idOf(std::uint64_t owner) {
  return {std::int32_t(std::uint32_t(owner >> 32)), std::int32_t(std::uint32_t(owner))};
}

}  // namespace

Submaps::Submaps(std::function<robot::SubmapSource*()> source, const Options& options,
                 std::function<submap::Millis()> monotonic, QObject* parent)
    : QObject(parent),
      source_(std::move(source)),
      monotonic_(std::move(monotonic)),
      scheduler_(options.scheduler),
      tasks_(work::orOwn(options.workers)) {
  // Both may be called on any thread.
  cells::TextureStore::Listener listener;
  listener.lost = [this](std::uint64_t owner) {
    QMetaObject::invokeMethod(
        this, [this, owner] { lose(idOf(owner)); }, Qt::QueuedConnection);
  };
  listener.no_room = [this](const std::string& why) {
    QMetaObject::invokeMethod(
        this,
        [this, why] {
          Q_EMIT problemFound(
              {map::Severity::Warning,
               map::SubjectKind::SubmapMemory,
               {faultText("session",
                          "It is used up, and no file can be written for the other submaps: %1. They "
                          "stay in memory; free some disk space."),
                {why}},
               map::ProblemCode::Unavailable});
        },
        Qt::QueuedConnection);
  };
  textures_ = cells::TextureStore::make({options.texture_bytes, options.texture_folder}, std::move(listener));
  for (QTimer* timer : {&wake_timer_, &touched_timer_}) timer->setSingleShot(true);
  connect(&wake_timer_, &QTimer::timeout, this, &Submaps::pump);
  connect(&touched_timer_, &QTimer::timeout, this, &Submaps::notifyNow);
}

Submaps::~Submaps() {
  tasks_.drop();
  tasks_.waitForDone();
  textures_->silence();
}

std::size_t Submaps::textureBytes() const { return textures_->bytesInMemory(); }

void Submaps::forgetList() {
  if (still_) return;
  ++comparison_;  // the comparison in progress is outdated
  comparing_ = false;
  next_list_.reset();
  if (store_.listReceived()) adopt(store_.clear(), false);
}

void Submaps::onList(const map::SubmapList& list) {
  if (still_) return;
  if (!comparing_ && list.entries.size() < kLongList) {
    applyDifference(submap::compareLists(store_.listedBefore(), list));
    return;
  }
  next_list_ = list;  // an unprocessed one is outdated
  if (!comparing_) compareNext();
}

void Submaps::compareNext() {
  comparing_ = true;
  auto list = std::make_shared<const map::SubmapList>(std::move(*next_list_));
  next_list_.reset();
  // Before what waits to be decoded.
  tasks_.start(work::Urgency::InView, [this, list = std::move(list), before = store_.listedBefore(),
                                       number = comparison_] {
    auto difference = std::make_shared<const submap::ListDifference>(submap::compareLists(before, *list));
    QMetaObject::invokeMethod(
        this,
        [this, difference, number] {
          if (number != comparison_) return;
          comparing_ = false;
          if (!still_) applyDifference(*difference);
          if (!still_ && next_list_) compareNext();
        },
        Qt::QueuedConnection);
  });
}

void Submaps::applyDifference(const submap::ListDifference& difference) {
  const bool first = !store_.listReceived();
  adopt(store_.apply(difference), first);
}

void Submaps::adopt(const submap::SubmapChange& change, bool first) {
  if (change.new_session) {
    ++generation_;
    if (robot::SubmapSource* const source = source_(); !first && source) source->cancelAll();
    scheduler_.setUuid(store_.uuid());
    tally_.clear();
    failure_reasons_.clear();
    decoding_.clear();
    lost_.clear();
    asked_again_.clear();
  }
  for (const map::SubmapId id : scheduler_.listArrived()) refreshRow(id);
  for (const map::SubmapId id : change.removed) {
    scheduler_.unwant(id);
    failure_reasons_.erase(id);
    tally_.remove(id);
    touched_.ids.push_back(id);
  }
  for (const map::SubmapId id : change.restarted) scheduler_.unwant(id);
  for (const auto* ids : {&change.listed, &change.restarted}) {
    for (const map::SubmapId id : *ids) {
      const submap::SubmapRow* const row = store_.find(id);
      if (row->pose_usable) scheduler_.want(id, row->entry.version);
      refreshRow(id);
    }
  }
  touched_.all |= change.new_session;
  if (change.new_session) Q_EMIT restarted();
  publish(change);
  if (change.set_changed) {
    notifyNow();  // listeners learn about them before the counters change
    Q_EMIT listChanged();
  } else {
    notifySoon();
  }
  Q_EMIT listTaken(change.new_session);
  pump();
}

void Submaps::publish(const submap::SubmapChange& change) {
  for (const map::Recovery& recovery : change.recoveries) Q_EMIT recovered(recovery);
  for (const map::Problem& problem : change.problems) Q_EMIT problemFound(problem);
  if (!change.removed.empty()) Q_EMIT removed(change.removed);
  if (!change.placed.empty()) Q_EMIT placed(change.placed);
}

void Submaps::setOnline(bool online) {
  online_ = online;
  if (online) pump();
}

void Submaps::retryNow() {
  failure_reasons_.clear();
  for (const map::SubmapId id : scheduler_.retryNow()) refreshRow(id);
  notifySoon();
  pump();
}

void Submaps::standStill() {
  still_ = true;
  still_bytes_ = qint64(textures_->bytesInMemory());  // memory of textures that are no longer used changes
  ++generation_;                                      // results of decoding in progress are outdated
  tasks_.drop();
  wake_timer_.stop();
}

void Submaps::pump() {
  robot::SubmapSource* const source = source_();
  if (!source || still_ || !online_ || decodes_ >= kMostDecodes) return;
  for (const map::SubmapKey& key : scheduler_.take(monotonic_())) {
    refreshRow(key.id);
    notifySoon();
    source->fetch(key, [self = QPointer<Submaps>(this)](map::SubmapAnswer answer) {
      if (self) self->onAnswer(std::move(answer));
    });
  }
  const submap::Millis now = monotonic_();
  if (const auto due = scheduler_.nextDue(now)) wake_timer_.start(std::max(1, int((*due - now).count())));
}

void Submaps::onAnswer(map::SubmapAnswer answer) {
  using Outcome = map::SubmapAnswer::Outcome;
  if (still_) return;
  if (answer.outcome != Outcome::Cancelled) Q_EMIT bodyCame(answer.bytes, answer.from_cache);
  const map::SubmapKey key = answer.key;
  const bool older = answer.outcome == Outcome::Ok && answer.version > 0 && answer.version < key.version;
  // From a recording nothing newer will come.
  scheduler_.answered(key, answer.outcome, older && answer.from_cache ? 0 : answer.version, monotonic_());
  if (answer.outcome == Outcome::Ok || answer.outcome == Outcome::Cancelled) {
    qCDebug(lcSubmaps, "submap %d/%d version %d: %s, %zu bytes%s", key.id.trajectory, key.id.index,
            key.version, answer.outcome == Outcome::Ok ? "came" : "cancelled", answer.bytes,
            answer.from_cache ? ", from disk" : "");
  } else {
    qCInfo(lcSubmaps, "submap %d/%d version %d: %s", key.id.trajectory, key.id.index, key.version,
           inEnglish(answer.reason).c_str());
  }
  if (key.uuid == store_.uuid() && store_.find(key.id)) {
    if (answer.outcome != Outcome::Ok && answer.outcome != Outcome::Cancelled) {
      failure_reasons_[key.id] = answer.reason;
      const bool missing = answer.outcome == Outcome::NotFound;
      const bool versioned = key.version != map::kNoVersion;
      Fault why = versioned ? Fault(fault::VersionNotHad, {std::int64_t(key.version)}, {answer.reason})
                            : Fault(faultText("session", "It cannot be loaded"), {}, {answer.reason});
      why.then = missing && versioned ? Consequence::AskedAgainAtTheNext : Consequence::AskedAgain;
      Q_EMIT problemFound({missing ? map::Severity::Warning : map::Severity::Error, map::subjectOf(key.id),
                           std::move(why), map::ProblemCode::Unavailable, answer.failure});
    }
    if (answer.outcome == Outcome::Ok) {
      failure_reasons_.erase(key.id);
      if (older) {
        Fault why(faultText("session", "Version %1 is listed, but the robot sent version %2. It is shown."),
                  {std::int64_t(key.version), std::int64_t(answer.version)});
        if (!answer.from_cache) {
          failure_reasons_[key.id] = why;
          why.then = Consequence::AskedAgain;
        }
        Q_EMIT problemFound({answer.from_cache ? map::Severity::Info : map::Severity::Warning,
                             map::subjectOf(key.id), std::move(why), map::ProblemCode::Unavailable});
      } else {
        Q_EMIT recovered({map::subjectOf(key.id), map::ProblemCode::Unavailable});
      }
      decode(std::move(answer));
    }
    refreshRow(key.id);
  }
  notifySoon();
  pump();
}

void Submaps::decode(map::SubmapAnswer answer) {
  ++decoding_[answer.key.id];
  ++decodes_;
  tasks_.start(work::Urgency::Wanted, [this, generation = generation_, held = std::move(answer)] {
    Decoded decoded{generation, held.from_cache, submap::decode(held)};
    for (const submap::Slice& slice : decoded.submap.slices) {
      if (slice.texture) textures_->keep(*slice.texture, ownerOf(held.key.id));
    }
    const std::lock_guard lock(decoded_mutex_);
    decoded_.push_back(std::move(decoded));
    if (decoded_.size() == 1) {
      QMetaObject::invokeMethod(
          this, [this] { onDecoded(); }, Qt::QueuedConnection);
    }
  });
}

void Submaps::onDecoded() {
  std::vector<Decoded> batch;
  {
    const std::lock_guard lock(decoded_mutex_);
    batch.swap(decoded_);
  }
  decodes_ -= batch.size();
  submap::SubmapChange change;
  for (Decoded& decoded : batch) {
    if (decoded.generation == generation_) addDecoded(std::move(decoded), change);
  }
  publish(change);
  notifySoon();
  pump();
}

void Submaps::addDecoded(Decoded decoded, submap::SubmapChange& change) {
  const map::SubmapId id = decoded.submap.key.id;
  if (const auto it = decoding_.find(id); it != decoding_.end() && --it->second <= 0) decoding_.erase(it);
  const bool corrupt = std::any_of(decoded.submap.slices.begin(), decoded.submap.slices.end(),
                                   [](const submap::Slice& slice) { return slice.corrupt.any(); });
  if (corrupt) discard(decoded.submap.key, decoded.submap.version, decoded.from_cache);
  lost_.erase(id);
  const submap::SubmapChange one = store_.commit(std::move(decoded.submap));
  change.placed.insert(change.placed.end(), one.placed.begin(), one.placed.end());
  change.problems.insert(change.problems.end(), one.problems.begin(), one.problems.end());
  change.recoveries.insert(change.recoveries.end(), one.recoveries.begin(), one.recoveries.end());
  refreshRow(id);
}

void Submaps::discard(const map::SubmapKey& key, std::int32_t answered_version, bool from_cache) {
  robot::SubmapSource* const source = source_();
  if (!source) return;
  source->discard(key, answered_version);
  // What lay on the disk may be broken where the robot's own answer is whole. That one is asked for once.
  if (!from_cache) return;
  const auto [asked, first] = asked_again_.try_emplace(key.id, key.version);
  if (!first && asked->second == key.version) return;
  asked->second = key.version;
  scheduler_.again(key);
}

void Submaps::lose(map::SubmapId id) {
  if (still_) {
    lost_.insert(id);
    return;
  }
  const submap::SubmapChange change = store_.lose(id);
  if (change.placed.empty()) return;
  lost_.insert(id);
  scheduler_.again({store_.uuid(), id, store_.find(id)->entry.version});
  refreshRow(id);
  publish(change);
  notifySoon();
  pump();
}

void Submaps::refreshRow(map::SubmapId id) {
  const submap::SubmapRow* const row = store_.find(id);
  if (!row) return;
  const geometry::WorldRect bounds = store_.bounds(id, slice_);
  tally_.set(id, {status(id), row->drawable(slice_), row->visible, bounds});
  if (!bounds.empty()) scheduler_.place(id, bounds.center(), !row->visible);
  if (!touched_.all) touched_.ids.push_back(id);
}

void Submaps::reportAllChanged() {
  touched_.all = true;
  for (const auto& [id, row] : store_.rows()) refreshRow(id);
}

void Submaps::notifyNow() {
  touched_timer_.stop();
  TouchedRows rows = std::exchange(touched_, {});
  if (rows.all) rows.ids.clear();
  std::sort(rows.ids.begin(), rows.ids.end());
  rows.ids.erase(std::unique(rows.ids.begin(), rows.ids.end()), rows.ids.end());
  Q_EMIT touched(rows);
}

void Submaps::notifySoon() {
  if (!touched_timer_.isActive()) touched_timer_.start(kTouchedEveryMs);
}

SubmapStatus Submaps::status(map::SubmapId id) const {
  const submap::SubmapRow* row = store_.find(id);
  if (!row) return SubmapStatus::Queued;
  if (!row->pose_usable) return SubmapStatus::Unplaced;
  const submap::FetchState fetch = scheduler_.state(id);
  if (row->shown_version >= 0) {
    const bool newer_coming = row->entry.version > row->shown_version &&
                              (fetch == submap::FetchState::Queued || fetch == submap::FetchState::Fetching ||
                               decoding_.contains(id));
    if (newer_coming) return SubmapStatus::Updating;
    if (fetch == submap::FetchState::Waiting) return SubmapStatus::Waiting;
    const bool has_slice = std::size_t(slice_) < row->slices.size();
    if (has_slice && row->slices[std::size_t(slice_)].texture)
      return row->visible ? SubmapStatus::OnScreen : SubmapStatus::Hidden;
    if (has_slice && row->slices[std::size_t(slice_)].corrupt.any()) return SubmapStatus::Corrupt;
    return SubmapStatus::NoSlice;
  }
  if (decoding_.contains(id)) return SubmapStatus::Fetching;
  switch (fetch) {
    case submap::FetchState::Fetching:
      return SubmapStatus::Fetching;
    case submap::FetchState::Missing:
      return SubmapStatus::Missing;
    case submap::FetchState::Waiting:
      return SubmapStatus::Waiting;
    case submap::FetchState::Queued:
    case submap::FetchState::Idle:
      break;
  }
  return SubmapStatus::Queued;
}

Fault Submaps::reason(map::SubmapId id) const {
  const submap::SubmapRow* row = store_.find(id);
  if (!row) return {};
  if (row->pose_problem != FaultCode()) return {submap::fault::CannotBePlaced, {}, {row->pose_problem}};
  if (const auto it = failure_reasons_.find(id); it != failure_reasons_.end()) return it->second;
  if (auto corrupt = row->corruptSlices(); !corrupt.empty()) return {fault::Slices, {}, std::move(corrupt)};
  return row->stale_texture ? faultText("session", "The robot lists an older version than the one shown.")
                            : FaultCode();
}

SubmapCounts Submaps::counts() const {
  SubmapCounts counts = tally_.counts();
  counts.list_received = store_.listReceived();
  counts.texture_bytes = still_ ? still_bytes_ : qint64(textureBytes());
  counts.fetching = scheduler_.inProgress();
  counts.queued = scheduler_.queued();
  return counts;
}

bool Submaps::settled(int tries) const {
  return store_.listReceived() && !comparing_ && decoding_.empty() && scheduler_.settled(tries);
}

void Submaps::setSlice(int slice) {
  if (slice == slice_ || slice < 0) return;
  slice_ = slice;
  reportAllChanged();
  Q_EMIT sliceChanged();
  notifySoon();
}

void Submaps::setVisible(const std::vector<map::SubmapId>& ids, bool visible) {
  std::vector<map::SubmapId> changed;
  for (const map::SubmapId id : ids) {
    const submap::SubmapRow* row = store_.find(id);
    if (!row || row->visible == visible) continue;
    store_.setVisible(id, visible);
    refreshRow(id);
    changed.push_back(id);
  }
  if (changed.empty()) return;
  Q_EMIT placed(changed);
  notifySoon();
}

void Submaps::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  scheduler_.setView(visible_world, center_m);
}

}  // namespace mapwright::session

#include "moc_submaps.cpp"
