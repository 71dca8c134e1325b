#include "ui/kit/dock_title.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {

namespace {

class DockTitle : public QWidget {
 public:
  explicit DockTitle(QDockWidget* dock) : QWidget(dock) {
    auto* name = new QLabel(dock->windowTitle(), this);
    QFont bold = name->font();
    bold.setWeight(QFont::DemiBold);
    name->setFont(bold);
    auto* close = new QToolButton(this);
    close->setIcon(themedIcon(QStringLiteral("close")));
    close->setIconSize({14, 14});
    close->setFixedSize(22, 22);
    close->setToolTip(QCoreApplication::translate("window", "Close. To open it again, use the View menu"));
    close->setAccessibleName(QCoreApplication::translate("window", "Close %1").arg(dock->windowTitle()));
    close->setFocusPolicy(Qt::NoFocus);
    QObject::connect(close, &QToolButton::clicked, dock, &QDockWidget::close);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 3, 4, 3);
    row->addWidget(name, 1);
    row->addWidget(close);
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
