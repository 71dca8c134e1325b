// What the colours and shapes on the map mean.
#pragma once

#include <map>
#include <vector>

#include <QDockWidget>
#include <QPointer>

#include "grids/grid_cells.h"
#include "session/session.h"
#include "ui/scene/map_scene.h"

class QScrollArea;

namespace mapwright::ui {

/// The legend of what is on screen. It is made while somebody sees it, and anew when something changes.
class LegendDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit LegendDock(scene::MapScene* scene, QWidget* parent = nullptr);
  /// Null: no robot.
  void setSession(session::Session* session);
  const std::vector<scene::LegendSection>& shown() const { return shown_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refreshSoon();
  void refresh();
  void updateGrid(map::GridKind kind);

  scene::MapScene* scene_;
  QPointer<session::Session> session_;
  QScrollArea* scroll_;
  std::vector<scene::LegendSection> shown_;
  std::map<map::GridKind, std::pair<bool, grids::CellCode>> grids_;  // how their colours are meant
  bool made_ = false;                                                // once at least
  bool due_ = false;                                                 // refresh() will be called
};

}  // namespace mapwright::ui
