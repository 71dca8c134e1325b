// A survey of all submaps that is made in the background, tile by tile, on the pool. GUI-thread object.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "agreement/survey.h"
#include "render/dense_cache.h"
#include "work/workers.h"

namespace mapwright::scene {

class AgreementRun : public QObject {
  Q_OBJECT
 public:
  explicit AgreementRun(std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  /// Cancels, and waits for what is running.
  ~AgreementRun() override;

  /// All submaps of now: only the tiles under what has changed since are made again, by go(). Too many tiles:
  /// cells of twice the edge, up to agreement::kCoarsestCellM; if they are too many even then, the fault, and
  /// nothing has changed.
  std::optional<Fault> setSubmaps(const std::vector<render::PlacedTexture>& submaps, int tolerance_cells);
  /// Makes what is missing, until stop().
  void go();
  void stop();  // what has been made stays
  void forget();
  bool running() const { return running_; }
  const agreement::Survey& survey() const { return survey_; }

 Q_SIGNALS:
  void progressed();  // twice a second while tiles are made, and when all are made

 private:
  struct Made {
    std::uint64_t generation;
    std::shared_ptr<const agreement::Tile> tile;
  };
  void collect();
  void takeOver();
  void giveOut();

  agreement::Survey survey_;
  render::DenseCache cache_;
  bool running_ = false;
  std::map<std::uint64_t, agreement::TileTask> given_out_;  // by generation
  QElapsedTimer since_told_;
  std::size_t most_given_out_;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::vector<Made> made_;  // guarded by mutex_
  work::Tasks tasks_;       // after all that its jobs use
};

}  // namespace mapwright::scene
