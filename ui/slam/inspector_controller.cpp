#include "ui/slam/inspector_controller.h"

#include <utility>

#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>

#include "render/tile_colors.h"
#include "session/session.h"
#include "submap/submap_store.h"
#include "ui/kit/actions.h"
#include "ui/kit/findings.h"
#include "ui/kit/icons.h"
#include "ui/kit/panels.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/shell/window_status_bar.h"
#include "ui/slam/inspector_dock.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

InspectorController::InspectorController(WindowContext& context, QAction* show_ids, QAction* show_outlines,
                                         QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new InspectorDock(&context.scene, show_ids, show_outlines, &context.window)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 20, .menu_rank = 30});
  context_.actions.add({.id = "filter",
                        .text = tr("Filter &submaps"),
                        .icon = "filter",
                        .keys = {"Ctrl+F"},
                        .tip = tr("Go to the filter of the SLAM inspector"),
                        .needs_session = true,
                        .menu = {MenuGroup::Window, 10}},
                       this, &InspectorController::goToFilter);
  addToMapMenu();
  context_.findings.add([this]() -> Findings::Search {
    return [this](const QString& typed, const Findings::See& see) { findSubmaps(typed, see); };
  });
  connect(dock_, &InspectorDock::locateWanted, this, &InspectorController::locate);
  connect(dock_, &InspectorDock::colorModeWanted, this, &InspectorController::colorModeWanted);
  connect(dock_, &InspectorDock::counted, &context_.bar, &WindowStatusBar::recount);
  connect(dock_, &InspectorDock::copyWanted, this,
          [this](const QString& text, const QString& said) { copyText(context_.overlay, text, said); });
}

void InspectorController::addToMapMenu() {
  context_.actions.addToMapMenu({MapMenuGroup::Submap, 10}, [this](QMenu& menu,
                                                                   const Eigen::Vector2d& world) {
    const auto id = context_.scene.submapAt(world);
    if (!id || !context_.current.session()) return;
    const QString name = QString::fromStdString(map::toText(*id));
    menu.addAction(themedIcon(QStringLiteral("submaps")), tr("Select submap %1").arg(name), this, [this, id] {
      dock_->show();
      dock_->select(*id);
    });
    menu.addAction(themedIcon(QStringLiteral("eye-off")), tr("Hide submap %1").arg(name), this, [this, id] {
      if (session::Session* const session = context_.current.session()) session->setVisible({*id}, false);
    });
  });
}

/// "12-3" is one, "12-" or "12" are those of a trajectory.
void InspectorController::findSubmaps(const QString& typed, const Findings::See& see) {
  session::Session* const session = context_.current.session();
  static const QRegularExpression pattern(QStringLiteral("^(\\d{1,9})(?:-(\\d{0,9}))?$"));
  const QRegularExpressionMatch match = pattern.match(typed);
  if (!session || !match.hasMatch()) return;
  const int trajectory = match.captured(1).toInt();
  const auto& rows = session->submaps().rows();
  for (auto row = rows.lower_bound({trajectory, 0}); row != rows.end(); ++row) {
    const map::SubmapId id = row->first;
    if (id.trajectory != trajectory) break;
    const QString name = QString::fromStdString(map::toText(id));
    if (!name.startsWith(typed)) continue;
    see({tr("Submap %1").arg(name), tr("Submap"), QStringLiteral("submaps"), [this, id] {
           context_.panels.open(dock_);
           dock_->select(id);
           locate(id);
         }});
  }
}

void InspectorController::setColorMode(render::ColorMode mode) { dock_->setColorMode(mode); }

void InspectorController::clickedOnMap(const Eigen::Vector2d& world_m) {
  if (!context_.scene.highlightedAt(world_m)) dock_->clearSelection();
}

void InspectorController::setSession(session::Session* session) {
  dock_->setSession(session);
  if (!session) return;
  // A robot without submaps has put another panel in front of it.
  const bool has_submaps = session->robot().submapSource() != nullptr;
  if (std::exchange(behind_, !has_submaps) && has_submaps) context_.panels.suggest(dock_);
}

bool InspectorController::escape() {
  const bool pointed_at = !context_.scene.highlighted().empty();
  dock_->clearSelection();
  return pointed_at;
}

void InspectorController::locate(map::SubmapId id) {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const geometry::WorldRect bounds = session->submaps().bounds(id, session->slice());
  if (!bounds.empty()) {
    context_.viewpoint.lookAt(bounds);
    Q_EMIT located(id);
    return;
  }
  context_.overlay.toasts()->add(Mark::Warning,
                                 tr("Submap %1 has no valid pose, so it cannot be placed on the map.")
                                     .arg(QString::fromStdString(map::toText(id))));
}

void InspectorController::goToFilter() {
  context_.panels.open(dock_);
  dock_->filterEdit()->setFocus();
  dock_->filterEdit()->selectAll();
}

}  // namespace mapwright::ui

#include "moc_inspector_controller.cpp"
