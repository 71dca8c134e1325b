#include "ui/kit/plain_label.h"

#include <algorithm>

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

PlainLabel::PlainLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

PlainLabel::PlainLabel(const QString& text, QWidget* parent) : PlainLabel(parent) { setText(text); }

void PlainLabel::setText(const QString& given) {
  const QString text = words::plainLine(given);
  if (text == text_) return;
  text_ = text;
  setAccessibleName(text);
  if (sample_.isEmpty() || most_lines_ > 1) updateGeometry();
  update();
}

void PlainLabel::setAlignment(Qt::Alignment alignment) {
  alignment_ = alignment | Qt::AlignVCenter;
  update();
}

void PlainLabel::setElideMode(Qt::TextElideMode mode) {
  elide_ = mode;
  update();
}

void PlainLabel::setSample(const QString& sample) {
  sample_ = sample;
  updateGeometry();
}

void PlainLabel::setMostLines(int lines) {
  most_lines_ = std::max(lines, 1);
  QSizePolicy policy = sizePolicy();
  policy.setHeightForWidth(most_lines_ > 1);
  // Layouts give a fixed one the height of one line, whatever the height for its width is.
  policy.setVerticalPolicy(most_lines_ > 1 ? QSizePolicy::Minimum : QSizePolicy::Fixed);
  setSizePolicy(policy);
}

QStringList PlainLabel::linesIn(int width) const {
  const QFontMetrics metrics = fontMetrics();
  const auto fits = [&](const QString& text) { return metrics.horizontalAdvance(text) <= width; };
  QString rest = text_;
  QStringList lines;
  while (lines.size() + 1 < most_lines_ && !fits(rest)) {
    qsizetype end = -1;
    for (qsizetype blank = rest.indexOf(QLatin1Char(' ')); blank >= 0 && fits(rest.left(blank));
         blank = rest.indexOf(QLatin1Char(' '), blank + 1)) {
      end = blank;
    }
    if (end <= 0) break;  // there is no room for even a word
    lines << rest.left(end);
    rest = rest.mid(end + 1);
  }
  return lines << metrics.elidedText(rest, elide_, width);
}

int PlainLabel::heightForWidth(int width) const {
  if (most_lines_ == 1) return -1;
  const int more = int(linesIn(width - iconWidth()).size()) - 1;
  return sizeHint().height() + more * fontMetrics().lineSpacing();
}

void PlainLabel::setSecondary(bool secondary) {
  secondary_ = secondary;
  update();
}

void PlainLabel::setIcon(const QString& icon_name, const QColor& color) {
  if (icon_ == icon_name && icon_color_ == color) return;
  const bool same_width = icon_.isEmpty() == icon_name.isEmpty();
  icon_ = icon_name;
  icon_color_ = color;
  if (!same_width) updateGeometry();
  update();
}

void PlainLabel::setHint(const QString& hint) { hint_ = hint; }

QSize PlainLabel::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  const int width = metrics.horizontalAdvance(sample_.isEmpty() ? text_ : sample_) + iconWidth() + 2;
  return {width, qMax(20, metrics.height() + 2)};
}

QSize PlainLabel::minimumSizeHint() const {
  return {qMin(sizeHint().width(), fontMetrics().averageCharWidth() * 4 + iconWidth()), sizeHint().height()};
}

void PlainLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QRect area = rect();
  if (!icon_.isEmpty()) {
    paintIcon(&painter, QRectF(area.left(), area.center().y() - 7.5, 16, 16), icon_, icon_color_);
    area.setLeft(area.left() + iconWidth());
  }
  const UiColors colors = appColors();
  painter.setPen(!isEnabled() ? palette().color(QPalette::Disabled, QPalette::WindowText)
                 : secondary_ ? colors.secondary_text
                              : colors.text);
  const QStringList lines = linesIn(area.width());
  painter.drawText(area, int(alignment_) | (lines.size() == 1 ? int(Qt::TextSingleLine) : 0),
                   lines.join(QLatin1Char('\n')));
}

bool PlainLabel::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    QString tip = hint_;
    if (linesIn(width() - iconWidth()).join(QLatin1Char(' ')) != text_) {
      tip = tip.isEmpty() ? text_ : tip + QLatin1Char('\n') + text_;
    }
    auto* help = static_cast<QHelpEvent*>(event);
    if (tip.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(help->globalPos(), plainToolTip(tip), this);
    }
    return true;
  }
  return QWidget::event(event);
}

void PlainLabel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) updateGeometry();
  QWidget::changeEvent(event);
}

QString plainToolTip(const QString& text) {
  if (text.isEmpty()) return {};
  QString escaped = words::plainText(text).toHtmlEscaped();
  escaped.replace(QLatin1Char('\n'), QLatin1String("<br>"));
  return QStringLiteral("<qt>%1</qt>").arg(escaped);
}

}  // namespace mapwright::ui

#include "moc_plain_label.cpp"
