// Fetched data is lost with the robot: asks once whether to save it, for all of it.
#pragma once

#include <functional>
#include <vector>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "ui/kit/controller.h"

namespace mapwright::window {

class FetchedQuestion : public QObject {
  Q_OBJECT
 public:
  /// `window`: the parent of the question.
  explicit FetchedQuestion(QWidget* window, QObject* parent = nullptr);

  /// Calls `then` when nothing of it is needed any more: at once if there is nothing, otherwise when all of
  /// it is saved or discarded; never if the user stays.
  void ask(std::vector<Fetched> what, std::function<void()> then);

 private:
  void saveFrom(std::size_t at);

  QWidget* window_;
  QPointer<QMessageBox> question_;
  std::vector<Fetched> what_;
  std::function<void()> then_;
  std::uint64_t asked_ = 0;  // counts the questions: saves for an older one are ignored
};

}  // namespace mapwright::window
