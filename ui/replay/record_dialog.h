// What the robot should record: a suffix for the name, and the length. Stays open until the robot has
// accepted.
#pragma once

#include <functional>

#include <QDialog>

#include "robot/bag_library.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace mapwright::ui {

class RecordDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RecordDialog(QWidget* parent = nullptr);
  robot::BagOrder order() const;
  QLineEdit* suffix() const { return suffix_; }
  QSpinBox* duration() const { return duration_; }
  QPushButton* recordButton() const { return record_; }
  /// The error; empty = none.
  QString errorShown() const;
  /// The request is in progress.
  void setAsking(bool asking);
  void fail(const QString& sentence);

 Q_SIGNALS:
  void recordWanted();

 private:
  void check();
  void say(const QString& sentence, bool bad);
  QLineEdit* suffix_;
  QSpinBox* duration_;
  QPushButton* record_;
  QLabel* said_;
  bool asking_ = false, bad_ = false;
};

}  // namespace mapwright::ui
