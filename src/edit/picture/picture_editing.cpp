#include "edit/picture/picture_editing.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <QUndoCommand>

#include "sentences/plural.h"

namespace mapwright::edit {

using picture::Canvas;
using picture::CellRect;
using picture::DifferenceCount;
using picture::EditedGrid;
using picture::Ink;
using picture::kEdge;
using picture::Kind;
using picture::Patch;

namespace {

/// Changes of at most this many cells are made at once: some milliseconds.
constexpr std::int64_t kMostAtOnce = std::int64_t(1) << 21;

constexpr std::size_t kMostMarked = 50'000;

picture::Tidied tidy(Canvas& canvas, const CellRect& where, Tidying what, int cells,
                     const std::atomic<bool>* cancelled) {
  if (what == Tidying::Specks) return picture::removeSpecks(canvas, where, cells, cancelled);
  if (what == Tidying::Gaps) return picture::closeGaps(canvas, where, cells, cancelled);
  return picture::smoothFree(canvas, where, cells, cancelled);
}

}  // namespace

QString cellsText(std::int64_t cells) {
  return sentences::counted(PictureEditing::tr("%1 cells", nullptr, sentences::formOf(cells)), cells);
}

PictureEditing::PictureEditing(const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent), share_(workers) {}

PictureEditing::~PictureEditing() {
  for (const StopFlag& flag : {looking_, merging_, reckoning_}) {
    if (flag) flag->store(true);
  }
}

void PictureEditing::open(std::shared_ptr<const grids::GridPyramid> cells,
                          const map::GridReference& reference, bool holds_unknown) {
  reset();
  grid_ = std::make_shared<EditedGrid>(std::move(cells));
  setSaved(grid_->snapshot());
  reference_ = reference;
  holds_unknown_ = holds_unknown;
  if (!holds(kind_)) kind_ = Kind::Free;
  Q_EMIT stateChanged();
}

void PictureEditing::close() {
  reset();
  Q_EMIT stateChanged();
}

void PictureEditing::reset() {
  stopLooking();
  if (merging_) merging_->store(true);
  merging_.reset();
  coming_.reset();
  taken_.reset();
  if (reckoning_) reckoning_->store(true);
  reckoning_.reset();
  waiting_.clear();
  stroke_waits_ = false;
  stroke_.reset();
  undo_.clear();
  grid_.reset();
  saved_.reset();
  selection_ = {};
  count_ = {};
  met_ = {};
  recountConflicts();
  preview_.reset();
}

void PictureEditing::setKind(Kind kind) {
  if (kind == kind_ || !holds(kind)) return;
  kind_ = kind;
  Q_EMIT stateChanged();
}

bool PictureEditing::holds(Kind kind) const {
  if (!grid_) return true;
  return picture::byteOf(kind, grid_->code()).has_value() && (kind != Kind::Unknown || holds_unknown_);
}

void PictureEditing::setAcross(int cells) {
  const int bounded = std::clamp(cells, 1, picture::kWidestBrush);
  if (bounded == across_) return;
  across_ = bounded;
  Q_EMIT stateChanged();
}

Ink PictureEditing::ink() const { return {picture::byteOf(kind_, grid_->code()).value_or(0), {}}; }

Ink PictureEditing::groundInk() const {
  return {picture::byteOf(holds(Kind::Unknown) ? Kind::Unknown : Kind::Free, grid_->code()).value_or(0), {}};
}

void PictureEditing::beginStroke(bool eraser) {
  if (grid_) startStroke(eraser, {across_, ink()});
}

void PictureEditing::startStroke(bool eraser, const picture::Brush& brush) {
  if (waits([this, eraser, brush] { startStroke(eraser, brush); })) {
    stroke_waits_ = true;
    return;
  }
  endStroke();
  dropPreview();
  erasing_ = eraser;
  stroke_of_saved_ = saved_number_;
  stroke_.emplace(*grid_, picture::Brush{brush.across, eraser ? Ink{0, saved_} : brush.ink});
}

void PictureEditing::strokeTo(const Eigen::Vector2d& world_m) {
  if (waits([this, world_m] { strokeTo(world_m); }) || !stroke_) return;
  const CellRect touched = stroke_->to(cellAt(world_m));
  if (!touched.empty()) Q_EMIT cellsChanged(worldOf(touched));
}

void PictureEditing::endStroke() {
  if (stroke_waits_ && waits([this] { endStroke(); })) {
    stroke_waits_ = false;
    return;
  }
  if (!stroke_) return;
  PictureStep step;
  step.patch = stroke_->finish();
  stroke_.reset();
  landMergeSoon();
  if (step.patch.empty()) return;
  step.before = count_.of(step.patch);
  step.after = picture::DifferenceCount::counted(*grid_, *saved_, step.patch);
  // A save in between contains a part of it: the former counts are unknown then.
  step.of_saved = stroke_of_saved_ == saved_number_ ? saved_number_ : 0;
  count_.set(step.after);
  recountConflicts();
  recordStep(std::move(step), erasing_ ? tr("eraser") : tr("brush"));
  Q_EMIT stateChanged();
}

void PictureEditing::drawLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  if (!grid_) return;
  const Eigen::Vector2d from = cellAt(from_m), to = cellAt(to_m);
  const std::int64_t most = std::int64_t(across_) * std::max(grid_->width(), grid_->height());
  change(tr("line"), most, [from, to, brush = picture::Brush{across_, ink()}](Canvas& canvas, const auto&) {
    picture::drawLine(canvas, from, to, brush);
    return true;
  });
}

void PictureEditing::drawRectangle(const CellRect& rect) {
  if (!grid_) return;
  change(tr("rectangle"), rect.intersected(grid_->all()).area(),
         [rect, ink = ink()](Canvas& canvas, const auto&) {
           picture::drawRectangle(canvas, rect, ink);
           return true;
         });
}

void PictureEditing::drawPolygon(const std::vector<Eigen::Vector2d>& corners_m) {
  if (!grid_) return;
  std::vector<Eigen::Vector2d> corners;
  CellRect bounds;
  for (const Eigen::Vector2d& corner : corners_m) {
    corners.push_back(cellAt(corner));
    bounds = bounds.united(picture::rectangleOf(corners.back(), corners.back()));
  }
  change(tr("polygon"), bounds.intersected(grid_->all()).area(),
         [corners, ink = ink()](Canvas& canvas, const auto&) {
           picture::drawPolygon(canvas, corners, ink);
           return true;
         });
}

void PictureEditing::fill(const Eigen::Vector2d& at_m) {
  if (!grid_) return;
  const Eigen::Vector2d at = cellAt(at_m);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < grid_->width() && at.y() < grid_->height())) return;
  change(tr("fill"), grid_->all().area(),
         [column = int(at.x()), row = int(at.y()), ink = ink()](Canvas& canvas, const auto& stop) {
           return picture::floodFill(canvas, column, row, ink, &stop);
         });
}

void PictureEditing::select(const CellRect& rect) {
  const CellRect inside = grid_ ? rect.intersected(grid_->all()) : CellRect{};
  if (inside == selection_) return;
  selection_ = inside;
  Q_EMIT stateChanged();
}

bool PictureEditing::copySelection() {
  if (!grid_ || selection_.empty()) return false;
  Canvas canvas(*grid_);
  auto copy = picture::copyCells(canvas, selection_);
  if (!copy) return false;
  clip_ = std::make_shared<const picture::Clip>(std::move(*copy));
  Q_EMIT stateChanged();
  return true;
}

void PictureEditing::pasteAt(int left, int top) {
  if (!grid_ || !clip_) return;
  const CellRect where{left, top, left + clip_->width, top + clip_->height};
  change(
      tr("paste"), where.area(),
      [clip = clip_, left, top](Canvas& canvas, const auto&) {
        picture::putClip(canvas, *clip, left, top);
        return true;
      },
      [this, where] { select(where); });
}

void PictureEditing::moveSelection(int columns, int rows, bool leaves_copy) {
  if (!grid_ || selection_.empty() || (columns == 0 && rows == 0)) return;
  const CellRect from = selection_;
  change(
      leaves_copy ? tr("copy") : tr("move"), 2 * from.area(),
      [from, columns, rows, leaves_copy, ground = groundInk()](Canvas& canvas, const auto&) {
        const auto piece = picture::copyCells(canvas, from);
        if (!piece) return false;
        if (!leaves_copy) picture::drawRectangle(canvas, from, ground);
        picture::putClip(canvas, *piece, from.left + columns, from.top + rows);
        return true;
      },
      [this, to = from.moved(columns, rows)] { select(to); });
}

void PictureEditing::paintSelection() {
  if (!grid_ || selection_.empty()) return;
  drawRectangle(selection_);
}

CellRect PictureEditing::cellsBetween(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const {
  return picture::rectangleOf(cellAt(a_m), cellAt(b_m));
}

geometry::WorldRect PictureEditing::worldOf(const CellRect& rect) const {
  geometry::WorldRect world;
  if (rect.empty()) return world;
  for (const int column : {rect.left, rect.right}) {
    for (const int row : {rect.top, rect.bottom}) {
      world.extend(reference_.worldFromCell({double(column), double(row)}));
    }
  }
  return world;
}

/// Its effect is already applied when it is pushed.
class PictureEditing::Command : public QUndoCommand {
 public:
  Command(PictureEditing& editing, PictureStep step, const QString& text)
      : QUndoCommand(text), editing_(editing), step_(std::make_unique<PictureStep>(std::move(step))) {
    editing_.held_.add(step_->patch);
  }
  ~Command() override { editing_.held_.remove(step_->patch); }
  void undo() override { exchange(false); }
  void redo() override {
    if (!std::exchange(done_, false)) exchange(true);
  }
  /// Merges change it, too, although the stack treats its commands as constants.
  PictureStep& step() const { return *step_; }

 private:
  void exchange(bool forward) {
    editing_.held_.remove(step_->patch);
    editing_.exchange(*step_, forward);
    editing_.held_.add(step_->patch);
  }

  PictureEditing& editing_;
  std::unique_ptr<PictureStep> step_;
  bool done_ = true;
};

void PictureEditing::rebase(picture::Rebase& rebase) {
  for (int i = 0; i < undo_.count(); ++i) {
    Patch& patch = static_cast<const Command*>(undo_.command(i))->step().patch;
    held_.remove(patch);
    rebase.apply(patch);
    held_.add(patch);
  }
}

std::vector<Patch> PictureEditing::stepsSoFar() const {
  std::vector<Patch> patches;
  for (int i = 0; i < undo_.count(); ++i)
    patches.push_back(static_cast<const Command*>(undo_.command(i))->step().patch);
  return patches;
}

void PictureEditing::setSaved(std::shared_ptr<const picture::EditedGrid> saved) {
  saved_ = std::move(saved);
  ++saved_number_;
}

void PictureEditing::push(PictureStep step, const QString& text) {
  if (step.patch.empty()) return;
  endStroke();  // its effect is on the grid that this was made for
  exchange(step, true);
  recordStep(std::move(step), text);
}

/// Already applied to the grid.
void PictureEditing::recordStep(PictureStep step, const QString& text) {
  undo_.push(new Command(*this, std::move(step), text));
  forgetOldest();
}

void PictureEditing::applyPatch(Patch patch, const QString& text) {
  if (waits([this, patch, text] { applyPatch(patch, text); })) return;
  push({std::move(patch), {}, {}, 0}, text);
}

void PictureEditing::exchange(PictureStep& step, bool forward) {
  // Work in progress was made for the former cells: drops it.
  if (stroke_) grid_->revert(stroke_->finish());
  stroke_.reset();
  landMergeSoon();
  stop();
  dropPreview();
  if (step.patch.finest_only) step.patch = picture::withCoarserLevels(*grid_, step.patch, !forward);
  if (step.of_saved != saved_number_ && forward) step.before = count_.of(step.patch);
  if (forward) {
    grid_->apply(step.patch);
  } else {
    grid_->revert(step.patch);
  }
  if (step.of_saved == saved_number_) {
    count_.set(forward ? step.after : step.before);
  } else {
    count_.recount(*grid_, *saved_, step.patch);
    step.of_saved = forward ? saved_number_ : 0;
    if (forward) step.after = count_.of(step.patch);
  }
  recountConflicts();
  Q_EMIT cellsChanged(worldOf(step.patch.cells));
  Q_EMIT stateChanged();
}

/// A stack removes commands only from the top, so those that stay are pushed again.
void PictureEditing::forgetOldest() {
  if (held_.bytes() <= undo_budget_) return;
  int forgotten = 0;
  picture::PatchMemory kept = held_;
  const auto stepAt = [this](int i) -> const PictureStep& {
    return static_cast<const Command*>(undo_.command(i))->step();
  };
  while (forgotten + 1 < undo_.count() && kept.bytes() > undo_budget_) kept.remove(stepAt(forgotten++).patch);
  if (forgotten == 0) return;
  std::vector<std::pair<PictureStep, QString>> stays;
  for (int i = forgotten; i < undo_.count(); ++i) stays.emplace_back(stepAt(i), undo_.text(i));
  {
    const QSignalBlocker quiet(undo_);  // what can be undone next stays the same
    undo_.clear();
    for (auto& [step, text] : stays) undo_.push(new Command(*this, std::move(step), text));
  }
  Q_EMIT stepsForgotten(forgotten);
}

bool PictureEditing::waits(std::function<void()> operation) {
  if (!reckoning_) return false;
  waiting_.push_back(std::move(operation));
  return true;
}

void PictureEditing::change(const QString& text, std::int64_t most_cells, Make make,
                            std::function<void()> then) {
  if (waits([this, text, most_cells, make, then] { change(text, most_cells, make, then); })) return;
  if (most_cells > kMostAtOnce) return reckon(text, std::move(make), std::move(then));
  Canvas canvas(*grid_);
  if (!make(canvas, std::atomic<bool>(false))) {
    Q_EMIT tooLarge();
    return;
  }
  push({canvas.take(), {}, {}, 0}, text);
  if (then) then();
}

void PictureEditing::reckon(const QString& text, Make make, std::function<void()> then) {
  endStroke();
  dropPreview();
  reckoning_ = std::make_shared<std::atomic<bool>>(false);
  share_.start(work::Urgency::Wanted,
               [this, text, make = std::move(make), then = std::move(then), now = grid_->snapshot(),
                saved = saved_, number = saved_number_, flag = reckoning_] {
                 std::optional<PictureStep> step;
                 Canvas canvas(*now);
                 if (make(canvas, *flag)) {
                   step.emplace();
                   step->patch = canvas.take();
                   step->before = DifferenceCount::counted(*now, *saved, step->patch);
                   now->apply(step->patch);
                   step->after = DifferenceCount::counted(*now, *saved, step->patch);
                   step->of_saved = number;
                 }
                 QMetaObject::invokeMethod(
                     this,
                     [this, flag, text, then, step = std::move(step)]() mutable {
                       if (flag == reckoning_) land(std::move(step), text, then);
                     },
                     Qt::QueuedConnection);
               });
  Q_EMIT stateChanged();
}

void PictureEditing::land(std::optional<PictureStep> step, const QString& text,
                          const std::function<void()>& then) {
  reckoning_.reset();
  landMergeSoon();
  stroke_waits_ = false;
  const auto waiting = std::exchange(waiting_, {});
  if (step) {
    push(std::move(*step), text);
    if (then) then();
  }
  Q_EMIT stateChanged();
  if (!step) Q_EMIT tooLarge();
  for (const auto& operation : waiting) operation();  // which may have to wait again
}

void PictureEditing::stop() {
  stroke_waits_ = false;
  waiting_.clear();
  if (!reckoning_) return;
  reckoning_->store(true);
  reckoning_.reset();
  landMergeSoon();
  Q_EMIT stateChanged();
}

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

void PictureEditing::markSaved(const std::shared_ptr<const EditedGrid>& saved) {
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
  std::vector<picture::TileKey> keys;
  for (const auto& [key, count] : count_.tiles) keys.push_back(key);
  change(tr("discard changes"), std::int64_t(keys.size()) * kEdge * kEdge,
         [keys, saved = saved_](Canvas& canvas, const auto&) {
           for (const picture::TileKey& key : keys) {
             for (int row = 0; row < kEdge; ++row)
               canvas.paintRow(key.y * kEdge + row, key.x * kEdge, (key.x + 1) * kEdge, {0, saved});
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

void PictureEditing::mergeTheirs(std::shared_ptr<const grids::GridPyramid> theirs, std::string revision) {
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

}  // namespace mapwright::edit

#include "moc_picture_editing.cpp"
