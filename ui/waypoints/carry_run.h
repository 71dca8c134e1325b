// What becomes of the waypoints of an old map, on a thread beside the pool. GUI-thread object; deleting it
// waits.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include <QObject>

#include "carry/carried.h"
#include "work/workers.h"

namespace mapwright::window {

class CarryRun : public QObject {
  Q_OBJECT
 public:
  explicit CarryRun(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~CarryRun() override;

  void start(render::PlacedGrid old_map, render::PlacedGrid new_map, const geometry::Pose2& transform,
             std::vector<carry::Spot> old_spots, const carry::CarryOptions& options);
  /// Nothing is heard of it any more.
  void cancel();
  bool running() const { return running_; }

 Q_SIGNALS:
  void finished(const std::vector<mapwright::carry::Carried>& carried);  // in the order of the spots

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  bool running_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::window
