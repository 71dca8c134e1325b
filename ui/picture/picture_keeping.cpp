// PictureEditing: clean-up in the background, saved state, and changes by others.
#include <atomic>
#include <numeric>
#include <tuple>
#include <utility>

#include "ui/picture/picture_editing.h"

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

void TidyPreview::show(const EditedGrid& now) {
  changes = picture::changesOf(now, step.patch, kMostMarked);
  const auto then = now.snapshot();
  then->apply(step.patch);
  cells = then;
  found.cells = std::accumulate(changes.become.begin(), changes.become.end(), std::int64_t(0));
}

void PictureEditing::stopLooking() {
  if (!looking_) return;
  looking_->store(true);
  looking_.reset();
  landMergeSoon();
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
    made.show(*now);
    step.before = picture::DifferenceCount::counted(*now, *saved, step.patch);
    step.after = picture::DifferenceCount::counted(*made.cells, *saved, step.patch);
    step.of_saved = number;
    QMetaObject::invokeMethod(
        this,
        [this, stop, made = std::move(made)]() mutable {
          if (stop != looking_) return;  // the cells have changed, or something else was requested
          looking_.reset();
          landMergeSoon();
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
  met_ = {};  // undecided conflicts were not saved
  recountConflicts();
  count_ = picture::DifferenceCount::between(*grid_, *saved_);
  Q_EMIT stateChanged();
}

void PictureEditing::revert() {
  if (!grid_ || waits([this] { revert(); })) return;
  endStroke();
  using picture::kEdge;
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

/// Changes by others to the saved picture, merged with the local ones.
struct PictureEditing::Taken {
  std::shared_ptr<const EditedGrid> base, saved;  // the former and the new saved state
  Patch theirs;
  picture::Merge merge;
  quint64 of_grid = 0;  // the revision of the grid that it was made for
  picture::Rebase rebase;
  std::string revision;
};

bool PictureEditing::touched() const {
  return unsaved() || undo_.count() > 0 || stroking() || reckoning() || looking() || preview_ || merging() ||
         !selection_.empty();
}

void PictureEditing::takeIn(std::shared_ptr<const grids::GridPyramid> theirs, std::string revision) {
  if (!grid_) return;
  coming_ = Coming{std::move(theirs), std::move(revision)};
  if (!merging_) mergeNext();
}

void PictureEditing::mergeNext() {
  if (!coming_) return;
  merging_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, coming = *std::exchange(coming_, std::nullopt), base = saved_,
                    mine = grid_->snapshot(), of_grid = grid_->revision(), steps = stepsSoFar(),
                    stop = merging_]() mutable {
    Patch theirs = picture::differenceTo(*base, *coming.cells, stop.get());
    picture::Rebase rebase(theirs, base);
    picture::Merge merge = picture::mergeCells(*mine, theirs, *base);
    rebase.know(merge);
    for (Patch& patch : steps) rebase.apply(patch);  // it remembers their results
    const auto saved = base->snapshot();
    saved->apply(theirs);
    const auto taken = std::make_shared<Taken>(Taken{base, saved, std::move(theirs), std::move(merge),
                                                     of_grid, std::move(rebase), std::move(coming.revision)});
    QMetaObject::invokeMethod(
        this,
        [this, stop, taken] {
          if (stop != merging_) return;
          taken_ = taken;
          landMerge();
        },
        Qt::QueuedConnection);
  });
}

/// Not at once: the caller is in the middle of a change.
void PictureEditing::landMergeSoon() {
  if (taken_) QMetaObject::invokeMethod(this, &PictureEditing::landMerge, Qt::QueuedConnection);
}

void PictureEditing::landMerge() {
  // A stroke in progress, and computations, refer to the present cells.
  if (!taken_ || stroking() || reckoning() || looking()) return;
  Taken& taken = *taken_;
  if (grid_->revision() != taken.of_grid) {
    taken.merge = picture::mergeCells(*grid_, taken.theirs, *taken.base);
    taken.rebase.know(taken.merge);
  }
  rebase(taken.rebase);
  grid_->apply(taken.merge.patch);
  setSaved(taken.saved);
  if (preview_) {
    PictureStep& step = preview_->step;
    taken.rebase.apply(step.patch);
    if (step.patch.finest_only) step.patch = picture::withCoarserLevels(*grid_, step.patch, false);
    preview_->show(*grid_);
    step.of_saved = 0;
    Q_EMIT previewChanged();
  }
  count_.recount(*grid_, *saved_, taken.theirs);
  met_.unite(taken.merge.conflicts);
  recountConflicts();
  const auto landed = std::exchange(taken_, nullptr);
  merging_.reset();
  Q_EMIT cellsChanged(worldOf(landed->merge.patch.cells));
  Q_EMIT stateChanged();
  Q_EMIT mergeDone(landed->merge.taken, landed->revision);
  if (!merging_ && grid_) mergeNext();
}

void PictureEditing::recountConflicts() {
  std::tie(conflicts_, where_conflicts_) =
      met_.tiles.empty() ? std::pair<std::int64_t, picture::CellRect>{} : met_.differing(*grid_, *saved_);
}

geometry::WorldRect PictureEditing::whereConflicts() const { return worldOf(where_conflicts_); }

void PictureEditing::decide(bool take_theirs) {
  if (conflicts_ == 0 || waits([this, take_theirs] { decide(take_theirs); })) return;
  endStroke();
  const picture::CellSet met = std::exchange(met_, {});
  if (take_theirs) push({picture::copied(*grid_, *saved_, met), {}, {}, 0}, tr("take theirs"));
  recountConflicts();
  Q_EMIT stateChanged();
}

}  // namespace mapwright::window
