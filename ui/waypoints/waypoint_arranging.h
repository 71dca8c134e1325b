// What is done with several waypoints at once: aligned, distributed, mirrored, headed along their way,
// renamed. Each is one step to undo. GUI thread.
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QPointer>

#include "placing/arrange.h"
#include "ui/shell/window_context.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_snapping.h"

namespace mapwright::ui {

class MirrorTool;
class RenameDialog;

class WaypointArranging : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  WaypointArranging(WindowContext& context, WaypointEditing* editing, WaypointSnapping* snapping,
                    QObject* parent = nullptr);

  /// The selected ones in the order of the list on screen.
  void setListOrder(std::function<std::vector<edit::Key>()> order) { list_order_ = std::move(order); }
  RenameDialog* renameDialog() const;  // null: none is open
  MirrorTool* mirrorTool() const { return mirror_; }

 private:
  using Arranging = std::function<std::vector<placing::Spot>(std::vector<placing::Spot>)>;
  struct Entry {
    QAction* action;
    std::size_t least;  // so many have to be selected
  };
  void add(const char* id, const QString& text, const char* key, const QString& tip, std::size_t least,
           const QString& what, Arranging how);
  void arrange(const Arranging& how, const QString& what);
  void refresh();
  void rename();

  WindowContext& context_;
  WaypointEditing* editing_;
  MirrorTool* mirror_;
  QMenu* menu_;
  std::vector<Entry> entries_;
  std::function<std::vector<edit::Key>()> list_order_;
  QPointer<RenameDialog> dialog_;
};

}  // namespace mapwright::ui
