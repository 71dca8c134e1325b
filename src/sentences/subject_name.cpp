#include "sentences/subject_name.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using map::Subject;
using map::SubjectKind;

class SubjectText {
  Q_DECLARE_TR_FUNCTIONS(Subject)
};

constexpr std::size_t kLongestName = 200;  // ids are the robot's own

QString shortened(const std::string& id) { return QString::fromStdString(id.substr(0, kLongestName)); }

/// Ids of maps say what kind they are: see map::subjectOf.
QString mapName(const Subject& subject) {
  const QString called = QString::fromStdString(subject.label);
  if (subject.id.starts_with("file:")) {
    const QString file = called.isEmpty() ? shortened(subject.id.substr(5)) : called;
    return file.isEmpty() ? SubjectText::tr("File") : SubjectText::tr("File %1").arg(file);
  }
  if (!called.isEmpty()) return SubjectText::tr("Map \"%1\"").arg(called);
  if (subject.id == "live") return SubjectText::tr("Live map");
  if (subject.id.starts_with("mapping:"))
    return SubjectText::tr("Mapping %1").arg(shortened(subject.id.substr(8)));
  return SubjectText::tr("Map %1").arg(shortened(subject.id));
}

QString partName(const std::string& part) {
  if (part == map::kMapsPart) return SubjectText::tr("Maps");
  if (part == map::kMappingsPart) return SubjectText::tr("Mappings");
  if (part == map::kCurrentMapPart) return SubjectText::tr("Current map");
  if (part == map::kBagsPart) return SubjectText::tr("Bags");
  if (part == map::kRecordingsPart) return SubjectText::tr("Recordings");
  return shortened(part);
}

QString conditionName(const std::string& id) {
  if (id == "emergency-stop") return SubjectText::tr("Emergency stop");
  if (id == "position-lost") return SubjectText::tr("Lost position");
  if (id == "wheels-released") return SubjectText::tr("Released wheels");
  if (id == "manual-control") return SubjectText::tr("Manual control");
  if (id == "position-uncertain") return SubjectText::tr("Uncertain position");
  if (id == "wheels-slipping") return SubjectText::tr("Slipping wheels");
  if (id == "alert") return SubjectText::tr("Alert");
  if (id.starts_with("alert:")) return SubjectText::tr("Alert %1").arg(shortened(id.substr(6)));
  return shortened(id);
}

}  // namespace

QString nameOf(const Subject& subject) {
  const QString id = QString::fromStdString(subject.id);
  switch (subject.kind) {
    case SubjectKind::Robot:
      return id.isEmpty() ? SubjectText::tr("Robot") : SubjectText::tr("Robot %1").arg(id);
    case SubjectKind::Map:
      return mapName(subject);
    case SubjectKind::Places:
      return SubjectText::tr("Waypoints of %1").arg(mapName(subject));
    case SubjectKind::Overview:
      return SubjectText::tr("Overview");
    case SubjectKind::SubmapList:
      return SubjectText::tr("Submap list");
    case SubjectKind::Submap:
      return SubjectText::tr("Submap %1").arg(id);
    case SubjectKind::SubmapMemory:
      return SubjectText::tr("Memory for submaps");
    case SubjectKind::Topic:
      return SubjectText::tr("Topic %1").arg(id);
    case SubjectKind::DiskCache:
      return SubjectText::tr("Disk cache");
    case SubjectKind::Bag:
      return SubjectText::tr("Bag %1").arg(shortened(subject.id));
    case SubjectKind::Catalogue:
      return partName(subject.id);
    case SubjectKind::Condition:
      return conditionName(subject.id);
    case SubjectKind::Other:
      return SubjectText::tr(subject.id.c_str());  // the program has named some of them itself
  }
  return id;
}

}  // namespace mapwright::sentences
