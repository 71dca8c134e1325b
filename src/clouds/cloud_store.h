// The clouds of the map on screen: put in order in the background, counted, cut into sections, written to
// files. For the window and for commands.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <tl/expected.hpp>

#include "clouds/heights.h"
#include "clouds/newest_clouds.h"
#include "clouds/section.h"
#include "fault/fault.h"
#include "geometry/rect.h"
#include "map/map_part.h"
#include "work/workers.h"

namespace mapwright::clouds {

/// The content of one answer of a robot.
struct CloudPiece {
  std::shared_ptr<const map::SpatialCloud> cloud;  // never null
  bool voxels = false;                             // the middles of occupied cells
  std::optional<map::CloudRegion> region = {};     // as requested; nullopt = the whole map
};

/// What is held, and how much of it is shown: within the heights, and not replaced by newer clouds.
struct CloudSums : NewestClouds::Totals {
  std::uint64_t shown = 0;
};

/// GUI thread.
class CloudStore : public QObject {
  Q_OBJECT
 public:
  explicit CloudStore(std::shared_ptr<work::Workers> workers = nullptr, QObject* parent = nullptr);
  ~CloudStore() override;

  /// The newest replaces older ones in its region.
  void add(CloudPiece piece);
  void clear();
  bool empty() const { return !set_ && waiting_.empty() && !ordering_; }
  /// Everything added is in order, and counted.
  bool settled() const { return waiting_.empty() && !ordering_ && !counting_; }

  /// Shows only these heights; nullopt = all.
  void setHeightRange(std::optional<HeightRange> range);
  const std::optional<HeightRange>& heightRange() const { return range_; }
  /// The edge of all voxels; nullopt = as detected.
  void setVoxel(std::optional<double> metres);

  /// null: nothing is ready yet.
  const std::shared_ptr<const CloudSet>& set() const { return set_; }
  const CloudSums& sums() const { return sums_; }
  const Heights& heights() const { return heights_; }
  geometry::WorldRect bounds() const;  // empty without clouds

  /// Computed in the background; a newer request replaces one that is not finished. The reply comes later,
  /// unless this is destroyed or cleared first.
  using SectionReply = std::function<void(std::shared_ptr<const Section>)>;
  void cut(const Cut& cut, SectionReply reply);
  /// Writes what is shown; the file extension selects PCD, PLY or CSV. Replaces what is there now. The reply
  /// is the number of points.
  void write(const QString& path, std::function<void(tl::expected<std::uint64_t, Fault>)> reply);

 Q_SIGNALS:
  void changed();  // what is drawn
  void summed();   // sums() and heights()
  void settledChanged();

 private:
  HeightRange chosenHeights() const { return range_.value_or(HeightRange{}); }
  std::shared_ptr<const CloudSet> setOrNone() const;
  void stopAll();
  void later(std::uint64_t epoch, std::function<void()> made);
  void proceed();
  void count();
  void publish(const std::shared_ptr<const CloudSet>& set, const Heights& found, std::uint64_t shown);
  void proceedCutting();
  void emitSettled();

  using Flag = std::shared_ptr<std::atomic<bool>>;
  NewestClouds newest_;
  std::shared_ptr<const CloudSet> set_;
  CloudSums sums_;
  Heights heights_;
  std::optional<HeightRange> range_;
  std::deque<CloudPiece> waiting_;
  bool ordering_ = false, counting_ = false, count_again_ = false, cutting_ = false, was_settled_ = true;
  std::optional<std::pair<Cut, SectionReply>> next_cut_;
  std::uint64_t epoch_ = 0;  // results of an older one are ignored
  Flag order_stop_, cut_stop_, write_stop_;
  work::Tasks share_;  // last member: its jobs use all of the above
};

}  // namespace mapwright::clouds
