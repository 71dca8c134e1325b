#include "ui/kit/safety_badge.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QStringList>
#include <QTimeZone>

#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

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

namespace {

struct SafetyBadgeText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::ui::Safety)
};

constexpr int kLongestText = 200;
constexpr std::size_t kMostLines = 12;  // of a tooltip
constexpr std::size_t kMostOthers = 5;

QString clock(const QDateTime& time, const QDateTime& now) {
  const bool today = time.date() == now.date();
  return QLocale::c().toString(time,
                               today ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

QString state(const map::SafetyCondition& condition) {
  using map::SafetyKind;
  switch (condition.kind) {
    case SafetyKind::EmergencyStop:
      return SafetyBadgeText::tr("Emergency stop pressed");
    case SafetyKind::PositionLost:
      return SafetyBadgeText::tr("Position lost");
    case SafetyKind::WheelsReleased:
      return SafetyBadgeText::tr("Wheels released");
    case SafetyKind::ManualControl:
      return SafetyBadgeText::tr("Under manual control");
    case SafetyKind::PositionUncertain:
      return SafetyBadgeText::tr("Position uncertain");
    case SafetyKind::WheelsSlipping:
      return SafetyBadgeText::tr("Wheels slipping");
    case SafetyKind::Alert:
      break;
  }
  return safetyWord(condition);
}

}  // namespace

QString safetyWord(const map::SafetyCondition& condition) {
  using map::SafetyKind;
  switch (condition.kind) {
    case SafetyKind::EmergencyStop:
      return SafetyBadgeText::tr("Emergency stop");
    case SafetyKind::ManualControl:
      return SafetyBadgeText::tr("Manual control");
    case SafetyKind::Alert: {
      const QString level = condition.severity == map::Severity::Error ? SafetyBadgeText::tr("Error")
                                                                       : SafetyBadgeText::tr("Warning");
      return condition.code == 0 ? level : QStringLiteral("%1 %2").arg(level).arg(condition.code);
    }
    default:
      return state(condition);
  }
}

QString safetySentence(const map::SafetyCondition& condition, const QDateTime& now) {
  QString sentence = state(condition);
  // Without a time, or with a wrong clock, "since" is omitted.
  if (condition.since_s > 0 && condition.since_s < 4e9) {
    const QDateTime since = QDateTime::fromMSecsSinceEpoch(qint64(condition.since_s * 1000), now.timeZone());
    sentence = SafetyBadgeText::tr("%1 since %2").arg(sentence, clock(since, now));
  }
  if (condition.times >= map::kSafetyFlaps)
    sentence = SafetyBadgeText::tr("%1, on and off, %2 times").arg(sentence, countText(condition.times));
  const QString text = plainWords(condition.text, kLongestText);
  return text.isEmpty() ? sentence : SafetyBadgeText::tr("%1: %2").arg(sentence, text);
}

SafetyText safetyText(const SafetyState& known, const QDateTime& now) {
  SafetyText text;
  if (known.conditions.empty()) return text;
  const auto more = [](std::size_t count) {
    return count > 1 ? QStringLiteral(" +%1").arg(countText(qint64(count - 1))) : QString();
  };
  const map::SafetyCondition& gravest = known.conditions.front();
  const bool error = gravest.severity == map::Severity::Error;
  text.mark = error ? Mark::Bad : Mark::Warning;
  text.greyed = known.as_of.has_value();
  text.badge = safetyWord(gravest) + more(known.conditions.size());
  QStringList lines;
  if (known.as_of) lines << SafetyBadgeText::tr("As of %1, no longer live:").arg(clock(*known.as_of, now));
  for (std::size_t i = 0; i < std::min(kMostLines, known.conditions.size()); ++i)
    lines << safetySentence(known.conditions[i], now);
  if (known.conditions.size() > kMostLines)
    lines << SafetyBadgeText::tr("and %1 more").arg(countText(qint64(known.conditions.size() - kMostLines)));
  text.detail = lines.join(QLatin1Char('\n'));
  if (!error) return text;
  text.sentence = safetySentence(gravest, now);
  QStringList others;
  for (std::size_t i = 1; i < std::min(kMostOthers, known.conditions.size()); ++i)
    others << safetyWord(known.conditions[i]);
  if (!others.isEmpty())
    text.sentence = words::paragraph(
        {words::asSentence(text.sentence), SafetyBadgeText::tr("Also: %1").arg(words::listed(others))});
  if (known.as_of)
    text.sentence = SafetyBadgeText::tr("As of %1: %2").arg(clock(*known.as_of, now), text.sentence);
  return text;
}

}  // namespace mapwright::ui
