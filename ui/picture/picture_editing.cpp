#include "ui/picture/picture_editing.h"

#include <algorithm>
#include <utility>

#include "picture/draw.h"

namespace mapwright::window {

using picture::Canvas;
using picture::CellRect;
using picture::EditedGrid;
using picture::Ink;
using picture::Kind;
using picture::Patch;

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
  note(std::move(step), erasing_ ? tr("eraser") : tr("brush"));
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

}  // namespace mapwright::window

#include "moc_picture_editing.cpp"
