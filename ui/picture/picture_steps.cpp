// PictureEditing: steps that are made, undone, redone and dropped, and those computed on the thread pool.
#include <utility>

#include <QUndoCommand>

#include "ui/picture/picture_editing.h"

namespace mapwright::window {

using picture::Canvas;
using picture::DifferenceCount;
using picture::Patch;

namespace {

/// Changes of at most this many cells are made at once: some milliseconds.
constexpr std::int64_t kMostAtOnce = std::int64_t(1) << 21;

}  // namespace

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
  note(std::move(step), text);
}

/// Already applied to the grid.
void PictureEditing::note(PictureStep step, const QString& text) {
  undo_.push(new Command(*this, std::move(step), text));
  forgetOldest();
}

void PictureEditing::takeUp(Patch patch, const QString& text) {
  if (waits([this, patch, text] { takeUp(patch, text); })) return;
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

}  // namespace mapwright::window
