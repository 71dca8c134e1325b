#include "ui/waypoints/edit_controller.h"

#include <QDockWidget>
#include <QKeyEvent>
#include <QUndoGroup>
#include <QUndoView>

#include "ui/kit/actions.h"
#include "ui/kit/panels.h"
#include "ui/shell/unsaved_changes.h"

namespace mapwright::ui {

namespace {

/// Command names may contain other names: escapes mnemonics.
QString withName(const QString& verb, QString command) {
  command.replace(QLatin1Char('&'), QLatin1String("&&"));
  return command.isEmpty() ? verb : QStringLiteral("%1 %2").arg(verb, command);
}

/// The steps of the edited document; a click goes back or forth to one. Single letters are left to the
/// window.
class History : public QUndoView {
 public:
  using QUndoView::QUndoView;

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    event->key() == Qt::Key_Escape ? event->ignore() : QUndoView::keyPressEvent(event);
  }
  void keyboardSearch(const QString&) override {}
};

}  // namespace

EditController::EditController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  QUndoGroup& group = context_.undo;
  undo_ = context_.actions.add({.id = "undo",
                                .text = tr("&Undo"),
                                .icon = "undo",
                                .keys = {"Ctrl+Z"},
                                .tip = tr("Undo the last change"),
                                .menu = {MenuGroup::Undo, 10},
                                .bar = {BarGroup::Edit, 10}},
                               &group, &QUndoGroup::undo);
  redo_ = context_.actions.add({.id = "redo",
                                .text = tr("&Redo"),
                                .icon = "redo",
                                .keys = {"Ctrl+Shift+Z", "Ctrl+Y"},
                                .tip = tr("Redo the change that was undone last"),
                                .menu = {MenuGroup::Undo, 20},
                                .bar = {BarGroup::Edit, 20}},
                               &group, &QUndoGroup::redo);
  save_ = context_.actions.add({.id = "save",
                                .text = tr("&Save"),
                                .icon = "save",
                                .keys = {"Ctrl+S"},
                                .tip = tr("Save the changes"),
                                .menu = {MenuGroup::Save, 10},
                                .bar = {BarGroup::Edit, 30}},
                               &context_.unsaved, &UnsavedChanges::save);
  connect(&group, &QUndoGroup::canUndoChanged, this, &EditController::refresh);
  connect(&group, &QUndoGroup::canRedoChanged, this, &EditController::refresh);
  connect(&context_.unsaved, &UnsavedChanges::changed, this, &EditController::refresh);
  connect(&group, &QUndoGroup::undoTextChanged, undo_,
          [this](const QString& what) { undo_->setText(withName(tr("&Undo"), what)); });
  connect(&group, &QUndoGroup::redoTextChanged, redo_,
          [this](const QString& what) { redo_->setText(withName(tr("&Redo"), what)); });
  addHistory();
  refresh();
}

EditController::~EditController() { delete history_; }

void EditController::addHistory() {
  history_ = new QDockWidget(tr("History"), &context_.window);
  history_->setObjectName(QStringLiteral("history"));
  auto* const steps = new History(&context_.undo, history_);
  steps->setEmptyLabel(tr("Original state"));
  steps->setAccessibleName(tr("Steps that can be undone"));
  steps->setUniformItemSizes(true);
  history_->setWidget(steps);
  context_.panels.add(history_,
                      {.side = PanelPosition::Side::Right, .tab = 17, .menu_rank = 47, .open = false});
}

void EditController::refresh() {
  undo_->setEnabled(context_.undo.canUndo());
  redo_->setEnabled(context_.undo.canRedo());
  save_->setEnabled(context_.unsaved.maySave());
}

}  // namespace mapwright::ui

#include "moc_edit_controller.cpp"
