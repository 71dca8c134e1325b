// Requests waiting for their result from another thread.
#pragma once

#include <memory>
#include <unordered_map>
#include <utility>

#include <QObject>

#include "robot/robot.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::wire {

/// Keeps the callbacks of requests on the caller's thread, by a ticket that can be passed to other threads.
/// Callbacks still waiting at destruction are never called, and their calls are over.
template <typename T>
class PendingCalls {
 public:
  PendingCalls() = default;
  PendingCalls(const PendingCalls&) = delete;
  PendingCalls& operator=(const PendingCalls&) = delete;
  ~PendingCalls() {
    for (auto& [ticket, entry] : entries_) end(*entry.state);
  }

  quint64 add(OutcomeTo<T> reply, std::shared_ptr<Call::State> state) {
    entries_.emplace(++last_, Entry{std::move(reply), std::move(state)});
    return last_;
  }
  /// Calls the callback of `ticket` once; unknown tickets are ignored. The callback may destroy this.
  void end(quint64 ticket, Outcome<T> outcome) {
    auto node = entries_.extract(ticket);
    if (node.empty()) return;
    end(*node.mapped().state);
    if (node.mapped().reply) node.mapped().reply(std::move(outcome));
  }
  /// Reports progress; its listener may destroy this.
  void tell(quint64 ticket, Progress progress) {
    const auto found = entries_.find(ticket);
    if (found == entries_.end()) return;
    found->second.state->progress = progress;
    if (const auto listener = found->second.state->on_progress) listener(progress);
  }

 private:
  struct Entry {
    OutcomeTo<T> reply;
    std::shared_ptr<Call::State> state;
  };
  static void end(Call::State& state) {
    state.over = true;
    state.cancel = nullptr;
    state.on_progress = nullptr;
  }

  quint64 last_ = 0;
  std::unordered_map<quint64, Entry> entries_;
};

/// What cancelling a request does.
enum class Stopping {
  AtOnce,      // read-only: it ends as cancelled at once, whatever becomes of its requests
  AsItStands,  // a change: the link's own result says whether it took effect
};

/// Calls question(*link, errand, reply) on the thread of `link`, where `reply` may be called once at any
/// time. The result arrives in `pending` on the thread of `asker`, which owns it and outlives the link's
/// thread. `subject`: for the failure of a cancelled request.
template <typename T, typename Link, typename Question>
Call askAcross(QObject* asker, Link* link, PendingCalls<T>& pending, const map::Subject& subject,
               OutcomeTo<T> reply, Question question, Stopping stopping = Stopping::AtOnce) {
  auto state = std::make_shared<Call::State>();
  const quint64 ticket = pending.add(std::move(reply), state);
  const auto errand = std::make_shared<Errand>([asker, &pending, ticket](Progress progress) {
    QMetaObject::invokeMethod(
        asker, [&pending, ticket, progress] { pending.tell(ticket, progress); }, Qt::QueuedConnection);
  });
  const auto end = [asker, &pending, ticket](Outcome<T> outcome) {
    QMetaObject::invokeMethod(
        asker, [&pending, ticket, outcome = std::move(outcome)] { pending.end(ticket, outcome); },
        Qt::QueuedConnection);
  };
  QMetaObject::invokeMethod(
      link,
      [link, errand, end, question = std::move(question)] { question(*link, errand, OutcomeTo<T>(end)); },
      Qt::QueuedConnection);
  state->cancel = [link, errand, end, subject, stopping] {
    QMetaObject::invokeMethod(
        link, [errand] { errand->cancel(); }, Qt::QueuedConnection);
    if (stopping == Stopping::AtOnce)
      end(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Cancelled, .subject = subject}));
  };
  return Call(std::move(state));
}

/// A request without any work: its known result is delivered later.
template <typename T>
Call endLater(QObject* asker, PendingCalls<T>& pending, OutcomeTo<T> reply, Outcome<T> outcome) {
  auto state = std::make_shared<Call::State>();
  const quint64 ticket = pending.add(std::move(reply), state);
  QMetaObject::invokeMethod(
      asker, [&pending, ticket, outcome = std::move(outcome)] { pending.end(ticket, outcome); },
      Qt::QueuedConnection);
  return Call(std::move(state));
}

}  // namespace mapwright::robot::wire
