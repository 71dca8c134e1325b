// PictureEditing: tidying up beside the window, what is saved, and what others have changed.
#include <atomic>
#include <utility>

#include "window/picture/picture_editing.h"

namespace mapwright::window {

using picture::Canvas;
using picture::EditedGrid;
using picture::Patch;

namespace {

constexpr std::size_t kMostMarked = 50'000;

picture::Tidied tidy(Canvas& canvas, const picture::CellRect& where, Tidying what, int cells,
                     const std::atomic<bool>* cancelled) {
  switch (what) {
    case Tidying::Specks:
      return picture::removeSpecks(canvas, where, cells, cancelled);
    case Tidying::Gaps:
      return picture::closeGaps(canvas, where, cells, cancelled);
    case Tidying::Edges:
      break;
  }
  return picture::smoothFree(canvas, where, cells, cancelled);
}

}  // namespace

void PictureEditing::stopLooking() {
  if (looking_) looking_->store(true);
  looking_.reset();
}

void PictureEditing::lookFor(Tidying what, int cells) {
  if (!grid_ || waits([this, what, cells] { lookFor(what, cells); })) return;
  endStroke();
  dropPreview();
  looking_ = std::make_shared<std::atomic<bool>>(false);
  const auto where = selection_.empty() ? grid_->all() : selection_;
  share_.startLong([this, what, cells, where, now = grid_->snapshot(), saved = saved_, number = saved_number_,
                    stop = looking_] {
    Canvas canvas(*now);
    TidyPreview made;
    made.what = what;
    made.found = tidy(canvas, where, what, cells, stop.get());
    PictureStep& step = made.step;
    step.patch = canvas.take();
    made.runs = picture::changedRuns(*now, step.patch, kMostMarked);
    const auto then = now->snapshot();
    then->apply(step.patch);
    made.cells = then;
    step.before = picture::DifferenceCount::counted(*now, *saved, step.patch);
    step.after = picture::DifferenceCount::counted(*then, *saved, step.patch);
    step.of_saved = number;
    QMetaObject::invokeMethod(
        this,
        [this, stop, made = std::move(made)]() mutable {
          if (stop != looking_) return;  // the cells are others now, or something else is looked for
          looking_.reset();
          preview_ = std::move(made);
          Q_EMIT previewChanged();
          Q_EMIT stateChanged();
        },
        Qt::QueuedConnection);
  });
  Q_EMIT stateChanged();
}

void PictureEditing::applyPreview() {
  if (!preview_) return;
  PictureStep step = std::move(preview_->step);
  const QString text = preview_->what == Tidying::Specks ? tr("remove specks")
                       : preview_->what == Tidying::Gaps ? tr("close gaps")
                                                         : tr("smooth edges");
  dropPreview();
  push(std::move(step), text);
}

void PictureEditing::dropPreview() {
  const bool looked = looking();
  stopLooking();
  if (!std::exchange(preview_, std::nullopt) && !looked) return;
  Q_EMIT previewChanged();
  Q_EMIT stateChanged();
}

std::shared_ptr<const EditedGrid> PictureEditing::snapshot() const { return grid_->snapshot(); }

void PictureEditing::noteSaved(const std::shared_ptr<const EditedGrid>& saved) {
  if (!grid_ || saved->base() != grid_->base()) return;
  setSaved(saved);
  count_ = picture::DifferenceCount::between(*grid_, *saved_);
  Q_EMIT stateChanged();
}

void PictureEditing::revert() {
  if (!grid_ || waits([this] { revert(); })) return;
  endStroke();
  conflict_.reset();
  constexpr int kEdge = Canvas::kEdge;
  std::vector<picture::TilePlace> places;
  for (const auto& [place, count] : count_.tiles) places.push_back(place);
  change(tr("discard changes"), std::int64_t(places.size()) * kEdge * kEdge,
         [places, saved = saved_](Canvas& canvas, const auto&) {
           for (const picture::TilePlace& place : places) {
             for (int row = 0; row < kEdge; ++row)
               canvas.paintRow(place.y * kEdge + row, place.x * kEdge, (place.x + 1) * kEdge, {0, saved});
           }
           return true;
         });
}

/// What others have made of the saved picture, put together with what is here.
struct PictureEditing::Taken {
  Patch theirs;
  picture::Merge merge;
  std::shared_ptr<const EditedGrid> saved;
  picture::DifferenceCount count;
};

PictureEditing::Taken PictureEditing::takenFrom(const EditedGrid& mine, const EditedGrid& base,
                                                Patch theirs) {
  Taken taken;
  taken.merge = picture::mergeCells(mine, theirs, base);
  const auto saved = base.snapshot();
  saved->apply(theirs);
  taken.saved = saved;
  const auto then = mine.snapshot();
  then->apply(taken.merge.patch);
  taken.count = picture::DifferenceCount::between(*then, *saved);
  taken.theirs = std::move(theirs);
  return taken;
}

void PictureEditing::takeIn(std::shared_ptr<const grids::GridPyramid> theirs) {
  if (!grid_) return;
  if (merging_) merging_->store(true);
  merging_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, theirs = std::move(theirs), base = saved_, mine = grid_->snapshot(),
                    revision = grid_->revision(), stop = merging_] {
    const auto taken =
        std::make_shared<Taken>(takenFrom(*mine, *base, picture::differenceTo(*base, *theirs, stop.get())));
    QMetaObject::invokeMethod(
        this,
        [this, stop, base, revision, taken] {
          if (stop != merging_) return;
          merging_.reset();
          const auto land = [this, base, revision, taken] {
            endStroke();
            if (grid_->revision() != revision) *taken = takenFrom(*grid_, *base, std::move(taken->theirs));
            take(std::move(*taken), base);
          };
          if (!waits(land)) land();
        },
        Qt::QueuedConnection);
  });
}

void PictureEditing::take(Taken taken, const std::shared_ptr<const EditedGrid>& base) {
  setSaved(taken.saved);
  conflict_.reset();
  if (taken.merge.conflicts > 0)
    conflict_ = Conflict{std::move(taken.theirs), base, taken.merge.conflicts, taken.merge.where};
  PictureStep step;
  step.patch = std::move(taken.merge.patch);
  step.of_saved = saved_number_;
  for (const auto& [place, change] : step.patch.tiles) {
    if (place.level != 0) continue;
    const auto found = taken.count.tiles.find(place);
    step.after.emplace_back(place, found == taken.count.tiles.end() ? 0 : found->second);
  }
  step.before = picture::DifferenceCount::counted(*grid_, *saved_, step.patch);
  push(std::move(step), tr("changes from elsewhere"));
  count_ = std::move(taken.count);
  Q_EMIT stateChanged();
  Q_EMIT mergeDone(taken.merge.taken);
}

geometry::WorldRect PictureEditing::whereConflicts() const {
  return conflict_ ? worldOf(conflict_->where) : geometry::WorldRect{};
}

void PictureEditing::decide(bool take_theirs) {
  if (!conflict_ || waits([this, take_theirs] { decide(take_theirs); })) return;
  endStroke();
  const Conflict conflict = *std::exchange(conflict_, std::nullopt);
  if (take_theirs)
    push({picture::mergeCells(*grid_, conflict.theirs, *conflict.base, true).patch, {}, {}, 0},
         tr("take theirs"));
  Q_EMIT stateChanged();
}

}  // namespace mapwright::window
