#include "ui/shell/unsaved_changes.h"

#include <algorithm>
#include <utility>

#include <QWidget>

#include "ui/kit/controller.h"
#include "ui/kit/fetched_question.h"

namespace mapwright::window {

namespace {

std::vector<Fetched> fetchedBy(const std::vector<Controller*>& controllers) {
  std::vector<Fetched> all;
  for (Controller* controller : controllers) {
    for (Fetched& one : controller->fetched()) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

UnsavedChanges::UnsavedChanges(QWidget* window)
    : QObject(window), fetched_(new FetchedQuestion(window, this)) {}

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
  then = [this, then = std::move(then)] { fetched_->ask(fetchedBy(controllers_), then); };
  for (auto it = controllers_.rbegin(); it != controllers_.rend(); ++it)
    then = [controller = *it, then = std::move(then)] { controller->beforeLeavingRobot(then); };
  then();
}

}  // namespace mapwright::window

#include "moc_unsaved_changes.cpp"
