#include "robot/ros/dispatch_capability.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
namespace {

/// A request of the dispatcher, once it is known what the robot can do.
template <typename Request>
auto whenKnown(map::AskedFor asked_for, Request request) {
  // `rest`: its arguments, and the reply.
  return [asked_for, request](RosLink& link, const wire::TaskPtr& task, const auto&... rest) {
    link.whenKnown(task, map::Subject(std::string(kDispatcher)), asked_for,
                   [&link, task, request, rest...](std::optional<map::Failure> failure) {
                     const auto& reply = std::get<sizeof...(rest) - 1>(std::tie(rest...));
                     if (failure) return reply(fail(std::move(*failure)));
                     std::invoke(request, link.dispatch(), task, rest...);
                   });
  };
}

}  // namespace

RosDispatch::RosDispatch(RosLink* link, std::int64_t longest_message) : link_(link) {
  const DispatchRequests* const requests = &link->dispatch();
  connect(requests, &DispatchRequests::mapChanged, this, &MapDispatch::mapChanged);
  connect(requests, &DispatchRequests::projectedCame, this,
          [this](const std::shared_ptr<const ProjectedPart>& part) {
            projected_[part->index] = part;
            Q_EMIT projectedChanged(part->index);
          });
  connect(requests, &DispatchRequests::projectedGone, this, [this](int index) {
    if (projected_.erase(index) > 0) Q_EMIT projectedChanged(index);
  });
  connect(requests, &DispatchRequests::extentTold, this,
          [this, longest_message](const std::optional<map::GridReference>& grid) {
            std::optional<MapExtent> extent;
            if (grid) {
              const std::int64_t cells = std::int64_t(grid->width) * grid->height;
              extent = MapExtent{*grid, aboutBytesOfCells(cells), leastBytesOfCells(cells), longest_message};
            }
            if (std::exchange(extent_, extent) != extent) Q_EMIT extentChanged();
          });
  connect(requests, &DispatchRequests::projectedSilent, this, [this](const QStringList& topics) {
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
  return map::Subject(there ? there->name : std::string(kDispatcher));
}

/// Meaningless requests are not sent (docs/protocols/rep130-map-dispatcher.md, "Maps in space").
map::Failure RosDispatch::refused(DispatchService service, map::AskedFor asked_for, FaultCode why) const {
  return {.kind = map::FailureKind::Refused,
          .subject = subjectOf(service),
          .asked_for = asked_for,
          .reason = map::FailureReason::Unfit,
          .cause = why};
}

Call RosDispatch::grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) {
  const auto service = region ? DispatchService::GridRegion : DispatchService::Grid;
  if (region && !isSound(*region))
    return link_.refuse(std::move(reply), refused(service, map::AskedFor::All, fault::RegionMeansNothing));
  return link_.ask(subjectOf(service), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::grid), region);
}

Call RosDispatch::cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
                        OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  const auto service = cloudService(kind, region.has_value());
  if (region && !isSound(*region))
    return link_.refuse(std::move(reply), refused(service, map::AskedFor::All, fault::RegionMeansNothing));
  return link_.ask(subjectOf(service), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::cloud), kind, region);
}

Call RosDispatch::save(const std::string& filename, OutcomeTo<std::string> reply) {
  const bool control = std::any_of(filename.begin(), filename.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (filename.empty() || filename.size() > 4096 || control) {
    return link_.refuse(std::move(reply),
                        refused(DispatchService::Save, map::AskedFor::Change, fault::FileNameMeansNothing));
  }
  return link_.change(subjectOf(DispatchService::Save), std::move(reply),
                      whenKnown(map::AskedFor::Change, &DispatchRequests::save), filename);
}

Call RosDispatch::projections(OutcomeTo<std::vector<map::Projection>> reply) {
  return link_.ask(subjectOf(DispatchService::ReadProjections), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::projections));
}

Call RosDispatch::project(const std::vector<map::Projection>& wanted,
                          OutcomeTo<std::vector<map::Projection>> reply) {
  const bool sound =
      wanted.size() <= kMostProjections &&
      std::all_of(wanted.begin(), wanted.end(), [](const map::Projection& one) { return isSound(one); });
  if (!sound) {
    return link_.refuse(std::move(reply), refused(DispatchService::ChangeProjections, map::AskedFor::Change,
                                                  fault::ProjectionMeansNothing));
  }
  return link_.change(subjectOf(DispatchService::ChangeProjections), std::move(reply),
                      whenKnown(map::AskedFor::Change, &DispatchRequests::project), wanted);
}

std::vector<ProjectedPart> RosDispatch::projected() const {
  std::vector<ProjectedPart> all;
  for (const auto& [index, part] : projected_) all.push_back(*part);
  return all;
}

}  // namespace mapwright::robot::ros

#include "moc_dispatch_capability.cpp"
