#include "map/catalogue.h"

namespace mapwright::map {
namespace {

constexpr std::size_t kLongestName = 200;  // ids and names are the robot's own

std::string called(const MapKey& key, const std::string& name) {
  if (key.kind == MapKind::File) {
    const std::string& file = name.empty() ? key.id : name;
    return file.empty() ? "File" : "File " + file.substr(0, kLongestName);
  }
  if (!name.empty()) return "Map \"" + name.substr(0, kLongestName) + "\"";
  const std::string id = key.id.substr(0, kLongestName);
  return key.kind == MapKind::Live      ? "Live map"
         : key.kind == MapKind::Mapping ? "Mapping " + id
                                        : "Map " + id;
}

}  // namespace

Subject subjectOf(const MapKey& key, const std::string& name) {
  return {SubjectKind::Map, toText(key), called(key, name)};
}

Subject placesOf(const MapKey& key, const std::string& name) {
  return {SubjectKind::Places, toText(key), "Navigation points of " + called(key, name)};
}

std::string toText(const MapKey& key) {
  switch (key.kind) {
    case MapKind::Live:
      return "live";
    case MapKind::Mapping:
      return "mapping:" + key.id;
    case MapKind::File:
      return key.id.empty() ? "file" : key.id;
    case MapKind::Stored:
      break;
  }
  return key.id;
}

MapKey mapKeyFromText(const std::string& text) {
  if (text == "live") return {MapKind::Live, {}};
  if (text == "file") return {MapKind::File, {}};
  if (text.starts_with("mapping:")) return {MapKind::Mapping, text.substr(8)};
  return {MapKind::Stored, text};
}

}  // namespace mapwright::map
