#include "ui/maps/change_question.h"

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
  question.done = ChangeQuestionText::tr("The robot now uses %1.");
  const QString name = called(map);
  question.text =
      current
          ? ChangeQuestionText::tr("The robot will switch from %2 to %1. Its current task may be aborted.")
                .arg(name, called(current))
          : ChangeQuestionText::tr("The robot will switch to %1. Its current task may be aborted.").arg(name);
}

void askToDelete(ChangeQuestion& question, const map::CatalogueEntry* map) {
  question.ends_something = true;
  question.title = ChangeQuestionText::tr("Delete from the robot");
  question.accept = ChangeQuestionText::tr("Delete");
  question.done = ChangeQuestionText::tr("%1 was deleted.");
  question.text =
      ChangeQuestionText::tr("This deletes %1 and its waypoints from the robot. It cannot be undone.")
          .arg(called(map));
  if (map && map->is_current) {
    question.text += QLatin1Char(' ') + ChangeQuestionText::tr("The robot is using it now.");
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
      question.text = ChangeQuestionText::tr("What should %1 be called?").arg(called(map));
      question.accept = ChangeQuestionText::tr("Rename");
      question.name = map ? QString::fromStdString(map->name) : QString();
      question.done = ChangeQuestionText::tr("It is now called %1.");
      break;
    case MapChange::Load:
      askToLoad(question, map, current);
      break;
    case MapChange::Archive:
      question.title = ChangeQuestionText::tr("Archive on the robot");
      question.text = ChangeQuestionText::tr("%1 will be archived. It is not deleted and can be restored.")
                          .arg(called(map));
      question.accept = ChangeQuestionText::tr("Archive");
      question.done = ChangeQuestionText::tr("%1 was archived.");
      break;
    case MapChange::Unarchive:
      question.title = ChangeQuestionText::tr("Restore from the archive");
      question.text =
          ChangeQuestionText::tr("%1 will be listed among the robot's maps again.").arg(called(map));
      question.accept = ChangeQuestionText::tr("Restore");
      question.done = ChangeQuestionText::tr("%1 was restored from the archive.");
      break;
    case MapChange::Delete:
      askToDelete(question, map);
      break;
    case MapChange::StartMapping:
      question.ends_something = true;
      question.title = ChangeQuestionText::tr("Start mapping");
      question.text =
          current
              ? ChangeQuestionText::tr("The robot will leave %1 and start a new map.").arg(called(current))
              : ChangeQuestionText::tr("The robot will start a new map.");
      question.accept = ChangeQuestionText::tr("Start mapping");
      question.done = ChangeQuestionText::tr("The robot is mapping.");
      break;
    case MapChange::StopMapping:
      question.ends_something = true;
      question.title = ChangeQuestionText::tr("Stop mapping");
      question.text =
          ChangeQuestionText::tr("The robot will stop mapping. Save the map afterwards, or it may be lost.");
      question.accept = ChangeQuestionText::tr("Stop mapping");
      question.done = ChangeQuestionText::tr("Mapping has stopped.");
      break;
    case MapChange::Save:
      question.title = ChangeQuestionText::tr("Save the new map");
      question.text = ChangeQuestionText::tr("What should the new map be called?");
      question.accept = ChangeQuestionText::tr("Save");
      question.name = QString();
      question.done = ChangeQuestionText::tr("The map was saved as %1.");
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
