#include "replay/replay_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPointer>

#include "replay/chunks.h"
#include "robot/faults.h"

namespace mapwright::replay {

using robot::ConnectionPhase;

namespace {

constexpr int kLookAgainMs = 250;

robot::ConnectionState inPhase(ConnectionPhase phase) {
  robot::ConnectionState state;
  state.phase = phase;
  return state;
}

Fault lackOfBags(const robot::Absence& absence) {
  std::vector<FaultArgument> arguments{std::int64_t(robot::Capability::Bags), std::int64_t(absence.reason)};
  arguments.insert(arguments.end(), absence.arguments.begin(), absence.arguments.end());
  return {robot::fault::CapabilityLacking, std::move(arguments)};
}

robot::RawMessage rawOf(const Chunk& chunk, const robot::BagMessage& message) {
  const std::string_view text = chunk.source->textOf(message);
  robot::RawMessage raw;
  raw.topic = QString::fromStdString(message.message.topic);
  raw.received =
      QDateTime::fromMSecsSinceEpoch(qint64(std::clamp(message.message.received_s, -1e11, 1e11) * 1000));
  raw.bytes = qint64(text.size());
  raw.text = QByteArray(text.data(), std::min(qsizetype(text.size()), robot::kMaxRawText));
  return raw;
}

}  // namespace

/// Sends everything recorded; listeners drop what they did not ask for.
class ReplayRobot::Topics : public robot::LiveTopics {
 public:
  Topics(robot::LiveTopics& origin, ReplayRobot& replay) : origin_(origin), replay_(replay) {}
  QStringList known() const override { return origin_.known(); }
  QStringList topicsOf(map::Stream stream) const override { return origin_.topicsOf(stream); }
  void setWanted(const map::Streams& streams, const QStringList& topics) override {
    wanted_ = {streams, topics};
    // A renewed subscription comes as two calls, without and then with it: compare after both.
    if (std::exchange(compares_, true)) return;
    QMetaObject::invokeMethod(
        &replay_, [this] { compareWants(); }, Qt::QueuedConnection);
  }
  /// For newly wanted data, send the last messages before now.
  void compareWants() {
    compares_ = false;
    const Wants before = std::exchange(seen_, wanted_);
    const bool more = std::any_of(wanted_.streams.begin(), wanted_.streams.end(),
                                  [&](map::Stream stream) { return !before.streams.contains(stream); }) ||
                      std::any_of(wanted_.topics.begin(), wanted_.topics.end(),
                                  [&](const QString& topic) { return !before.topics.contains(topic); });
    if (more) replay_.lookAgain();
  }
  void setWatching(bool on) override {
    replay_.watching_ = on;
    if (on)
      QMetaObject::invokeMethod(
          &replay_, [replay = &replay_] { replay->notifyLastRaw(); }, Qt::QueuedConnection);
  }
  void setTap(robot::FrameTap) override {}

 private:
  robot::LiveTopics& origin_;
  ReplayRobot& replay_;
  struct Wants {
    map::Streams streams;
    QStringList topics;
  };
  Wants wanted_, seen_;
  bool compares_ = false;  // soon
};

/// The submaps of the bag's robot. Those of an earlier SLAM session are gone: the list of a bag stays as it
/// is.
class ReplayRobot::Submaps : public robot::SubmapSource {
 public:
  explicit Submaps(ReplayRobot& replay) : replay_(replay) {}
  robot::Call fetch(const map::SubmapKey& key, Reply reply) override {
    return origin().fetch(key, [reply = std::move(reply)](map::SubmapAnswer answer) {
      using Outcome = map::SubmapAnswer::Outcome;
      if (answer.outcome == Outcome::WrongUuid) answer.outcome = Outcome::NotFound;
      reply(std::move(answer));
    });
  }
  void cancelAll() override { origin().cancelAll(); }
  void cancel(const map::SubmapKey& key) override { origin().cancel(key); }
  void discard(const map::SubmapKey& key, std::int32_t answered_version) override {
    origin().discard(key, answered_version);
  }

 private:
  robot::SubmapSource& origin() const { return *replay_.origin_->submapSource(); }
  ReplayRobot& replay_;
};

/// The maps of the bag's robot. The current one is that stated in the bag, not the robot's present one.
class ReplayRobot::Maps : public robot::MapCatalogue {
 public:
  explicit Maps(ReplayRobot& replay) : replay_(replay) {}
  robot::Call list(robot::OutcomeTo<std::vector<map::CatalogueEntry>> reply) override {
    return origin()->list([this, alive = replay_.alive_, reply = std::move(reply)](
                              robot::Outcome<std::vector<map::CatalogueEntry>> entries) {
      if (*alive && entries) mark(*entries);
      reply(std::move(entries));
    });
  }
  robot::Call describe(const map::MapKey& key, robot::OutcomeTo<map::CatalogueEntry> reply) override {
    return origin()->describe(key, std::move(reply));
  }
  robot::Call thumbnail(const map::MapKey& key, robot::OutcomeTo<std::string> reply) override {
    return origin()->thumbnail(key, std::move(reply));
  }
  void discardThumbnail(const map::MapKey& key) override { origin()->discardThumbnail(key); }

 private:
  robot::MapCatalogue* origin() const { return replay_.origin_->mapCatalogue(); }
  void mark(std::vector<map::CatalogueEntry>& entries) const {
    const std::optional<map::MapInfo>& info = replay_.map_info_;
    if (!info || (info->uid.empty() && info->name.empty())) return;
    const auto is = [&](const map::CatalogueEntry& entry) {
      const bool by_uid = !info->uid.empty() && !entry.uid.empty();
      return by_uid ? entry.uid == info->uid : !info->name.empty() && entry.name == info->name;
    };
    for (map::CatalogueEntry& entry : entries) entry.is_current = false;
    const auto found = std::find_if(entries.begin(), entries.end(), is);
    if (found != entries.end()) found->is_current = true;
  }
  ReplayRobot& replay_;
};

ReplayRobot::ReplayRobot(std::unique_ptr<robot::Robot> origin, std::string name, Reading::Options options,
                         QObject* parent)
    : Robot(parent), origin_(std::move(origin)), name_(std::move(name)), options_(std::move(options)) {
  if (robot::LiveTopics* live = origin_->liveTopics()) live_ = std::make_unique<Topics>(*live, *this);
  submaps_ = std::make_unique<Submaps>(*this);
  maps_ = std::make_unique<Maps>(*this);
  look_again_.setSingleShot(true);
  connect(&look_again_, &QTimer::timeout, this, [this] {
    if (reading_ && at_s_) jump();
  });
  connect(origin_.get(), &Robot::problemFound, this, &Robot::problemFound);
  connect(origin_.get(), &Robot::recovered, this, &Robot::recovered);
  connect(origin_.get(), &Robot::identityChanged, this, &Robot::identityChanged);
  connect(origin_.get(), &Robot::capabilitiesChanged, this, &Robot::capabilitiesChanged);
}

ReplayRobot::ReplayRobot(std::unique_ptr<robot::Robot> origin, robot::BagKey key, Reading::Options options,
                         QObject* parent)
    : ReplayRobot(std::move(origin), key.name, std::move(options), parent) {
  key_ = std::move(key);
}

ReplayRobot::~ReplayRobot() {
  *alive_ = false;
  finding_.cancel();
}

robot::SubmapSource* ReplayRobot::submapSource() {
  return origin_->submapSource() ? submaps_.get() : nullptr;
}

std::optional<std::vector<robot::OfferedTopic>> ReplayRobot::offered() const {
  robot::OffersTopics* const of = robot::topicsOfferedBy(*origin_);
  return of ? of->offered() : std::nullopt;
}

QStringList ReplayRobot::choicesFor(map::Stream stream) const {
  robot::OffersTopics* const of = robot::topicsOfferedBy(*origin_);
  return of ? of->choicesFor(stream) : QStringList();
}

robot::TopicChoices ReplayRobot::chosen() const {
  robot::OffersTopics* const of = robot::topicsOfferedBy(*origin_);
  return of ? of->chosen() : robot::TopicChoices();
}

void ReplayRobot::choose(const robot::TopicChoices& choices) {
  robot::OffersTopics* const of = robot::topicsOfferedBy(*origin_);
  if (!of || of->chosen() == choices) return;
  of->choose(choices);
  if (!reading_) return;
  // The screen stays unchanged until the time is known again.
  setKnowledge(Knowledge::Buffering);
  if (reading_) reading_->readAnew();
}

robot::LiveTopics* ReplayRobot::liveTopics() { return live_.get(); }

robot::MapCatalogue* ReplayRobot::mapCatalogue() { return origin_->mapCatalogue() ? maps_.get() : nullptr; }

void ReplayRobot::onMapInfo(const std::optional<map::MapInfo>& info) {
  const auto named = [](const std::optional<map::MapInfo>& one) {
    return one ? std::pair(one->uid, one->name) : std::pair<std::string, std::string>();
  };
  const bool other = named(map_info_) != named(info);
  map_info_ = info;
  if (other) Q_EMIT mapsChanged();
}

robot::Absence ReplayRobot::unavailableReason(robot::Capability capability) const {
  using robot::Capability;
  const bool changes = capability == Capability::WaypointEditing ||
                       capability == Capability::Administration || capability == Capability::PictureEditing ||
                       capability == Capability::OverlayEditing;
  // There is no robot: the data comes from the bag.
  return changes ? robot::Absence{robot::Absence::Reason::LocalFiles, {name_}}
                 : origin_->unavailableReason(capability);
}

void ReplayRobot::connectToRobot() {
  if (state_.phase == ConnectionPhase::Online || state_.phase == ConnectionPhase::Connecting) return;
  setState(inPhase(ConnectionPhase::Connecting));
  find();
}

void ReplayRobot::disconnectFromRobot() {
  finding_.cancel();
  look_again_.stop();
  reading_.reset();
  at_s_.reset();
  knowledge_ = Knowledge::Buffering;
  setState({});
}

void ReplayRobot::lookAgain() {
  if (reading_ && reading_->info() && at_s_) look_again_.start(0);
}

void ReplayRobot::find() {
  robot::BagLibrary* const library = origin_->bagLibrary();
  if (!library) {
    refuse({.kind = map::FailureKind::Unsupported,
            .subject = {map::SubjectKind::Bag, name_},
            .reason = map::FailureReason::NotOffered,
            .cause = lackOfBags(origin_->unavailableReason(robot::Capability::Bags))});
    return;
  }
  if (key_) return open(*key_);
  finding_ = library->list([this, alive = alive_](const robot::Outcome<std::vector<robot::BagEntry>>& rows) {
    if (!*alive || state_.phase != ConnectionPhase::Connecting) return;
    robot::BagKey key{robot::BagKind::Bag, name_};
    bool found = false;
    for (const robot::BagEntry& row : rows ? *rows : std::vector<robot::BagEntry>()) {
      if (row.key.name != name_ || (found && row.key.kind == robot::BagKind::Recording)) continue;
      key = row.key;
      found = true;
    }
    open(key);
  });
}

void ReplayRobot::open(robot::BagKey key) {
  reading_ = std::make_unique<Reading>(*origin_->bagLibrary(), std::move(key), options_);
  connect(reading_.get(), &Reading::opened, this, [this] {
    const QPointer<ReplayRobot> alive(this);
    setState(inPhase(ConnectionPhase::Online));
    if (alive && at_s_) goTo(*at_s_);
  });
  connect(reading_.get(), &Reading::failed, this, &ReplayRobot::refuse);
  connect(reading_.get(), &Reading::changed, this, [this] {
    const QPointer<ReplayRobot> alive(this);
    reportHoles();
    if (!alive || !at_s_ || knowledge_ == Knowledge::Exact) return;
    // While looking back, computing the world of each range on the way would cost more than it shows.
    if (knowledge_ == Knowledge::Buffering || reading_->chunks().settledUntil(*at_s_)) {
      jump();
    } else if (!look_again_.isActive()) {
      look_again_.start(kLookAgainMs);
    }
  });
  connect(reading_.get(), &Reading::replaced, this, [this](Tick from) {
    if (at_s_ && *at_s_ >= secondsOf(from)) lookAgain();
  });
  reading_->open();
}

void ReplayRobot::refuse(const map::Failure& failure) {
  Fault reason = failure.cause;
  if (!reason.any()) reason = {robot::fault::ItAnswered, {failure.detail}};
  robot::ConnectionState state = inPhase(ConnectionPhase::Refused);
  state.reason = std::move(reason);
  state.failure = failure.kind;
  setState(std::move(state));
}

void ReplayRobot::setState(robot::ConnectionState state) {
  if (state == state_) return;
  state_ = std::move(state);
  Q_EMIT connectionChanged();
}

void ReplayRobot::setKnowledge(Knowledge knowledge) {
  if (std::exchange(knowledge_, knowledge) != knowledge) Q_EMIT knowledgeChanged();
}

void ReplayRobot::goTo(double at_s) {
  if (!reading_ || !reading_->info()) {
    at_s_ = at_s;
    return;
  }
  if (at_s_ && at_s >= *at_s_ && knowledge_ == Knowledge::Exact && playTo(at_s)) return;
  at_s_ = at_s;
  reading_->want(at_s);
  const QPointer<ReplayRobot> alive(this);
  reportHoles();
  if (alive) jump();
}

void ReplayRobot::reportHoles() {
  if (!reading_ || !reading_->info() || !at_s_) return;
  std::vector<Hole> holes = reading_->chunks().holes(-HUGE_VAL, *at_s_);
  if (holes == reported_) return;
  reported_ = std::move(holes);
  const map::Subject bag = subjectOf(reading_->key());
  if (reported_.empty()) {
    Q_EMIT recovered({bag, map::ProblemCode::Unavailable});
  } else {
    Q_EMIT problemFound({map::Severity::Warning, bag, faultOf(reported_), map::ProblemCode::Unavailable});
  }
}

bool ReplayRobot::playTo(double at_s) {
  std::vector<ChunkPtr> passed;
  const Cell* cell = reading_->chunks().cellAt(*at_s_);
  const Cell* last = reading_->chunks().cellAt(at_s);
  if (!cell || !last) return false;
  for (auto it = reading_->chunks().cells().find(cell->from); it != reading_->chunks().cells().end(); ++it) {
    ChunkPtr chunk = reading_->chunkAt(it->first);
    if (!chunk) return false;
    passed.push_back(std::move(chunk));
    if (it->first == last->from) break;
  }
  const double from_s = std::exchange(at_s_, at_s).value();
  const QPointer<ReplayRobot> alive(this);
  for (const ChunkPtr& chunk : passed) {
    const std::size_t end = chunk->countUntil(at_s);
    for (std::size_t i = chunk->countUntil(from_s); i < end; ++i) {
      const robot::BagMessage& message = chunk->at(i);
      if (isRecorded(message)) topics_[message.message.topic] = message.message.received_s;
      if (watching_ && isRecorded(message)) Q_EMIT rawReceived(rawOf(*chunk, message));
      if (!alive || at_s_ != at_s) return true;
      if (!message.known) continue;
      const auto* grid = std::get_if<map::GridMessage>(&message.message.message);
      if (grid && !message.picture_url.empty()) {
        fetchPicture(*grid, message.picture_url);
        continue;
      }
      Q_EMIT topicReceived(message.message);
      if (!alive || at_s_ != at_s) return true;
      if (const auto* const info = std::get_if<map::MapInfo>(&message.message.message)) onMapInfo(*info);
      if (!alive || at_s_ != at_s) return true;
    }
  }
  reading_->want(at_s);
  return true;
}

void ReplayRobot::jump() {
  const Moment moment = reading_->moment();
  if (moment.knowledge == Knowledge::Buffering) {
    setKnowledge(Knowledge::Buffering);
    return;
  }
  topics_ = moment.topics;
  knowledge_ = moment.knowledge;
  const QPointer<ReplayRobot> alive(this);
  map::World world = moment.at.world;
  for (auto& [kind, picture] : std::exchange(pictures_, {})) picture.call.cancel();
  for (const auto& [kind, url] : moment.at.pictures) {
    fetchPicture(world.live.grids.at(kind), url);
    world.live.grids.erase(kind);
  }
  const std::optional<map::MapInfo> info = world.live.map_info;
  Q_EMIT jumped(world, moment.knowledge);
  if (alive) onMapInfo(info);
  if (alive) Q_EMIT knowledgeChanged();
  if (alive) notifyLastRaw();
}

void ReplayRobot::notifyLastRaw() {
  const Cell* const cell =
      watching_ && reading_ && reading_->info() && at_s_ ? reading_->chunks().cellAt(*at_s_) : nullptr;
  const ChunkPtr chunk = cell ? reading_->chunkAt(cell->from) : nullptr;
  if (!chunk) return;
  std::map<std::string, const robot::BagMessage*> last;
  for (const std::uint32_t i : chunk->back_filled) {
    const robot::BagMessage& message = chunk->source->messages[i];
    if (isRecorded(message)) last[message.message.topic] = &message;
  }
  for (std::size_t i = 0; i < chunk->countUntil(*at_s_); ++i) {
    if (isRecorded(chunk->at(i))) last[chunk->at(i).message.topic] = &chunk->at(i);
  }
  const QPointer<ReplayRobot> alive(this);
  for (const auto& [topic, message] : last) {
    Q_EMIT rawReceived(rawOf(*chunk, *message));
    if (!alive) return;
  }
}

void ReplayRobot::fetchPicture(const map::GridMessage& grid, const std::string& url) {
  const std::uint64_t number = ++last_picture_;
  if (auto before = pictures_.extract(grid.kind)) before.mapped().call.cancel();
  Picture& picture = pictures_[grid.kind];
  picture.number = number;
  picture.call = origin_->bagLibrary()->picture(
      grid.topic, url,
      [this, alive = alive_, grid, url,
       number](const robot::Outcome<std::shared_ptr<const std::string>>& outcome) {
        if (!*alive) return;
        const auto waiting = pictures_.find(grid.kind);
        if (waiting == pictures_.end() || waiting->second.number != number) return;
        pictures_.erase(waiting);
        if (!outcome) {
          Q_EMIT problemFound(map::problemOf(outcome.error(), map::Severity::Warning));
          return;
        }
        map::GridMessage whole = grid;
        whole.png = *outcome;
        whole.body_bytes = whole.png->size();
        // It belongs to the present, however old it is: an earlier stamp would cut the trail.
        Q_EMIT topicReceived({std::move(whole), at_s_.value_or(0), std::nullopt, grid.topic});
      });
}

}  // namespace mapwright::replay

#include "moc_replay_robot.cpp"
