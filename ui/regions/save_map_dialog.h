// Asks for the name of the file to which the robot saves its map.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

/// Stays open until the robot has answered, and shows the answer next to the input.
class SaveMapDialog : public QDialog {
  Q_OBJECT
 public:
  explicit SaveMapDialog(QWidget* parent = nullptr);

  QString filename() const;
  /// The robot has been asked.
  void wait();
  /// It was not saved.
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
