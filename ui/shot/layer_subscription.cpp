#include "ui/shot/layer_subscription.h"

#include <algorithm>
#include <iterator>

#include "map/live_state.h"
#include "robot/offers_topics.h"
#include "session/layer_grids.h"

namespace mapwright::ui::shot {

using scene::Layer;

LayerSubscription::LayerSubscription(session::Session& session) : session_(session) {
  // The session connected to this signal earlier, so its world already contains the message.
  connect(&session_.robot(), &robot::Robot::topicReceived, this,
          [this](const map::StampedMessage& message) { heard_.insert(message.topic); });
}

robot::LiveTopics::Basics LayerSubscription::basics(const std::set<Layer>& layers, bool submaps) {
  robot::LiveTopics::Basics basics;
  basics.submaps = submaps;
  basics.pose = std::any_of(layers.begin(), layers.end(), [](Layer layer) {
    return scene::specOf(layer).always_on.contains(map::Stream::Pose);
  });
  basics.state = false;
  return basics;
}

void LayerSubscription::ask(const std::set<Layer>& layers, bool live_map) {
  robot::LiveTopics* const live = session_.robot().liveTopics();
  if (!live) return;
  layers_ = layers;
  map::Streams all;
  for (const Layer layer : layers) {
    if (layer == Layer::WholeMap) continue;
    map::Streams streams = scene::layerStreams(layer), always_on = scene::specOf(layer).always_on;
    all.insert(streams.begin(), streams.end());
    // A picture has arrived when it is decoded, not when the message with its address has.
    if (const auto grid = scene::specOf(layer).grid) {
      pictures_[*grid] = *streams.begin();
    } else {
      waiting_.merge(streams);
    }
    waiting_.merge(always_on);
  }
  if (live_map) all.merge(scene::layerStreams(Layer::WholeMap));
  session_.want(QStringLiteral("shot"), all);
}

QStringList LayerSubscription::topicsOf(map::Stream stream) const {
  robot::LiveTopics* const live = session_.robot().liveTopics();
  return live ? live->topicsOf(stream) : QStringList();
}

/// The points of several scanners are shown together, and so are markers: none that the robot lists may be
/// missing.
QStringList LayerSubscription::silentOf(map::Stream stream) const {
  const QStringList topics = topicsOf(stream);
  QStringList silent, missing;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(silent),
               [this](const QString& topic) { return !heard_.contains(topic.toStdString()); });
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  const bool together = stream == map::Stream::Cloud || stream == map::Stream::SeenObjects;
  const auto offered = of && together ? of->offered() : std::nullopt;
  if (!offered) return silent.size() < topics.size() ? QStringList() : topics.mid(0, 1);
  for (const robot::OfferedTopic& topic : *offered) {
    if (silent.contains(topic.name)) missing << topic.name;
  }
  return missing;
}

std::vector<Layer> LayerSubscription::unfillable() const {
  std::vector<Layer> empty;
  std::copy_if(layers_.begin(), layers_.end(), std::back_inserter(empty), [this](Layer layer) {
    const map::Streams streams = scene::layerStreams(layer);
    return layer != Layer::WholeMap && !streams.empty() &&
           std::all_of(streams.begin(), streams.end(),
                       [this](map::Stream stream) { return topicsOf(stream).isEmpty(); });
  });
  return empty;
}

bool LayerSubscription::in() const {
  return silent().isEmpty() && unplacedMarkers().empty() && !session_.layerGrids().busy();
}

std::map<QString, int> LayerSubscription::unplacedMarkers() const {
  robot::OffersTopics* const of = robot::topicsOfferedBy(session_.robot());
  if (!of || !waiting_.contains(map::Stream::SeenObjects)) return {};
  return of->unplacedMarkers();
}

QStringList LayerSubscription::unplaced() const {
  QStringList unplaced;
  for (const map::Stream stream : waiting_) {
    for (const QString& topic : topicsOf(stream)) {
      const map::Subject subject(map::SubjectKind::Topic, topic.toStdString());
      const auto& rows = session_.problems().rows();
      const bool is_unplaced = std::any_of(rows.begin(), rows.end(), [&](const session::LoggedProblem& row) {
        return !row.resolved && row.problem.code == map::ProblemCode::Unplaced &&
               row.problem.subject == subject;
      });
      if (is_unplaced && !unplaced.contains(topic)) unplaced << topic;
    }
  }
  return unplaced;
}

QStringList LayerSubscription::silent() const {
  QStringList silent;
  for (const map::Stream stream : waiting_) silent += silentOf(stream);
  for (const auto& [kind, stream] : pictures_) {
    if (!session_.live().grids.contains(kind)) silent += topicsOf(stream).mid(0, 1);
  }
  silent.sort();
  return silent;
}

}  // namespace mapwright::ui::shot

#include "moc_layer_subscription.cpp"
