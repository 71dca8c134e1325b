#include "robot/ros/ros_capabilities.h"

#include <utility>

namespace mapwright::robot::ros {

Call Catalogue::list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  return wire::askAcross(
      line_.asker, line_.link, lists_, map::Subject(map::SubjectKind::Catalogue, map::kMapsPart),
      std::move(reply),
      [](RosLink& link, auto errand, auto answer) { link.list(errand, std::move(answer)); });
}

Call Catalogue::describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  return wire::askAcross(
      line_.asker, line_.link, descriptions_, map::subjectOf(key), std::move(reply),
      [key](RosLink& link, auto errand, auto answer) { link.describe(errand, key, std::move(answer)); });
}

Call Catalogue::thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) {
  return wire::endLater<std::string>(
      line_.asker, thumbnails_, std::move(reply),
      tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                       .subject = map::subjectOf(key),
                                       .asked_for = map::AskedFor::SmallPicture,
                                       .reason = map::FailureReason::NotOffered}));
}

Call WholeMaps::fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  return wire::askAcross(
      line_.asker, line_.link, maps_, map::subjectOf(key), std::move(reply),
      [key](RosLink& link, auto errand, auto answer) { link.fetch(errand, key, std::move(answer)); });
}

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

void Topics::setWanted(const map::Streams& streams, const QStringList& topics) {
  QMetaObject::invokeMethod(line_.link,
                            [link = line_.link, streams, topics] { link->setWanted(streams, topics); });
}

void Topics::setBasics(const Basics& basics) {
  QMetaObject::invokeMethod(line_.link, [link = line_.link, basics] { link->setBasics(basics); });
}

void Topics::setWatching(bool on) {
  QMetaObject::invokeMethod(line_.link, [link = line_.link, on] { link->setWatching(on); });
}

}  // namespace mapwright::robot::ros
