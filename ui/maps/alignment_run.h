// Aligns two maps on a thread beside the pool. GUI-thread object; deleting it cancels and waits.
#pragma once

#include <atomic>
#include <memory>
#include <variant>
#include <vector>

#include <QObject>

#include "align/align.h"
#include "fault/fault.h"
#include "placing/align.h"
#include "render/compositor.h"
#include "render/sample_grid.h"
#include "work/workers.h"

namespace mapwright::ui {

class AlignmentRun : public QObject {
  Q_OBJECT
 public:
  explicit AlignmentRun(std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  ~AlignmentRun() override;

  /// Submaps are composed first. They are in ascending order of their ids.
  using NewMap = std::variant<render::PlacedGrid, std::vector<render::PlacedTexture>>;
  /// Where `old_map` lies on `new_map`.
  void start(render::PlacedGrid old_map, NewMap new_map, std::vector<placing::PointPair> pairs);
  /// Nothing is heard of it any more.
  void cancel();
  bool running() const { return running_; }

 Q_SIGNALS:
  void progressed(double done);  // 0..1
  void finished(const mapwright::align::Alignment& found);
  void failed(const mapwright::Fault& fault);  // the submaps cannot be composed

 private:
  std::shared_ptr<work::Workers> workers_;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  bool running_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
