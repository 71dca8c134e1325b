// What would be lost if the present map were left: of all controllers together. Whoever is about to leave it
// asks here.
#pragma once

#include <functional>
#include <vector>

#include <QObject>

namespace mapwright::window {

class Controller;
class FetchedQuestion;

class UnsavedChanges : public QObject {
  Q_OBJECT
 public:
  /// `window`: the parent of the question about what was fetched.
  explicit UnsavedChanges(QWidget* window = nullptr);

  /// Not owned; must outlive all questions.
  void watch(Controller* controller);
  /// It is about to be taken apart: it is not asked any more.
  void forget(Controller* controller);

  bool any() const;
  bool maySave() const;  // any of it, now
  void save();
  /// Calls `then` when the present map may be left: at once, or after the user has said what becomes of what
  /// is not saved, or never. Each controller is asked in its turn, since each may ask.
  void whenMayLeave(std::function<void()> then);
  /// Whether anything has been fetched of the robot that is nowhere else.
  bool losesFetched() const;
  /// The same where the robot is left; last of all what was fetched of it is asked about.
  void whenMayLeaveRobot(std::function<void()> then);

 Q_SIGNALS:
  void changed();

 private:
  std::vector<Controller*> controllers_;
  FetchedQuestion* fetched_;
};

}  // namespace mapwright::window
