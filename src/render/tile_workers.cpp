#include "render/tile_workers.h"

#include <QThread>

#include "raster/stand_back.h"

namespace mapwright::render {

TileWorkers::TileWorkers(int threads, std::function<void(std::vector<Outcome>)> receive)
    : receive_(std::move(receive)) {
  pool_.setMaxThreadCount(threads > 0 ? threads : QThread::idealThreadCount());
}

TileWorkers::~TileWorkers() {
  for (const auto& [ticket, cancelled] : running_) cancelled->store(true, std::memory_order_relaxed);
  pool_.waitForDone();
}

bool TileWorkers::hasRoom() const { return running_.size() <= std::size_t(pool_.maxThreadCount()); }

TileWorkers::Ticket TileWorkers::start(Work work) {
  const Ticket ticket = ++last_ticket_;
  auto cancelled = std::make_shared<std::atomic<bool>>(false);
  running_.emplace(ticket, cancelled);
  pool_.start([this, ticket, cancelled, work = std::move(work)] {
    // The GUI thread goes first: a late tile is seen less than a late frame.
    raster::standBack();
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
  if (found != running_.end()) found->second->store(true, std::memory_order_relaxed);
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
    running_.erase(found);
  }
  receive_(std::move(outcomes));
}

}  // namespace mapwright::render
