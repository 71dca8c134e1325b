// How a capability asks what lives on the thread of a link.
#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include <QObject>
#include <QPointer>

#include "robot/wire/requests.h"

namespace mapwright::robot::wire {

/// Whom a capability asks, and its requests under way. Lives with the capability, on the thread of the robot,
/// and outlives the thread of the link. A request is a member of `Part` (or a function of one) that takes an
/// errand, the arguments and the reply, or one that takes the arguments and returns the outcome.
template <typename Part>
class LinkRef {
 public:
  /// Asks the link itself.
  explicit LinkRef(Part* link) : link_(link), part_([link]() -> Part& { return *link; }) {}
  /// Asks a part of it, which is looked up on its thread.
  template <typename Link>
  LinkRef(Link* link, Part& (Link::*part)())
      : link_(link), part_([=]() -> Part& { return (link->*part)(); }) {}

  /// For what only reads: it can be cancelled at once. `subject`: whom it was about then.
  template <typename T, typename Request, typename... Args>
  Call ask(const map::Subject& subject, OutcomeTo<T> reply, Request request, Args... args) {
    return requests_.send(link_, subject, plain(std::move(reply)), work<T>(request, std::move(args)...),
                          Stopping::AtOnce);
  }
  /// For what changes something: cancelled, it tells how far it has come.
  template <typename T, typename Request, typename... Args>
  Call change(const map::Subject& subject, OutcomeTo<T> reply, Request request, Args... args) {
    return requests_.send(link_, subject, plain(std::move(reply)), work<T>(request, std::move(args)...),
                          Stopping::AsItStands);
  }
  /// For what nobody needs to be asked.
  template <typename T>
  Call refuse(OutcomeTo<T> reply, map::Failure why) {
    return requests_.endLater(plain(std::move(reply)), fail(std::move(why)));
  }
  /// Nothing comes back.
  template <typename Order, typename... Args>
  void tell(Order order, Args... args) const {
    QMetaObject::invokeMethod(link_, [part = part_, order, args...] { std::invoke(order, part(), args...); });
  }
  /// The reply to a change, with `changed` called before where something may have been changed. That may
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
    return [part = part_, request, args...](const ErrandPtr& errand, const OutcomeTo<Value>& reply) {
      if constexpr (std::is_invocable_v<Request, Part&, const ErrandPtr&, const Args&..., OutcomeTo<T>>) {
        std::invoke(request, part(), errand, args...,
                    OutcomeTo<T>([reply](Outcome<T> outcome) { reply(plain(std::move(outcome))); }));
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
