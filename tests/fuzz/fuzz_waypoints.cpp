// Files of waypoints: tables, GeoJSON, YAML, and the lists beside local maps.
#include "exchange/file_value.h"
#include "exchange/waypoint_file.h"
#include "exchange/waypoint_table.h"
#include "robot/files/waypoint_file.h"
#include "target.h"

namespace mapwright::fuzz::waypoints {
namespace {

using namespace exchange;

/// What is written is read back the same.
void readRecords(std::string_view text, char separator) {
  const auto records = csvRecords(text, separator);
  if (!records) return;
  for (const CsvRecord& record : *records) {
    MUST(!record.fields.empty());
    const std::string line = csvLine(record.fields, separator) + "\n";
    const auto again = csvRecords(line, separator);
    MUST(again);
    if (line == "\n" || line.starts_with("\xEF\xBB\xBF")) continue;
    MUST(again->size() == 1 && again->front().fields == record.fields);
  }
}

/// A waypoint that is moved in its file is found there, and the others stay.
void readStored(std::string_view text) {
  const auto stored = robot::files::parseWaypoints(text);
  if (!stored || stored->points.empty()) return;
  const map::Waypoint& before = stored->points.front();
  map::Waypoint after = before;
  after.position_m = {1, 2};
  const auto moved = robot::files::patchWaypoints(text, {{before.id, before, after}});
  MUST(moved);
  const auto again = robot::files::parseWaypoints(*moved);
  MUST(again && again->points.size() == stored->points.size());
  for (std::size_t i = 0; i < again->points.size(); ++i) {
    const Eigen::Vector2d at = i == 0 ? after.position_m : stored->points[i].position_m;
    MUST((again->points[i].position_m - at).norm() < 0.01 || again->points[i].position_m == at);
    MUST(again->points[i].id == stored->points[i].id && again->points[i].name == stored->points[i].name);
  }
}

void read(Input input) {
  Choices from(input);
  const unsigned what = from.byte();
  const auto held = exactly(from.rest());
  const std::string_view text = viewOf(held);
  switch (what % 5) {
    case 0:
      use(waypointFormatOf(text));
      use(wantedFromFile(text, WaypointFormat::Table, AngleUnit::Guess));
      use(wantedFromTable(text, shapeOf(text)));
      use(tagsOf(text));
      break;
    case 1:
      use(wantedFromFile(text, WaypointFormat::Json, AngleUnit::Guess));
      break;
    case 2:
      use(wantedFromFile(text, WaypointFormat::Yaml, AngleUnit::Guess));
      break;
    case 3:
      readStored(text);
      break;
    default:
      readRecords(text, (what & 64) != 0 ? '\t' : ',');
  }
}

}  // namespace
}  // namespace mapwright::fuzz::waypoints

MAPWRIGHT_FUZZ_TARGET(waypoints)
