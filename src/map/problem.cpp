#include "map/problem.h"

namespace mapwright::map {

std::string toText(const Subject& subject) {
  if (!subject.label.empty()) return subject.label;
  switch (subject.kind) {
    case SubjectKind::Robot:
      return subject.id.empty() ? "Robot" : "Robot " + subject.id;
    case SubjectKind::Map:
      return "Map " + subject.id;
    case SubjectKind::Places:
      return "Navigation points of map " + subject.id;
    case SubjectKind::Overview:
      return "Overview";
    case SubjectKind::SubmapList:
      return "Submap list";
    case SubjectKind::Submap:
      return "Submap " + subject.id;
    case SubjectKind::Topic:
      return "Topic " + subject.id;
    case SubjectKind::Other:
    case SubjectKind::Catalogue:
    case SubjectKind::Condition:
      break;
  }
  return subject.id;
}

}  // namespace mapwright::map
