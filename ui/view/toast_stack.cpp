#include "ui/view/toast_stack.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTextBoundaryFinder>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/icons.h"
#include "ui/kit/state_mark.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kAtMost = 4;
constexpr int kWidestText = 380, kNarrowestText = 120;
constexpr int kAroundTextPx = 140;  // mark, button to close, margins
constexpr QChar kMayBreak(0x200b);

/// Words wider than a line (paths, names) may be broken anywhere.
QString breakable(const QString& text, const QFontMetrics& metrics, int widest) {
  QStringList words = text.split(QLatin1Char(' '));
  for (QString& word : words) {
    if (metrics.horizontalAdvance(word) <= widest) continue;
    QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, word);
    QString pieces;
    for (qsizetype from = 0, to = finder.toNextBoundary(); to > from;
         from = to, to = finder.toNextBoundary()) {
      pieces += word.mid(from, to - from) + kMayBreak;
    }
    word = pieces;
  }
  return words.join(QLatin1Char(' '));
}

class MarkBox : public QWidget {
 public:
  MarkBox(Mark mark, QWidget* parent) : QWidget(parent), mark_(mark) { setFixedSize(14, 14); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    paintMark(&painter, QRectF(rect()), mark_, appColors());
  }

 private:
  Mark mark_;
};

void remove(QVBoxLayout& column, int at) {
  QLayoutItem* const item = column.takeAt(at);
  item->widget()->hide();
  item->widget()->deleteLater();
  delete item;
}

QString counted(const QString& text, int times) {
  return times > 1 ? ToastStack::tr("%1 (%2 times)").arg(text, QString::number(times)) : text;
}

}  // namespace

ToastStack::ToastStack(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(8);
  hide();
}

void ToastStack::add(Mark mark, const QString& text, ToastOffer offer, const QString& about) {
  // A repeated message is counted and moves to the newest position.
  int times = 1;
  const QString same = QStringLiteral("%1\n%2\n%3").arg(QString::number(int(mark)), offer.words, text);
  for (int i = column_->count() - 1; i >= 0; --i) {
    const QWidget* const old = column_->itemAt(i)->widget();
    const bool repeated = old->property("says").toString() == same;
    if (repeated) times += old->property("times").toInt();
    const bool overcome = !about.isEmpty() && old->property("about").toString() == about;
    if (repeated || overcome) remove(*column_, i);
  }
  while (column_->count() >= kAtMost) remove(*column_, 0);
  auto* toast = new QFrame(this);
  toast->setObjectName(QStringLiteral("toast"));
  toast->setProperty("says", same);
  toast->setProperty("times", times);
  toast->setProperty("about", about);
  QPushButton* const button = offer.words.isEmpty() ? nullptr : new QPushButton(offer.words, toast);
  if (button) {
    button->setObjectName(QStringLiteral("compact"));
    button->setFocusPolicy(Qt::NoFocus);
  }
  const int around = kAroundTextPx + (button ? button->sizeHint().width() : 0);
  const int widest = parentWidget()
                         ? std::clamp(parentWidget()->width() - around, kNarrowestText, kWidestText)
                         : kWidestText;
  auto* label = new QLabel(toast);
  label->setObjectName(QStringLiteral("toastText"));
  label->setTextFormat(Qt::PlainText);
  const QString plain = counted(words::plainText(text), times);
  label->setText(breakable(plain, label->fontMetrics(), widest));
  label->setAccessibleName(plain);
  label->setWordWrap(label->fontMetrics().horizontalAdvance(plain) > widest ||
                     plain.contains(QLatin1Char('\n')));
  label->setMaximumWidth(widest);
  if (label->wordWrap()) label->setFixedSize(widest, label->heightForWidth(widest));
  auto* close = new QToolButton(toast);
  close->setIcon(themedIcon(QStringLiteral("close")));
  close->setIconSize({14, 14});
  close->setToolTip(tr("Dismiss"));
  close->setFocusPolicy(Qt::NoFocus);
  auto* row = new QHBoxLayout(toast);
  row->setContentsMargins(12, 6, 6, 6);
  row->setSpacing(10);
  row->addWidget(new MarkBox(mark, toast), 0, Qt::AlignVCenter);
  row->addWidget(label, 1);
  if (button) row->addWidget(button);
  row->addWidget(close);
  column_->addWidget(toast, 0, Qt::AlignRight);
  const auto dismiss = [this, toast] {
    if (column_->indexOf(toast) < 0) return;
    column_->removeWidget(toast);
    toast->hide();
    toast->deleteLater();
    setVisible(column_->count() > 0);
    adjustSize();
    Q_EMIT changed();
  };
  connect(close, &QToolButton::clicked, toast, dismiss);
  if (button) {
    connect(button, &QPushButton::clicked, toast, [dismiss, wish = std::move(offer.accept)] {
      dismiss();
      if (wish) wish();
    });
  }
  const bool lasting = mark == Mark::Warning || mark == Mark::Bad || button;
  QTimer::singleShot(lasting ? lifetime_ms_ * 3 : lifetime_ms_, toast, dismiss);
  show();
  adjustSize();
  Q_EMIT changed();
}

void ToastStack::withdraw(const QString& text) {
  for (int i = column_->count() - 1; i >= 0; --i) {
    const QString says = column_->itemAt(i)->widget()->property("says").toString();
    if (says.section(QLatin1Char('\n'), 2) == text) remove(*column_, i);
  }
  setVisible(column_->count() > 0);
  adjustSize();
  Q_EMIT changed();
}

QStringList ToastStack::texts() const {
  QStringList texts;
  for (int i = 0; i < column_->count(); ++i) {
    if (const auto* label = column_->itemAt(i)->widget()->findChild<QLabel*>(QStringLiteral("toastText"))) {
      texts << label->accessibleName();
    }
  }
  return texts;
}

}  // namespace mapwright::ui

#include "moc_toast_stack.cpp"
