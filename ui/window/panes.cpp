#include "ui/window/panes.h"

#include <algorithm>
#include <initializer_list>

#include <QApplication>
#include <QDockWidget>
#include <QToolBar>

#include "ui/kit/panels.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/compare_bar.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {

namespace {

/// Where the focus was last in `pane`, otherwise its first stop of Tab; null: it has none.
QWidget* stopIn(QWidget* pane) {
  const auto takes = [pane](const QWidget* widget) {
    return (widget == pane || pane->isAncestorOf(widget)) && widget->isVisible() && widget->isEnabled() &&
           !widget->visibleRegion().isEmpty();
  };
  QWidget* const last = pane->focusWidget();
  if (last && last != pane && takes(last)) return last;
  for (QWidget* widget = pane;;) {
    if ((widget->focusPolicy() & Qt::TabFocus) && takes(widget)) return widget;
    widget = widget->nextInFocusChain();
    if (!widget || widget == pane) return nullptr;
  }
}

}  // namespace

std::vector<QWidget*> panesOf(const WindowContext& context) {
  std::vector<QWidget*> panes{&context.view};
  const MapOverlay& over = context.overlay;
  for (QWidget* strip :
       std::initializer_list<QWidget*>{over.safetyNotice(), over.notice(), over.placeNotice(),
                                       over.editNotice(), over.compareBar(), over.card(), over.toasts()})
    panes.push_back(strip);
  std::vector<QDockWidget*> docks = context.panels.docks();
  std::stable_sort(docks.begin(), docks.end(), [](const QDockWidget* a, const QDockWidget* b) {
    const QPoint at = a->mapToGlobal(QPoint()), other = b->mapToGlobal(QPoint());
    return std::pair(at.x(), at.y()) < std::pair(other.x(), other.y());
  });
  panes.insert(panes.end(), docks.begin(), docks.end());
  panes.push_back(&context.bar);
  for (QToolBar* bar : context.window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
    panes.push_back(bar);
  std::erase_if(panes, [](QWidget* pane) { return !pane->isVisible() || !stopIn(pane); });
  return panes;
}

void goToPane(const WindowContext& context, int step) {
  const std::vector<QWidget*> panes = panesOf(context);
  if (panes.empty()) return;
  const QWidget* const focused = QApplication::focusWidget();
  // The map is an ancestor of the strips over it.
  const auto here = std::find_if(panes.rbegin(), panes.rend(), [&](const QWidget* pane) {
    return focused && pane != &context.view && pane->isAncestorOf(focused);
  });
  const int at = here == panes.rend() ? 0 : int(panes.rend() - here) - 1;
  const int count = int(panes.size());
  QWidget* const next = panes[std::size_t((at + step + count) % count)];
  QWidget* const stop = next == &context.view ? next : stopIn(next);
  stop->window()->activateWindow();
  stop->setFocus(step > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
}

}  // namespace mapwright::ui
