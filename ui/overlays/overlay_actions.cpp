#include "ui/overlays/overlay_actions.h"

#include <QInputDialog>
#include <QMenu>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/overlays/collection_dialog.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlays_dock.h"

namespace mapwright::ui {

OverlayActions::OverlayActions(WindowContext& context, edit::OverlayEditing* editing, OverlayTool* tool,
                               OverlaySnapping* snapping, OverlaysDock* dock, QObject* parent)
    : QObject(parent),
      context_(context),
      editing_(editing),
      snapping_(snapping),
      teaching_(new OverlayTeaching(context, editing, tool, this)),
      transfer_(new OverlayTransfer(context, editing, this)),
      arranging_(new OverlayArranging(context, editing, this)),
      menu_(new QMenu(tr("O&verlays"), &context.window)),
      snap_menu_(new QMenu(tr("Snap t&o"), &context.window)) {
  addSnapping();
  defaults_ =
      context_.actions.add(menuName(Menu::Edit), QStringLiteral("overlayDefaults"),
                           tr("&Defaults of the map…"), QStringLiteral("settings"), {}, Reach::Everywhere,
                           tr("The sizes of racks and pallets that are usual on this map"));
  connect(defaults_, &QAction::triggered, this, &OverlayActions::askDefaults);
  transfer_->addTo(*menu_);
  menu_->addSeparator();
  menu_->addMenu(teaching_->menu());
  menu_->addMenu(arranging_->menu());
  menu_->addSeparator();
  menu_->addAction(snap_);
  menu_->addMenu(snap_menu_);
  menu_->addSeparator();
  menu_->addAction(defaults_);
  context_.actions.addToMenu({MenuGroup::Waypoints, 34}, menu_->menuAction());
  dock->setMenus(teaching_->menu(), arranging_->menu(), snap_, snap_menu_, defaults_);
  connect(snapping_, &OverlaySnapping::changed, this, &OverlayActions::refresh);
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged})
    connect(editing_, signal, this, &OverlayActions::refresh);
  connect(editing_, &edit::OverlayEditing::opened, this, [this] {
    if (defaults_dialog_) defaults_dialog_->close();
  });
  refresh();
}

CollectionDialog* OverlayActions::defaultsDialog() const { return defaults_dialog_; }

void OverlayActions::addSnapping() {
  using overlays::SnapKinds;
  const QString edit = menuName(Menu::Edit);
  snap_ = context_.actions.addToggle(
      edit, QStringLiteral("snapOverlays"), tr("&Snap overlays"), QStringLiteral("snap"),
      {QKeySequence(QStringLiteral("Shift+S"))}, Reach::OutsideText,
      tr("What is drawn or dragged snaps to what is selected in its menu; Alt suspends it"));
  connect(snap_, &QAction::triggered, snapping_, &OverlaySnapping::setOn);
  struct Kind {
    const char* id;
    QString text, tip;
    bool SnapKinds::*kind;
  };
  for (const auto& [id, text, tip, kind] :
       {Kind{"snapOverlayVertices", tr("&Points of overlays"),
             tr("Points, ends and corners of other overlays"), &SnapKinds::vertices},
        Kind{"snapOverlayEdges", tr("&Edges of overlays"), tr("Lines and outlines of other overlays"),
             &SnapKinds::edges},
        Kind{"snapOverlayAngles", tr("&Angles of 15° for overlays"),
             tr("From the point before, while a line is drawn"), &SnapKinds::angles},
        Kind{"snapOverlayGrid", tr("&Grid for overlays"), tr("Lines at a regular distance, see Spacing"),
             &SnapKinds::grid},
        Kind{"snapOverlayWalls", tr("&Walls of the map below"),
             tr("The edges of what is occupied on the map"), &SnapKinds::walls}}) {
    QAction* const action =
        context_.actions.addToggle(edit, QLatin1String(id), text, {}, {}, Reach::Everywhere, tip);
    connect(action, &QAction::triggered, this, [this, kind = kind](bool checked) {
      SnapKinds kinds = snapping_->kinds();
      kinds.*kind = checked;
      snapping_->setKinds(kinds);
      // Choosing what to snap to also turns snapping on.
      if (checked) snapping_->setOn(true);
    });
    kinds_.emplace_back(action, kind);
    snap_menu_->addAction(action);
  }
  snap_menu_->addSeparator();
  QAction* const spacing = context_.actions.add(
      edit, QStringLiteral("snapOverlaySpacing"), tr("&Spacing of the grid for overlays…"), {}, {},
      Reach::Everywhere, tr("The distance between the lines that overlays snap to"));
  connect(spacing, &QAction::triggered, this, &OverlayActions::askSpacing);
  snap_menu_->addAction(spacing);
}

void OverlayActions::askSpacing() {
  auto* const dialog = new QInputDialog(&context_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setObjectName(QStringLiteral("overlaySpacing"));
  dialog->setWindowTitle(tr("Spacing of the grid"));
  dialog->setLabelText(tr("Metres between its lines"));
  dialog->setInputMode(QInputDialog::DoubleInput);
  dialog->setDoubleDecimals(3);
  dialog->setDoubleRange(0.01, 100);
  dialog->setDoubleStep(0.1);
  dialog->setDoubleValue(snapping_->kinds().grid_m);
  connect(dialog, &QInputDialog::doubleValueSelected, this, [this](double metres) {
    overlays::SnapKinds kinds = snapping_->kinds();
    kinds.grid_m = metres;
    kinds.grid = true;
    snapping_->setKinds(kinds);
    snapping_->setOn(true);
  });
  dialog->open();
}

void OverlayActions::askDefaults() {
  if (defaults_dialog_) return defaults_dialog_->raise();
  if (!editing_->editable()) return;
  defaults_dialog_ = new CollectionDialog(*editing_->document().find(kCollectionKey), &context_.window);
  connect(defaults_dialog_, &QDialog::accepted, this, [this] {
    if (!defaults_dialog_ || !editing_->editable()) return;
    editing_->set(kCollectionKey, defaults_dialog_->edited(), tr("change the defaults of the map"));
  });
  defaults_dialog_->open();
}

void OverlayActions::refresh() {
  snap_->setChecked(snapping_->on());
  for (const auto& [action, kind] : kinds_) action->setChecked(snapping_->kinds().*kind);
  allow(defaults_, editing_->editable(), tr("Open the overlays of a map first."));
}

}  // namespace mapwright::ui

#include "moc_overlay_actions.cpp"
