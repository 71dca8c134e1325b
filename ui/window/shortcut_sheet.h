// All keys and mouse gestures on one page, and the About box.
#pragma once

class QDialog;
class QWidget;

namespace mapwright::ui {

class Actions;

/// Owned by `parent`, deleted when closed.
QDialog* makeShortcutSheet(const Actions& actions, QWidget* parent);
QDialog* makeAboutBox(QWidget* parent);

}  // namespace mapwright::ui
