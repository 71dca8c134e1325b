#include "ui/waypoints/line_bar.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/kit/plain_label.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {
namespace {
constexpr int kLineBarMarginPx = 16;
}

LineBar::LineBar(LineTool* tool, QWidget* map)
    : QFrame(map),
      tool_(tool),
      spacing_(new QDoubleSpinBox(this)),
      count_(new PlainLabel(this)),
      create_(new QPushButton(tr("Create"), this)),
      close_(new QPushButton(tr("Cancel"), this)) {
  setObjectName(QStringLiteral("card"));
  setCursor(Qt::ArrowCursor);
  spacing_->setLocale(QLocale::c());
  spacing_->setRange(LineTool::kLeastSpacingM, LineTool::kMostSpacingM);
  spacing_->setDecimals(2);
  spacing_->setSingleStep(0.25);
  spacing_->setSuffix(QStringLiteral(" m"));
  spacing_->setAccessibleName(tr("Distance between two waypoints"));
  auto* label = new QLabel(tr("&Spacing"), this);
  label->setBuddy(spacing_);
  count_->setSample(tr("%1 on 123.45 m").arg(waypointsText(1888)));
  create_->setObjectName(QStringLiteral("primary"));
  close_->setObjectName(QStringLiteral("secondary"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(8);
  row->addWidget(label);
  row->addWidget(spacing_);
  row->addSpacing(8);
  row->addWidget(count_);
  row->addWidget(close_);
  row->addWidget(create_);
  hide();
  connect(spacing_, &QDoubleSpinBox::valueChanged, tool_, &LineTool::setSpacing);
  connect(create_, &QPushButton::clicked, this, &LineBar::createWanted);
  connect(close_, &QPushButton::clicked, this, &LineBar::closed);
  connect(tool_, &LineTool::lineChanged, this, &LineBar::refresh);
  connect(tool_, &LineTool::activated, this, [this](bool active) {
    setVisible(active);
    place();
    if (active) raise();
  });
  map->installEventFilter(this);
  refresh();
}

QString LineBar::countShown() const { return count_->text(); }

void LineBar::refresh() {
  const QSignalBlocker quiet(spacing_);
  if (!spacing_->hasFocus()) spacing_->setValue(tool_->spacing());
  const auto count = qsizetype(tool_->spots().size());
  const QString length = QLocale::c().toString(tool_->length(), 'f', 2);
  count_->setText(tool_->length() <= 0 ? tr("No line yet")
                  : count == 0 ? tr("More than %1").arg(waypointsText(qsizetype(placing::kMostAlongLine)))
                               : tr("%1 on %2 m").arg(waypointsText(count), length));
  create_->setEnabled(tool_->ready() && count > 0);
}

void LineBar::place() {
  const QWidget* const map = parentWidget();
  const QSize size = sizeHint();
  setGeometry((map->width() - size.width()) / 2, map->height() - size.height() - kLineBarMarginPx,
              size.width(), size.height());
}

bool LineBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(watched, event);
}

void LineBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (create_->isEnabled()) Q_EMIT createWanted();
    return;
  }
  if (event->key() == Qt::Key_Escape) return Q_EMIT closed();
  QFrame::keyPressEvent(event);
}

}  // namespace mapwright::window

#include "moc_line_bar.cpp"
