// The live layers of a snapshot: what to request from the robot, and whether it has arrived.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QStringList>

#include "map/live_topics.h"
#include "session/session.h"
#include "ui/scene/layer.h"

namespace mapwright::ui::shot {

class LayerSubscription : public QObject {
  Q_OBJECT
 public:
  explicit LayerSubscription(session::Session& session);

  /// What to request in addition to what `layers` need.
  static robot::LiveTopics::Basics basics(const std::set<scene::Layer>& layers, bool submaps);

  /// Requests what `layers` need, and the live map if `live_map` is set.
  void ask(const std::set<scene::Layer>& layers, bool live_map);
  /// Notes that data of this topic has arrived.
  void hear(const std::string& topic) { heard_.insert(topic); }
  /// Every layer has something to show.
  bool in() const;
  /// Topics that sent nothing, as the robot names them.
  QStringList silent() const;
  /// By topic: requested markers without their transforms.
  std::map<QString, int> unplacedMarkers() const;
  /// Topics of requested layers with data that cannot be placed, as the list of problems says.
  QStringList unplaced() const;
  /// Requested layers for which the robot has no topic.
  std::vector<scene::Layer> unfillable() const;

 private:
  QStringList topicsOf(map::Stream stream) const;
  QStringList silentOf(map::Stream stream) const;

  session::Session& session_;
  std::set<scene::Layer> layers_;                  // asked for
  std::set<std::string> heard_;                    // topics whose messages have been applied
  map::Streams waiting_;                           // still expected to send something
  std::map<map::GridKind, map::Stream> pictures_;  // streams that are pictures
};

}  // namespace mapwright::ui::shot
