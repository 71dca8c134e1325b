#include "replay/chunk.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace mapwright::replay {

std::size_t Chunk::countUntil(double at_s) const {
  const auto end = std::partition_point(order.begin(), order.end(), [&](std::uint32_t index) {
    return source->messages[index].message.received_s <= at_s;
  });
  return std::size_t(end - order.begin());
}

std::size_t Chunk::bytes() const {
  if (!source) return 0;
  // Texts, what was made of them (pictures and clouds shrink), and the values themselves.
  const std::size_t text = source->text ? source->text->size() : 0;
  return text + std::max(text / 2, source->value_bytes) + source->messages.size() * sizeof(robot::BagMessage);
}

Chunk inRange(robot::BagChunkPtr answer) {
  Chunk chunk;
  chunk.from_s = answer->from_s;
  chunk.until_s = answer->until_s;
  std::map<std::pair<std::string_view, std::string_view>, int> at_beginning;  // topic and bytes
  for (std::uint32_t i = 0; i < answer->messages.size(); ++i) {
    const robot::BagMessage& message = answer->messages[i];
    const double stamp_s = message.message.received_s;
    if (stamp_s < chunk.from_s) {
      chunk.back_filled.push_back(i);
    } else if (stamp_s < chunk.until_s) {
      const bool may_be_told_twice = message.latched && stamp_s == chunk.from_s;
      if (may_be_told_twice && ++at_beginning[{message.message.topic, answer->textOf(message)}] == 2)
        continue;
      chunk.order.push_back(i);
    }
  }
  chunk.source = std::move(answer);
  const auto earlier = [&](std::uint32_t a, std::uint32_t b) {
    return chunk.source->messages[a].message.received_s < chunk.source->messages[b].message.received_s;
  };
  std::stable_sort(chunk.order.begin(), chunk.order.end(), earlier);
  std::stable_sort(chunk.back_filled.begin(), chunk.back_filled.end(), earlier);
  return chunk;
}

}  // namespace mapwright::replay
