// A survey of all submaps that is made in the background, tile by tile, on the pool, where its findings are
// ranked, too. GUI-thread object.
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

namespace mapwright::ui::scene {

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
  /// What the tiles said when they were ranked last: the worst kMostPlaces places. Never null.
  const std::shared_ptr<const agreement::Disagreement>& found() const { return found_; }
  /// Nothing is missing in found(): all tiles are made, and ranked as they are.
  bool foundAll() const { return survey_.complete() && of_found_ == version_; }
  static constexpr std::size_t kMostPlaces = 10'000;

 Q_SIGNALS:
  void progressed();  // twice a second while tiles are made, when all are made, and when found() is another

 private:
  struct Made {
    std::uint64_t generation;
    std::shared_ptr<const agreement::Tile> tile;
  };
  struct Ranking {
    std::shared_ptr<const agreement::Disagreement> found;
    std::uint64_t version = 0;
  };
  void collect();
  void takeOver();
  void giveOut();
  void halt();
  void beginAnew(agreement::Survey survey);
  void rank();
  void onRanked();

  agreement::Survey survey_;
  std::uint64_t version_ = 0, oldest_ = 0;  // of the tiles; rankings of older ones do not count any more
  std::shared_ptr<const agreement::Disagreement> found_;
  std::uint64_t of_found_ = 0;  // the version
  bool ranking_ = false;
  render::DenseCache cache_;
  bool running_ = false;
  std::map<std::uint64_t, agreement::TileTask> given_out_;  // by generation
  QElapsedTimer since_told_;
  std::size_t most_given_out_;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::vector<Made> made_;       // guarded by mutex_
  Ranking ranked_;               // likewise
  work::Tasks tasks_, rankers_;  // after all that their jobs use
};

}  // namespace mapwright::ui::scene
