#include "ui/waypoints/waypoint_questions.h"

#include <utility>

#include <QPushButton>

namespace mapwright::window {

void WaypointQuestions::askToDiscard(const QString& sentence, std::function<void()> then) {
  if (question_) return question_->raise();
  question_ = new QMessageBox(QMessageBox::Warning, tr("Discard changes"), sentence,
                              QMessageBox::Discard | QMessageBox::Cancel, window_);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Cancel);
  connect(question_, &QMessageBox::finished, this, [this, then = std::move(then)](int button) {
    question_ = nullptr;
    if (button == QMessageBox::Discard) then();
  });
  question_->open();
}

void WaypointQuestions::askToLeave(const QString& sentence, bool may_keep,
                                   std::function<void(Leaving)> then) {
  if (question_) {
    // Only the newest question matters.
    question_->disconnect(this);
    question_->close();
  }
  question_ = new QMessageBox(QMessageBox::Question, tr("Waypoints are not saved"), sentence,
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Save);
  QPushButton* keep = nullptr;
  if (may_keep) {
    keep = question_->addButton(tr("Keep as draft"), QMessageBox::ActionRole);
    keep->setObjectName(QStringLiteral("keepDraft"));
    keep->setToolTip(tr("They will be offered when you open this map again"));
  }
  connect(question_, &QMessageBox::finished, this, [this, keep, then = std::move(then)] {
    QMessageBox* const asked = std::exchange(question_, nullptr);
    QAbstractButton* const clicked = asked->clickedButton();
    if (clicked && clicked == keep) return then(Leaving::Keep);
    const auto standard = clicked ? asked->standardButton(clicked) : QMessageBox::Cancel;
    then(standard == QMessageBox::Save      ? Leaving::Save
         : standard == QMessageBox::Discard ? Leaving::Discard
                                            : Leaving::Stay);
  });
  question_->open();
}

}  // namespace mapwright::window

#include "moc_waypoint_questions.cpp"
