// Requests that wait until something is so.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <optional>

#include <QObject>

#include "robot/wire/errand.h"

class QTimer;

namespace mapwright::robot::wire {

/// Each ends once. What still waits when this is destroyed is never told. Lives on the thread of the link.
class WaitList : public QObject {
 public:
  enum class End { Held, TooLate, Cancelled, Dropped };
  using Then = std::function<void(End)>;

  /// `then` at once where it holds already, else by look(), by drop(), when `within` has passed (nullopt:
  /// there is no hurry), or after `errand` was cancelled.
  void await(const ErrandPtr& errand, std::optional<std::chrono::milliseconds> within,
             std::function<bool()> holds, Then then);
  /// Something has changed: what holds now ends.
  void look();
  /// There is nothing to wait for any more.
  void drop();
  bool empty() const { return waiting_.empty(); }

 private:
  struct Waiting {
    std::function<bool()> holds;
    Then then;
    ErrandPtr errand;
    int number = 0;           // of the errand
    QTimer* timer = nullptr;  // a child of this; null: none is needed
  };
  using Entry = std::shared_ptr<Waiting>;
  void end(const Entry& entry, End how);

  std::list<Entry> waiting_;
};

}  // namespace mapwright::robot::wire
