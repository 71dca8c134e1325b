// What dialogs have in common: which button is which, and how progress looks.
#pragma once

#include <initializer_list>

class QProgressBar;
class QPushButton;

namespace mapwright::window {

/// `main` is what Enter presses; `others` stand beside it.
void giveRoles(QPushButton& main, std::initializer_list<QPushButton*> others);
/// The same for what cannot be had back: it is pressed by hand, and Enter presses `safe`.
void giveCarefulRoles(QPushButton& main, QPushButton& safe);
/// Whether Enter presses it: not while that would destroy something, whatever has the keyboard.
void letEnterPress(QPushButton& button, bool lets);
/// A thin line from 0 to 1000 that is hidden at first, and keeps its room while it is.
void makeLine(QProgressBar& progress);

}  // namespace mapwright::window
