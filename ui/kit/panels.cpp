#include "ui/kit/panels.h"

#include <algorithm>

#include <QAction>
#include <QChildEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>

#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {

namespace {

using Side = PanelPlace::Side;

struct Edge {
  Side side;
  Qt::DockWidgetArea area;
  Qt::Orientation orientation;
  int px;
};
constexpr Edge kEdges[] = {{Side::Left, Qt::LeftDockWidgetArea, Qt::Horizontal, 220},
                           {Side::Right, Qt::RightDockWidgetArea, Qt::Horizontal, 322},
                           {Side::Bottom, Qt::BottomDockWidgetArea, Qt::Vertical, 168}};

}  // namespace

Panels::Panels(QMainWindow& window, Actions& actions) : QObject(&window), window_(window), actions_(actions) {
  window_.setDockNestingEnabled(true);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window_.installEventFilter(this);
}

bool Panels::eventFilter(QObject* watched, QEvent* event) {
  // The window creates them on demand. Truncated to a few letters they would be useless.
  if (event->type() == QEvent::ChildPolished) {
    if (auto* const tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) {
      tabs->setElideMode(Qt::ElideNone);
      tabs->setUsesScrollButtons(true);
    }
  }
  return QObject::eventFilter(watched, event);
}

void Panels::add(QDockWidget* dock, const PanelPlace& place) {
  giveTitle(dock);
  QAction* const toggle = dock->toggleViewAction();
  actions_.list({MenuGroup::Panels, place.menu_rank}, toggle);
  // The user wants to see the opened panel, not the tab in front of it; Qt places it only once it is laid
  // out.
  connect(toggle, &QAction::triggered, dock, [dock](bool on) {
    if (on) QMetaObject::invokeMethod(dock, &QDockWidget::raise, Qt::QueuedConnection);
  });
  const auto at = std::upper_bound(panels_.begin(), panels_.end(), place.menu_rank,
                                   [](int rank, const Panel& panel) { return rank < panel.place.menu_rank; });
  panels_.insert(at, {dock, place});
}

std::vector<QDockWidget*> Panels::docks() const {
  std::vector<QDockWidget*> docks;
  for (const Panel& panel : panels_) docks.push_back(panel.dock);
  return docks;
}

std::vector<Panels::Panel> Panels::onSide(Side side) const {
  std::vector<Panel> found;
  std::copy_if(panels_.begin(), panels_.end(), std::back_inserter(found),
               [&](const Panel& panel) { return panel.place.side == side; });
  std::stable_sort(found.begin(), found.end(),
                   [](const Panel& a, const Panel& b) { return a.place.tab < b.place.tab; });
  return found;
}

void Panels::arrange() {
  place();
  restored_ = false;
  // Which tab is in front is only known after layout.
  QTimer::singleShot(0, this, [this] {
    if (restored_) return;
    for (const Edge& edge : kEdges) {
      const auto stack = onSide(edge.side);
      const auto last =
          std::find_if(stack.rbegin(), stack.rend(), [](const Panel& panel) { return panel.place.open; });
      if (last != stack.rend()) last->dock->raise();
    }
    Q_EMIT arranged();
  });
}

void Panels::place() {
  for (const Panel& panel : panels_) {
    panel.dock->setFloating(false);
    window_.removeDockWidget(panel.dock);
  }
  for (const Edge& edge : kEdges) {
    QDockWidget* before = nullptr;
    for (const Panel& panel : onSide(edge.side)) {
      window_.addDockWidget(edge.area, panel.dock);
      if (before) window_.tabifyDockWidget(before, panel.dock);
      before = panel.dock;
    }
  }
  for (const Edge& edge : kEdges) {
    for (const Panel& panel : onSide(edge.side)) panel.dock->setVisible(panel.place.open);
  }
  for (const Qt::Orientation orientation : {Qt::Horizontal, Qt::Vertical}) {
    QList<QDockWidget*> docks;
    QList<int> sizes;
    for (const Edge& edge : kEdges) {
      const auto stack = onSide(edge.side);
      if (edge.orientation != orientation || stack.empty()) continue;
      docks << stack.back().dock;
      sizes << edge.px;
    }
    window_.resizeDocks(docks, sizes, orientation);
  }
}

int Panels::version() const {
  QByteArray names;
  for (const Panel& panel : panels_) names += panel.dock->objectName().toUtf8() + '\n';
  return qChecksum(names);
}

QByteArray Panels::state() const { return window_.saveState(version()); }

bool Panels::restore(const QByteArray& state) {
  if (!window_.restoreState(state, version())) return false;
  restored_ = true;
  return true;
}

void Panels::open(QDockWidget* dock) {
  dock->show();
  dock->raise();
}

void Panels::suggest(QDockWidget* dock) {
  if (!restored_) dock->raise();
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

}  // namespace mapwright::window

#include "moc_panels.cpp"
