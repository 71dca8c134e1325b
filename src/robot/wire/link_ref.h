// How a capability calls what lives on the thread of a link, and how the results come back.
#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include <QObject>
#include <QPointer>

#include "map/subject.h"
#include "robot/call.h"
#include "robot/wire/task.h"
#include "robot/wire/unsaid.h"

namespace mapwright::robot::wire {

/// What cancelling does to a request.
enum class Stopping {
  AtOnce,      // it only reads: it ends as cancelled, whatever becomes of it
  AsItStands,  // it changes something: its own outcome says what has become of that
};

/// The callbacks of requests in progress, kept on the thread that made the requests. Those that are left when
/// it is destroyed are never called, and their calls are over. Outlives the thread of the link. Without the
/// types of the results, which LinkRef puts back: this is compiled once.
class Requests : public QObject {
 public:
  using Value = std::shared_ptr<void>;
  /// Runs on the thread of the link, and calls the reply there once, whenever.
  using Work = std::function<void(const TaskPtr& task, const OutcomeTo<Value>& reply)>;

  ~Requests() override;

  /// Runs `work` on the thread of `link`; the outcome comes to `reply` here. `subject` is that of the failure
  /// if the request is cancelled.
  Call send(QObject* link, const map::Subject& subject, OutcomeTo<Value> reply, Work work, Stopping stopping);
  /// A request whose outcome is known already, delivered later.
  Call endLater(OutcomeTo<Value> reply, Outcome<Value> outcome);

 private:
  struct Entry {
    OutcomeTo<Value> reply;
    std::shared_ptr<Call::State> state;
  };
  quint64 add(OutcomeTo<Value> reply, std::shared_ptr<Call::State> state);
  void postEnd(quint64 ticket, Outcome<Value> outcome);
  void end(quint64 ticket, Outcome<Value> outcome);
  void reportProgress(quint64 ticket, Progress progress);

  quint64 last_ = 0;
  std::unordered_map<quint64, Entry> entries_;  // by ticket
};

/// A part of a link, and the requests to it in progress. Lives with the capability, on the thread of the
/// robot, and outlives the thread of the link. A request is a member of `Part` (or a function of one) that
/// takes a task, the arguments and the reply, or one that takes the arguments and returns the outcome.
template <typename Part>
class LinkRef {
 public:
  /// The link itself.
  explicit LinkRef(Part* link) : link_(link), part_([link]() -> Part& { return *link; }) {}
  /// A part of it, which is looked up on its thread.
  template <typename Link>
  LinkRef(Link* link, Part& (Link::*part)())
      : link_(link), part_([=]() -> Part& { return (link->*part)(); }) {}

  /// A request that only reads: it can be cancelled at once. `subject` is that of the failure then.
  template <typename T, typename Request, typename... Args>
  Call ask(const map::Subject& subject, OutcomeTo<T> reply, Request request, Args... args) {
    return requests_.send(link_, subject, plain(std::move(reply)), work<T>(request, std::move(args)...),
                          Stopping::AtOnce);
  }
  /// A request that changes something: cancelled, it says how far it has come.
  template <typename T, typename Request, typename... Args>
  Call change(const map::Subject& subject, OutcomeTo<T> reply, Request request, Args... args) {
    return requests_.send(link_, subject, plain(std::move(reply)), work<T>(request, std::move(args)...),
                          Stopping::AsItStands);
  }
  /// A request that is refused without asking anybody.
  template <typename T>
  Call refuse(OutcomeTo<T> reply, map::Failure why) {
    return requests_.endLater(plain(std::move(reply)), fail(std::move(why)));
  }
  /// Nothing comes back.
  template <typename Order, typename... Args>
  void post(Order order, Args... args) const {
    QMetaObject::invokeMethod(link_, [part = part_, order, args...] { std::invoke(order, part(), args...); });
  }
  /// The reply to a change, with `changed` called before it if something may have been changed. That may
  /// destroy the robot, which then replies no more.
  template <typename T>
  OutcomeTo<T> telling(std::function<void()> changed, OutcomeTo<T> reply) const {
    return [alive = QPointer(&requests_), changed = std::move(changed),
            reply = std::move(reply)](Outcome<T> outcome) {
      if (outcome || outcome.error().applied != map::Applied::No) changed();
      if (alive) reply(std::move(outcome));
    };
  }

 private:
  using Value = Requests::Value;

  template <typename T>
  static OutcomeTo<Value> plain(OutcomeTo<T> reply) {
    return [reply = std::move(reply)](Outcome<Value> outcome) {
      if (!outcome) return reply(fail(std::move(outcome.error())));
      reply(std::move(*std::static_pointer_cast<T>(*outcome)));
    };
  }
  template <typename T>
  static Outcome<Value> plain(Outcome<T> outcome) {
    if (!outcome) return fail(std::move(outcome.error()));
    return std::make_shared<T>(std::move(*outcome));
  }
  template <typename T, typename Request, typename... Args>
  Requests::Work work(Request request, Args... args) const {
    return
        [part = part_, link = link_, request, args...](const TaskPtr& task, const OutcomeTo<Value>& reply) {
          if constexpr (std::is_invocable_v<Request, Part&, const TaskPtr&, const Args&..., OutcomeTo<T>>) {
            std::invoke(request, part(), task, args..., OutcomeTo<T>([reply, link](Outcome<T> outcome) {
                          if (outcome) unsaidOf(link).hideInRemarks(*outcome);
                          reply(plain(std::move(outcome)));
                        }));
          } else {
            reply(plain(Outcome<T>(std::invoke(request, part(), args...))));
          }
        };
  }

  QObject* link_;
  std::function<Part&()> part_;
  Requests requests_;
};

}  // namespace mapwright::robot::wire
