#include "app/layer_wish.h"

#include <algorithm>
#include <array>

namespace mapwright::app {
namespace {

using scene::Layer;

/// A picture is there when it is decoded, not when the message that names it has come.
constexpr std::array<std::pair<Layer, map::GridKind>, 5> kPictures{
    {{Layer::Incremental, map::GridKind::Incremental},
     {Layer::EnvMatch, map::GridKind::EnvMatch},
     {Layer::EnvSymmetry, map::GridKind::EnvSymmetry},
     {Layer::CostmapLow, map::GridKind::CostmapLow},
     {Layer::CostmapHigh, map::GridKind::CostmapHigh}}};

}  // namespace

LayerWish::LayerWish(session::Session& session) : session_(session) {}

robot::LiveTopics::Basics LayerWish::basics(const std::set<Layer>& layers, bool submaps) {
  const std::array around_robot{Layer::Robot,     Layer::Trail, Layer::Footprint, Layer::ExpandedFootprint,
                                Layer::LocalPath, Layer::Boxes};
  robot::LiveTopics::Basics basics;
  basics.submaps = submaps;
  basics.pose = std::any_of(around_robot.begin(), around_robot.end(),
                            [&](Layer layer) { return layers.contains(layer); });
  basics.state = false;
  return basics;
}

void LayerWish::ask(const std::set<Layer>& layers, bool live_map) {
  robot::LiveTopics* const live = session_.robot().liveTopics();
  if (!live) return;
  QStringList all;
  for (const Layer layer : layers) {
    if (layer == Layer::WholeMap) continue;
    const QStringList topics = scene::layerTopics(layer);
    all += topics;
    const auto picture = std::find_if(kPictures.begin(), kPictures.end(),
                                      [&](const auto& entry) { return entry.first == layer; });
    if (picture != kPictures.end()) {
      pictures_[picture->second] = topics.first();
    } else {
      topics_.insert(topics.begin(), topics.end());
    }
  }
  if (live_map) all += scene::layerTopics(Layer::WholeMap);
  session_.want(QStringLiteral("command"), all);
  if (topics_.empty()) return;
  live->setWatching(true);
  connect(&session_.robot(), &robot::Robot::rawReceived, this, [this](const robot::RawMessage& message) {
    topics_.erase(message.topic);
    // Old firmware sends it under its older name.
    if (message.topic == QLatin1String("/trajectory")) topics_.erase(QStringLiteral("/trajectory_node_list"));
  });
}

bool LayerWish::in() const { return silent().isEmpty() && !session_.layerGrids().busy(); }

QStringList LayerWish::silent() const {
  QStringList silent;
  for (const QString& topic : topics_) silent << topic;
  for (const auto& [kind, topic] : pictures_) {
    if (!session_.live().grids.contains(kind)) silent << topic;
  }
  silent.sort();
  return silent;
}

}  // namespace mapwright::app
