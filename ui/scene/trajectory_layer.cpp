// The path along which the map was made: of the robot, or of an opened map.
#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kTrajectoryPx = 2;

class TrajectoryLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    const auto paint_one = [&](std::span<const Eigen::Vector2d> line) {
      drawHaloedLine(*painter, context_, colorOr(context_.theme.trajectory), sizeOr(kTrajectoryPx), line,
                     option->exposedRect);
    };
    if (of() == FeaturesOf::Robot) return paint_one(context_.live->trajectory);
    for (const auto& line : context_.of(*of()).trajectories) paint_one(line);
  }
  geometry::WorldRect contentBounds() const override {
    if (of() == FeaturesOf::Robot) return boundsOf(context_.live->trajectory);
    geometry::WorldRect bounds;
    for (const auto& line : context_.of(*of()).trajectories) bounds.extend(boundsOf(line));
    return bounds;
  }

 protected:
  QRectF reach() const override {
    const double margin = sizeOr(kTrajectoryPx) + 2;
    if (of() == FeaturesOf::Robot) return reachOf(context_.live->trajectory, margin);
    QRectF reach;
    for (const auto& line : context_.of(*of()).trajectories) reach |= reachOf(line, margin);
    return reach;
  }
};

void seeTrajectories(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  if (of == FeaturesOf::Robot) return seeLine(context.live->trajectory, see);
  const auto& lines = context.of(of).trajectories;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() > 1) seePart(see, i, ObjectForm::Line, lines[i]);
  }
}

MapObject describeTrajectory(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const bool robots = of == FeaturesOf::Robot;
  return oneLine(ObjectText::tr("Trajectory"),
                 robots ? context.live->trajectory.size() : context.of(of).trajectories[number].size(),
                 robots ? map::topicIndex<map::TrajectoryMessage>() : -1);
}

constexpr LayerObjects kTrajectories{seeTrajectories, describeTrajectory};

}  // namespace

template <>
LayerSpec layerSpec<Layer::Trajectory>() {
  return {.name = "trajectory",
          .title = QT_TRANSLATE_NOOP("scene", "Trajectory"),
          .shown = false,
          .sets = LayerSet::Mapping,
          .streams = {map::Stream::Trajectory},
          .topics = {map::topicIndex<map::TrajectoryMessage>()},
          .traits = [] { return lineTraits(kTrajectoryPx); },
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<TrajectoryLayer>,
          .objects = &kTrajectories,
          .sample = [](LegendSample& sample, ObjectForm,
                       std::int64_t) { sample.live.trajectory = sample.line(); },
          .legend =
              [](Legend& legend) {
                legend.addThing(LegendText::tr("Path along which the map was made"), ObjectForm::Line);
              }};
}

}  // namespace mapwright::ui::scene
