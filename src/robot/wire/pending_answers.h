// Questions that wait for an answer from another thread.
#pragma once

#include <unordered_map>
#include <utility>

#include <QtGlobal>

#include "robot/robot.h"

namespace mapwright::robot::wire {

/// Keeps the callbacks of questions on the thread that asked, under a ticket that may travel. What is still
/// held when it is destroyed is never called.
template <typename T>
class PendingAnswers {
 public:
  quint64 add(AnswerTo<T> reply) {
    replies_.emplace(++last_, std::move(reply));
    return last_;
  }
  /// Calls the callback of `ticket` once; unknown tickets are ignored.
  void answer(quint64 ticket, Answer<T> answer) {
    auto node = replies_.extract(ticket);
    if (!node.empty() && node.mapped()) node.mapped()(std::move(answer));
  }

 private:
  quint64 last_ = 0;
  std::unordered_map<quint64, AnswerTo<T>> replies_;
};

/// Asks `link` on its own thread: question(*link, reply), where `reply` may be called there once, whenever.
/// The answer comes to `pending` on the thread of `asker`, which owns it and outlives the link's thread.
template <typename T, typename Link, typename Question>
void askAcross(QObject* asker, Link* link, PendingAnswers<T>& pending, AnswerTo<T> reply, Question question) {
  const quint64 ticket = pending.add(std::move(reply));
  QMetaObject::invokeMethod(
      link,
      [asker, link, &pending, ticket, question = std::move(question)] {
        question(*link, AnswerTo<T>([asker, &pending, ticket](Answer<T> answer) {
          QMetaObject::invokeMethod(
              asker, [&pending, ticket, answer = std::move(answer)] { pending.answer(ticket, answer); },
              Qt::QueuedConnection);
        }));
      },
      Qt::QueuedConnection);
}

}  // namespace mapwright::robot::wire
