// The whole map, and the reference map under it. RasterStack draws them.
#include "robot/robot.h"
#include "sentences/absence_sentence.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {

template <>
LayerSpec layerSpec<Layer::Reference>() {
  return {.name = "reference",
          .title = QT_TRANSLATE_NOOP("scene", "Reference map"),
          .follows_robot = false,
          .in_all = false,  // it lies in the window alone
          .why_empty = neverEmpty};
}

template <>
LayerSpec layerSpec<Layer::WholeMap>() {
  return {.name = "whole",
          .title = QT_TRANSLATE_NOOP("scene", "Whole map"),
          .shown = false,
          .left_alone = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly,
          .streams = {map::Stream::WholeMap},
          .follows_robot = false,
          .topic_chosen = true,
          .in_all = false,  // --mode decides about it
          .traits =
              [] {
                return LayerTraits{.choice_title = QCoreApplication::translate("scene", "Zoomed out"),
                                   .choices = {QCoreApplication::translate("scene", "Occupied wins"),
                                               QCoreApplication::translate("scene", "Average")}};
              },
          .why_empty =
              [](robot::Robot& robot) {
                return robot.wholeMapSource() || robot.liveTopics()
                           ? QString()
                           : sentences::absenceReason(robot::Capability::WholeMaps,
                                                      robot.unavailableReason(robot::Capability::WholeMaps));
              },
          .legend = [](Legend& legend) { addCells(legend, legend.theme().map); }};
}

}  // namespace mapwright::ui::scene
