#include "session/layer_grids.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/faults.h"

namespace mapwright::session {
namespace {

tl::expected<grids::ColoredGrid, Fault> decoded(const map::GridMessage& message,
                                                const grids::Resources& resources) {
  const bool colours = message.reading.mode == map::CellReading::Mode::Picture;
  return colours ? grids::decodeColors(message.png, LayerGrids::kMaxCells, resources)
                 : grids::decodeOccupancy(message.png, message.reading, LayerGrids::kMaxCells, resources);
}

}  // namespace

LayerGrids::LayerGrids(grids::Resources resources, QObject* parent)
    : QObject(parent),
      resources_{work::orOwn(std::move(resources.workers)), std::move(resources.unpacked)},
      tasks_(resources_.workers) {}

LayerGrids::~LayerGrids() {
  tasks_.drop();
  tasks_.waitForDone();
}

void LayerGrids::onGrid(const map::GridMessage& message) {
  Row& row = rows_[message.kind];
  if (row.busy) {
    row.next = message;  // the one in between is never seen
    return;
  }
  start(message.kind, message);
}

void LayerGrids::start(map::GridKind kind, map::GridMessage message) {
  rows_[kind].busy = true;
  tasks_.start(work::Urgency::Wanted, [this, kind, generation = generation_, message = std::move(message)] {
    auto grid = std::make_shared<tl::expected<LayerGrid, Fault>>(LayerGrid{message.grid, {}});
    using Colors = tl::expected<grids::ColoredGrid, Fault>;
    auto colors =
        message.png
            ? decoded(message, resources_)
            : Colors(tl::make_unexpected(Fault(faultText("session", "It arrived without a picture."))));
    if (const auto why = map::unusableReason(message.grid)) {
      *grid = tl::make_unexpected(*why);
    } else if (!colors) {
      *grid = tl::make_unexpected(colors.error());
    } else {
      (*grid)->picture = std::move(*colors);
      (*grid)->reference.width = (*grid)->picture.indices->width();
      (*grid)->reference.height = (*grid)->picture.indices->height();
      if (!std::isfinite((*grid)->reference.origin.yaw_rad)) (*grid)->reference.origin.yaw_rad = 0;
    }
    QMetaObject::invokeMethod(
        this,
        [this, kind, generation, grid, topic = message.topic,
         broken = message.png && !colors ? message.fingerprint : std::string()] {
          if (generation != generation_) return;
          if (!broken.empty()) Q_EMIT unreadable(broken);
          Row& row = rows_[kind];
          row.busy = false;
          const bool dropped = std::exchange(row.dropped, false);
          if (auto next = std::exchange(row.next, std::nullopt)) start(kind, std::move(*next));
          if (dropped) return;
          const map::Subject subject{map::SubjectKind::Topic, topic};
          const bool was_broken = std::exchange(row.broken, !*grid);
          if (*grid) {
            row.shown = std::move(**grid);
            if (was_broken) Q_EMIT recovered({subject, map::ProblemCode::Unreadable});
            Q_EMIT changed(kind);
          } else {
            Q_EMIT problemFound({map::Severity::Warning, subject,
                                 std::move(grid->error()).followedBy(Consequence::PictureBeforeStays),
                                 map::ProblemCode::Unreadable});
          }
        },
        Qt::QueuedConnection);
  });
}

const LayerGrid* LayerGrids::find(map::GridKind kind) const {
  const auto found = rows_.find(kind);
  return found == rows_.end() || !found->second.shown ? nullptr : &*found->second.shown;
}

void LayerGrids::drop(map::GridKind kind) {
  const auto found = rows_.find(kind);
  if (found == rows_.end()) return;
  Row& row = found->second;
  row.next.reset();
  row.dropped = row.busy;
  row.broken = false;
  if (std::exchange(row.shown, std::nullopt)) Q_EMIT changed(kind);
}

bool LayerGrids::busy() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const auto& entry) { return entry.second.busy; });
}

void LayerGrids::standStill() {
  ++generation_;
  tasks_.drop();
}

void LayerGrids::clear() {
  ++generation_;
  tasks_.drop();
  const auto rows = std::exchange(rows_, {});
  for (const auto& [kind, row] : rows) Q_EMIT changed(kind);
}

}  // namespace mapwright::session

#include "moc_layer_grids.cpp"
