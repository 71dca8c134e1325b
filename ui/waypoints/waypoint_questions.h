// What is asked before unsaved waypoints are lost or left behind: one question at a time, which stays open
// until it is answered. GUI thread.
#pragma once

#include <functional>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

namespace mapwright::window {

class WaypointQuestions : public QObject {
  Q_OBJECT
 public:
  enum class Leaving { Save, Keep, Discard, Stay };

  explicit WaypointQuestions(QWidget* window) : QObject(window), window_(window) {}
  QMessageBox* shown() const { return question_; }  // null: nothing is asked

  /// `then` is called when they are to be discarded.
  void askToDiscard(const QString& sentence, std::function<void()> then);
  /// `may_keep`: a draft of them can be kept. Asked once more while it is open, the later one counts.
  void askToLeave(const QString& sentence, bool may_keep, std::function<void(Leaving)> then);

 private:
  QWidget* window_;
  QPointer<QMessageBox> question_;
};

}  // namespace mapwright::window
