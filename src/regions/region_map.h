// Loads a robot's map by the visible regions: sends the requests that MapRegions needs.
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

/// Lives on the thread of the dispatcher, which may be destroyed first: then nothing more arrives, and the
/// received cells stay.
class RegionMap : public QObject {
  Q_OBJECT
 public:
  struct Options {
    MapRegions::Options regions = {};
    std::function<Millis()> monotonic = {};  // null = the default clock
  };
  RegionMap(robot::MapDispatch& dispatch, Options options, QObject* parent = nullptr);
  /// Requests in progress are cancelled.
  ~RegionMap() override;

  const MapRegions& regions() const { return regions_; }
  /// The robot can send its map by region.
  bool offered() const { return dispatch_ && dispatch_->offered(robot::DispatchService::GridRegion); }

  /// The dispatcher is gone: pending requests never finish.
  bool gone() const { return !dispatch_; }

  /// The visible area (for a rotated view its bounds); nullopt = nothing, and nothing is requested.
  void setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m);
  /// Requests everything visible again; the old cells are shown until then.
  void refresh();
  /// Retries failed requests at once.
  void retryNow();
  /// Freezes the state, whatever is still answered, so that it can be drawn.
  void standStill();
  /// The robot's capabilities have changed: a dispatcher that is back may have another map.
  void onOffers();
  /// Sends what is due; called automatically whenever something may have changed.
  void look();

 Q_SIGNALS:
  void changed();  // how regions stand
  void cellsChanged(const mapwright::geometry::WorldRect& where);
  void sheetsChanged();  // other sheets, or another order; emitted before cellsChanged()

 private:
  void onExtent();
  void onAnswer(std::uint64_t id, robot::Outcome<map::GridPart> outcome);

  QPointer<robot::MapDispatch> dispatch_;
  std::function<Millis()> monotonic_;
  MapRegions regions_;
  std::map<std::uint64_t, robot::Call> calls_;
  QTimer due_;
  bool still_ = false, was_offered_ = false;
};

}  // namespace mapwright::regions
