#include "window/picture/picture_editing.h"

#include <utility>

#include <QUndoCommand>

#include "picture/fill.h"

namespace mapwright::window {

using picture::Canvas;
using picture::CellRect;
using picture::EditedGrid;
using picture::Ink;
using picture::Kind;
using picture::Patch;

namespace {
constexpr int kMostUndone = 200;
}

/// What it does has been done when it is pushed.
class PictureEditing::Command : public QUndoCommand {
 public:
  Command(PictureEditing& editing, Patch patch, const QString& text)
      : QUndoCommand(text), editing_(editing), patch_(std::move(patch)) {}
  void undo() override { editing_.exchange(patch_, false); }
  void redo() override {
    if (!std::exchange(done_, false)) editing_.exchange(patch_, true);
  }

 private:
  PictureEditing& editing_;
  Patch patch_;
  bool done_ = true;
};

PictureEditing::PictureEditing(const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent), share_(workers) {
  undo_.setUndoLimit(kMostUndone);
}

PictureEditing::~PictureEditing() {
  stopLooking();
  if (merging_) merging_->store(true);
}

void PictureEditing::open(std::shared_ptr<const grids::GridPyramid> cells,
                          const map::GridReference& reference, bool holds_unknown) {
  reset();
  grid_ = std::make_shared<EditedGrid>(std::move(cells));
  saved_ = grid_->snapshot();
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
  stroke_.reset();
  undo_.clear();
  grid_.reset();
  saved_.reset();
  selection_ = {};
  count_ = {};
  conflict_.reset();
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
  if (!grid_) return;
  endStroke();
  dropPreview();
  erasing_ = eraser;
  stroke_.emplace(*grid_, picture::Brush{across_, eraser ? Ink{0, saved_} : ink()});
}

void PictureEditing::strokeTo(const Eigen::Vector2d& world_m) {
  if (!stroke_) return;
  const CellRect touched = stroke_->to(cellAt(world_m));
  if (!touched.empty()) Q_EMIT cellsChanged(worldOf(touched));
}

void PictureEditing::endStroke() {
  if (!stroke_) return;
  Patch patch = stroke_->finish();
  stroke_.reset();
  if (patch.empty()) return;
  noteTouched(patch);
  undo_.push(new Command(*this, std::move(patch), erasing_ ? tr("eraser") : tr("brush")));
  Q_EMIT stateChanged();
}

void PictureEditing::push(Patch patch, const QString& text) {
  if (patch.empty()) return;
  exchange(patch, true);
  undo_.push(new Command(*this, std::move(patch), text));
}

void PictureEditing::take(Canvas& canvas, const QString& text) { push(canvas.take(), text); }

void PictureEditing::exchange(const Patch& patch, bool forward) {
  // What is under way was made for the cells as they were: it never was.
  if (stroke_) grid_->revert(stroke_->finish());
  stroke_.reset();
  dropPreview();
  if (forward) {
    grid_->apply(patch);
  } else {
    grid_->revert(patch);
  }
  noteTouched(patch);
  Q_EMIT cellsChanged(worldOf(patch.cells));
  Q_EMIT stateChanged();
}

void PictureEditing::noteTouched(const Patch& patch) { count_.recount(*grid_, *saved_, patch); }

void PictureEditing::drawLine(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  if (!grid_) return;
  Canvas canvas(*grid_);
  picture::drawLine(canvas, cellAt(from_m), cellAt(to_m), {across_, ink()});
  take(canvas, tr("line"));
}

void PictureEditing::drawRectangle(const CellRect& rect) {
  if (!grid_) return;
  Canvas canvas(*grid_);
  picture::drawRectangle(canvas, rect, ink());
  take(canvas, tr("rectangle"));
}

void PictureEditing::drawPolygon(const std::vector<Eigen::Vector2d>& corners_m) {
  if (!grid_) return;
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& corner : corners_m) corners.push_back(cellAt(corner));
  Canvas canvas(*grid_);
  picture::drawPolygon(canvas, corners, ink());
  take(canvas, tr("polygon"));
}

bool PictureEditing::fill(const Eigen::Vector2d& at_m) {
  if (!grid_) return true;
  const Eigen::Vector2d at = cellAt(at_m);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < grid_->width() && at.y() < grid_->height())) return true;
  Canvas canvas(*grid_);
  if (!picture::floodFill(canvas, int(at.x()), int(at.y()), ink())) return false;
  take(canvas, tr("fill"));
  return true;
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
  clip_ = std::move(copy);
  Q_EMIT stateChanged();
  return true;
}

void PictureEditing::pasteAt(int left, int top) {
  if (!grid_ || !clip_) return;
  Canvas canvas(*grid_);
  picture::putClip(canvas, *clip_, left, top);
  take(canvas, tr("paste"));
  select({left, top, left + clip_->width, top + clip_->height});
}

void PictureEditing::moveSelection(int columns, int rows, bool leaves_copy) {
  if (!grid_ || selection_.empty() || (columns == 0 && rows == 0)) return;
  Canvas canvas(*grid_);
  const auto piece = picture::copyCells(canvas, selection_);
  if (!piece) return;
  const CellRect from = selection_;
  if (!leaves_copy) picture::drawRectangle(canvas, from, groundInk());
  picture::putClip(canvas, *piece, from.left + columns, from.top + rows);
  take(canvas, leaves_copy ? tr("copy") : tr("move"));
  select(from.moved(columns, rows));
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

}  // namespace mapwright::window
