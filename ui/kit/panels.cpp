#include "ui/kit/panels.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QChildEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QScrollArea>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

using Side = PanelPosition::Side;

struct Edge {
  Side side;
  Qt::DockWidgetArea area;
  Qt::Orientation across, along;  // its width, and how its stacks follow one another
  int Layout::*px;
};
constexpr Edge kEdges[] = {
    {Side::Left, Qt::LeftDockWidgetArea, Qt::Horizontal, Qt::Vertical, &Layout::left_px},
    {Side::Right, Qt::RightDockWidgetArea, Qt::Horizontal, Qt::Vertical, &Layout::right_px},
    {Side::Bottom, Qt::BottomDockWidgetArea, Qt::Vertical, Qt::Horizontal, &Layout::bottom_px}};
constexpr int kSharePx = 100;

/// Where there is no room for all tabs: a list of them in place of the arrows, behind which nobody would look
/// for the others. The wheel still moves the tabs.
class AllTabs : public QToolButton {
 public:
  explicit AllTabs(QTabBar* tabs) : QToolButton(tabs), tabs_(tabs) {
    setObjectName(QStringLiteral("allTabs"));
    setIcon(themedIcon(QStringLiteral("chevron-down")));
    setToolTip(Panels::tr("All panels here"));
    setAccessibleName(toolTip());
    setFocusPolicy(Qt::NoFocus);
    setPopupMode(QToolButton::InstantPopup);
    auto* const list = new QMenu(this);
    setMenu(list);
    connect(list, &QMenu::aboutToShow, this, [this, list] {
      list->clear();
      for (int i = 0; i < tabs_->count(); ++i) {
        QAction* const action =
            list->addAction(tabs_->tabText(i), this, [this, i] { tabs_->setCurrentIndex(i); });
        action->setCheckable(true);
        action->setChecked(i == tabs_->currentIndex());
      }
    });
    for (QToolButton* arrow : arrows()) arrow->installEventFilter(this);
    hide();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool moved = event->type() == QEvent::Show || event->type() == QEvent::Hide ||
                       event->type() == QEvent::Move || event->type() == QEvent::Resize;
    if (moved) cover();
    return QToolButton::eventFilter(watched, event);
  }

 private:
  QList<QToolButton*> arrows() const {
    QList<QToolButton*> arrows;
    for (const char* name : {"ScrollLeftButton", "ScrollRightButton"}) {
      if (auto* const arrow = tabs_->findChild<QToolButton*>(QLatin1String(name))) arrows << arrow;
    }
    return arrows;
  }
  void cover() {
    QRect room;
    for (const QToolButton* arrow : arrows()) {
      if (!arrow->isHidden()) room |= arrow->geometry();
    }
    setVisible(!room.isEmpty());
    setGeometry(room);
    raise();
  }

  QTabBar* tabs_;
};

}  // namespace

Panels::Panels(QMainWindow& window, Actions& actions) : QObject(&window), window_(window), actions_(actions) {
  window_.setDockNestingEnabled(true);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.installEventFilter(this);
}

bool Panels::eventFilter(QObject* watched, QEvent* event) {
  // The window creates them on demand. Truncated to a few letters they would be useless.
  if (event->type() == QEvent::ChildPolished) {
    if (auto* const tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) {
      tabs->setAccessibleName(tr("Panels"));
      tabs->setElideMode(Qt::ElideNone);
      tabs->setUsesScrollButtons(true);
      new AllTabs(tabs);
    }
  }
  return QObject::eventFilter(watched, event);
}

void Panels::add(QDockWidget* dock, const PanelPosition& position) {
  giveTitle(dock);
  if (QWidget* const body = dock->widget()) {
    orderTabsAsLaidOut(*body);
    // What a dock needs at least must not keep the window from a small screen.
    if (!isScrolled(*dock)) setScrolledWidget(*dock, body);
  }
  QAction* const toggle = dock->toggleViewAction();
  actions_.list({MenuGroup::Panels, position.menu_rank}, toggle);
  // The user wants to see the panel, not the tab in front of it: also if it was open, behind that. Before
  // QDockWidget is triggered, which closes it.
  connect(toggle, &QAction::toggled, dock, [this, dock](bool on) {
    behind_ = !on && dock->isVisible() && dock->visibleRegion().isEmpty() ? dock : nullptr;
  });
  // Qt positions it only once it is laid out.
  connect(toggle, &QAction::triggered, dock, [this, dock](bool on) {
    if (!on && std::exchange(behind_, nullptr) != dock) return;
    dock->show();
    QMetaObject::invokeMethod(dock, &QDockWidget::raise, Qt::QueuedConnection);
  });
  const auto at =
      std::upper_bound(panels_.begin(), panels_.end(), position.menu_rank,
                       [](int rank, const Panel& panel) { return rank < panel.position.menu_rank; });
  panels_.insert(at, {dock, position});
}

std::vector<QDockWidget*> Panels::docks() const {
  std::vector<QDockWidget*> docks;
  for (const Panel& panel : panels_) docks.push_back(panel.dock);
  return docks;
}

std::vector<std::vector<Panels::Panel>> Panels::stacksOn(Side side) const {
  std::vector<std::vector<Panel>> stacks;
  QStringList named;
  std::size_t largest = 0;
  int most = 0;
  for (const Layout::Stack& stack : layout_.stacks) {
    named += stack.docks;
    if (stack.side != side) continue;
    std::vector<Panel> found;
    for (const QString& name : stack.docks) {
      std::copy_if(panels_.begin(), panels_.end(), std::back_inserter(found),
                   [&](const Panel& panel) { return panel.dock->objectName() == name; });
    }
    if (found.empty()) continue;
    if (stack.share >= most) {
      largest = stacks.size();
      most = stack.share;
    }
    stacks.push_back(std::move(found));
  }
  std::vector<Panel> others;
  std::copy_if(panels_.begin(), panels_.end(), std::back_inserter(others), [&](const Panel& panel) {
    return panel.position.side == side && !named.contains(panel.dock->objectName());
  });
  std::stable_sort(others.begin(), others.end(),
                   [](const Panel& a, const Panel& b) { return a.position.tab < b.position.tab; });
  if (stacks.empty() && !others.empty()) stacks.emplace_back();
  // Where there is the most room.
  if (!others.empty()) stacks[largest].insert(stacks[largest].end(), others.begin(), others.end());
  return stacks;
}

const Layout::Stack* Panels::stackOf(const QDockWidget* dock) const {
  const auto stack = std::find_if(
      layout_.stacks.begin(), layout_.stacks.end(),
      [&](const Layout::Stack& candidate) { return candidate.docks.contains(dock->objectName()); });
  return stack == layout_.stacks.end() ? nullptr : &*stack;
}

bool Panels::opensAtFirst(const Panel& panel) const { return panel.position.open || stackOf(panel.dock); }

void Panels::arrange(const Layout& layout) {
  layout_ = layout;
  window_.setUpdatesEnabled(false);
  layOut();
  window_.setUpdatesEnabled(true);
  restored_ = false;
  // Which tab is in front is only known after layout.
  QTimer::singleShot(0, this, [this] {
    if (restored_) return;
    raiseFirst();
    Q_EMIT arranged();
  });
}

void Panels::raiseFirst() {
  for (const Edge& edge : kEdges) {
    for (const std::vector<Panel>& stack : stacksOn(edge.side)) {
      const auto last = std::find_if(stack.rbegin(), stack.rend(),
                                     [this](const Panel& panel) { return opensAtFirst(panel); });
      if (last != stack.rend()) (stackOf(stack.front().dock) ? stack.front() : *last).dock->raise();
    }
  }
}

void Panels::layOut() {
  window_.setCorner(Qt::BottomRightCorner,
                    layout_.wide_bottom ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea);
  for (const Panel& panel : panels_) {
    panel.dock->setFloating(false);
    window_.removeDockWidget(panel.dock);
  }
  for (const Edge& edge : kEdges) {
    const auto stacks = stacksOn(edge.side);
    // Before there are tabs: what is split from a tab becomes a tab, too.
    for (std::size_t i = 0; i < stacks.size(); ++i) {
      QDockWidget* const first = stacks[i].front().dock;
      window_.addDockWidget(edge.area, first);
      if (i > 0) window_.splitDockWidget(stacks[i - 1].front().dock, first, edge.along);
    }
    for (const std::vector<Panel>& stack : stacks) {
      for (std::size_t i = 1; i < stack.size(); ++i) {
        window_.addDockWidget(edge.area, stack[i].dock);
        window_.tabifyDockWidget(stack[i - 1].dock, stack[i].dock);
      }
    }
  }
  for (const Panel& panel : panels_) panel.dock->setVisible(opensAtFirst(panel));
  share();
}

void Panels::share() {
  for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
    QList<QDockWidget*> docks;
    QList<int> sizes;
    for (const Edge& edge : kEdges) {
      const auto stacks = stacksOn(edge.side);
      if (edge.across != orientation || stacks.empty()) continue;
      docks << stacks.back().back().dock;
      sizes << layout_.*edge.px;
    }
    window_.resizeDocks(docks, sizes, orientation);
  }
  for (const Edge& edge : kEdges) {
    QList<QDockWidget*> docks;
    QList<int> sizes;
    for (const Layout::Stack& stack : layout_.stacks) {
      if (stack.side != edge.side) continue;
      const auto panel = std::find_if(panels_.begin(), panels_.end(), [&](const Panel& candidate) {
        return stack.docks.contains(candidate.dock->objectName());
      });
      if (panel == panels_.end()) continue;
      docks << panel->dock;
      sizes << stack.share * kSharePx;
    }
    if (docks.size() > 1) window_.resizeDocks(docks, sizes, edge.along);
  }
}

int Panels::version() const {
  QByteArray names;
  for (const Panel& panel : panels_) names += panel.dock->objectName().toUtf8() + '\n';
  return qChecksum(names);
}

QByteArray Panels::state() const { return window_.saveState(version()); }

bool Panels::restore(const QByteArray& state, const Layout& layout) {
  if (!window_.restoreState(state, version())) return false;
  layout_ = layout;
  restored_ = true;
  return true;
}

void Panels::open(QDockWidget* dock) {
  dock->show();
  dock->raise();
}

void Panels::suggest(QDockWidget* dock) {
  const Layout::Stack* const stack = stackOf(dock);
  if (!restored_ && !(stack && stack->keeps_front)) dock->raise();
}

void Panels::standBack() {
  const auto idle = [](const Panel& panel) { return panel.position.idle && panel.position.idle(); };
  for (const Panel& panel : panels_) {
    const bool in_front = panel.dock->isVisible() && !panel.dock->visibleRegion().isEmpty();
    if (!in_front || !idle(panel)) continue;
    const QList<QDockWidget*> tabs = window_.tabifiedDockWidgets(panel.dock);
    std::vector<Panel> others;
    for (const auto& stack : stacksOn(panel.position.side))
      others.insert(others.end(), stack.begin(), stack.end());
    const auto next = std::find_if(others.begin(), others.end(), [&](const Panel& other) {
      return tabs.contains(other.dock) && !other.dock->isHidden() && !idle(other);
    });
    if (next != others.end()) next->dock->raise();
  }
}

namespace {

class DockTitle : public QWidget {
 public:
  explicit DockTitle(QDockWidget* dock) : QWidget(dock) {
    auto* name = new QLabel(dock->windowTitle(), this);
    makeHeading(*name);
    QToolButton* close =
        iconButton(QStringLiteral("close"), 14,
                   QCoreApplication::translate("window", "Close. To open it again, use the View menu"), this,
                   QCoreApplication::translate("window", "Close %1").arg(dock->windowTitle()));
    close->setFixedSize(22, 22);
    close->setFocusPolicy(Qt::NoFocus);
    QObject::connect(close, &QToolButton::clicked, dock, &QDockWidget::close);
    setLayout(rowOf({{name, 1}, close}, -1, QMargins(8, 3, 4, 3)));
    setFixedHeight(28);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const UiColors colors = appColors();
    QPainter painter(this);
    painter.fillRect(rect(), colors.window);
    painter.setPen(colors.border);
    painter.drawLine(0, height() - 1, width(), height() - 1);
  }
};

}  // namespace

void giveTitle(QDockWidget* dock) { dock->setTitleBarWidget(new DockTitle(dock)); }

}  // namespace mapwright::ui

#include "moc_panels.cpp"
