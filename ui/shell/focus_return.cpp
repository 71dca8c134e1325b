#include "ui/shell/focus_return.h"

#include <QApplication>
#include <QEvent>

namespace mapwright::window {
namespace {

bool canHaveFocus(const QWidget* widget) { return widget && widget->isVisible() && widget->isEnabled(); }

}  // namespace

FocusReturn::FocusReturn(QWidget& window, QWidget& map, QObject* parent)
    : QObject(parent), window_(window), map_(map) {
  window_.installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, &FocusReturn::onFocusChanged);
}

void FocusReturn::onFocusChanged(QWidget* before, QWidget* now) {
  const bool ours = before && before->window() == &window_ && (!now || now->window() == &window_);
  if (ours && window_.isActiveWindow() && !canHaveFocus(before) && canHaveFocus(&map_)) map_.setFocus();
}

bool FocusReturn::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::WindowDeactivate) {
    had_it_ = window_.focusWidget();
    some_had_it_ = had_it_ != nullptr;
  }
  // A button that opened a dialog may be of no more use once that is done.
  if (event->type() == QEvent::WindowActivate && some_had_it_ && !canHaveFocus(had_it_)) map_.setFocus();
  return QObject::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_focus_return.cpp"
