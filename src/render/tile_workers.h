// The thread pool as used for tile work, from the GUI thread. Private to this room.
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

/// The result of a piece of work: a tile of the view (null pixels: nothing observed) with its image, or one
/// of the pyramid.
struct TileResult {
  std::shared_ptr<const Composition> pixels;
  QImage image;
  PyramidTilePtr tile;
};

/// Runs pure functions on the thread pool and passes their results to its own thread, several at a time.
/// Takes only one piece of work more than there are threads, so that what is started is what matters now.
class TileWorkers : public QObject {
 public:
  using Ticket = std::uint64_t;  // never 0
  /// Polls `cancelled`; after that its result is ignored.
  using Work = std::function<TileResult(const std::atomic<bool>& cancelled)>;
  struct Outcome {
    Ticket ticket = 0;
    bool cancelled = false;
    TileResult result;
  };

  /// `receive` is called in this object's thread with at least one result.
  TileWorkers(std::shared_ptr<work::Workers> workers, std::function<void(std::vector<Outcome>)> receive);
  ~TileWorkers() override;  // cancels everything and waits

  bool hasRoom() const;
  Ticket start(work::Urgency urgency, Work work);  // precondition: hasRoom()
  /// The result still arrives, marked as cancelled. It no longer counts against the limit: it may wait in the
  /// queue behind other work, and then does nothing.
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
  work::Tasks tasks_;              // last member: its jobs use all of the above
};

}  // namespace mapwright::render
