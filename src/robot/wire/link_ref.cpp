#include "robot/wire/link_ref.h"

namespace mapwright::robot::wire {
namespace {

void setOver(Call::State& state) {
  state.over = true;
  state.cancel = nullptr;
  state.on_progress = nullptr;
}

}  // namespace

Requests::~Requests() {
  for (auto& [ticket, entry] : entries_) setOver(*entry.state);
}

quint64 Requests::add(OutcomeTo<Value> reply, std::shared_ptr<Call::State> state) {
  entries_.emplace(++last_, Entry{std::move(reply), std::move(state)});
  return last_;
}

/// From any thread.
void Requests::postEnd(quint64 ticket, Outcome<Value> outcome) {
  QMetaObject::invokeMethod(
      this, [this, ticket, outcome = std::move(outcome)] { end(ticket, outcome); }, Qt::QueuedConnection);
}

/// Does nothing if it is over already. The callback may destroy this.
void Requests::end(quint64 ticket, Outcome<Value> outcome) {
  auto node = entries_.extract(ticket);
  if (node.empty()) return;
  setOver(*node.mapped().state);
  if (node.mapped().reply) node.mapped().reply(std::move(outcome));
}

/// The listener may destroy this.
void Requests::reportProgress(quint64 ticket, Progress progress) {
  const auto found = entries_.find(ticket);
  if (found == entries_.end()) return;
  found->second.state->progress = progress;
  if (const auto listener = found->second.state->on_progress) listener(progress);
}

Call Requests::send(QObject* link, const map::Subject& subject, OutcomeTo<Value> reply, Work work,
                    Stopping stopping) {
  auto state = std::make_shared<Call::State>();
  const quint64 ticket = add(std::move(reply), state);
  const auto task = std::make_shared<Task>([this, ticket](Progress progress) {
    QMetaObject::invokeMethod(
        this, [this, ticket, progress] { reportProgress(ticket, progress); }, Qt::QueuedConnection);
  });
  QMetaObject::invokeMethod(
      link,
      [this, ticket, task, link, work = std::move(work)] {
        work(task, [this, ticket, link](Outcome<Value> outcome) {
          if (!outcome) unsaidOf(link).hideIn(outcome.error());
          postEnd(ticket, std::move(outcome));
        });
      },
      Qt::QueuedConnection);
  state->cancel = [this, link, task, ticket, subject, stopping] {
    QMetaObject::invokeMethod(
        link, [task] { task->cancel(); }, Qt::QueuedConnection);
    if (stopping == Stopping::AtOnce)
      postEnd(ticket, fail({.kind = map::FailureKind::Cancelled, .subject = subject}));
  };
  return Call(std::move(state));
}

Call Requests::endLater(OutcomeTo<Value> reply, Outcome<Value> outcome) {
  auto state = std::make_shared<Call::State>();
  postEnd(add(std::move(reply), state), std::move(outcome));
  return Call(std::move(state));
}

}  // namespace mapwright::robot::wire
