#include "window/edit/edit_controller.h"

#include <QUndoGroup>

#include "window/unsaved_changes.h"

namespace mapwright::window {

namespace {

/// The names of commands hold names of others: no mnemonics in them.
QString withName(const QString& verb, QString command) {
  command.replace(QLatin1Char('&'), QLatin1String("&&"));
  return command.isEmpty() ? verb : QStringLiteral("%1 %2").arg(verb, command);
}

}  // namespace

EditController::EditController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  QUndoGroup& group = context_.undo;
  undo_ = context_.actions.add({.id = "undo",
                                .text = tr("&Undo"),
                                .icon = "undo",
                                .keys = {"Ctrl+Z"},
                                .tip = tr("Take the last change back"),
                                .menu = {MenuGroup::Undo, 10},
                                .bar = {BarGroup::Edit, 10}},
                               &group, &QUndoGroup::undo);
  redo_ = context_.actions.add({.id = "redo",
                                .text = tr("&Redo"),
                                .icon = "redo",
                                .keys = {"Ctrl+Shift+Z", "Ctrl+Y"},
                                .tip = tr("Make the change again that was taken back last"),
                                .menu = {MenuGroup::Undo, 20},
                                .bar = {BarGroup::Edit, 20}},
                               &group, &QUndoGroup::redo);
  save_ = context_.actions.add({.id = "save",
                                .text = tr("&Save"),
                                .icon = "save",
                                .keys = {"Ctrl+S"},
                                .tip = tr("Write what has been changed where it is kept"),
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
  refresh();
}

void EditController::refresh() {
  undo_->setEnabled(context_.undo.canUndo());
  redo_->setEnabled(context_.undo.canRedo());
  save_->setEnabled(context_.unsaved.maySave());
}

}  // namespace mapwright::window
