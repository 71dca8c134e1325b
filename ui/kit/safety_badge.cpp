#include "ui/kit/safety_badge.h"

#include <QEvent>
#include <QPainter>

#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"

namespace mapwright::window {

namespace {

constexpr int kBadgeWidestPx = 190, kBadgeMarkPx = 12, kBadgeEdgePx = 6, kBadgeGapPx = 5;

QFont heavy(QFont font) {
  font.setWeight(QFont::DemiBold);
  return font;
}

}  // namespace

int safetyWidth(const SafetyText& text, const QFont& font) {
  if (text.mark == Mark::None) return 0;
  const int words = QFontMetrics(heavy(font)).horizontalAdvance(text.badge) + 2;
  return qMin(kBadgeWidestPx, kBadgeEdgePx + kBadgeMarkPx + kBadgeGapPx + words + kBadgeEdgePx);
}

void paintSafety(QPainter* painter, const QRect& rect, const SafetyText& text, const UiColors& live) {
  if (text.mark == Mark::None) return;
  const UiColors colors = text.greyed ? greyed(live) : live;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor edge = markColor(text.mark, colors);
  QColor ground = edge;
  ground.setAlpha(colors.dark ? 60 : 36);
  painter->setPen(QPen(edge, 1, text.greyed ? Qt::DashLine : Qt::SolidLine));
  painter->setBrush(ground);
  painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  const QRectF mark(rect.left() + kBadgeEdgePx, rect.center().y() + 0.5 - kBadgeMarkPx / 2.0, kBadgeMarkPx,
                    kBadgeMarkPx);
  paintMark(painter, mark, text.mark, colors);
  painter->setFont(heavy(painter->font()));
  painter->setPen(markTextColor(text.mark, colors));
  const QRect words = rect.adjusted(kBadgeEdgePx + kBadgeMarkPx + kBadgeGapPx, 0, -kBadgeEdgePx, 0);
  painter->drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                    painter->fontMetrics().elidedText(text.badge, Qt::ElideMiddle, words.width()));
  painter->restore();
}

SafetyBadge::SafetyBadge(QWidget* parent) : QAbstractButton(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  hide();
}

void SafetyBadge::setSafety(const SafetyText& text) {
  if (text == text_) return;
  const bool resized = safetyWidth(text, font()) != safetyWidth(text_, font());
  text_ = text;
  setToolTip(plainToolTip(text.detail));
  setAccessibleName(text.badge);
  setAccessibleDescription(text.detail);
  if (resized) updateGeometry();
  setVisible(text.mark != Mark::None);
  update();
}

QSize SafetyBadge::sizeHint() const { return {safetyWidth(text_, font()), 22}; }

void SafetyBadge::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  paintSafety(&painter, rect(), text_, colors);
  if (!hasFocus()) return;
  painter.setPen(QPen(colors.accent, 2));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SafetyBadge::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
  QAbstractButton::changeEvent(event);
}

}  // namespace mapwright::window

#include "moc_safety_badge.cpp"
