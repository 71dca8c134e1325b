// The live layers of a snapshot: what the robot is asked for, and whether it has come.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QStringList>

#include "map/live_topics.h"
#include "scene/layer.h"
#include "session/session.h"

namespace mapwright::app {

class LayerWish : public QObject {
  Q_OBJECT
 public:
  explicit LayerWish(session::Session& session);

  /// What a robot is asked for besides what `layers` need.
  static robot::LiveTopics::Basics basics(const std::set<scene::Layer>& layers, bool submaps);

  /// Asks for what `layers` need, and for the live map where that is wanted.
  void ask(const std::set<scene::Layer>& layers, bool live_map);
  /// What of this topic is in the world already.
  void hear(const std::string& topic) { heard_.insert(topic); }
  /// Every layer has got something to show.
  bool in() const;
  /// What gave nothing, as the robot calls it.
  QStringList silent() const;
  /// Layers that were asked for and that no topic of the robot can fill.
  std::vector<scene::Layer> unfillable() const;

 private:
  QStringList topicsOf(map::Stream stream) const;
  QStringList silentOf(map::Stream stream) const;

  session::Session& session_;
  std::set<scene::Layer> layers_;                  // asked for
  std::set<std::string> heard_;                    // topics that a message of has been taken into the world
  map::Streams waiting_;                           // that something is to come of
  std::map<map::GridKind, map::Stream> pictures_;  // streams that are pictures
};

}  // namespace mapwright::app
