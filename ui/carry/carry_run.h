// Looks at two maps on a thread beside the pool. GUI-thread object; deleting it waits.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QObject>

#include "carry/carried.h"
#include "work/workers.h"

namespace mapwright::ui {

class CarryRun : public QObject {
  Q_OBJECT
 public:
  /// What is to be found out, and then, on the GUI thread, what is done with it.
  using Then = std::function<void()>;
  using Job = std::function<Then(const carry::Site& site)>;

  explicit CarryRun(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~CarryRun() override;

  void start(render::PlacedGrid old_map, render::PlacedGrid new_map, const geometry::Pose2& transform,
             Job job);
  /// Nothing is heard of it any more.
  void cancel();

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
