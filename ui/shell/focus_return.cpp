#include "ui/shell/focus_return.h"

#include <QApplication>

namespace mapwright::ui {
namespace {

bool canHaveFocus(const QWidget* widget) { return widget && widget->isVisible() && widget->isEnabled(); }

}  // namespace

FocusReturn::FocusReturn(QWidget& window, QWidget& map, QObject* parent)
    : QObject(parent), window_(window), map_(&map) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { onFocusChanged(now); });
}

/// Also when the window is active again: a button that opened a dialog may be of no more use once that is
/// done.
void FocusReturn::onFocusChanged(QWidget* now) {
  if (now && now->window() != &window_) return;
  const bool gone = some_had_it_ && !canHaveFocus(had_it_);
  if (gone && window_.isActiveWindow() && canHaveFocus(map_)) {
    had_it_ = map_;
    map_->setFocus();
  } else if (now) {
    had_it_ = now;
    some_had_it_ = true;
  }
}

}  // namespace mapwright::ui

#include "moc_focus_return.cpp"
