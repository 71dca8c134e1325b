// Requests to an object that lives on a thread of its own, and their way back.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include <QObject>

#include "map/subject.h"
#include "robot/call.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::wire {

/// What cancelling does to a request.
enum class Stopping {
  AtOnce,      // it only reads: it ends as cancelled, whatever becomes of it
  AsItStands,  // it changes something: its own outcome says what has become of that
};

/// The callbacks of requests under way, kept on the thread that asked. What is still held when it is
/// destroyed is never called, and its calls are over. Outlives the thread that is asked. LinkRef puts the
/// types back that are left out here: this is compiled once.
class Requests : public QObject {
 public:
  using Value = std::shared_ptr<void>;
  /// Runs on the thread that is asked, and calls the reply there once, whenever.
  using Work = std::function<void(const ErrandPtr& errand, const OutcomeTo<Value>& reply)>;

  ~Requests() override;

  /// Runs `work` on the thread of `link`; the outcome comes to `reply` here. `subject`: whom a cancelled
  /// request was about.
  Call send(QObject* link, const map::Subject& subject, OutcomeTo<Value> reply, Work work, Stopping stopping);
  /// A request that needs nobody: its outcome is known, and told later.
  Call endLater(OutcomeTo<Value> reply, Outcome<Value> outcome);

 private:
  struct Entry {
    OutcomeTo<Value> reply;
    std::shared_ptr<Call::State> state;
  };
  quint64 add(OutcomeTo<Value> reply, std::shared_ptr<Call::State> state);
  void postEnd(quint64 ticket, Outcome<Value> outcome);
  void end(quint64 ticket, Outcome<Value> outcome);
  void tell(quint64 ticket, Progress progress);

  quint64 last_ = 0;
  std::unordered_map<quint64, Entry> entries_;  // by a ticket, which may travel
};

}  // namespace mapwright::robot::wire
