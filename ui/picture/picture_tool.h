// Paints on the map: brush, eraser, line, rectangle, polygon, fill, and selecting a rectangle to copy, move
// or paint.
#pragma once

#include <optional>
#include <vector>

#include "edit/picture/picture_editing.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

/// How to mark a cell that would become this kind: distinguishable by lightness and hatching, not only by
/// colour.
struct BecomesLook {
  QColor color;
  Qt::BrushStyle lines;  // over the colour, if there is room
};
BecomesLook becomesLook(picture::Kind kind);

enum class PaintMode { Brush, Eraser, Line, Rectangle, Polygon, Fill, Select };
inline constexpr int kPaintModes = 7;

class PictureTool : public DragTool {
  Q_OBJECT
 public:
  /// Both must outlive this.
  PictureTool(edit::PictureEditing* editing, scene::MapScene* scene, QObject* parent = nullptr);

  PaintMode mode() const { return mode_; }
  void setMode(PaintMode mode);

  QString name() const override { return QStringLiteral("picture"); }
  bool takesEveryPress() const override { return true; }
  void activate() override;
  void deactivate() override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void modeChanged();
  void activated();
  /// It is impossible; a sentence.
  void refused(const QString& why);

 private:
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void finish(const MapPoint& at) override;
  void cancel() override { editing_->endStroke(); }  // what is painted stays, as one step
  void click(const MapPoint& at) override;
  bool stepBack() override;
  /// Whole cells by which the selection has been dragged.
  std::pair<int, int> movedBy() const;
  QPolygonF outline(const picture::CellRect& rect) const;
  void paintPreview(QPainter& painter) const;
  void paintSelection(QPainter& painter) const;
  void paintShape(QPainter& painter) const;
  void paintBrush(QPainter& painter) const;

  edit::PictureEditing* editing_;
  PaintMode mode_ = PaintMode::Brush;
  std::optional<Eigen::Vector2d> hand_;   // the cursor, world metres
  std::vector<Eigen::Vector2d> corners_;  // of the polygon
  bool on_selection_ = false;             // the press
  bool copies_ = false;                   // and leaves the original
};

}  // namespace mapwright::ui
