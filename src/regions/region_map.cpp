#include "regions/region_map.h"

#include <algorithm>
#include <utility>

namespace mapwright::regions {
namespace {

constexpr Millis kLeastWait{10};

Millis steadyNow() {
  return std::chrono::duration_cast<Millis>(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace

RegionMap::RegionMap(robot::MapDispatch& dispatch, Options options, QObject* parent)
    : QObject(parent),
      dispatch_(&dispatch),
      monotonic_(options.monotonic ? std::move(options.monotonic) : steadyNow),
      regions_(options.regions) {
  due_.setSingleShot(true);
  connect(&due_, &QTimer::timeout, this, &RegionMap::look);
  connect(dispatch_, &robot::MapDispatch::mapChanged, this, &RegionMap::refresh);
  connect(dispatch_, &robot::MapDispatch::offersChanged, this, &RegionMap::onOffers);
  connect(dispatch_, &robot::MapDispatch::extentChanged, this, &RegionMap::onExtent);
  was_offered_ = offered();
  onExtent();
  connect(dispatch_, &QObject::destroyed, this, &RegionMap::look);
}

RegionMap::~RegionMap() {
  for (const auto& [id, call] : std::exchange(calls_, {})) call.cancel();
}

void RegionMap::setView(std::optional<geometry::WorldRect> rect, const Eigen::Vector2d& centre_m) {
  if (still_) return;
  regions_.setView(rect, centre_m);
  look();
}

void RegionMap::refresh() {
  if (still_) return;
  regions_.refresh();
  look();
}

void RegionMap::retryNow() {
  regions_.retryNow();
  look();
}

void RegionMap::standStill() {
  still_ = true;
  due_.stop();
  for (const auto& [id, call] : std::exchange(calls_, {})) call.cancel();
}

void RegionMap::onExtent() {
  const auto extent = dispatch_->extent();
  regions_.setExtent(extent ? std::optional(extent->grid) : std::nullopt);
  look();
}

void RegionMap::onOffers() {
  if (still_) return;
  const bool was_offered = std::exchange(was_offered_, offered());
  if (was_offered_ && !was_offered) regions_.refresh();
  look();
}

void RegionMap::look() {
  if (still_) return;
  due_.stop();
  for (const std::uint64_t id : regions_.unwanted()) {
    if (const auto call = calls_.find(id); call != calls_.end()) call->second.cancel();
  }
  if (offered()) {
    for (const RegionRequest& request : regions_.take(monotonic_())) {
      // The robot may answer after this is destroyed.
      calls_[request.id] =
          dispatch_->grid(askedFor(request.rect),
                          [self = QPointer(this), id = request.id](robot::Outcome<map::GridPart> outcome) {
                            if (self) self->onAnswer(id, std::move(outcome));
                          });
    }
    if (const auto due = regions_.nextDue(monotonic_()))
      due_.start(int(std::clamp(*due - monotonic_(), kLeastWait, Millis(3'600'000)).count()));
  }
  Q_EMIT changed();
}

void RegionMap::onAnswer(std::uint64_t id, robot::Outcome<map::GridPart> outcome) {
  if (still_) return;
  calls_.erase(id);
  const MapRegions::Change change = regions_.answered(id, std::move(outcome), monotonic_());
  if (change.sheets) Q_EMIT sheetsChanged();
  if (!change.cells.empty()) Q_EMIT cellsChanged(change.cells);
  look();
}

}  // namespace mapwright::regions

#include "moc_region_map.cpp"
