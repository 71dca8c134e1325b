#include "ui/regions/region_tip.h"

#include <utility>

#include <QHelpEvent>
#include <QToolTip>

#include "ui/kit/plain_label.h"

namespace mapwright::window {

RegionTip::RegionTip(MapView& view, std::function<QString(const Eigen::Vector2d&)> words, QObject* parent)
    : QObject(parent), view_(view), words_(std::move(words)) {
  view_.viewport()->installEventFilter(this);
}

bool RegionTip::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QObject::eventFilter(watched, event);
  const auto* const help = static_cast<QHelpEvent*>(event);
  const QString words = words_(view_.worldAt(help->pos()));
  if (words.isEmpty()) {
    QToolTip::hideText();
    return QObject::eventFilter(watched, event);
  }
  // It depends on the position: nearby the reason may differ.
  constexpr int kAroundPx = 24;
  const QRect around(help->pos() - QPoint(kAroundPx, kAroundPx), QSize(2 * kAroundPx, 2 * kAroundPx));
  QToolTip::showText(help->globalPos(), plainToolTip(words), view_.viewport(), around);
  return true;
}

}  // namespace mapwright::window

#include "moc_region_tip.cpp"
