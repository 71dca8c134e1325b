// The live layers of a snapshot: what the robot is asked for, and whether it has come.
#pragma once

#include <map>
#include <set>

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

  /// What a robot is asked for besides the topics of `layers`.
  static robot::LiveTopics::Basics basics(const std::set<scene::Layer>& layers, bool submaps);

  /// Asks for what `layers` need, and for the live map where that is wanted.
  void ask(const std::set<scene::Layer>& layers, bool live_map);
  /// Every layer has got something to show.
  bool in() const;
  /// The topics that gave nothing.
  QStringList silent() const;

 private:
  session::Session& session_;
  std::set<QString> topics_;                   // that gave nothing yet
  std::map<map::GridKind, QString> pictures_;  // layers that are pictures, by topic
};

}  // namespace mapwright::app
