// Asks before a map of the robot is changed, and stays open until the robot has answered, so that typed text
// is not lost.
#pragma once

#include <functional>

#include <QDialog>

#include "robot/call.h"
#include "ui/maps/change_question.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

class ChangeDialog : public QDialog {
  Q_OBJECT
 public:
  using Outcome = robot::Outcome<map::CatalogueEntry>;
  using Ask = std::function<robot::Call(const robot::MapOrder&, robot::OutcomeTo<map::CatalogueEntry>)>;

  /// `ask` is called once for every press of the button, never while an answer is pending.
  ChangeDialog(ChangeQuestion question, Ask ask, QWidget* parent = nullptr);

  /// Where the robot may be, most likely first. None is preselected.
  void setPlaces(const std::vector<std::string>& names);

  QLineEdit* nameEdit() const { return name_; }    // null: not asked for
  QLineEdit* typedEdit() const { return typed_; }  // likewise
  QComboBox* places() const { return places_; }    // likewise
  QPushButton* acceptButton() const { return accept_; }
  QString textShown() const;
  QString errorShown() const;
  bool waiting() const { return call_.has_value(); }

  void reject() override;

 Q_SIGNALS:
  /// `as_asked`: false if the robot accepted it but reports something else.
  void done(const mapwright::map::CatalogueEntry& now, const QString& said, bool as_asked);

 private:
  QString whyNot() const;
  void check();
  std::string place() const;
  void send();
  void take(const Outcome& outcome);

  ChangeQuestion question_;
  Ask ask_;
  std::optional<robot::Call> call_;
  QLabel *text_, *error_;
  QLineEdit *name_ = nullptr, *typed_ = nullptr;
  QComboBox* places_ = nullptr;
  QPushButton *accept_, *cancel_;
};

}  // namespace mapwright::window
