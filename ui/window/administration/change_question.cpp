#include "window/administration/change_question.h"

#include <algorithm>
#include <tuple>

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::window {
namespace {

using robot::MapChange;

class ChangeQuestionText {
  Q_DECLARE_TR_FUNCTIONS(ChangeQuestion)
};

QString called(const map::CatalogueEntry* map) {
  if (!map) return {};
  return map->name.empty() ? QString::fromStdString(map::toText(map->key))
                           : words::plainName(map->name).left(80);
}

void askToLoad(ChangeQuestion& question, const map::CatalogueEntry* map, const map::CatalogueEntry* current) {
  question.ends_something = true;
  question.title = ChangeQuestionText::tr("Load on the robot");
  question.accept = ChangeQuestionText::tr("Load");
  question.done = ChangeQuestionText::tr("The robot works with %1 now.");
  const QString name = called(map);
  question.text =
      current
          ? ChangeQuestionText::tr("The robot will work with %1 instead of %2. What it is doing now may end.")
                .arg(name, called(current))
          : ChangeQuestionText::tr("The robot will work with %1. What it is doing now may end.").arg(name);
}

void askToDelete(ChangeQuestion& question, const map::CatalogueEntry* map) {
  question.ends_something = true;
  question.title = ChangeQuestionText::tr("Delete from the robot");
  question.accept = ChangeQuestionText::tr("Delete");
  question.done = ChangeQuestionText::tr("%1 is deleted.");
  question.text =
      ChangeQuestionText::tr("%1 will be deleted from the robot, with its waypoints. It cannot be had back.")
          .arg(called(map));
  if (map && map->is_current) {
    question.text += QLatin1Char(' ') + ChangeQuestionText::tr("The robot works with it now.");
    question.typed = called(map);
  }
}

}  // namespace

ChangeQuestion questionFor(MapChange change, const map::CatalogueEntry* map,
                           const map::CatalogueEntry* current) {
  ChangeQuestion question;
  question.order.change = change;
  if (map) question.order.key = map->key;
  switch (change) {
    case MapChange::Rename:
      question.title = ChangeQuestionText::tr("Rename on the robot");
      question.text = ChangeQuestionText::tr("What is %1 called from now on?").arg(called(map));
      question.accept = ChangeQuestionText::tr("Rename");
      question.name = map ? QString::fromStdString(map->name) : QString();
      question.done = ChangeQuestionText::tr("It is called %1 now.");
      break;
    case MapChange::Load:
      askToLoad(question, map, current);
      break;
    case MapChange::Archive:
      question.title = ChangeQuestionText::tr("Archive on the robot");
      question.text = ChangeQuestionText::tr("%1 will be put away. It is kept, and can be taken out again.")
                          .arg(called(map));
      question.accept = ChangeQuestionText::tr("Archive");
      question.done = ChangeQuestionText::tr("%1 is archived.");
      break;
    case MapChange::Unarchive:
      question.title = ChangeQuestionText::tr("Take out of the archive");
      question.text = ChangeQuestionText::tr("%1 will be among the robot's maps again.").arg(called(map));
      question.accept = ChangeQuestionText::tr("Take out");
      question.done = ChangeQuestionText::tr("%1 is out of the archive.");
      break;
    case MapChange::Delete:
      askToDelete(question, map);
      break;
    case MapChange::StartMapping:
      question.ends_something = true;
      question.title = ChangeQuestionText::tr("Start mapping");
      question.text =
          current
              ? ChangeQuestionText::tr("The robot will begin a new map and leave %1.").arg(called(current))
              : ChangeQuestionText::tr("The robot will begin a new map.");
      question.accept = ChangeQuestionText::tr("Start mapping");
      question.done = ChangeQuestionText::tr("The robot is mapping.");
      break;
    case MapChange::StopMapping:
      question.ends_something = true;
      question.title = ChangeQuestionText::tr("Stop mapping");
      question.text =
          ChangeQuestionText::tr("The robot will end mapping. Save the map afterwards, or it may be lost.");
      question.accept = ChangeQuestionText::tr("Stop mapping");
      question.done = ChangeQuestionText::tr("Mapping is stopped.");
      break;
    case MapChange::Save:
      question.title = ChangeQuestionText::tr("Save the new map");
      question.text = ChangeQuestionText::tr("What is the map called that has just been made?");
      question.accept = ChangeQuestionText::tr("Save");
      question.name = QString();
      question.done = ChangeQuestionText::tr("The map is kept as %1.");
      break;
  }
  return question;
}

std::vector<std::string> placesToStand(const std::vector<map::Waypoint>& points) {
  const auto tagged = [](const map::Waypoint& point, const char* tag) {
    return std::find(point.tags.begin(), point.tags.end(), tag) != point.tags.end();
  };
  std::vector<std::tuple<int, std::string>> places;
  for (const map::Waypoint& point : points) {
    if (point.name.empty()) continue;
    const bool known = tagged(point, "localisation") || tagged(point, "localization");
    places.emplace_back(known ? 0 : tagged(point, "map_entry") ? 1 : 2, point.name);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::string> names;
  for (auto& [rank, name] : places) names.push_back(std::move(name));
  return names;
}

}  // namespace mapwright::window
