#include "replay/reading.h"

#include <algorithm>
#include <utility>

#include "map/failure.h"

namespace mapwright::replay {
namespace {

constexpr double kBeforeAllS = -1e300;

robot::BagChunkPtr nothingIn(const Cell& cell) {
  auto nothing = std::make_shared<robot::BagChunk>();
  nothing->from_s = secondsOf(cell.from);
  nothing->until_s = secondsOf(cell.until);
  return nothing;
}

}  // namespace

Reading::Reading(robot::BagLibrary& library, robot::BagKey key, Options options, QObject* parent)
    : QObject(parent), library_(library), key_(std::move(key)), options_(std::move(options)) {
  clock_.start();
  wake_.setSingleShot(true);
  making_.setMaxThreadCount(1);
  connect(&wake_, &QTimer::timeout, this, &Reading::proceed);
  connect(&look_again_, &QTimer::timeout, this, &Reading::lookAgain);
}

Reading::~Reading() {
  *alive_ = false;
  opening_.cancel();
  looking_.cancel();
  for (const auto& [from, asked] : asked_) asked.call.cancel();
  making_.waitForDone();
}

void Reading::open() {
  opening_.cancel();
  opening_ = library_.info(key_, [this, alive = alive_](robot::Outcome<robot::BagInfo> outcome) {
    if (!*alive) return;
    if (!outcome) {
      Q_EMIT failed(outcome.error());
      return;
    }
    info_ = *outcome;
    chunks_.emplace(*info_, options_.chunks);
    if (options_.look_again_ms > 0 && key_.kind == robot::BagKind::File)
      look_again_.start(options_.look_again_ms);
    Q_EMIT opened();
  });
}

void Reading::lookAgain() {
  if (!chunks_ || looks_ || key_.kind != robot::BagKind::File) return;
  looks_ = true;
  looking_ = library_.info(key_, [this, alive = alive_](const robot::Outcome<robot::BagInfo>& outcome) {
    if (!*alive) return;
    looks_ = false;
    // What cannot be checked now may be available the next time; reading reports errors.
    if (outcome && !(*outcome == *info_)) lengthen(*outcome);
  });
}

void Reading::lengthen(const robot::BagInfo& info) {
  info_ = info;
  for (const Tick from : chunks_->lengthen(info)) {
    // Requests in progress may be outdated.
    if (auto asked = asked_.extract(from)) {
      asked.mapped().call.cancel();
      if (chunks_->find(from)) chunks_->cancelled(from);
    }
    if (chunks_->isStale(from)) continue;
    held_.erase(from);
    index_.forget(from);
  }
  proceed();
  Q_EMIT changed();
}

void Reading::want(double at_s) {
  if (!chunks_) return;
  chunks_->want(at_s);
  proceed();
}

void Reading::setWhole(bool whole) {
  options_.chunks.whole = whole;
  if (!chunks_) return;
  chunks_->setWhole(whole);
  proceed();
}

void Reading::readAgain(const std::vector<Tick>& ranges) {
  if (!chunks_) return;
  chunks_->readAgain(ranges);
  proceed();
}

void Reading::readAnew() {
  if (!chunks_) return;
  for (const auto& [from, asked] : std::exchange(asked_, {})) asked.call.cancel();
  held_.clear();
  index_.clear();
  const std::optional<double> wanted = chunks_->wanted();
  chunks_.emplace(*info_, options_.chunks);
  if (wanted) chunks_->want(*wanted);
  proceed();
  Q_EMIT changed();
}

void Reading::retryNow() {
  if (!chunks_) return;
  chunks_->retryNow();
  proceed();
}

ChunkPtr Reading::chunkAt(Tick from) const {
  const auto found = held_.find(from);
  return found == held_.end() ? nullptr : found->second;
}

void Reading::proceed() {
  for (const Tick from : chunks_->toCancel()) {
    chunks_->cancelled(from);
    // Its reply still comes, but is ignored.
    if (auto asked = asked_.extract(from)) asked.mapped().call.cancel();
  }
  for (const Tick from : chunks_->toDrop()) {
    chunks_->dropped(from);
    held_.erase(from);
  }
  for (const Tick from : chunks_->next(now())) ask(from);
  if (const auto at = chunks_->wakesAt(now())) wake_.start(int(std::max<Millis>(*at - now(), 0)) + 1);
}

void Reading::ask(Tick from) {
  const Cell& cell = *chunks_->find(from);
  const std::uint64_t number = ++last_number_;
  chunks_->begun(from);
  Asked& asked = asked_[from];
  asked.number = number;
  robot::BagRange range{secondsOf(cell.from), secondsOf(cell.until)};
  // Until everything before has been read, this is the best available.
  const Cell* const here = chunks_->wanted() ? chunks_->cellAt(*chunks_->wanted()) : nullptr;
  const auto known = chunks_->cells().find(from);
  range.back_fill = here && from >= here->from && known != chunks_->cells().begin() &&
                    !chunks_->readUntil(secondsOf(std::prev(known)->second.from));
  range.whole_texts = options_.whole_texts;
  asked.call = library_.messages(
      key_, range, [this, alive = alive_, from, number](const robot::Outcome<robot::BagChunkPtr>& outcome) {
        if (!*alive || !isAwaited(from, number)) return;
        if (outcome) {
          make(from, number, *outcome);
        } else {
          asked_.erase(from);
          miss(from, outcome.error());
        }
      });
}

bool Reading::isAwaited(Tick from, std::uint64_t number) {
  const auto asked = asked_.find(from);
  return asked != asked_.end() && asked->second.number == number;
}

Reading::Made Reading::made(robot::BagChunkPtr answer) {
  Made result;
  result.chunk = std::make_shared<const Chunk>(inRange(std::move(answer)));
  result.digest = digestOf(*result.chunk);
  return result;
}

void Reading::make(Tick from, std::uint64_t number, const robot::BagChunkPtr& answer) {
  making_.start([this, from, number, answer] {
    const auto result = std::make_shared<Made>(made(answer));
    QMetaObject::invokeMethod(
        this,
        [this, from, number, result] {
          if (!isAwaited(from, number)) return;
          asked_.erase(from);
          hold(from, std::move(*result));
          proceed();
          Q_EMIT changed();
        },
        Qt::QueuedConnection);
  });
}

void Reading::hold(Tick from, Made made) {
  // Reading a range again does not change its digest, except at the end of a growing file.
  const bool again = index_.digests().contains(from), grown = again && chunks_->isStale(from);
  chunks_->read(from, made.chunk->bytes(), made.digest.messages);
  if (!again || grown) index_.add(from, std::move(made.digest));
  const ChunkPtr chunk = held_.insert_or_assign(from, std::move(made.chunk)).first->second;
  const std::shared_ptr<bool> alive = alive_;
  Q_EMIT chunkRead(chunk);
  if (*alive && grown) Q_EMIT replaced(from);
}

void Reading::miss(Tick from, const map::Failure& failure) {
  const Cell cell = *chunks_->find(from);
  chunks_->failed(from, failure, now());
  const Cell* after = chunks_->find(from);
  if (after && after->state == CellState::Read && !held_.contains(from)) {
    // The robot has no data there.
    hold(from, made(nothingIn(cell)));
  }
  proceed();
  Q_EMIT changed();
}

const map::TopicMessage* Reading::contentAt(Tick from, std::uint32_t index) const {
  const ChunkPtr chunk = chunkAt(from);
  return chunk && index < chunk->order.size() ? &chunk->at(index).message.message : nullptr;
}

Moment Reading::moment() {
  Moment moment;
  const std::optional<double> at_s = chunks_ ? chunks_->wanted() : std::nullopt;
  const Cell* here = at_s ? chunks_->cellAt(*at_s) : nullptr;
  if (!here) {
    // In an empty bag nothing is missing.
    if (chunks_ && chunks_->cells().empty()) moment.knowledge = Knowledge::Exact;
    return moment;
  }
  const Tick from = here->from;
  ChunkPtr chunk = chunkAt(from);
  if (!chunk && here->tries > 0) chunk = made(nothingIn(*here)).chunk;
  if (!chunk) return moment;
  const bool complete = chunks_->readUntil(*at_s), settled = chunks_->settledUntil(*at_s);
  moment.at = worldAt(index_, from, *chunk, *at_s, complete,
                      [this](Tick other, std::uint32_t index) { return contentAt(other, index); });
  moment.topics = topicsAt(index_, from, *chunk, *at_s, complete);
  moment.knowledge = settled && moment.at.missing.empty() ? Knowledge::Exact : Knowledge::LookingBack;
  // What the world uses must stay in memory, otherwise it would be requested at every step.
  std::vector<Tick> needed = moment.at.missing;
  for (const auto& [slot, source] : moment.at.sources) {
    const auto digest = index_.digests().find(source.first);
    if (source.first == from || digest == index_.digests().end()) continue;
    const auto last = digest->second.last.find(slot);
    if (last != digest->second.last.end() && !last->second.message) needed.push_back(source.first);
  }
  chunks_->need(std::move(needed));
  proceed();
  return moment;
}

RangeWalk::RangeWalk(Reading& reading, std::optional<double> from_s, std::optional<double> to_s)
    : reading_(reading), from_s_(from_s), to_s_(to_s) {
  const Cell* const first = reading_.chunks().cellAt(from_s.value_or(kBeforeAllS));
  next_s_ = from_s.value_or(kBeforeAllS);
  wantNext(first);
}

void RangeWalk::wantNext(const Cell* cell) {
  if (!cell || (to_s_ && secondsOf(cell->from) > *to_s_)) {
    next_s_.reset();
    return;
  }
  next_s_ = std::max(*next_s_, secondsOf(cell->from));
  reading_.want(*next_s_);
}

const Cell* RangeWalk::waitsFor() const { return next_s_ ? reading_.chunks().cellAt(*next_s_) : nullptr; }

ChunkPtr RangeWalk::next() {
  // Ranges may have been merged or split meanwhile.
  const Cell* cell = waitsFor();
  for (; cell && cell->lost; cell = waitsFor()) wantAfter(*cell);
  ChunkPtr chunk = cell ? reading_.chunkAt(cell->from) : nullptr;
  if (!chunk) return nullptr;
  wantAfter(*cell);
  return chunk;
}

void RangeWalk::wantAfter(const Cell& cell) {
  const auto& cells = reading_.chunks().cells();
  const auto after = cells.upper_bound(cell.from);
  wantNext(after == cells.end() ? nullptr : &after->second);
}

double RangeWalk::share() const {
  if (!next_s_) return 1;
  const Chunks& chunks = reading_.chunks();
  const double first_s = std::max(from_s_.value_or(kBeforeAllS), chunks.start_s());
  const double last_s = std::min(to_s_.value_or(-kBeforeAllS), chunks.end_s());
  return last_s > first_s ? std::clamp((*next_s_ - first_s) / (last_s - first_s), 0.0, 1.0) : 0;
}

}  // namespace mapwright::replay

#include "moc_reading.cpp"
