// A strip above the map for lasting conditions: a lost connection, a map that failed.
#pragma once

#include <QFrame>
#include <QString>

#include "ui/kit/status_text.h"

class QToolButton;
class QPushButton;

namespace mapwright::ui {

class PlainLabel;

class NoticeBar : public QFrame {
  Q_OBJECT
 public:
  explicit NoticeBar(QWidget* parent = nullptr);
  /// Shows the sentence (plain text) with a button; an empty sentence hides the bar. If closable, the user
  /// can dismiss it: closed(). `greyed`: it is about data that is no longer live.
  void setNotice(Mark mark, const QString& sentence, const QString& offer, bool closable = false,
                 bool greyed = false);
  /// A second button, until the next setNotice(); empty = none.
  void setSecondOffer(const QString& offer);
  QString sentence() const;
  Mark mark() const { return mark_; }
  bool greyed() const { return greyed_; }
  QPushButton* offerButton() const { return button_; }
  QPushButton* secondButton() const { return second_; }
  QToolButton* closeButton() const { return close_; }

 Q_SIGNALS:
  void offerTaken();
  void secondTaken();
  void closed();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Mark mark_ = Mark::None;
  bool greyed_ = false;
  PlainLabel* label_;
  QPushButton *button_, *second_;
  QToolButton* close_;
};

/// "12 s", "1 min 48 s", "26 h 3 min".
QString lengthText(qint64 seconds);
/// "No connection since 14:03:12, 1 min 48 s. Showing the last data received." `file`: what a local one is
/// called; empty: it is a robot.
QString lostConnectionSentence(const QDateTime& since, const QDateTime& now, const QString& file = {});

}  // namespace mapwright::ui
