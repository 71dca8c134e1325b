// Asks for coordinates to go to.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::ui {

/// Parses "12.3, -4.5", "12.3 -4.5", "x 12.3 y -4.5 m", "12,3; -4,5". Metres; nullopt if it is not a point
/// within a million metres.
std::optional<Eigen::Vector2d> parsePoint(const QString& text);

class GoToDialog : public QDialog {
  Q_OBJECT
 public:
  explicit GoToDialog(const Eigen::Vector2d& present, QWidget* parent = nullptr);
  std::optional<Eigen::Vector2d> point() const;
  QLineEdit* field() const { return field_; }
  QLabel* errorLabel() const { return error_; }

 private:
  void check();
  QLineEdit* field_;
  QLabel* error_;
  QPushButton* go_;
};

}  // namespace mapwright::ui
