// A robot's map by the regions in view: asks its dispatcher for what MapRegions wants.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "regions/map_regions.h"
#include "robot/map_dispatch.h"

namespace mapwright::regions {

/// Lives on the thread of the dispatcher, which may go before it: nothing more comes then, and what came
/// stays.
class RegionMap : public QObject {
  Q_OBJECT
 public:
  struct Options {
    MapRegions::Options regions = {};
    std::function<Millis()> monotonic = {};  // null = the usual clock
  };
  RegionMap(robot::MapDispatch& dispatch, Options options, QObject* parent = nullptr);
  /// Requests under way are cancelled.
  ~RegionMap() override;

  const MapRegions& regions() const { return regions_; }
  /// A region can be asked for: the robot offers it.
  bool offered() const { return dispatch_ && dispatch_->offered(robot::DispatchService::GridRegion); }

  /// The dispatcher is gone: what was under way never ends.
  bool gone() const { return !dispatch_; }

  /// What is looked at (of a turned view: what it lies in); nullopt = nothing, and nothing is asked for.
  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// Everything in view is asked for once more; until it is there the old is shown.
  void refresh();
  /// What failed is asked for at once.
  void retryNow();
  /// From now on nothing changes any more, whatever is still answered: for whoever draws the present state.
  void standStill();
  /// What the robot offers has changed: a dispatcher that is back may have another map.
  void takeOffers();
  /// Sends what is due; by itself whenever something may have changed.
  void look();

 Q_SIGNALS:
  void changed();  // how regions stand
  void cellsChanged(const mapwright::geometry::WorldRect& where);
  void sheetsChanged();  // others, or in another order; comes before cellsChanged()

 private:
  void takeExtent();
  void take(std::uint64_t id, robot::Outcome<map::GridPart> outcome);

  QPointer<robot::MapDispatch> dispatch_;
  std::function<Millis()> monotonic_;
  MapRegions regions_;
  std::map<std::uint64_t, robot::Call> calls_;
  QTimer due_;
  bool still_ = false, was_offered_ = false;
};

}  // namespace mapwright::regions
