#include "robot/ros/ros_capabilities.h"

namespace mapwright::robot::ros {

QStringList Topics::known() const {
  QStringList names;
  for (const FoundTopic& topic : known_.offered.value_or(std::vector<FoundTopic>()))
    names << QString::fromStdString(topic.name);
  if (!names.isEmpty()) return names;
  for (const Source& source : known_.sources) names << QString::fromStdString(source.topic);
  names.removeDuplicates();
  return names;
}

QStringList Topics::topicsOf(map::Stream stream) const {
  QStringList names;
  for (const Source& source : sourcesFor(stream, known_.sources)) {
    // Patches are reported under the name of their grid.
    if (source.form != Form::GridPatch) names << QString::fromStdString(source.topic);
  }
  names.removeDuplicates();
  return names;
}

}  // namespace mapwright::robot::ros
