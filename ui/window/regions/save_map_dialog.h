// Asks what the robot is to call the file into which it saves its map.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

/// The question stays open until the robot has answered: what it says is seen beside what was asked.
class SaveMapDialog : public QDialog {
  Q_OBJECT
 public:
  explicit SaveMapDialog(QWidget* parent = nullptr);

  QString filename() const;
  /// The robot has been asked.
  void wait();
  /// It has not saved it.
  void refuse(const QString& why);

 Q_SIGNALS:
  void saveWanted(const QString& filename);

 private:
  void look();

  QLineEdit* name_;
  QLabel* state_;
  QPushButton* save_;
  bool waits_ = false;
};

}  // namespace mapwright::window
