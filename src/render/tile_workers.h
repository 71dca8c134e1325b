// The pool that tile work runs on, seen from the GUI thread. Private to this room.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include "render/compositor.h"
#include "render/pyramid_tile.h"

namespace mapwright::render {

/// What a piece of work made: a tile of the view (null pixels: nothing observed) with its image, or one of
/// the pyramid.
struct TileResult {
  std::shared_ptr<const Composition> pixels;
  QImage image;
  PyramidTilePtr tile;
};

/// Runs pure functions on threads of its own and hands their results to the thread it lives in, several at a
/// time. No queue to speak of: it takes one piece of work more than it has threads, so what is started is
/// what matters now.
class TileWorkers : public QObject {
 public:
  using Ticket = std::uint64_t;  // never 0
  /// Polls `cancelled`; after that its result does not matter.
  using Work = std::function<TileResult(const std::atomic<bool>& cancelled)>;
  struct Outcome {
    Ticket ticket = 0;
    bool cancelled = false;
    TileResult result;
  };

  /// threads = 0: one per core. `receive` is called in this object's thread with at least one outcome.
  TileWorkers(int threads, std::function<void(std::vector<Outcome>)> receive);
  ~TileWorkers() override;  // cancels everything and waits

  bool hasRoom() const;
  Ticket start(Work work);  // precondition: hasRoom()
  /// The outcome still arrives, marked as cancelled.
  void cancel(Ticket ticket);

 private:
  void deliver();

  QThreadPool pool_;
  std::function<void(std::vector<Outcome>)> receive_;
  std::unordered_map<Ticket, std::shared_ptr<std::atomic<bool>>> running_;
  Ticket last_ticket_ = 0;
  std::mutex mutex_;
  std::vector<Outcome> finished_;  // guarded by mutex_
};

}  // namespace mapwright::render
