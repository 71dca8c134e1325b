// What Autoxing robots answer and send: JSON, binary frames, and submaps down to their cells.
#include "map/catalogue.h"
#include "robot/axbot/device_info.h"
#include "robot/axbot/parse_maps.h"
#include "robot/axbot/parse_topics.h"
#include "submap/submap_store.h"
#include "target.h"

namespace mapwright::fuzz::axbot {
namespace {

using namespace robot::axbot;

void readFrames(std::string_view bytes) {
  use(parseTextFrame(bytes));
  use(rawText("/x", bytes));
  use(parseBinaryFrame(bytes));
  use(rawBinary(bytes));
  const auto frame = unpackBinaryFrame(bytes);
  if (!frame) return;
  MUST(topicOfBinaryFrame(bytes) == frame->topic);
  use(parseBinaryBody(frame->topic, frame->body));
  use(jsonOfBinaryBody(frame->body));
}

void readMaps(std::string_view bytes) {
  const map::MapKey key{map::MapKind::Stored, "1"};
  use(parseMapRows(bytes, map::MapKind::Stored));
  use(parseRunningMapping(bytes));
  use(parseMapDetail(bytes, key));
  use(parseMapFacts(bytes, key));
  use(parseNewId(bytes));
  use(parseCurrentMap(bytes));
  use(parseTrajectories(bytes));
  use(parseLandmarks(bytes));
  use(parseOverlays(bytes));
  use(deviceInfoIn(QByteArray(bytes.data(), qsizetype(bytes.size()))));
}

void read(Input input) {
  Choices from(input);
  const unsigned what = from.byte() % 4;
  const auto held = exactly(from.rest());
  const std::string_view bytes = viewOf(held);
  if (what == 0) readFrames(bytes);
  if (what == 1) readMaps(bytes);
  if (what == 2) use(parseOverview(bytes, 0.05));
  if (what == 3) {
    map::SubmapKey key;
    key.uuid = "u";
    use(submap::decode(parseSubmapResponse(key, bytes)));
  }
}

}  // namespace
}  // namespace mapwright::fuzz::axbot

MAPWRIGHT_FUZZ_TARGET(axbot)
