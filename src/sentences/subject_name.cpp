#include "sentences/subject_name.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using map::Subject;
using map::SubjectKind;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Subject)
};

constexpr std::size_t kLongestName = 200;  // ids are the robot's own

QString shortened(const std::string& id) { return QString::fromStdString(id.substr(0, kLongestName)); }

/// Ids of maps say what kind they are: see map::subjectOf.
QString mapName(const Subject& subject) {
  const QString called = QString::fromStdString(subject.label);
  if (subject.id.starts_with("file:")) {
    const QString file = called.isEmpty() ? shortened(subject.id.substr(5)) : called;
    return file.isEmpty() ? Words::tr("File") : Words::tr("File %1").arg(file);
  }
  if (!called.isEmpty()) return Words::tr("Map \"%1\"").arg(called);
  if (subject.id == "live") return Words::tr("Live map");
  if (subject.id.starts_with("mapping:")) return Words::tr("Mapping %1").arg(shortened(subject.id.substr(8)));
  return Words::tr("Map %1").arg(shortened(subject.id));
}

QString partName(const std::string& part) {
  if (part == map::kMapsPart) return Words::tr("Maps");
  if (part == map::kMappingsPart) return Words::tr("Mappings");
  if (part == map::kCurrentMapPart) return Words::tr("Current map");
  if (part == map::kBagsPart) return Words::tr("Bags");
  if (part == map::kRecordingsPart) return Words::tr("Recordings");
  return shortened(part);
}

QString conditionName(const std::string& id) {
  if (id == "emergency-stop") return Words::tr("Emergency stop");
  if (id == "position-lost") return Words::tr("Lost position");
  if (id == "wheels-released") return Words::tr("Released wheels");
  if (id == "manual-control") return Words::tr("Manual control");
  if (id == "position-uncertain") return Words::tr("Uncertain position");
  if (id == "wheels-slipping") return Words::tr("Slipping wheels");
  if (id == "alert") return Words::tr("Alert");
  if (id.starts_with("alert:")) return Words::tr("Alert %1").arg(shortened(id.substr(6)));
  return shortened(id);
}

}  // namespace

QString nameOf(const Subject& subject) {
  const QString id = QString::fromStdString(subject.id);
  switch (subject.kind) {
    case SubjectKind::Robot:
      return id.isEmpty() ? Words::tr("Robot") : Words::tr("Robot %1").arg(id);
    case SubjectKind::Map:
      return mapName(subject);
    case SubjectKind::Places:
      return Words::tr("Waypoints of %1").arg(mapName(subject));
    case SubjectKind::Overview:
      return Words::tr("Overview");
    case SubjectKind::SubmapList:
      return Words::tr("Submap list");
    case SubjectKind::Submap:
      return Words::tr("Submap %1").arg(id);
    case SubjectKind::SubmapMemory:
      return Words::tr("Memory for submaps");
    case SubjectKind::Topic:
      return Words::tr("Topic %1").arg(id);
    case SubjectKind::DiskCache:
      return Words::tr("Disk cache");
    case SubjectKind::Bag:
      return Words::tr("Bag %1").arg(shortened(subject.id));
    case SubjectKind::Catalogue:
      return partName(subject.id);
    case SubjectKind::Condition:
      return conditionName(subject.id);
    case SubjectKind::Other:
      break;
  }
  return id;
}

}  // namespace mapwright::sentences
