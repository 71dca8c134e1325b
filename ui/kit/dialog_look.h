// The common look of dialogs: roles of buttons, progress.
#pragma once

#include <initializer_list>

class QProgressBar;
class QPushButton;

namespace mapwright::ui {

/// `main` is triggered by Enter; `others` are next to it.
void giveRoles(QPushButton& main, std::initializer_list<QPushButton*> others);
/// The same for an action that cannot be undone: it needs a click, and Enter triggers `safe`.
void giveCarefulRoles(QPushButton& main, QPushButton& safe);
/// Whether Enter triggers it: not while that would destroy something.
void letEnterPress(QPushButton& button, bool lets);
/// A thin line from 0 to 1000, initially hidden but with its space reserved.
void makeLine(QProgressBar& progress);

}  // namespace mapwright::ui
