// What was fetched of a robot goes with it: whether it is to be saved is asked once, about all of it.
#pragma once

#include <functional>
#include <vector>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

#include "window/controller.h"

namespace mapwright::window {

class FetchedQuestion : public QObject {
  Q_OBJECT
 public:
  /// `window`: the parent of the question.
  explicit FetchedQuestion(QWidget* window, QObject* parent = nullptr);

  /// Calls `then` when nothing of it is needed any more: at once where there is nothing, else when all of it
  /// is saved, or was given up; never when the user stays.
  void ask(std::vector<Fetched> what, std::function<void()> then);

 private:
  void saveFrom(std::size_t at);

  QWidget* window_;
  QPointer<QMessageBox> question_;
  std::vector<Fetched> what_;
  std::function<void()> then_;
  std::uint64_t asked_ = 0;  // what is saved for an older question goes nowhere
};

}  // namespace mapwright::window
