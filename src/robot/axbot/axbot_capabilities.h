// The capabilities of an Autoxing robot: one object each, on the thread of the robot. They call the link on
// its own thread and return its results.
#pragma once

#include <functional>

#include "robot/axbot/axbot_link.h"
#include "robot/map_administration.h"
#include "robot/robot.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::axbot {

class Overview : public OverviewSource {
 public:
  explicit Overview(AxbotLink* link) : link_(link) {}
  Call fetchOverview(double resolution_m, OutcomeTo<map::WholeMap> reply) override;

 private:
  wire::LinkRef<AxbotLink> link_;
};

class Administration : public MapAdministration {
 public:
  /// `changed` is called, on the thread of the robot, before the answer to a change that may have been
  /// applied.
  Administration(AxbotLink* link, std::function<void()> changed)
      : maps_(link, &AxbotLink::maps), changed_(std::move(changed)) {}
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const override;
  Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) override;

 private:
  wire::LinkRef<MapRequests> maps_;
  std::function<void()> changed_;
};

class Topics : public wire::TopicsOf<AxbotLink> {
 public:
  using TopicsOf::TopicsOf;
  QStringList known() const override { return knownTopics(); }
  QStringList topicsOf(map::Stream stream) const override;
};

}  // namespace mapwright::robot::axbot
