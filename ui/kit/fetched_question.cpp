#include "ui/kit/fetched_question.h"

#include <utility>

#include <QPushButton>
#include <QStringList>

namespace mapwright::window {

FetchedQuestion::FetchedQuestion(QWidget* window, QObject* parent) : QObject(parent), window_(window) {}

void FetchedQuestion::ask(std::vector<Fetched> what, std::function<void()> then) {
  if (what.empty()) return then();
  what_ = std::move(what);
  then_ = std::move(then);
  ++asked_;
  if (question_) return question_->raise();
  QStringList names;
  for (const Fetched& one : what_) names << one.name;
  question_ =
      new QMessageBox(QMessageBox::Question, tr("Fetched and not saved"),
                      tr("The following was fetched from this robot and is not saved. It will be lost: %1.")
                          .arg(names.join(QStringLiteral("; "))),
                      QMessageBox::Discard | QMessageBox::Cancel, window_);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const save = question_->addButton(tr("Save…"), QMessageBox::AcceptRole);
  save->setObjectName(QStringLiteral("saveFetched"));
  question_->setDefaultButton(save);
  connect(question_, &QMessageBox::finished, this, [this, save] {
    QMessageBox* const asked = std::exchange(question_, nullptr);
    QAbstractButton* const clicked = asked->clickedButton();
    if (clicked == save) return saveFrom(0);
    const auto next = std::exchange(then_, nullptr);
    what_.clear();
    if (clicked && asked->standardButton(clicked) == QMessageBox::Discard && next) next();
  });
  question_->open();
}

void FetchedQuestion::saveFrom(std::size_t at) {
  if (at < what_.size()) {
    const auto save = what_[at].save;
    return save([self = QPointer(this), at, asked = asked_] {
      if (self && asked == self->asked_) self->saveFrom(at + 1);
    });
  }
  what_.clear();
  if (const auto next = std::exchange(then_, nullptr)) next();
}

}  // namespace mapwright::window

#include "moc_fetched_question.cpp"
