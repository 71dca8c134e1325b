// The capabilities that every ROS robot may have: one object each, on the thread of the robot. They call the
// link on its own thread and return its results.
#pragma once

#include <memory>

#include "robot/robot.h"
#include "robot/ros/ros_link.h"
#include "robot/wire/pending_calls.h"

namespace mapwright::robot::ros {

/// The caller's context and the link. Both outlive the requests of a capability.
struct Line {
  QObject* asker;
  RosLink* link;
};

/// Only the live map, or the maps of a map manager.
class Catalogue : public MapCatalogue {
 public:
  explicit Catalogue(Line line) : line_(line) {}
  Call list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) override;
  Call describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) override;
  Call thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) override;

 private:
  Line line_;
  wire::PendingCalls<std::vector<map::CatalogueEntry>> lists_;
  wire::PendingCalls<map::CatalogueEntry> descriptions_;
  wire::PendingCalls<std::string> thumbnails_;
};

/// The robot's current map; it sends no others.
class WholeMaps : public WholeMapSource {
 public:
  explicit WholeMaps(Line line) : line_(line) {}
  Call fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) override;

 private:
  Line line_;
  wire::PendingCalls<map::WholeMap> maps_;
};

class Topics : public LiveTopics {
 public:
  /// `known` is kept up to date by the robot.
  Topics(Line line, std::shared_ptr<wire::TapPlace> tap, const KnownTopics& known)
      : line_(line), tap_(std::move(tap)), known_(known) {}
  QStringList known() const override;
  QStringList topicsOf(map::Stream stream) const override;
  void setWanted(const map::Streams& streams, const QStringList& topics) override;
  void setBasics(const Basics& basics) override;
  void setWatching(bool on) override;
  void setTap(FrameTap tap) override { tap_->set(std::move(tap)); }

 private:
  Line line_;
  std::shared_ptr<wire::TapPlace> tap_;
  const KnownTopics& known_;
};

}  // namespace mapwright::robot::ros
