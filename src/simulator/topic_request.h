// What a client of /ws/v2/topics asks for (docs/protocols/autoxing.md, "Live topics").
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mapwright::simulator {

struct TopicRequest {
  std::vector<std::string> enable, disable;
  std::string problem;  // a sentence when the message cannot be used; then nothing is to be done
};

/// Reads {"enable_topic": ..., "disable_topic": ...}; lists of topics only when `lists_allowed`.
TopicRequest parseTopicRequest(std::string_view text, bool lists_allowed);

}  // namespace mapwright::simulator
