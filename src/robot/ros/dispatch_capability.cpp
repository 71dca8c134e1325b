#include "robot/ros/dispatch_capability.h"

#include <algorithm>
#include <utility>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"

namespace mapwright::robot::ros {

RosDispatch::RosDispatch(RosLink* link, QObject* parent) : MapDispatch(parent), link_(link) {
  connect(link_, &RosLink::dispatchedMapChanged, this, &MapDispatch::mapChanged);
  connect(link_, &RosLink::projectedCame, this, [this](const std::shared_ptr<const ProjectedPart>& part) {
    projected_[part->index] = part;
    Q_EMIT projectedChanged(part->index);
  });
  connect(link_, &RosLink::projectedGone, this, [this](int index) {
    if (projected_.erase(index) > 0) Q_EMIT projectedChanged(index);
  });
  connect(link_, &RosLink::mapExtentTold, this, [this](const std::optional<MapExtent>& extent) {
    if (std::exchange(extent_, extent) != extent) Q_EMIT extentChanged();
  });
  connect(link_, &RosLink::projectedSilent, this, [this](const QStringList& topics) {
    silent_.clear();
    for (const QString& topic : topics) silent_.push_back(topic.toStdString());
  });
}

void RosDispatch::setFound(const FoundDispatch& found) {
  const bool other = found.offers() != found_.offers();
  found_ = found;
  if (other) Q_EMIT offersChanged();
}

map::Subject RosDispatch::subjectOf(DispatchService service) const {
  const auto there = found_.serviceOf(service);
  return map::Subject(there ? there->name : std::string("map dispatcher (REP 130)"));
}

/// Meaningless requests are not sent (docs/protocols/rep130-map-dispatcher.md, "Maps in space").
map::Failure RosDispatch::refused(DispatchService service, map::AskedFor asked_for, FaultCode why) const {
  map::Failure failure;
  failure.kind = map::FailureKind::Refused;
  failure.subject = subjectOf(service);
  failure.asked_for = asked_for;
  failure.reason = map::FailureReason::Unfit;
  failure.cause = why;
  return failure;
}

Call RosDispatch::grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) {
  const auto service = region ? DispatchService::GridRegion : DispatchService::Grid;
  if (region && !isSound(*region)) {
    return wire::endLater<map::GridPart>(
        this, grids_, std::move(reply),
        tl::make_unexpected(refused(service, map::AskedFor::All, fault::RegionMeansNothing)));
  }
  return wire::askAcross(this, link_, grids_, subjectOf(service), std::move(reply),
                         [region](RosLink& link, auto errand, auto answer) {
                           link.dispatchGrid(errand, region, std::move(answer));
                         });
}

Call RosDispatch::cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
                        OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  const bool points = kind == CloudKind::Points;
  const auto service = points ? (region ? DispatchService::CloudRegion : DispatchService::Cloud)
                              : (region ? DispatchService::OccupancyRegion : DispatchService::Occupancy);
  if (region && !isSound(*region)) {
    return wire::endLater<std::shared_ptr<const map::SpatialCloud>>(
        this, clouds_, std::move(reply),
        tl::make_unexpected(refused(service, map::AskedFor::All, fault::RegionMeansNothing)));
  }
  return wire::askAcross(this, link_, clouds_, subjectOf(service), std::move(reply),
                         [kind, region](RosLink& link, auto errand, auto answer) {
                           link.dispatchCloud(errand, kind, region, std::move(answer));
                         });
}

Call RosDispatch::save(const std::string& filename, OutcomeTo<std::string> reply) {
  const bool control = std::any_of(filename.begin(), filename.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (filename.empty() || filename.size() > 4096 || control) {
    return wire::endLater<std::string>(
        this, saves_, std::move(reply),
        tl::make_unexpected(
            refused(DispatchService::Save, map::AskedFor::Change, fault::FileNameMeansNothing)));
  }
  return wire::askAcross(
      this, link_, saves_, subjectOf(DispatchService::Save), std::move(reply),
      [filename](RosLink& link, auto errand, auto answer) {
        link.dispatchSave(errand, filename, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

Call RosDispatch::projections(OutcomeTo<std::vector<map::Projection>> reply) {
  return wire::askAcross(
      this, link_, projections_, subjectOf(DispatchService::ReadProjections), std::move(reply),
      [](RosLink& link, auto errand, auto answer) { link.dispatchProjections(errand, std::move(answer)); });
}

Call RosDispatch::project(const std::vector<map::Projection>& wanted,
                          OutcomeTo<std::vector<map::Projection>> reply) {
  const bool sound =
      wanted.size() <= kMostProjections &&
      std::all_of(wanted.begin(), wanted.end(), [](const map::Projection& one) { return isSound(one); });
  if (!sound) {
    return wire::endLater<std::vector<map::Projection>>(
        this, projections_, std::move(reply),
        tl::make_unexpected(refused(DispatchService::ChangeProjections, map::AskedFor::Change,
                                    fault::ProjectionMeansNothing)));
  }
  return wire::askAcross(
      this, link_, projections_, subjectOf(DispatchService::ChangeProjections), std::move(reply),
      [wanted](RosLink& link, auto errand, auto answer) {
        link.dispatchProject(errand, wanted, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

std::vector<ProjectedPart> RosDispatch::projected() const {
  std::vector<ProjectedPart> all;
  for (const auto& [index, part] : projected_) all.push_back(*part);
  return all;
}

}  // namespace mapwright::robot::ros

#include "moc_dispatch_capability.cpp"
