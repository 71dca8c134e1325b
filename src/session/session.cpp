#include "session/session.h"

#include <utility>

#include <QFile>
#include <QLoggingCategory>

#include "grids/grid_pyramid.h"
#include "grids/tile_cache.h"
#include "map/live_state.h"
#include "map/world.h"
#include "robot/robot.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "session/submaps.h"
#include "work/workers.h"

namespace mapwright::session {
namespace {

Q_LOGGING_CATEGORY(lcSession, "mapwright.session", QtWarningMsg)

constexpr int kProblemsEveryMs = 100;
constexpr submap::Millis kListsStayFor{60'000};

std::function<submap::Millis()> orOwnClock(std::function<submap::Millis()> monotonic) {
  if (monotonic) return monotonic;
  QElapsedTimer timer;
  timer.start();
  return [timer] { return submap::Millis(timer.elapsed()); };
}

}  // namespace

Session::Session(std::unique_ptr<robot::Robot> robot, Options options, QObject* parent,
                 std::function<submap::Millis()> monotonic)
    : QObject(parent),
      robot_(std::move(robot)),
      monotonic_(orOwnClock(std::move(monotonic))),
      wall_(std::move(options.wall)),
      resources_(
          std::make_unique<grids::Resources>(work::orOwn(std::move(options.workers)),
                                             std::make_shared<grids::TileCache>(options.budgets.unpacked))),
      world_(std::make_unique<map::World>()),
      live_(world_->live),
      safety_(live_, [this] { return wallSeconds(); }),
      submaps_(std::make_unique<Submaps>(
          [this] { return robot_->submapSource(); },
          Submaps::Options{options.scheduler, resources_->workers, options.budgets.textures,
                           QFile::encodeName(options.sidecar_folder).toStdString()},
          monotonic_)),
      overview_wanted_(options.overview),
      submaps_wanted_(options.basics.submaps),
      maps_by_itself_(options.maps),
      live_wanted_(options.maps),
      catalogue_(robot_->mapCatalogue()),
      whole_map_(options.sidecar_folder, *resources_),
      compared_map_(options.sidecar_folder, *resources_),
      map_for_checks_(options.sidecar_folder, *resources_),
      overview_({}, *resources_),
      layer_grids_(std::make_unique<LayerGrids>(*resources_)),
      pose_graph_(*robot_, resources_->workers) {
  if (robot::LiveTopics* const live = robot_->liveTopics()) live->setBasics(options.basics);
  problems_timer_.setSingleShot(true);
  connect(&problems_timer_, &QTimer::timeout, this, &Session::problemsChanged);

  connect(robot_.get(), &robot::Robot::topicReceived, this, &Session::onTopic);
  connect(robot_.get(), &robot::Robot::problemFound, this,
          [this](const map::Problem& problem) { report(problem); });
  connect(robot_.get(), &robot::Robot::recovered, this,
          [this](const map::Recovery& recovery) { recover(recovery); });
  connect(robot_.get(), &robot::Robot::identityChanged, this, &Session::identityChanged);
  connect(robot_.get(), &robot::Robot::connectionChanged, this, &Session::onConnection);
  no_live_map_timer_.setInterval(options.live_map_within_ms);
  wireSubmaps();
  wireMaps();
  wireSafety(options.log_safety);
}

work::Budgets Session::memory() const {
  work::Budgets held;
  held.textures = submaps_->textureBytes();
  held.unpacked = resources_->unpacked->bytes();
  return held;
}

Session::~Session() {
  robot_->disconnect(this);
  robot_.reset();  // no reply may arrive once the members below go
}

const submap::SubmapStore& Session::submaps() const { return submaps_->store(); }
int Session::lostPictures() const { return submaps_->lost(); }
SubmapStatus Session::status(map::SubmapId id) const { return submaps_->status(id); }
Fault Session::reason(map::SubmapId id) const { return submaps_->reason(id); }
bool Session::settled(int tries) const { return submaps_->settled(tries); }
int Session::slice() const { return submaps_->slice(); }
void Session::setSlice(int slice) { submaps_->setSlice(slice); }
void Session::setVisible(const std::vector<map::SubmapId>& ids, bool visible) {
  submaps_->setVisible(ids, visible);
}
void Session::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  submaps_->setView(visible_world, center_m);
}
geometry::WorldRect Session::contentBounds() const { return submaps_->contentBounds(); }

void Session::open() { robot_->connectToRobot(); }

void Session::close() { robot_->disconnectFromRobot(); }

void Session::standStill() {
  if (std::exchange(still_, true)) return;
  robot_->disconnect(this);
  ++generation_;
  submaps_->standStill();
  no_live_map_timer_.stop();
  for (MapSlot* slot : {&whole_map_, &compared_map_, &map_for_checks_, &overview_}) slot->standStill();
  layer_grids_->standStill();
}

void Session::retryNow() {
  const auto phase = robot_->connection().phase;
  if (phase != robot::ConnectionPhase::Online && phase != robot::ConnectionPhase::Connecting) {
    robot_->connectToRobot();
  }
  catalogue_.refresh();
  retryMaps();
  pose_graph_.refresh();
  submaps_->retryNow();
}

void Session::clearProblems() {
  problems_.clear();
  Q_EMIT problemsChanged();
}

void Session::wireSubmaps() {
  submaps_->setOnline(robot_->connection().phase == robot::ConnectionPhase::Online);
  connect(submaps_.get(), &Submaps::restarted, this, [this] {
    ++generation_;
    if (problems_.resolveAll(map::SubjectKind::Submap, wall_())) reportProblems();
    if (generation_ > 1) pose_graph_.refresh();  // the first list belongs to the graph that was asked for
    Q_EMIT sessionRestarted();
  });
  connect(submaps_.get(), &Submaps::listChanged, this, &Session::listChanged);
  connect(submaps_.get(), &Submaps::listTaken, this, [this](bool new_session) {
    if (new_session) askForOverview();
  });
  connect(submaps_.get(), &Submaps::placed, this, &Session::submapsPlaced);
  connect(submaps_.get(), &Submaps::removed, this, &Session::submapsRemoved);
  connect(submaps_.get(), &Submaps::sliceChanged, this, &Session::sliceChanged);
  connect(submaps_.get(), &Submaps::touched, this, [this](const TouchedRows& rows) {
    Q_EMIT rowsTouched(rows);
    Q_EMIT rowsChanged();
  });
  connect(submaps_.get(), &Submaps::problemFound, this,
          [this](const map::Problem& problem) { report(problem); });
  connect(submaps_.get(), &Submaps::recovered, this,
          [this](const map::Recovery& recovery) { recover(recovery); });
  connect(submaps_.get(), &Submaps::bodyCame, this, &Session::countFetch);
}

void Session::wireSafety(bool log) {
  connect(this, &Session::liveHeard, &safety_, [this](int what) {
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

void Session::onConnection() {
  const bool online = robot_->connection().phase == robot::ConnectionPhase::Online;
  submaps_->setOnline(online);
  if (online != was_online_) {
    if (!online) stale_since_ = robot::silentSince(*robot_).value_or(wall_());
    if (online) stale_since_.reset();
    qCInfo(lcSession, "%s: %s", qUtf8Printable(robot_->address()), online ? "online" : "offline");
    was_online_ = online;
    if (online) {
      if (problems_.resolveAll(map::SubjectKind::Robot, wall_())) reportProblems();
      // A short loss changes no list: over a bad link asking again and again would be a load of its own.
      const bool wanted = maps_by_itself_ || catalogue_.asked();
      if (wanted && (!listed_at_ || now() - *listed_at_ > kListsStayFor)) catalogue_.refresh();
      retryMaps();
    }
  }
  Q_EMIT connectionChanged();
}

void Session::onTopic(const map::StampedMessage& stamped) {
  const map::TopicMessage& message = stamped.message;
  // Data still arriving after it is no longer wanted would stay forever.
  if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message); cloud && !listensTo(cloud->topic)) {
    return;
  }
  if (const auto* grid = std::get_if<map::GridMessage>(&message);
      grid && grid->kind != map::GridKind::WholeMap && !listensTo(grid->topic)) {
    return;
  }
  onMessage(stamped);
}

void Session::onMessage(const map::StampedMessage& stamped) {
  const map::TopicMessage& message = stamped.message;
  const int frame = live_.frame;
  const auto [heard, first] = heard_.try_emplace(message.index());
  const bool known = !first && map::repeats(live_, message);
  const double unchanged_s = known && heard->second ? heard->second->unchanged_s : stamped.at_s();
  heard->second = Heard{QString::fromStdString(stamped.topic), stamped.at_s(), unchanged_s};
  *world_ = map::reduce(std::move(*world_), stamped);
  if (live_.frame != frame) {
    // Latched data (landmarks, doors, the map) may have arrived before the message about the new frame: a new
    // subscription gets it again.
    if (robot::LiveTopics* const live = robot_->liveTopics()) live->setWanted({}, {});
    onFrame();
  }
  if (const auto* list = std::get_if<map::SubmapList>(&message)) {
    if (submaps_wanted_) submaps_->onList(*list);
    return;
  }
  if (const auto* unreadable = std::get_if<map::UnreadableMessage>(&message)) {
    report({map::Severity::Warning, map::Subject(map::SubjectKind::Topic, unreadable->topic),
            unreadable->reason, map::ProblemCode::Unreadable});
    return;
  }
  if (const auto* grid = std::get_if<map::GridMessage>(&message)) {
    if (grid->body_bytes > 0) countFetch(grid->body_bytes, grid->from_cache);
    onGrid(*grid, known);
  }
  if (!known) Q_EMIT liveChanged(int(message.index()));
  Q_EMIT liveHeard(int(message.index()));
}

std::optional<Session::Heard> Session::heard(int what) const {
  const auto heard = heard_.find(std::size_t(what));
  return heard == heard_.end() ? std::nullopt : heard->second;
}

void Session::reset(map::World world, bool whole) {
  for (auto& [what, heard] : heard_) heard.reset();
  // What ended before it was never on screen: it is not held there.
  std::erase_if(world.live.safety, [](const map::SafetyCondition& each) { return each.ended_s.has_value(); });
  world.live.frame = live_.frame + 1;
  const std::optional<map::SubmapList> list = world.submaps;
  *world_ = std::move(world);
  onFrame();
  if (list && submaps_wanted_) submaps_->onList(*list);
  if (!list && whole) submaps_->forgetList();
  for (const auto& [kind, grid] : std::map(live_.grids)) onGrid(grid);
  for (std::size_t what = 0; what < std::variant_size_v<map::TopicMessage>; ++what) {
    Q_EMIT liveChanged(int(what));
    Q_EMIT liveHeard(int(what));
  }
}

void Session::report(const map::Problem& problem, const QDateTime& at) {
  qCInfo(lcSession, "%s: %s", qUtf8Printable(sentences::nameOf(problem.subject)),
         qUtf8Printable(sentences::sentenceOf(problem)));
  problems_.add(problem, at.isValid() ? at : wall_());
  reportProblems();
}

void Session::recover(const map::Recovery& recovery, const QDateTime& at) {
  if (!problems_.resolve(recovery, at.isValid() ? at : wall_())) return;
  qCInfo(lcSession, "%s: well again", qUtf8Printable(sentences::nameOf(recovery.subject)));
  reportProblems();
}

void Session::reportProblems() {
  if (!problems_timer_.isActive()) problems_timer_.start(kProblemsEveryMs);
}

void Session::countFetch(std::size_t body_bytes, bool from_cache) {
  from_cache ? ++cache_hits_ : ++fetches_;
  if (!from_cache) bytes_fetched_ += body_bytes;
}

SubmapCounts Session::counts() const {
  SubmapCounts counts = submaps_->counts();
  counts.fetches = fetches_;
  counts.cache_hits = cache_hits_;
  counts.bytes_fetched = bytes_fetched_;
  return counts;
}

}  // namespace mapwright::session

#include "moc_session.cpp"
