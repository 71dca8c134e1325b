#include "ui/waypoints/waypoint_arranging.h"

#include <utility>

#include <QMenu>

#include "geometry/pose.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/mirror_tool.h"
#include "ui/waypoints/rename_dialog.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::ui {
namespace {

using Spots = std::vector<placing::Spot>;
constexpr double kUpright = geometry::radiansFromDegrees(90);

QString editMenu() { return menuName(Menu::Edit); }

}  // namespace

WaypointArranging::WaypointArranging(WindowContext& context, WaypointEditing* editing,
                                     WaypointSnapping* snapping, QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      mirror_(new MirrorTool(editing, &context.scene, snapping, this)),
      menu_(new QMenu(tr("&Arrange waypoints"), &context.window)),
      list_order_([editing] { return editing->inOrder(); }) {
  using placing::Axis;
  using placing::LastHeads;
  menu_->setToolTipsVisible(true);
  const auto along = [](auto how, Axis axis) {
    return [how, axis](Spots spots) { return how(std::move(spots), axis); };
  };
  add("alignWaypointsX", tr("Align on one &x"), "Ctrl+Shift+X",
      tr("Move all selected waypoints to the middle of their x"), 2, tr("align %1"),
      along(&placing::aligned, Axis::X));
  add("alignWaypointsY", tr("Align on one &y"), "Ctrl+Shift+Y",
      tr("Move all selected waypoints to the middle of their y"), 2, tr("align %1"),
      along(&placing::aligned, Axis::Y));
  const QString evenly = tr("Space the selected waypoints evenly between the outermost two");
  add("distributeWaypointsX", tr("&Distribute along x"), "Ctrl+Alt+X", evenly, 3, tr("distribute %1"),
      along(&placing::distributed, Axis::X));
  add("distributeWaypointsY", tr("Dis&tribute along y"), "Ctrl+Alt+Y", evenly, 3, tr("distribute %1"),
      along(&placing::distributed, Axis::Y));
  menu_->addSeparator();
  add("mirrorWaypointsX", tr("Mirror &left and right"), "Ctrl+Shift+M",
      tr("Mirror the selected waypoints, with their headings, about the vertical line through their middle"),
      2, tr("mirror %1"), [](Spots spots) {
        const Eigen::Vector2d centre = placing::centreOf(spots);
        return placing::mirrored(std::move(spots), centre, kUpright);
      });
  add("mirrorWaypointsY", tr("Mirror &up and down"), "Ctrl+Alt+M",
      tr("Mirror the selected waypoints, with their headings, about the horizontal line through their "
         "middle"),
      2, tr("mirror %1"), [](Spots spots) {
        const Eigen::Vector2d centre = placing::centreOf(spots);
        return placing::mirrored(std::move(spots), centre, 0);
      });
  QAction* const about_line = context_.actions.addToggle(
      editMenu(), QStringLiteral("mirrorWaypointsLine"), tr("Mirror about a l&ine"), {}, {},
      Reach::Everywhere,
      tr("Mirror the selected waypoints, with their headings, about a line that you draw"));
  menu_->addAction(about_line);
  entries_.push_back({about_line, 1});
  context_.tools.add(mirror_, about_line);
  menu_->addSeparator();
  add("headWaypointsNext", tr("Head towards the &next"), "Ctrl+Shift+H",
      tr("Turn each selected waypoint towards the next one, in the order of selection; the last one like the "
         "one before"),
      2, tr("turn %1"),
      [](Spots spots) { return placing::headingOn(std::move(spots), LastHeads::OnAsBefore); });
  add("headWaypointsLoop", tr("Head around a l&oop"), "Ctrl+Alt+H",
      tr("Turn each selected waypoint towards the next one, in the order of selection; the last one towards "
         "the first"),
      2, tr("turn %1"),
      [](Spots spots) { return placing::headingOn(std::move(spots), LastHeads::BackToFirst); });
  context_.actions.addToMenu({MenuGroup::Waypoints, 14}, menu_->menuAction());
  QAction* const rename = context_.actions.add(
      {.id = "renameWaypoints",
       .text = tr("&Rename waypoints…"),
       .keys = {"Shift+F2"},
       .tip = tr("New names for all selected waypoints: counted, or with a part replaced"),
       .menu = {MenuGroup::Waypoints, 15}},
      this, &WaypointArranging::rename);
  entries_.push_back({rename, 1});
  connect(mirror_, &MirrorTool::activated, this, [this] { context_.view.setFocus(); });
  connect(mirror_, &MirrorTool::ended, this, [this] { context_.tools.choose(QStringLiteral("waypoints")); });
  connect(editing_, &WaypointEditing::renameSeveralWanted, this, &WaypointArranging::rename);
  connect(editing_, &WaypointEditing::opened, this, &WaypointArranging::refresh);
  connect(editing_, &WaypointEditing::selectionChanged, this, &WaypointArranging::refresh);
  refresh();
}

void WaypointArranging::add(const char* id, const QString& text, const char* key, const QString& tip,
                            std::size_t least, const QString& what, Arranging how) {
  QAction* const action = context_.actions.add(editMenu(), QLatin1String(id), text, {},
                                               {QKeySequence(QLatin1String(key))}, Reach::Everywhere, tip);
  connect(action, &QAction::triggered, this, [this, how = std::move(how), what] { arrange(how, what); });
  menu_->addAction(action);
  entries_.push_back({action, least});
}

void WaypointArranging::arrange(const Arranging& how, const QString& what) {
  const std::vector<edit::Key> keys = editing_->inOrder();
  const Spots spots = how(editing_->spots(keys));
  WaypointPreview to;
  for (std::size_t i = 0; i < keys.size(); ++i) to.emplace(keys[i], spots[i]);
  editing_->apply(to, what.arg(waypointsText(qsizetype(to.size()))));
}

void WaypointArranging::refresh() {
  const QString why =
      editing_->document() ? editing_->unavailableReason() : tr("Open a map to place waypoints in it.");
  for (const Entry& entry : entries_) {
    allow(entry.action, editing_->editable() && editing_->selected().size() >= entry.least,
          !editing_->editable() ? why
          : entry.least > 2     ? tr("Select at least three waypoints.")
          : entry.least > 1     ? tr("Select at least two waypoints.")
                                : tr("Nothing is selected."));
  }
  if (!entries_.empty() && editing_->selected().empty() && context_.tools.chosen() == mirror_)
    Q_EMIT mirror_->ended();
}

RenameDialog* WaypointArranging::renameDialog() const { return dialog_; }

void WaypointArranging::rename() {
  if (dialog_ || !editing_->editable() || editing_->selected().empty()) return;
  dialog_ = new RenameDialog(editing_, list_order_, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_waypoint_arranging.cpp"
