#include "map/catalogue.h"

#include <algorithm>

namespace mapwright::map {
namespace {

constexpr std::size_t kLongestName = 200;  // names come from the robot

std::string identityOf(const MapKey& key) {
  return key.kind == MapKind::File ? "file:" + key.id : toText(key);
}

}  // namespace

Subject subjectOf(const MapKey& key, const std::string& name) {
  return {SubjectKind::Map, identityOf(key), name.substr(0, kLongestName)};
}

Subject placesOf(const MapKey& key, const std::string& name) {
  return {SubjectKind::Places, identityOf(key), name.substr(0, kLongestName)};
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

const CatalogueEntry* entryOf(const std::vector<CatalogueEntry>& entries, const MapKey& key) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& row) { return row.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

const CatalogueEntry* currentOf(const std::vector<CatalogueEntry>& entries) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [](const auto& row) { return row.is_current; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace mapwright::map
