// The rectangles of the projections on the map: draw, select, move, resize.
#pragma once

#include <optional>

#include "ui/clouds/projection_draft.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

/// Drag on an empty part of the map: a new one. Click one: select it. Drag its edge, corner or inside: change
/// it. Delete removes the selected one.
class ProjectionTool : public DragTool {
  Q_OBJECT
 public:
  /// Both must outlive this. Call refresh() after changing the draft.
  ProjectionTool(const scene::MapScene* scene, const ProjectionDraft* draft, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("projections"); }
  QCursor cursor() const override;
  void hovered(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  /// Not editable: read-only for now, or because the robot cannot set them.
  void setEditable(bool editable, bool takes);
  void refresh();

 Q_SIGNALS:
  void chosen(std::optional<int> index);
  void drawn(const mapwright::geometry::WorldRect& rect);
  void changedTo(int index, const mapwright::map::Projection& projection);
  void removeWanted();

 private:
  /// One that is dragged.
  struct Grabbed {
    int index;
    RectGrip grip;
    map::Projection before;
  };
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void finish(const MapPoint& at) override;
  void cancel() override;
  void click(const MapPoint& at) override { Q_EMIT chosen(indexAt(at)); }
  RectGrip gripOnChosen(const MapPoint& at) const;
  std::optional<int> indexAt(const MapPoint& at) const;
  /// The new one that is being drawn.
  geometry::WorldRect newOne() const;

  const ProjectionDraft* draft_;
  bool editable_ = false, takes_ = false;
  std::optional<Grabbed> grabbed_;
  RectGrip under_ = RectGrip::None;
};

}  // namespace mapwright::ui
