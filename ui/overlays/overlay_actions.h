// The menu "Overlays" below Edit, and what its entries do besides the tool: from the robot, snapping, the
// clipboard, arranging, defaults of the map. GUI thread.
#pragma once

#include <utility>
#include <vector>

#include <QObject>
#include <QPointer>

#include "ui/overlays/overlay_arranging.h"
#include "ui/overlays/overlay_snapping.h"
#include "ui/overlays/overlay_teaching.h"
#include "ui/overlays/overlay_transfer.h"

namespace mapwright::ui {

class CollectionDialog;
class OverlaysDock;

class OverlayActions : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlayActions(WindowContext& context, edit::OverlayEditing* editing, OverlayTool* tool,
                 OverlaySnapping* snapping, OverlaysDock* dock, QObject* parent = nullptr);

  OverlayTeaching* teaching() const { return teaching_; }
  OverlayTransfer* transfer() const { return transfer_; }
  OverlayArranging* arranging() const { return arranging_; }
  CollectionDialog* defaultsDialog() const;  // null: none is open

 private:
  void addSnapping();
  void askSpacing();
  void askDefaults();
  void refresh();

  WindowContext& context_;
  edit::OverlayEditing* editing_;
  OverlaySnapping* snapping_;
  OverlayTeaching* teaching_;
  OverlayTransfer* transfer_;
  OverlayArranging* arranging_;
  QMenu *menu_, *snap_menu_;
  QAction *snap_, *defaults_;
  std::vector<std::pair<QAction*, bool overlays::SnapKinds::*>> kinds_;
  QPointer<CollectionDialog> defaults_dialog_;
};

}  // namespace mapwright::ui
