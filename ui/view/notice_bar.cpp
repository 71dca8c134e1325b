#include "ui/view/notice_bar.h"

#include <algorithm>

#include <QApplication>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent),
      label_(new PlainLabel(this)),
      button_(new QPushButton(this)),
      second_(new QPushButton(this)),
      close_(iconButton(QStringLiteral("close"), 16, tr("Dismiss"), this, tr("Dismiss this notice"))) {
  setObjectName(QStringLiteral("notice"));
  for (QPushButton* button : {button_, second_}) button->setObjectName(QStringLiteral("secondary"));
  second_->hide();
  setLayout(rowOf({{label_, 1}, button_, second_, close_}, 12, QMargins(36, 6, 8, 6)));
  label_->setSample(QStringLiteral("x"));
  label_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  label_->setMostLines(2);
  connect(close_, &QToolButton::clicked, this, &NoticeBar::closed);
  connect(button_, &QPushButton::clicked, this, &NoticeBar::offerTaken);
  connect(second_, &QPushButton::clicked, this, &NoticeBar::secondTaken);
  hide();
}

void NoticeBar::setSecondOffer(const QString& offer) {
  second_->setText(offer);
  second_->setVisible(!offer.isEmpty());
}

void NoticeBar::setNotice(Mark mark, const QString& sentence, const QString& offer, bool closable,
                          bool greyed) {
  const QWidget* const focused = QApplication::focusWidget();
  const bool here = focused && isAncestorOf(focused);
  mark_ = mark;
  greyed_ = greyed;
  label_->setSecondary(greyed);
  label_->setText(words::plainText(sentence));
  button_->setText(offer);
  button_->setVisible(!offer.isEmpty());
  second_->hide();
  close_->setVisible(closable);
  setVisible(!sentence.isEmpty());
  // Otherwise the focus would hop to the next field, and keys that are meant for the map would be typed
  // there.
  if (here && !focused->isVisible()) parentWidget()->setFocus();
  update();
}

QString NoticeBar::sentence() const { return label_->text(); }

void NoticeBar::paintEvent(QPaintEvent*) {
  const UiColors colors = greyed_ ? ui::greyed(appColors()) : appColors();
  QPainter painter(this);
  painter.fillRect(rect(), colors.window);
  QColor tint = markColor(mark_, colors);
  painter.fillRect(QRect(0, 0, 4, height()), tint);
  tint.setAlpha(28);
  painter.fillRect(rect(), tint);
  painter.setPen(colors.border);
  painter.drawLine(0, height() - 1, width(), height() - 1);
  paintMark(&painter, QRectF(14, height() / 2.0 - 7, 14, 14), mark_, colors);
}

QString lengthText(qint64 seconds) {
  const qint64 s = std::max<qint64>(seconds, 0);
  if (s < 60) return QCoreApplication::translate("window", "%1 s").arg(s);
  if (s < 3600)
    return QCoreApplication::translate("window", "%1 min %2 s")
        .arg(QString::number(s / 60), QString::number(s % 60));
  return QCoreApplication::translate("window", "%1 h %2 min")
      .arg(QString::number(s / 3600), QString::number(s % 3600 / 60));
}

QString lostConnectionSentence(const QDateTime& since, const QDateTime& now, const QString& file) {
  const QString format =
      since.date() == now.date() ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm:ss");
  const QString at = QLocale::c().toString(since, format), ago = lengthText(since.secsTo(now));
  if (!file.isEmpty())
    return QCoreApplication::translate("window",
                                       "%1 has not been readable since %2, %3. Showing what was read last.")
        .arg(file, at, ago);
  return QCoreApplication::translate("window", "No connection since %1, %2. Showing the last data received.")
      .arg(at, ago);
}

}  // namespace mapwright::ui

#include "moc_notice_bar.cpp"
