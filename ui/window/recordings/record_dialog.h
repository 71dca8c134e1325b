// What the robot is to record: a suffix of the name, and how long.
#pragma once

#include <functional>

#include <QDialog>

#include "robot/bag_library.h"

class QLineEdit;
class QSpinBox;

namespace mapwright::window {

class RecordDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RecordDialog(QWidget* parent = nullptr);
  robot::BagOrder order() const;
  QLineEdit* suffix() const { return suffix_; }
  QSpinBox* duration() const { return duration_; }

 private:
  QLineEdit* suffix_;
  QSpinBox* duration_;
};

}  // namespace mapwright::window
