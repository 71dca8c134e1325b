#include "session/layer_grids.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/stand_back.h"

namespace mapwright::session {

LayerGrids::LayerGrids(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

LayerGrids::~LayerGrids() {
  pool_.clear();
  pool_.waitForDone();
}

void LayerGrids::take(const map::GridMessage& message) {
  Row& row = rows_[message.kind];
  if (row.busy) {
    row.next = message;  // the one in between is never seen
    return;
  }
  start(message.kind, message);
}

void LayerGrids::start(map::GridKind kind, map::GridMessage message) {
  rows_[kind].busy = true;
  pool_.start([this, kind, generation = generation_, message = std::move(message)] {
    raster::standBack();
    auto grid = std::make_shared<tl::expected<LayerGrid, std::string>>(LayerGrid{message.grid, {}});
    auto colors = message.png ? raster::decodeColors(message.png, kMaxCells)
                              : tl::make_unexpected(raster::GridError{"It came without a picture."});
    if (const auto why = map::whyUnusable(message.grid)) {
      *grid = tl::make_unexpected(*why);
    } else if (!colors) {
      *grid = tl::make_unexpected(colors.error().sentence);
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
                                 grid->error() + " The picture before it stays.",
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
  pool_.clear();
}

void LayerGrids::clear() {
  ++generation_;
  pool_.clear();
  const auto rows = std::exchange(rows_, {});
  for (const auto& [kind, row] : rows) Q_EMIT changed(kind);
}

}  // namespace mapwright::session
