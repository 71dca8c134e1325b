// PictureEditing: tidying up beside the window, what is saved, and what others have changed.
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
  if (!grid_) return;
  endStroke();
  dropPreview();
  looking_ = std::make_shared<std::atomic<bool>>(false);
  const auto where = selection_.empty() ? grid_->all() : selection_;
  share_.startLong([this, what, cells, where, now = grid_->snapshot(), stop = looking_] {
    Canvas canvas(*now);
    TidyPreview made;
    made.what = what;
    made.found = tidy(canvas, where, what, cells, stop.get());
    made.patch = canvas.take();
    made.runs = picture::changedRuns(*now, made.patch, kMostMarked);
    const auto then = now->snapshot();
    then->apply(made.patch);
    made.cells = then;
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
  Patch patch = std::move(preview_->patch);
  const QString text = preview_->what == Tidying::Specks ? tr("remove specks")
                       : preview_->what == Tidying::Gaps ? tr("close gaps")
                                                         : tr("smooth edges");
  dropPreview();
  push(std::move(patch), text);
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
  saved_ = saved;
  count_ = picture::DifferenceCount::between(*grid_, *saved_);
  Q_EMIT stateChanged();
}

void PictureEditing::revert() {
  if (!grid_) return;
  endStroke();
  conflict_.reset();
  Canvas canvas(*grid_);
  constexpr int kEdge = Canvas::kEdge;
  for (const auto& [place, count] : count_.tiles) {
    for (int row = 0; row < kEdge; ++row)
      canvas.paintRow(place.y * kEdge + row, place.x * kEdge, (place.x + 1) * kEdge, {0, saved_});
  }
  take(canvas, tr("discard changes"));
}

void PictureEditing::takeIn(std::shared_ptr<const grids::GridPyramid> theirs) {
  if (!grid_) return;
  if (merging_) merging_->store(true);
  merging_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, theirs = std::move(theirs), base = saved_, stop = merging_] {
    Patch difference = picture::differenceTo(*base, *theirs, stop.get());
    QMetaObject::invokeMethod(
        this,
        [this, stop, base, difference = std::move(difference)] {
          if (stop != merging_) return;
          merging_.reset();
          takeDifference(base, difference);
        },
        Qt::QueuedConnection);
  });
}

void PictureEditing::takeDifference(const std::shared_ptr<const EditedGrid>& base, const Patch& theirs) {
  endStroke();
  picture::Merge merge = picture::mergeCells(*grid_, theirs, *base);
  const auto saved = base->snapshot();
  saved->apply(theirs);
  saved_ = saved;
  conflict_.reset();
  if (merge.conflicts > 0) conflict_ = Conflict{theirs, base, merge.conflicts, merge.where};
  push(std::move(merge.patch), tr("changes from elsewhere"));
  count_ = picture::DifferenceCount::between(*grid_, *saved_);
  Q_EMIT stateChanged();
  Q_EMIT mergeDone(merge.taken);
}

geometry::WorldRect PictureEditing::whereConflicts() const {
  return conflict_ ? worldOf(conflict_->where) : geometry::WorldRect{};
}

void PictureEditing::decide(bool take_theirs) {
  if (!conflict_) return;
  endStroke();
  const Conflict conflict = *std::exchange(conflict_, std::nullopt);
  if (take_theirs)
    push(picture::mergeCells(*grid_, conflict.theirs, *conflict.base, true).patch, tr("take theirs"));
  Q_EMIT stateChanged();
}

}  // namespace mapwright::window
