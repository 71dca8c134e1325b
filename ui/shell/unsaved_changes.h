// The unsaved changes of all controllers. Ask here before leaving the present map.
#pragma once

#include <functional>
#include <vector>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "ui/kit/controller.h"

namespace mapwright::ui {

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
  /// Asks once whether to save fetched data, for all of it. Calls `then` when nothing of it is needed any
  /// more: at once if there is nothing, otherwise when all of it is saved or discarded; never if the user
  /// stays.
  void askAboutFetched(std::vector<Fetched> what, std::function<void()> then);
  void saveFrom(std::size_t at);

  QWidget* window_;
  std::vector<Controller*> controllers_;
  QPointer<QMessageBox> question_;
  std::vector<Fetched> what_;
  std::function<void()> then_;
  std::uint64_t asked_ = 0;  // counts the questions: saves for an older one are ignored
};

}  // namespace mapwright::ui
