// MCAP and bags of ROS 1, also while they are written: bit 0 of the first byte says that half of the file
// comes after it was opened. And what of their messages is shown and exported.
#include <algorithm>
#include <memory>

#include "recording_reads.h"
#include "robot/recorded/message_fields.h"
#include "target.h"

namespace mapwright::fuzz::recording {
namespace {

using namespace mapwright::recording;
using namespace robot::recorded;

void readMessages(Source& source) {
  MessageFields fields;
  const auto cursor = source.messages({});
  for (int count = 0; count < 200; ++count) {
    const auto message = cursor->next();
    if (!message) return;
    for (const auto whom : {MessageText::For::People, MessageText::For::Programs}) {
      const MessageText text(*message, whom);
      if (isRos(*message->channel, true)) {
        use(text.ofRos(fields.read(*message), fields));
        use(fields.readAsItIs(*message));
      }
      use(text.ofOther(fields.readOther(*message)));
      use(text.ofBytes());
      robot::wire::JsonReader json;
      const std::string_view bytes = text.bytes();
      if (const auto root = json.readKeepingDigits(bytes); root && root->is_object())
        use(text.ofFrame(*root));
    }
  }
}

void read(Input input) {
  Choices from(input);
  const bool grows = (from.byte() & 1) != 0;
  const Input bytes = from.rest();
  const auto held =
      std::make_shared<std::string>(textOf(bytes.first(grows ? bytes.size() / 2 : bytes.size())));
  const auto opened = openRecording(heldBytes(held), smallLimits());
  if (!opened) return;
  readSource(**opened);
  if (grows) {
    held->append(textOf(bytes.subspan(held->size())));
    (*opened)->refresh();
    readSource(**opened);
  }
  readMessages(**opened);
}

}  // namespace
}  // namespace mapwright::fuzz::recording

MAPWRIGHT_FUZZ_TARGET(recording)
