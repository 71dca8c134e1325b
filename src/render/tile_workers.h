// The crew as tile work sees it, from the GUI thread. Private to this room.
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

#include "render/compositor.h"
#include "render/pyramid_tile.h"
#include "work/workers.h"

namespace mapwright::render {

/// What a piece of work made: a tile of the view (null pixels: nothing observed) with its image, or one of
/// the pyramid.
struct TileResult {
  std::shared_ptr<const Composition> pixels;
  QImage image;
  PyramidTilePtr tile;
};

/// Runs pure functions on the crew and hands their results to the thread it lives in, several at a time. No
/// queue to speak of: it takes one piece of work more than there are threads, so what is started is what
/// matters now.
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

  /// `receive` is called in this object's thread with at least one outcome.
  TileWorkers(std::shared_ptr<work::Workers> workers, std::function<void(std::vector<Outcome>)> receive);
  ~TileWorkers() override;  // cancels everything and waits

  bool hasRoom() const;
  Ticket start(work::Urgency urgency, Work work);  // precondition: hasRoom()
  /// The outcome still arrives, marked as cancelled. It takes no room any more: it may stand in the queue
  /// behind what others wait for, and then does nothing.
  void cancel(Ticket ticket);

 private:
  void deliver();

  const int threads_;
  std::function<void(std::vector<Outcome>)> receive_;
  std::unordered_map<Ticket, std::shared_ptr<std::atomic<bool>>> running_;
  std::size_t cancelled_ = 0;  // of those
  Ticket last_ticket_ = 0;
  std::mutex mutex_;
  std::vector<Outcome> finished_;  // guarded by mutex_
  work::Share share_;              // last: its jobs see all of the above
};

}  // namespace mapwright::render
