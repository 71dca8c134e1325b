#include "session/session.h"

#include <algorithm>
#include <utility>

#include <QPointer>

#include "raster/stand_back.h"
#include "words/sentences.h"

namespace mapwright::session {
namespace {

constexpr int kRowsEveryMs = 100;
constexpr submap::Millis kListsStayFor{60'000};

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

}  // namespace

Session::Session(std::unique_ptr<robot::Robot> robot, Options options, QObject* parent,
                 std::function<submap::Millis()> monotonic)
    : QObject(parent),
      robot_(std::move(robot)),
      monotonic_(std::move(monotonic)),
      safety_(live_, [] { return double(QDateTime::currentMSecsSinceEpoch()) / 1000; }),
      scheduler_(options.scheduler),
      overview_wanted_(options.overview),
      submaps_wanted_(options.basics.submaps),
      maps_by_itself_(options.maps),
      live_wanted_(options.maps),
      catalogue_(robot_->mapCatalogue()),
      whole_map_(options.sidecar_folder),
      compared_map_(options.sidecar_folder),
      overview_({}) {
  if (!monotonic_) {
    monotonic_ = [timer = [] {
      QElapsedTimer started;
      started.start();
      return started;
    }()] { return submap::Millis(timer.elapsed()); };
  }
  if (options.decode_threads > 0) decode_pool_.setMaxThreadCount(options.decode_threads);
  if (robot::LiveTopics* const live = robot_->liveTopics()) live->setBasics(options.basics);
  scheduler_.setPriority([this](map::SubmapId id) { return priorityOf(id); });

  for (QTimer* timer : {&wake_timer_, &rows_timer_, &problems_timer_}) timer->setSingleShot(true);
  connect(&wake_timer_, &QTimer::timeout, this, &Session::pump);
  connect(&rows_timer_, &QTimer::timeout, this, &Session::rowsChanged);
  connect(&problems_timer_, &QTimer::timeout, this, &Session::problemsChanged);

  connect(robot_.get(), &robot::Robot::topicReceived, this, &Session::takeTopic);
  connect(robot_.get(), &robot::Robot::problemFound, this,
          [this](const map::Problem& problem) { report(problem); });
  connect(robot_.get(), &robot::Robot::recovered, this,
          [this](const map::Recovery& recovery) { recover(recovery); });
  connect(robot_.get(), &robot::Robot::identityChanged, this, &Session::identityChanged);
  connect(robot_.get(), &robot::Robot::connectionChanged, this, &Session::noteConnection);
  wireMaps();
  wireSafety(options.log_safety);
}

Session::~Session() {
  robot_->disconnect(this);
  robot_.reset();  // no reply may arrive once the members below go
  decode_pool_.clear();
  decode_pool_.waitForDone();
}

void Session::open() { robot_->connectToRobot(); }

void Session::close() { robot_->disconnectFromRobot(); }

void Session::standStill() {
  if (std::exchange(still_, true)) return;
  robot_->disconnect(this);
  ++generation_;  // what is being decoded is not taken any more
  decode_pool_.clear();
  for (QTimer* timer : {&wake_timer_, &fallback_timer_, &no_live_map_timer_}) timer->stop();
  for (MapSlot* slot : {&whole_map_, &compared_map_, &overview_}) slot->standStill();
  layer_grids_.standStill();
}

void Session::retryNow() {
  const auto phase = robot_->connection().phase;
  if (phase != robot::ConnectionPhase::Online && phase != robot::ConnectionPhase::Connecting) {
    robot_->connectToRobot();
  }
  scheduler_.retryNow();
  failure_reasons_.clear();
  catalogue_.refresh();
  retryMaps();
  touchRows();
  pump();
}

void Session::clearProblems() {
  problems_.clear();
  Q_EMIT problemsChanged();
}

void Session::wireSafety(bool log) {
  connect(this, &Session::liveChanged, &safety_, [this](int what) {
    using map::topicIndex;
    if (what == topicIndex<map::AlertsMessage>() || what == topicIndex<map::WheelState>() ||
        what == topicIndex<map::SlamStatus>())
      safety_.look();
  });
  if (!log) return;
  connect(&safety_, &SafetyWatch::began, this,
          [this](const map::SafetyCondition& condition) { report(map::problemOf(condition)); });
  connect(&safety_, &SafetyWatch::ended, this,
          [this](const map::SafetyCondition& condition) { recover({map::problemOf(condition).subject}); });
}

void Session::noteConnection() {
  const bool online = robot_->connection().phase == robot::ConnectionPhase::Online;
  if (online != was_online_) {
    if (!online) stale_since_ = QDateTime::currentDateTime();
    if (online) stale_since_.reset();
    was_online_ = online;
    if (online) {
      if (problems_.resolveAll(map::SubjectKind::Robot, QDateTime::currentDateTime())) tellProblems();
      pump();
      // A short loss changes no list: over a bad link asking again and again would be a load of its own.
      const bool wanted = maps_by_itself_ || catalogue_.asked();
      if (wanted && (!listed_at_ || now() - *listed_at_ > kListsStayFor)) catalogue_.refresh();
      retryMaps();
    }
  }
  Q_EMIT connectionChanged();
}

void Session::takeTopic(const map::TopicMessage& message) {
  // What is still on its way when nobody listens any more would stay for ever.
  if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message); cloud && !listensTo(cloud->topic)) {
    return;
  }
  if (const auto* grid = std::get_if<map::GridMessage>(&message);
      grid && grid->kind != map::GridKind::WholeMap && !listensTo(grid->topic)) {
    return;
  }
  const int frame = live_.frame;
  live_ = map::reduce(std::move(live_), message, double(QDateTime::currentMSecsSinceEpoch()) / 1000);
  if (live_.frame != frame) takeFrame();
  if (const auto* list = std::get_if<map::SubmapList>(&message)) {
    if (submaps_wanted_) takeList(*list);
    return;
  }
  if (const auto* unreadable = std::get_if<map::UnreadableMessage>(&message)) {
    report({map::Severity::Warning, map::Subject(map::SubjectKind::Topic, unreadable->topic),
            unreadable->reason, map::ProblemCode::Unreadable});
    return;
  }
  if (const auto* grid = std::get_if<map::GridMessage>(&message)) takeGrid(*grid);
  Q_EMIT liveChanged(int(message.index()));
}

void Session::takeList(const map::SubmapList& list) {
  const bool first = !book_.listReceived();
  const submap::BookChange change = book_.apply(list);
  if (change.new_session) {
    ++generation_;
    if (!first && robot_->submapSource()) robot_->submapSource()->cancelAll();
    scheduler_.setUuid(book_.uuid());
    failure_reasons_.clear();
    decoding_.clear();
    if (problems_.resolveAll(map::SubjectKind::Submap, QDateTime::currentDateTime())) tellProblems();
    asked_again_.clear();
  }
  scheduler_.listArrived();
  for (const map::SubmapId id : change.removed) {
    scheduler_.unwant(id);
    failure_reasons_.erase(id);
  }
  for (const map::SubmapId id : change.restarted) scheduler_.unwant(id);
  for (const auto& [id, row] : book_.rows()) {
    if (row.pose_usable) scheduler_.want(id, row.entry.version);
  }
  if (change.new_session) Q_EMIT sessionRestarted();
  publish(change);
  if (change.set_changed) Q_EMIT listChanged();
  if (change.new_session) askForOverview();
  touchRows();
  pump();
}

void Session::publish(const submap::BookChange& change) {
  for (const map::Recovery& recovery : change.recoveries) recover(recovery);
  for (const map::Problem& problem : change.problems) report(problem);
  if (!change.removed.empty()) Q_EMIT submapsRemoved(change.removed);
  if (!change.placed.empty()) Q_EMIT submapsPlaced(change.placed);
}

void Session::pump() {
  robot::SubmapSource* source = robot_->submapSource();
  if (!source || still_) return;
  // Without a live link the list may be of another session: what is under way may end, nothing new is asked
  // for.
  if (robot_->connection().phase == robot::ConnectionPhase::Online) {
    for (const map::SubmapKey& key : scheduler_.take(now())) {
      source->fetch(key, [self = QPointer<Session>(this)](map::SubmapAnswer answer) {
        if (self) self->takeAnswer(std::move(answer));
      });
      touchRows();
    }
    if (const auto due = scheduler_.nextDue(now())) {
      wake_timer_.start(std::max(1, int((*due - now()).count())));
    }
  }
}

void Session::takeAnswer(map::SubmapAnswer answer) {
  using Outcome = map::SubmapAnswer::Outcome;
  if (still_) return;
  if (answer.outcome != Outcome::Cancelled) countFetch(answer.bytes, answer.from_cache);
  scheduler_.answered(answer.key, answer.outcome, answer.version, now());
  const map::SubmapKey key = answer.key;
  if (key.uuid == book_.uuid() && book_.find(key.id)) {
    if (answer.outcome != Outcome::Ok && answer.outcome != Outcome::Cancelled) {
      const std::string reason = words::asSentence(answer.reason);
      failure_reasons_[key.id] = reason;
      const bool missing = answer.outcome == Outcome::NotFound;
      report({missing ? map::Severity::Warning : map::Severity::Error, map::subjectOf(key.id),
              "Version " + std::to_string(key.version) + ": " + reason +
                  (missing ? " It will be asked for again at the next version."
                           : " It will be asked for again."),
              map::ProblemCode::Unavailable, answer.failure});
    }
    if (answer.outcome == Outcome::Ok) {
      failure_reasons_.erase(key.id);
      recover({map::subjectOf(key.id), map::ProblemCode::Unavailable});
      ++decoding_[key.id];
      decode_pool_.start([this, generation = generation_, held = std::move(answer)]() mutable {
        raster::standBack();
        const bool from_cache = held.from_cache;
        auto decoded = submap::decode(held);
        QMetaObject::invokeMethod(
            this,
            [this, generation, from_cache, done = std::move(decoded)]() mutable {
              if (generation == generation_) takeDecoded(std::move(done), from_cache);
            },
            Qt::QueuedConnection);
      });
    }
  }
  touchRows();
  pump();
}

void Session::takeDecoded(submap::DecodedSubmap decoded, bool from_cache) {
  const map::SubmapId id = decoded.key.id;
  if (const auto it = decoding_.find(id); it != decoding_.end() && --it->second <= 0) decoding_.erase(it);
  const bool corrupt = std::any_of(decoded.slices.begin(), decoded.slices.end(),
                                   [](const submap::Slice& slice) { return !slice.corrupt.empty(); });
  if (corrupt) discard(decoded.key, decoded.version, from_cache);
  publish(book_.commit(std::move(decoded)));
  touchRows();
  if (corrupt) pump();
}

void Session::discard(const map::SubmapKey& key, std::int32_t answered_version, bool from_cache) {
  if (!robot_->submapSource()) return;
  robot_->submapSource()->discard(key, answered_version);
  // What lay on the disk may be broken where the robot's own answer is whole. That one is asked for once.
  if (!from_cache) return;
  const auto [asked, first] = asked_again_.try_emplace(key.id, key.version);
  if (!first && asked->second == key.version) return;
  asked->second = key.version;
  scheduler_.again(key);
}

void Session::report(const map::Problem& problem, const QDateTime& at) {
  problems_.add(problem, at.isValid() ? at : QDateTime::currentDateTime());
  tellProblems();
}

void Session::recover(const map::Recovery& recovery, const QDateTime& at) {
  if (problems_.resolve(recovery, at.isValid() ? at : QDateTime::currentDateTime())) tellProblems();
}

void Session::tellProblems() {
  if (!problems_timer_.isActive()) problems_timer_.start(kRowsEveryMs);
}

void Session::countFetch(std::size_t body_bytes, bool from_cache) {
  from_cache ? ++cache_hits_ : ++fetches_;
  if (!from_cache) bytes_fetched_ += body_bytes;
}

void Session::touchRows() {
  if (!rows_timer_.isActive()) rows_timer_.start(kRowsEveryMs);
}

SubmapStatus Session::status(map::SubmapId id) const {
  const submap::SubmapRow* row = book_.find(id);
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
    if (has_slice && row->slices[std::size_t(slice_)].texture) return SubmapStatus::OnScreen;
    if (has_slice && !row->slices[std::size_t(slice_)].corrupt.empty()) return SubmapStatus::Corrupt;
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

QString Session::reason(map::SubmapId id) const {
  const submap::SubmapRow* row = book_.find(id);
  if (!row) return {};
  if (!row->pose_problem.empty()) return text(words::because("It cannot be placed", row->pose_problem));
  if (const auto it = failure_reasons_.find(id); it != failure_reasons_.end()) return text(it->second);
  if (const std::string corrupt = row->corruptReason(); !corrupt.empty())
    return text(words::asSentence(corrupt));
  if (row->stale_texture) return tr("The robot lists an older version than the one shown.");
  return {};
}

SubmapCounts Session::counts() const {
  SubmapCounts counts;
  counts.list_received = book_.listReceived();
  counts.listed = int(book_.rows().size());
  counts.texture_bytes = qint64(book_.textureBytes());
  counts.fetches = fetches_;
  counts.cache_hits = cache_hits_;
  counts.bytes_fetched = bytes_fetched_;
  counts.fetching = scheduler_.underWay();
  counts.queued = scheduler_.queued();
  std::optional<std::int32_t> last_trajectory;
  for (const auto& [id, row] : book_.rows()) {
    if (last_trajectory != id.trajectory) ++counts.trajectories;
    last_trajectory = id.trajectory;
    counts.hidden += !row.visible;
    const SubmapStatus now_status = status(id);
    counts.updating += now_status == SubmapStatus::Updating;
    if (row.drawable(slice_)) {
      ++counts.shown;
      continue;
    }
    switch (now_status) {
      case SubmapStatus::Missing:
        ++counts.missing;
        break;
      case SubmapStatus::Waiting:
        ++counts.failed;
        break;
      case SubmapStatus::Corrupt:
      case SubmapStatus::Unplaced:
        ++counts.corrupt;
        break;
      case SubmapStatus::NoSlice:
        ++counts.without_slice;
        break;
      case SubmapStatus::OnScreen:
      case SubmapStatus::Updating:
      case SubmapStatus::Queued:
      case SubmapStatus::Fetching:
        ++counts.pending;
        break;
    }
  }
  return counts;
}

bool Session::settled(int tries) const {
  if (!book_.listReceived() || !decoding_.empty() || scheduler_.underWay() > 0) return false;
  return std::all_of(book_.rows().begin(), book_.rows().end(), [&](const auto& entry) {
    if (!entry.second.pose_usable) return true;
    switch (scheduler_.state(entry.first)) {
      case submap::FetchState::Waiting:
        return scheduler_.failures(entry.first) >= tries;
      case submap::FetchState::Queued:
      case submap::FetchState::Fetching:
        return false;
      case submap::FetchState::Idle:
      case submap::FetchState::Missing:
        break;
    }
    return true;
  });
}

void Session::setSlice(int slice) {
  if (slice == slice_ || slice < 0) return;
  slice_ = slice;
  Q_EMIT sliceChanged();
  touchRows();
}

void Session::setVisible(const std::vector<map::SubmapId>& ids, bool visible) {
  std::vector<map::SubmapId> changed;
  for (const map::SubmapId id : ids) {
    const submap::SubmapRow* row = book_.find(id);
    if (!row || row->visible == visible) continue;
    book_.setVisible(id, visible);
    changed.push_back(id);
  }
  if (changed.empty()) return;
  scheduler_.reorder();
  Q_EMIT submapsPlaced(changed);
  touchRows();
}

void Session::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  if (visible_world == view_ && center_m == view_center_) return;
  view_ = visible_world;
  view_center_ = center_m;
  scheduler_.reorder();
}

double Session::priorityOf(map::SubmapId id) const {
  // Bands far enough apart that distance never crosses them: in view, out of view, hidden.
  constexpr double kOutOfView = 1e9, kHidden = 1e12;
  const submap::SubmapRow* row = book_.find(id);
  if (!row) return kHidden;
  const geometry::WorldRect bounds = book_.bounds(id, slice_);
  if (bounds.empty()) return kHidden;
  double priority = (bounds.center() - view_center_).norm();
  if (!view_.empty() && !view_.intersects(bounds)) priority += kOutOfView;
  if (!row->visible) priority += kHidden;
  return priority;
}

geometry::WorldRect Session::contentBounds() const {
  geometry::WorldRect drawn, listed;
  for (const auto& [id, row] : book_.rows()) {
    const bool held = row.visible && row.shown_version >= 0;
    if (held && book_.placement(id, slice_)) drawn.extend(book_.bounds(id, slice_));
  }
  if (!drawn.empty()) return drawn;
  for (const auto& [id, row] : book_.rows()) {
    if (row.visible) listed.extend(book_.bounds(id, slice_));
  }
  return listed;
}

}  // namespace mapwright::session
