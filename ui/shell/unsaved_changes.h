// The unsaved changes of all controllers. Ask here before leaving the present map.
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
  /// `window`: the parent of the question about fetched data.
  explicit UnsavedChanges(QWidget* window = nullptr);

  /// Not owned; must outlive all questions.
  void watch(Controller* controller);
  /// It is being destroyed: it is not asked any more.
  void forget(Controller* controller);

  bool any() const;
  bool maySave() const;  // any of it, now
  void save();
  /// Calls `then` when the present map may be left: at once, or after the user has decided about unsaved
  /// changes, or never. The controllers are asked one after the other, since each may show a question.
  void whenMayLeave(std::function<void()> then);
  /// Whether any fetched data would be lost.
  bool losesFetched() const;
  /// The same for leaving the robot; finally asks about fetched data.
  void whenMayLeaveRobot(std::function<void()> then);

 Q_SIGNALS:
  void changed();

 private:
  std::vector<Controller*> controllers_;
  FetchedQuestion* fetched_;
};

}  // namespace mapwright::window
