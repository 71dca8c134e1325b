// The selected overlays put in line and spread evenly. GUI thread.
#pragma once

#include <vector>

#include <QObject>

#include "edit/overlays/overlay_editing.h"
#include "overlays/overlay_arrange.h"
#include "ui/shell/window_context.h"

class QMenu;

namespace mapwright::ui {

class OverlayArranging : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  OverlayArranging(WindowContext& context, edit::OverlayEditing* editing, QObject* parent = nullptr);
  QMenu* menu() const { return menu_; }

 private:
  using Shifts = std::vector<Eigen::Vector2d>;
  void arrange(const QString& text,
               const std::function<Shifts(const std::vector<geometry::WorldRect>&)>& how);
  void refresh();

  edit::OverlayEditing* editing_;
  QMenu* menu_;
  std::vector<std::pair<QAction*, std::size_t>> actions_;  // with how many it takes at least
};

}  // namespace mapwright::ui
