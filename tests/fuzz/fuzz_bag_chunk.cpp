// A range of a bag of an Autoxing robot. Its messages are cut out of the text where that is plain enough, and
// read by the normal reader otherwise: both find the same.
#include "robot/axbot/parse_bags.h"
#include "target.h"

namespace mapwright::fuzz::bag_chunk {
namespace {

using namespace robot;

void mustAgree(const BagChunk& a, const BagChunk& b) {
  MUST(a.messages.size() == b.messages.size());
  MUST(a.without_stamp == b.without_stamp);
  MUST(a.unreadable == b.unreadable);
  for (std::size_t i = 0; i < a.messages.size(); ++i) {
    const auto &one = a.messages[i], &other = b.messages[i];
    MUST(one.message.message.index() == other.message.message.index());
    MUST(one.message.topic == other.message.topic);
    MUST(one.message.received_s == other.message.received_s);
    MUST(one.known == other.known && one.latched == other.latched);
    MUST(one.picture_url == other.picture_url);
    MUST(a.textOf(one) == b.textOf(other));
  }
}

void read(Input input) {
  const std::string text = textOf(input);
  use(axbot::parseBagInfo(text));
  use(axbot::parseBagRows(text, BagKind::Bag));
  use(axbot::parseBagRow(text, BagKind::Recording));
  BagRange range;
  range.from_s = 0;
  range.until_s = 1e10;
  range.max_bytes = 1 << 20;
  const auto chunk = axbot::parseBagChunk(text, range);
  const std::size_t brace = text.find_first_not_of(" \n\r\t");
  if (brace == std::string::npos || text[brace] != '{' || text.find('\0') != std::string::npos) return;
  // An escape in a member that nobody reads sends all of it to the normal reader.
  std::string odd = text;
  odd.insert(brace + 1, "\"_\":\"\\u0041\",");
  const auto normal = axbot::parseBagChunk(odd, range);
  if (chunk && normal) mustAgree(*chunk, *normal);
}

}  // namespace
}  // namespace mapwright::fuzz::bag_chunk

MAPWRIGHT_FUZZ_TARGET(bag_chunk)
