// A map dispatcher behind a rosbridge server, as a capability. On the thread of the robot. Source:
// docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <map>
#include <memory>

#include "robot/map_dispatch.h"
#include "robot/ros/ros_link.h"
#include "robot/wire/link_ref.h"

namespace mapwright::robot::ros {

class RosDispatch : public MapDispatch {
  Q_OBJECT
 public:
  /// `longest_message`: in bytes; no map comes that is longer.
  RosDispatch(RosLink* link, std::int64_t longest_message);

  /// Called by the robot before it reports changed capabilities.
  void setFound(const FoundDispatch& found);

  std::vector<DispatchOffer> offers() const override { return found_.offers(); }
  Call grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) override;
  Call cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) override;
  Call save(const std::string& filename, OutcomeTo<std::string> reply) override;
  Call projections(OutcomeTo<std::vector<map::Projection>> reply) override;
  Call project(const std::vector<map::Projection>& wanted,
               OutcomeTo<std::vector<map::Projection>> reply) override;
  std::optional<MapExtent> extent() const override { return extent_; }
  std::vector<ProjectedPart> projected() const override;
  std::vector<std::string> silent() const override { return silent_; }

 private:
  map::Subject subjectOf(DispatchService service) const;
  map::Failure refused(DispatchService service, map::AskedFor asked_for, FaultCode why) const;

  wire::LinkRef<RosLink> link_;
  FoundDispatch found_;
  std::map<int, std::shared_ptr<const ProjectedPart>> projected_;
  std::vector<std::string> silent_;
  std::optional<MapExtent> extent_;
};

}  // namespace mapwright::robot::ros
