// Overlays on their way over the clipboard, as GeoJSON: between maps, robots and text editors. GUI thread.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <QObject>

#include "edit/overlays/overlay_editing.h"
#include "ui/shell/window_context.h"

class QMenu;

namespace mapwright::ui {

class OverlayTransfer : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  OverlayTransfer(WindowContext& context, edit::OverlayEditing* editing, QObject* parent = nullptr);

  void addTo(QMenu& menu);
  void copy();
  void cut();
  /// Where they were, or around another place.
  void paste(std::optional<Eigen::Vector2d> at_m);

 private:
  void refresh();

  WindowContext& context_;
  edit::OverlayEditing* editing_;
  QAction *copy_, *cut_, *paste_, *paste_here_;
};

}  // namespace mapwright::ui
