#include "ui/overlays/overlay_history.h"

#include <utility>

namespace mapwright::ui {

using history::VersionStore;

struct OverlayHistory::Queue {
  std::mutex mutex;
  std::deque<std::function<void()>> jobs;
  bool running = false;
};

OverlayHistory::OverlayHistory(std::string path, std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      path_(std::move(path)),
      queue_(std::make_shared<Queue>()),
      share_(work::orOwn(std::move(workers))) {}

OverlayHistory::~OverlayHistory() = default;

void OverlayHistory::post(std::function<void()> job) {
  const std::lock_guard lock(queue_->mutex);
  queue_->jobs.push_back(std::move(job));
  if (std::exchange(queue_->running, true)) return;
  share_.startLong([queue = queue_] {
    for (;;) {
      std::function<void()> next;
      {
        const std::lock_guard lock_next(queue->mutex);
        queue->running = !queue->jobs.empty();
        if (!queue->running) return;
        next = std::move(queue->jobs.front());
        queue->jobs.pop_front();
      }
      next();
    }
  });
}

void OverlayHistory::keep(history::MapName map, std::optional<int> version, history::Origin origin,
                          std::string text, double now_s) {
  if (path_.empty()) return;
  post([this, map = std::move(map), version, origin, text = std::move(text), now_s] {
    auto store = VersionStore::open(path_);
    const std::optional<Fault> why =
        store ? store->keep(map, version, origin, text, now_s) : std::optional(store.error());
    QMetaObject::invokeMethod(
        this, [this, why] { setTrouble(why); }, Qt::QueuedConnection);
  });
}

void OverlayHistory::setTrouble(const std::optional<Fault>& why) {
  const Fault now = why.value_or(Fault());
  if (now != trouble_) {
    trouble_ = now;
    Q_EMIT troubleChanged();
  }
  if (!why) Q_EMIT kept();
}

void OverlayHistory::ask(std::function<Done(tl::expected<VersionStore, Fault> store)> work) {
  if (path_.empty()) return;
  post([this, work = std::move(work)] {
    QMetaObject::invokeMethod(this, work(VersionStore::open(path_)), Qt::QueuedConnection);
  });
}

void OverlayHistory::list(std::function<void(tl::expected<std::vector<history::KeptVersion>, Fault>)> reply) {
  ask([reply = std::move(reply)](tl::expected<VersionStore, Fault> store) -> Done {
    auto versions = store ? store->list({}, {})
                          : tl::expected<std::vector<history::KeptVersion>, Fault>(
                                tl::make_unexpected(std::move(store.error())));
    return [reply, versions = std::move(versions)] { reply(versions); };
  });
}

}  // namespace mapwright::ui

#include "moc_overlay_history.cpp"
