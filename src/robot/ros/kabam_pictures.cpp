#include "robot/ros/kabam_pictures.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/ros_calls.h"

namespace mapwright::robot::ros {
namespace {

constexpr int kEdge = grids::GridPyramid::kTileEdge;
constexpr int kBandRows = 16;  // divides the edge of a tile
constexpr char kTail[] = "\"}}";
constexpr qint64 kTailBytes = sizeof kTail - 1;

std::string pgmHead(int width, int height) {
  return "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
}

/// Rows `from` to `to` (exclusive) of one band of tiles, joined.
std::vector<std::uint8_t> rowsOf(const grids::GridPyramid& cells, int from, int to) {
  const std::size_t width = std::size_t(cells.width());
  std::vector<std::uint8_t> rows(width * std::size_t(to - from), grids::kUnknownOccupancy);
  for (int x = 0; x * kEdge < cells.width(); ++x) {
    const auto tile = cells.tile(0, x, from / kEdge);
    if (!tile) continue;
    const std::size_t left = std::size_t(x) * kEdge, part = std::min(std::size_t(kEdge), width - left);
    for (int row = from; row < to; ++row) {
      std::memcpy(rows.data() + std::size_t(row - from) * width + left,
                  tile->cells.get() + std::size_t(row % kEdge) * kEdge, part);
    }
  }
  return rows;
}

using net::rosbridge::CallAnswer;
using std::chrono::milliseconds;

/// The expected minimum speed.
constexpr std::int64_t kBytesPerMs = 1024;

map::Failure unfit(const map::Subject& subject, Fault cause) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = subject,
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Unfit,
          .cause = std::move(cause)};
}

milliseconds timeFor(const grids::GridPyramid& cells) {
  return milliseconds(std::int64_t(cells.width()) * cells.height() / kBytesPerMs);
}

}  // namespace

std::optional<std::uint8_t> shadeOf(std::uint8_t cell) {
  constexpr std::uint8_t kFree = 0, kOccupied = 100;
  switch (cell) {
    case kFree:
      return std::uint8_t(254);
    case kOccupied:
      return std::uint8_t(0);
    case grids::kUnknownOccupancy:
      return std::uint8_t(205);
    default:
      return std::nullopt;
  }
}

PictureArgs::PictureArgs(const KabamMap& map, std::shared_ptr<const grids::GridPyramid> cells,
                         std::function<bool()> wanted)
    : cells_(std::move(cells)), wanted_(std::move(wanted)) {
  head_ = updateImageHead(map, cells_->width(), cells_->height());
  const std::string head = pgmHead(cells_->width(), cells_->height());
  hash_.addData(QByteArrayView(head.data(), qsizetype(head.size())));
}

qint64 PictureArgs::bytes() const {
  const qint64 cells = qint64(cells_->width()) * cells_->height();
  return head_.size() + (cells + 2) / 3 * 4 + kTailBytes;
}

/// Complete groups of three; the rest waits.
std::optional<QByteArray> PictureArgs::next() {
  if (between_ || !wanted_()) return std::nullopt;
  QByteArray text = std::exchange(began_, true) ? QByteArray() : head_;
  while (row_ < cells_->height() && text.isEmpty()) {
    if (!makeBand()) return std::nullopt;
    const bool last = row_ == cells_->height();
    const qsizetype whole = last ? shades_.size() : shades_.size() / 3 * 3;
    text = shades_.first(whole).toBase64();
    shades_.remove(0, whole);
    if (last) text += kTail;
  }
  if (row_ == cells_->height() && fingerprint_.empty()) fingerprint_ = hash_.result().toHex().toStdString();
  return text;
}

bool PictureArgs::makeBand() {
  static const std::vector<std::optional<std::uint8_t>> kShades = [] {
    std::vector<std::optional<std::uint8_t>> shades;
    for (int cell = 0; cell < 256; ++cell) shades.push_back(shadeOf(std::uint8_t(cell)));
    return shades;
  }();
  const int to = std::min(row_ + kBandRows, cells_->height());
  const std::vector<std::uint8_t> rows = rowsOf(*cells_, row_, to);
  hash_.addData(QByteArrayView(rows.data(), qsizetype(rows.size())));
  const qsizetype held = shades_.size();
  shades_.resize(held + qsizetype(rows.size()));
  char* out = shades_.data() + held;
  for (const std::uint8_t cell : rows) {
    if (!kShades[cell]) {
      between_ = cell;
      return false;
    }
    *out++ = char(*kShades[cell]);
  }
  row_ = to;
  return true;
}

std::optional<std::int64_t> differingCells(const grids::GridPyramid& cells, const std::string& pgm) {
  const std::string head = pgmHead(cells.width(), cells.height());
  const std::size_t width = std::size_t(cells.width());
  if (!pgm.starts_with(head) || pgm.size() - head.size() != width * std::size_t(cells.height()))
    return std::nullopt;
  std::int64_t differing = 0;
  const char* shown = pgm.data() + head.size();
  for (int row = 0; row < cells.height(); row += kBandRows) {
    const std::vector<std::uint8_t> rows = rowsOf(cells, row, std::min(row + kBandRows, cells.height()));
    for (const std::uint8_t cell : rows) differing += std::uint8_t(*shown++) != cell;
  }
  return differing;
}

KabamPictures::KabamPictures(Parts parts, KabamTimeouts timeouts, milliseconds settles)
    : of_(std::move(parts)), timeouts_(timeouts) {
  settle_.setSingleShot(true);
  settle_.setInterval(settles);
  connect(&settle_, &QTimer::timeout, this, &KabamPictures::compare);
  connect(&of_.live_map, &LiveMap::came, &waits_, &wire::WaitList::look);
}

void KabamPictures::write(const wire::TaskPtr& task, const PictureChange& change,
                          OutcomeTo<PictureReceipt> reply) {
  const auto writing = std::make_shared<Writing>();
  writing->change = change;
  writing->reply = std::move(reply);
  writing->task = task;
  of_.requests.describe(task, change.map,
                        withValue<map::CatalogueEntry>(
                            writing->reply,
                            [this, writing](const map::CatalogueEntry& entry) {
                              writing->name = entry.name;
                              if (entry.is_current) return readAgain(writing);
                              end(writing, fail(unfit(writing->subject(), {fault::OnlyCurrentMapTaken})));
                            }),
                        map::AskedFor::Change);
}

void KabamPictures::readAgain(const WritingPtr& writing) {
  // If it is already subscribed, there may be no further message: request it again.
  of_.live_map.forget();
  of_.ask_again();
  writing->listening = of_.live_map.listen();
  of_.live_map.fetch(
      writing->task, writing->change.map, writing->name,
      [this, writing](Outcome<map::WholeMap> now) {
        if (!now) {
          now.error().asked_for = map::AskedFor::Change;
          now.error().subject = writing->subject();
          return end(writing, fail(std::move(now.error())));
        }
        if (auto failure = conflict(*writing)) return end(writing, fail(std::move(*failure)));
        send(writing);
      },
      timeFor(*writing->change.cells));
}

/// What is on the robot now is not what the change was made of, or is no more the map that the robot sends.
/// Of what is not known now (on a connection that is new) nothing is said.
std::optional<map::Failure> KabamPictures::conflict(const Writing& writing) const {
  const KabamState& state = of_.requests.state();
  if (state.current() && !state.isCurrent(writing.change.map.id))
    return unfit(writing.subject(), {fault::OnlyCurrentMapTaken});
  const auto& last = of_.live_map.last();
  const grids::GridPyramid& cells = *writing.change.cells;
  const bool fits = !last || (last->fingerprint == writing.change.revision &&
                              last->grid.width == cells.width() && last->grid.height == cells.height());
  if (fits) return std::nullopt;
  return map::Failure{
      .kind = map::FailureKind::Conflict,
      .subject = writing.subject(),
      .asked_for = map::AskedFor::Change,
      .cause = {faultText("ros", "the picture of \"%1\" was changed on the robot in the meantime"),
                {writing.name}}};
}

bool KabamPictures::shows(const std::string& fingerprint) const {
  return of_.live_map.last() && of_.live_map.last()->fingerprint == fingerprint;
}

void KabamPictures::send(const WritingPtr& writing) {
  KabamState& state = of_.requests.state();
  const KabamMap map = state.find(writing->change.map.id).value_or(KabamMap{});
  writing->args =
      std::make_shared<PictureArgs>(map, writing->change.cells, [this, asked = std::weak_ptr(writing)] {
        const WritingPtr now = asked.lock();
        // Changes by others during the upload are not overwritten silently.
        if (now) now->changed_meanwhile = conflict(*now).has_value();
        return now && !now->changed_meanwhile;
      });
  net::rosbridge::CallRequest request;
  request.service = state.ns() + "/update_map_image";
  request.made_while_sent = writing->args;
  request.travelled = [task = writing->task](qint64 bytes, qint64 of_bytes) {
    task->reportProgress({bytes, of_bytes});
  };
  request.large = true;
  request.timeout = timeouts_.call + timeFor(*writing->change.cells);
  call(writing->task, of_.client, std::move(request),
       [this, writing](const CallAnswer& answer) { onAnswer(writing, answer); });
}

void KabamPictures::onAnswer(const WritingPtr& writing, const CallAnswer& answer) {
  const map::Subject subject = writing->subject();
  const bool answered = answer.kind == CallAnswer::Kind::Answered;
  if (!answer.sent) {
    if (const auto cell = writing->args->cellBetween()) {
      return end(writing, fail(unfit(subject, {fault::CellBetweenKinds, {std::int64_t(*cell)}})));
    }
    if (writing->changed_meanwhile) {
      if (auto failure = conflict(*writing)) return end(writing, fail(std::move(*failure)));
    }
  }
  writing->doubt = answered ? resultOf("update_map_image", answer.values, subject)
                            : std::optional(failed(answer, subject, map::AskedFor::Change));
  const bool maybe_done = !writing->doubt || writing->doubt->applied != map::Applied::No;
  // What the robot sent before says nothing about what has become of it.
  if (maybe_done && !shows(writing->args->fingerprint())) of_.live_map.forget();
  // If only the connection for large data broke off, the map still comes.
  const bool map_comes = answer.kind == CallAnswer::Kind::LinkLost && answer.sent && of_.known();
  if (!writing->doubt || !isFinal(*writing->doubt) || map_comes) return confirm(writing);
  // Once there is a connection again, the map tells what has become of it.
  if (maybe_done) doubt(writing->change.map.id);
  end(writing, fail(*writing->doubt));
}

/// Waits for the map to show it; requests it once more half-way, in case it is not sent automatically.
void KabamPictures::confirm(const WritingPtr& writing) {
  writing->within = timeouts_.confirm + timeFor(*writing->change.cells);
  writing->confirming = true;
  QTimer::singleShot(writing->within / 2, this, [this, held = std::weak_ptr(writing)] {
    const WritingPtr now = held.lock();
    if (now && now->confirming) of_.ask_again();
  });
  waits_.await(
      writing->task, writing->within,
      [this, writing] {
        const std::string& wanted = writing->args->fingerprint();
        return !wanted.empty() && shows(wanted);
      },
      [this, writing](wire::WaitList::End how) {
        writing->confirming = false;
        if (how == wire::WaitList::End::Held)
          return end(writing, PictureReceipt{writing->args->fingerprint()});
        doubt(writing->change.map.id);
        if (how == wire::WaitList::End::Cancelled) return end(writing, fail(cancelled(writing->subject())));
        giveUp(writing);
      });
}

void KabamPictures::giveUp(const WritingPtr& writing) {
  if (writing->doubt) return end(writing, fail(std::move(*writing->doubt)));
  const auto& last = of_.live_map.last();
  const bool other = last && last->png && !shows(writing->change.revision) &&
                     of_.requests.state().isCurrent(writing->change.map.id);
  const auto cells = other ? differingCells(*writing->change.cells, *last->png) : std::nullopt;
  if (!cells) return end(writing, fail(unconfirmed(writing->subject(), writing->within)));
  map::Failure failure = unfit(writing->subject(), {fault::PictureShownOtherwise, {*cells}});
  failure.kind = map::FailureKind::RejectedByRobot;
  failure.applied = map::Applied::Yes;
  end(writing, fail(std::move(failure)));
}

void KabamPictures::doubt(const std::string& map_id) {
  if (!of_.live_map.last()) of_.ask_again();
  doubted_.insert(map_id);
  settle_.start();
}

void KabamPictures::compare() {
  const KabamState& state = of_.requests.state();
  const bool told = of_.known() && of_.requests.there() && state.current() && !state.isMapping();
  if (!told || state.current()->map.id.empty()) return;
  const std::string& id = state.current()->map.id;
  const auto& last = of_.live_map.last();
  bool other = doubted_.erase(id) > 0;
  if (last) {
    std::string& seen = seen_[id];
    other |= !seen.empty() && seen != last->fingerprint;
    seen = last->fingerprint;
  }
  if (other) Q_EMIT changed(QString::fromStdString(id));
}

void KabamPictures::end(const WritingPtr& writing, Outcome<PictureReceipt> outcome) {
  if (!outcome && outcome.error().kind == map::FailureKind::Conflict) doubt(writing->change.map.id);
  writing->reply(std::move(outcome));
  writing->listening.reset();
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_pictures.cpp"
