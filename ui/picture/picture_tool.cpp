#include "ui/picture/picture_tool.h"

#include <array>
#include <cmath>
#include <utility>

#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr double kLeastMarkPx = 3;
constexpr double kLinesFromPx = 6;     // a cell this wide has room for hatching
constexpr double kLeastCornersPx = 9;  // a click this close to the first corner closes a polygon

/// A line that is visible on any background.
void strokeTwice(QPainter& painter, const auto& draw) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(255, 255, 255, 220), 3));
  draw();
  painter.setPen(QPen(appColors().accent, 1));
  draw();
}

}  // namespace

BecomesLook becomesLook(picture::Kind kind) {
  static const std::array<BecomesLook, picture::kKinds> kLooks{
      {{QColor(86, 180, 233), Qt::NoBrush},
       {QColor(213, 94, 0), Qt::FDiagPattern},
       {QColor(170, 51, 119), Qt::DiagCrossPattern}}};
  return kLooks[std::size_t(kind)];
}

PictureTool::PictureTool(edit::PictureEditing* editing, scene::MapScene* scene, QObject* parent)
    : DragTool(scene, parent), editing_(editing) {
  connect(editing_, &edit::PictureEditing::stateChanged, this, [this] { notifyChanged(); });
  connect(editing_, &edit::PictureEditing::tooLarge, this, [this] {
    Q_EMIT refused(
        tr("This area is too large to change at once. Draw lines to divide it, then change the parts."));
  });
}

void PictureTool::setMode(PaintMode mode) {
  if (mode == mode_) return;
  dragCancelled();
  corners_.clear();
  mode_ = mode;
  Q_EMIT modeChanged();
  notifyChanged();
}

void PictureTool::activate() { Q_EMIT activated(); }

void PictureTool::deactivate() {
  DragTool::deactivate();
  corners_.clear();
  hand_.reset();
  editing_->select({});
  editing_->dropPreview();
}

bool PictureTool::grab(const MapPoint& at) {
  hand_ = at.world_m;
  if (!editing_->isOpen()) return false;
  on_selection_ = false;
  if (mode_ == PaintMode::Brush || mode_ == PaintMode::Eraser) {
    editing_->beginStroke(mode_ == PaintMode::Eraser);
    editing_->strokeTo(at.world_m);
  } else if (mode_ == PaintMode::Select) {
    const Eigen::Vector2d cell = editing_->cellAt(at.world_m);
    on_selection_ = editing_->selection().contains(int(std::floor(cell.x())), int(std::floor(cell.y())));
    copies_ = (at.modifiers & Qt::ControlModifier) != 0;
  }
  Q_EMIT changed();
  return true;
}

void PictureTool::update(const MapPoint& at) {
  hand_ = at.world_m;
  if (editing_->stroking()) editing_->strokeTo(at.world_m);
  if (mode_ == PaintMode::Select && !on_selection_)
    editing_->select(editing_->cellsBetween(hold()->from.world_m, at.world_m));
  copies_ = (at.modifiers & Qt::ControlModifier) != 0;
}

void PictureTool::click(const MapPoint& at) {
  if (!hold()) return;  // it was not open
  if (mode_ == PaintMode::Select) return editing_->select({});
  const bool closes = mode_ == PaintMode::Polygon && corners_.size() > 2 &&
                      QLineF(px(corners_.front()), px(at.world_m)).length() < kLeastCornersPx;
  if (closes) return editing_->drawPolygon(std::exchange(corners_, {}));
  finish(at);
}

void PictureTool::finish(const MapPoint& at) {
  hand_ = at.world_m;
  editing_->endStroke();
  const auto [columns, rows] = movedBy();
  const Eigen::Vector2d from = hold()->from.world_m;
  switch (mode_) {
    case PaintMode::Line:
      editing_->drawLine(from, at.world_m);
      break;
    case PaintMode::Rectangle:
      editing_->drawRectangle(editing_->cellsBetween(from, at.world_m));
      break;
    case PaintMode::Polygon:
      corners_.push_back(at.world_m);
      break;
    case PaintMode::Fill:
      editing_->fill(at.world_m);
      break;
    case PaintMode::Select:
      if (on_selection_) editing_->moveSelection(columns, rows, copies_);
      break;
    default:
      break;
  }
}

void PictureTool::hovered(const MapPoint& at) {
  hand_ = at.world_m;
  Q_EMIT changed();
}

void PictureTool::left() {
  hand_.reset();
  Q_EMIT changed();
}

bool PictureTool::stepBack() {
  if (!corners_.empty()) {
    corners_.clear();
  } else if (editing_->reckoning()) {
    editing_->stop();
  } else if (editing_->preview() || editing_->looking()) {
    editing_->dropPreview();
  } else if (!editing_->selection().empty()) {
    editing_->select({});
  } else {
    return false;
  }
  return true;
}

bool PictureTool::keyPressed(const MapKeyPress& press) {
  const bool ctrl = (press.modifiers & Qt::ControlModifier) != 0;
  switch (press.key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (corners_.size() > 2) {
        editing_->drawPolygon(std::exchange(corners_, {}));
      } else if (editing_->preview()) {
        editing_->applyPreview();
      } else {
        return false;
      }
      Q_EMIT hintChanged();
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      if (!corners_.empty()) {
        corners_.pop_back();
      } else if (!editing_->selection().empty()) {
        editing_->paintSelection();
      } else {
        return false;
      }
      Q_EMIT changed();
      return true;
    case Qt::Key_C:
      if (!ctrl || editing_->selection().empty()) return false;
      if (!editing_->copySelection())
        Q_EMIT refused(tr("The selection is too large to be copied. Select a smaller one."));
      return true;
    case Qt::Key_V:
      if (!ctrl || !editing_->hasCopy() || !hand_) return false;
      editing_->pasteAt(int(std::floor(editing_->cellAt(*hand_).x())),
                        int(std::floor(editing_->cellAt(*hand_).y())));
      setMode(PaintMode::Select);
      return true;
    case Qt::Key_Comma:
    case Qt::Key_Period: {
      const int step = std::max(1, editing_->across() / 5);
      editing_->setAcross(editing_->across() + (press.key == Qt::Key_Comma ? -step : step));
      return true;
    }
    default:
      return DragTool::keyPressed(press);
  }
}

std::pair<int, int> PictureTool::movedBy() const {
  if (!hold() || !hand_) return {0, 0};
  const Eigen::Vector2d moved = editing_->cellAt(*hand_) - editing_->cellAt(hold()->from.world_m);
  return {int(std::lround(moved.x())), int(std::lround(moved.y()))};
}

QPolygonF PictureTool::outline(const picture::CellRect& rect) const {
  QPolygonF polygon;
  const auto add = [&](int column, int row) {
    polygon << px(editing_->reference().worldFromCell({double(column), double(row)}));
  };
  add(rect.left, rect.top);
  add(rect.right, rect.top);
  add(rect.right, rect.bottom);
  add(rect.left, rect.bottom);
  return polygon;
}

void PictureTool::paint(QPainter& painter) {
  if (!editing_->isOpen()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  paintPreview(painter);
  paintSelection(painter);
  paintShape(painter);
  paintBrush(painter);
}

/// A mark on every cell that would change, visible even if the cells are not.
void PictureTool::paintPreview(QPainter& painter) const {
  if (!editing_->preview()) return;
  const map::GridReference& grid = editing_->reference();
  const QPointF corner = px(grid.worldFromCell({0, 0}));
  const QPointF across = px(grid.worldFromCell({1, 0})) - corner,
                down = px(grid.worldFromCell({0, 1})) - corner;
  const double cell_px = std::hypot(across.x(), across.y());
  const double wider = cell_px > 0 ? std::max(0.0, (kLeastMarkPx / cell_px - 1) / 2) : 0;
  const geometry::WorldRect visible = scene().view().visibleWorld();
  picture::CellRect seen;
  for (const double x : {visible.min_x, visible.max_x}) {
    for (const double y : {visible.min_y, visible.max_y})
      seen = seen.united(picture::rectangleOf(editing_->cellAt({x, y}), editing_->cellAt({x, y})));
  }
  std::array<QList<QRectF>, picture::kKinds> marks;
  for (const picture::ChangedRun& run : editing_->preview()->changes.runs) {
    if (run.cells.intersected(seen).empty()) continue;
    marks[std::size_t(run.becomes)] << QRectF(run.cells.left, run.cells.top, run.cells.width(),
                                              run.cells.height())
                                           .adjusted(-wider, -wider, wider, wider);
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  const QTransform of_cells(across.x(), across.y(), down.x(), down.y(), corner.x(), corner.y());
  painter.setTransform(of_cells, true);
  painter.setPen(Qt::NoPen);
  for (int i = 0; i < picture::kKinds; ++i) {
    const BecomesLook look = becomesLook(picture::Kind(i));
    painter.setBrush(look.color);
    painter.drawRects(marks[std::size_t(i)]);
    if (cell_px < kLinesFromPx) continue;
    QBrush lines(QColor(0, 0, 0, 150), look.lines);
    lines.setTransform(of_cells.inverted());  // in pixels, whatever the size of the cells
    painter.setBrush(lines);
    painter.drawRects(marks[std::size_t(i)]);
  }
  painter.restore();
}

void PictureTool::paintSelection(QPainter& painter) const {
  if (editing_->selection().empty()) return;
  const auto [columns, rows] = hold() && on_selection_ ? movedBy() : std::pair{0, 0};
  const QPolygonF frame = outline(editing_->selection().moved(columns, rows));
  painter.setPen(QPen(QColor(255, 255, 255, 220), 3));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(frame);
  QPen pen(appColors().accent, 2);
  pen.setDashPattern({4, 3});
  painter.setPen(pen);
  painter.drawPolygon(frame);
}

void PictureTool::paintShape(QPainter& painter) const {
  if (mode_ == PaintMode::Polygon && !corners_.empty()) {
    QPolygonF shape;
    for (const Eigen::Vector2d& corner : corners_) shape << px(corner);
    if (hand_) shape << px(*hand_);
    strokeTwice(painter, [&] { painter.drawPolyline(shape); });
    strokeTwice(painter, [&] { painter.drawEllipse(shape.front(), 4, 4); });
    return;
  }
  if (!hold() || !hand_) return;
  const Eigen::Vector2d& from = hold()->from.world_m;
  if (mode_ == PaintMode::Rectangle) {
    strokeTwice(painter, [&] { painter.drawPolygon(outline(editing_->cellsBetween(from, *hand_))); });
  } else if (mode_ == PaintMode::Line) {
    strokeTwice(painter, [&] { painter.drawLine(px(from), px(*hand_)); });
  }
}

void PictureTool::paintBrush(QPainter& painter) const {
  const bool brushes = mode_ == PaintMode::Brush || mode_ == PaintMode::Eraser || mode_ == PaintMode::Line;
  if (!brushes || !hand_) return;
  const int across = editing_->across();
  const map::GridReference& grid = editing_->reference();
  const Eigen::Vector2d centre = grid.worldFromCell(picture::brushCentre(editing_->cellAt(*hand_), across));
  const double radius = across / 2.0 * grid.resolution_m / scene().view().scale_m_per_px;
  strokeTwice(painter,
              [&] { painter.drawEllipse(px(centre), std::max(radius, 2.0), std::max(radius, 2.0)); });
}

QString PictureTool::hint() const {
  if (!editing_->isOpen()) return {};
  if (editing_->reckoning())
    return tr("Computing… Esc cancels. Anything you draw meanwhile is applied afterwards.");
  if (editing_->looking()) return tr("Preparing the preview… Esc cancels.");
  if (editing_->preview()) return tr("This is a preview. Enter applies it, Esc discards it.");
  switch (mode_) {
    case PaintMode::Brush:
      return tr(
          "Drag to paint. Comma and full stop change the size; Space and drag moves the map. Esc leaves.");
    case PaintMode::Eraser:
      return tr("Drag over the parts to restore to the saved map. Esc leaves.");
    case PaintMode::Line:
      return tr("Drag from one end to the other. Esc leaves.");
    case PaintMode::Rectangle:
      return tr("Drag from corner to corner. Esc leaves.");
    case PaintMode::Polygon:
      if (corners_.empty()) return tr("Click the corners of the area to paint. Esc leaves.");
      return tr(
          "Click the next corner. Click the first one or press Enter to paint. Backspace removes the last "
          "corner.");
    case PaintMode::Fill:
      return tr("Click an area to fill it. Esc leaves.");
    case PaintMode::Select:
      if (editing_->selection().empty())
        return tr("Drag around the part to copy, move or clean up. Esc leaves.");
      return tr(
          "Drag to move it (Ctrl: copy it), Ctrl+C copies, Ctrl+V pastes at the cursor, Delete paints it.");
  }
  return {};
}

}  // namespace mapwright::ui

#include "moc_picture_tool.cpp"
