#include "ui/shell/replay_clock.h"

#include <algorithm>
#include <utility>

#include "replay/world_at.h"

namespace mapwright::ui {

using replay::Knowledge;
using replay::Millis;
using replay::Player;

namespace {

constexpr Millis kReplayFrameMs = 16;
// Moves may be slow; at least as much time is left for everything else.
constexpr Millis kLongestPauseMs = 250;

}  // namespace

ReplayClock::ReplayClock(std::function<Millis()> now, QObject* parent)
    : QObject(parent), now_(std::move(now)) {
  clock_.start();
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &ReplayClock::proceed);
}

ReplayClock::~ReplayClock() = default;

void ReplayClock::attach(replay::ReplayRobot& robot, session::Session& session) {
  detach();
  robot_ = &robot;
  session_ = &session;
  connect(&robot, &replay::ReplayRobot::jumped, &session,
          [&session](const map::World& world, Knowledge knowledge) {
            // While looking back, the former submaps are better than none.
            session.reset(world, knowledge == Knowledge::Exact);
          });
  connect(&robot, &robot::Robot::connectionChanged, this, &ReplayClock::open);
  connect(&robot, &replay::ReplayRobot::knowledgeChanged, this, &ReplayClock::updateState);
  open();
}

void ReplayClock::detach() {
  timer_.stop();
  if (robot_) {
    robot_->disconnect(this);
    if (session_) robot_->disconnect(session_);
    if (robot_->reading()) robot_->reading()->disconnect(this);
  }
  robot_.clear();
  session_.clear();
  gone_to_.reset();
  told_ = {};
  if (std::exchange(player_, std::nullopt)) Q_EMIT closed();
}

void ReplayClock::open() {
  replay::Reading* const reading = robot_ ? robot_->reading() : nullptr;
  if (player_ || !reading || !reading->info()) return;
  player_.emplace(reading->chunks().start_s(), reading->chunks().end_s());
  untouched_ = true;
  connect(reading, &replay::Reading::changed, this, &ReplayClock::onRead);
  Q_EMIT opened();
  goSoon();
}

double ReplayClock::at() const { return player_ ? player_->at(now()) : 0; }

replay::Reading* ReplayClock::reading() const { return player_ && robot_ ? robot_->reading() : nullptr; }

Knowledge ReplayClock::knowledge() const { return robot_ ? robot_->knowledge() : Knowledge::Buffering; }

double ReplayClock::lookedBack() const { return readShareUntil(at()); }

double ReplayClock::readShare() const {
  const replay::Reading* const reading = this->reading();
  if (!reading) return 0;
  return reading->chunks().wholeRead() ? 1 : std::min(readShareUntil(end()), 1 - 1e-9);
}

double ReplayClock::readShareUntil(double until_s) const {
  const replay::Reading* const reading = this->reading();
  if (!reading) return 0;
  double of_s = 0, read_s = 0;
  for (const auto& [from, cell] : reading->chunks().cells()) {
    const double begins_s = std::max(replay::secondsOf(cell.from), start());
    const double ends_s = std::min(replay::secondsOf(cell.until), end());
    if (begins_s > until_s || ends_s <= begins_s) continue;
    of_s += ends_s - begins_s;
    if (cell.state == replay::CellState::Read) read_s += ends_s - begins_s;
  }
  return of_s > 0 ? read_s / of_s : 1;
}

bool ReplayClock::playing() const { return player_ && player_->playing(now()); }

std::optional<Player::Loop> ReplayClock::loop() const { return player_ ? player_->loop() : std::nullopt; }

std::optional<geometry::Pose2> ReplayClock::poseBetween() const {
  const replay::Reading* const reading = this->reading();
  if (!reading || knowledge() == Knowledge::Buffering) return std::nullopt;
  return replay::poseBetween(reading->index(), at());
}

void ReplayClock::play() {
  if (!player_) return;
  untouched_ = false;
  player_->playUntil(std::nullopt, now());
  player_->play(now());
  updateState();
  goSoon();
}

void ReplayClock::pause() {
  if (!player_) return;
  player_->pause(now());
  updateState();
  goSoon();
}

void ReplayClock::setSpeed(double speed) {
  if (!player_) return;
  player_->setSpeed(speed, now());
  Q_EMIT stateChanged();
  goSoon();
}

void ReplayClock::setLoop(std::optional<Player::Loop> loop) {
  if (!player_) return;
  player_->setLoop(loop, now());
  Q_EMIT stateChanged();
  goSoon();
}

void ReplayClock::playUntil(double until_s) {
  if (!player_ || until_s <= at()) return;
  player_->setSpeed(std::abs(player_->speed()), now());
  player_->setLoop(std::nullopt, now());
  player_->playUntil(until_s, now());
  Q_EMIT stateChanged();
  goSoon();
}

void ReplayClock::step(double by_s) {
  if (!player_) return;
  untouched_ = false;
  player_->step(by_s, now());
  Q_EMIT timeChanged(at());
  updateState();
  goSoon();
}

void ReplayClock::seek(double at_s) {
  if (!player_) return;
  untouched_ = false;
  player_->seek(at_s, now());
  Q_EMIT timeChanged(at());
  goSoon();
}

void ReplayClock::stepMessage(int direction) {
  const replay::Reading* const reading = this->reading();
  const replay::Cell* const here = reading ? reading->chunks().cellAt(at()) : nullptr;
  if (!here) return;
  const auto& cells = reading->chunks().cells();
  auto cell = cells.find(here->from);
  while (true) {
    const replay::ChunkPtr chunk = reading->chunkAt(cell->first);
    const bool lost = !chunk && cell->second.lost;
    if (!chunk && !lost && cell->first == here->from) return;  // it is being read
    // Go to missing data: playback continues there.
    if (!chunk && !lost)
      return step((direction > 0 ? replay::secondsOf(cell->second.from)
                                 : std::min(replay::secondsOf(cell->second.until), end())) -
                  at());
    std::optional<double> stamp_s;
    if (chunk) stamp_s = direction > 0 ? replay::stampAfter(*chunk, at()) : replay::stampBefore(*chunk, at());
    if (stamp_s) return step(*stamp_s - at());
    if (direction < 0 && cell == cells.begin()) return;
    direction > 0 ? ++cell : --cell;
    if (cell == cells.end()) return;
  }
}

void ReplayClock::retry() {
  if (replay::Reading* const reading = this->reading()) reading->retryNow();
}

void ReplayClock::goSoon() {
  if (player_) timer_.start(int(std::max<Millis>(0, went_ + pause_ms_ - clock_.elapsed())));
}

void ReplayClock::proceed() {
  if (!player_ || !robot_) return;
  const double at_s = at();
  const bool moved = std::exchange(gone_to_, at_s) != at_s;
  const Millis began = clock_.elapsed();
  // The time must not advance while the state is being shown.
  if (moved) robot_->goTo(at_s);
  if (!player_) return;  // closed by a slot of this signal
  if (moved) Q_EMIT timeChanged(at_s);
  went_ = clock_.elapsed();
  pause_ms_ = std::clamp(went_ - began, kReplayFrameMs, kLongestPauseMs);
  updateState();
  if (player_ && player_->playing(now())) goSoon();
}

void ReplayClock::updateState() {
  if (!player_) return;
  // The robot may know of a range before this does: what opens at the first map has been nowhere else.
  if (knowledge() == Knowledge::Exact && goToFirstMap()) return;
  player_->setWaiting(knowledge() == Knowledge::Buffering, now());
  const State state{playing(), player_->waiting(), knowledge()};
  if (std::exchange(told_, state) != state) Q_EMIT stateChanged();
  if (state.playing && !timer_.isActive()) goSoon();
}

void ReplayClock::onRead() {
  const replay::Reading* const reading = this->reading();
  if (!reading) return;
  player_->extend(reading->chunks().end_s());
  const auto& digests = reading->index().digests();
  if (!digests.empty()) {
    for (const auto& [topic, span] : digests.rbegin()->second.topics) player_->extend(span.last_s);
  }
  goToFirstMap();
  Q_EMIT rangesChanged();
}

bool ReplayClock::goToFirstMap() {
  const replay::Reading* const reading = untouched_ ? this->reading() : nullptr;
  const replay::Cell* const here = reading ? reading->chunks().cellAt(at()) : nullptr;
  const replay::ChunkPtr chunk = here ? reading->chunkAt(here->from) : nullptr;
  if (!chunk) return false;
  untouched_ = false;
  auto first_s = replay::stampOfFirstMap(*chunk);
  if (!first_s || *first_s <= at())
    first_s = chunk->countUntil(at()) == 0 ? replay::stampAfter(*chunk, at()) : std::nullopt;
  if (first_s) seek(*first_s);
  return first_s.has_value();
}

}  // namespace mapwright::ui

#include "moc_replay_clock.cpp"
