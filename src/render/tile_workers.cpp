#include "render/tile_workers.h"

#include <utility>

namespace mapwright::render {

TileWorkers::TileWorkers(std::shared_ptr<work::Workers> workers,
                         std::function<void(std::vector<Outcome>)> receive)
    : threads_(workers->threads()), receive_(std::move(receive)), tasks_(std::move(workers)) {}

TileWorkers::~TileWorkers() {
  for (const auto& [ticket, cancelled] : running_) cancelled->store(true, std::memory_order_relaxed);
}

bool TileWorkers::hasRoom() const { return running_.size() - cancelled_ <= std::size_t(threads_); }

TileWorkers::Ticket TileWorkers::start(work::Urgency urgency, Work work) {
  const Ticket ticket = ++last_ticket_;
  auto cancelled = std::make_shared<std::atomic<bool>>(false);
  running_.emplace(ticket, cancelled);
  tasks_.start(urgency, [this, ticket, cancelled, work = std::move(work)] {
    Outcome outcome{ticket, false, {}};
    if (!cancelled->load(std::memory_order_relaxed)) outcome.result = work(*cancelled);
    const std::lock_guard lock(mutex_);
    finished_.push_back(std::move(outcome));
    if (finished_.size() == 1)
      QMetaObject::invokeMethod(
          this, [this] { deliver(); }, Qt::QueuedConnection);
  });
  return ticket;
}

void TileWorkers::cancel(Ticket ticket) {
  const auto found = running_.find(ticket);
  if (found != running_.end() && !found->second->exchange(true, std::memory_order_relaxed)) ++cancelled_;
}

void TileWorkers::deliver() {
  std::vector<Outcome> outcomes;
  {
    const std::lock_guard lock(mutex_);
    outcomes.swap(finished_);
  }
  for (Outcome& outcome : outcomes) {
    const auto found = running_.find(outcome.ticket);
    outcome.cancelled = found->second->load(std::memory_order_relaxed);
    if (outcome.cancelled) --cancelled_;
    running_.erase(found);
  }
  receive_(std::move(outcomes));
}

}  // namespace mapwright::render
