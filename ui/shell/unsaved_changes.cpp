#include "ui/shell/unsaved_changes.h"

#include <algorithm>
#include <utility>

#include <QPushButton>
#include <QStringList>

namespace mapwright::ui {

namespace {

std::vector<Fetched> fetchedBy(const std::vector<Controller*>& controllers) {
  std::vector<Fetched> all;
  for (Controller* controller : controllers) {
    for (Fetched& one : controller->fetched()) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

UnsavedChanges::UnsavedChanges(QWidget* window) : QObject(window), window_(window) {}

bool UnsavedChanges::losesFetched() const { return !fetchedBy(controllers_).empty(); }

void UnsavedChanges::watch(Controller* controller) {
  controllers_.push_back(controller);
  connect(controller, &Controller::unsavedChanged, this, &UnsavedChanges::changed);
}

void UnsavedChanges::forget(Controller* controller) {
  std::erase(controllers_, controller);
  disconnect(controller, nullptr, this, nullptr);
}

bool UnsavedChanges::any() const {
  return std::any_of(controllers_.begin(), controllers_.end(),
                     [](const Controller* controller) { return controller->unsaved(); });
}

bool UnsavedChanges::maySave() const {
  return std::any_of(controllers_.begin(), controllers_.end(),
                     [](const Controller* controller) { return controller->maySave(); });
}

void UnsavedChanges::save() {
  for (Controller* controller : controllers_) controller->save();
}

void UnsavedChanges::whenMayLeave(std::function<void()> then) {
  // In reverse, so that the first is asked first.
  for (auto it = controllers_.rbegin(); it != controllers_.rend(); ++it)
    then = [controller = *it, then = std::move(then)] { controller->beforeLeaving(then); };
  then();
}

void UnsavedChanges::whenMayLeaveRobot(std::function<void()> then) {
  then = [this, then = std::move(then)] { askAboutFetched(fetchedBy(controllers_), then); };
  for (auto it = controllers_.rbegin(); it != controllers_.rend(); ++it)
    then = [controller = *it, then = std::move(then)] { controller->beforeLeavingRobot(then); };
  then();
}

void UnsavedChanges::askAboutFetched(std::vector<Fetched> what, std::function<void()> then) {
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

void UnsavedChanges::saveFrom(std::size_t at) {
  if (at < what_.size()) {
    const auto save = what_[at].save;
    return save([self = QPointer(this), at, asked = asked_] {
      if (self && asked == self->asked_) self->saveFrom(at + 1);
    });
  }
  what_.clear();
  if (const auto next = std::exchange(then_, nullptr)) next();
}

}  // namespace mapwright::ui

#include "moc_unsaved_changes.cpp"
