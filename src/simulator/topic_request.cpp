#include "simulator/topic_request.h"

#include <simdjson.h>

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostTopicsAtOnce = 256;
constexpr std::size_t kLongestTopic = 255;

/// Appends the topics that a value names; a sentence when it cannot be used.
std::string appendTopics(simdjson::dom::element value, bool lists_allowed, std::vector<std::string>& topics) {
  std::string_view name;
  simdjson::dom::array list;
  if (value.get(name) == simdjson::SUCCESS) {
    topics.emplace_back(name);
  } else if (value.get(list) == simdjson::SUCCESS) {
    if (!lists_allowed) return "A list of topics is not supported by this robot; enable them one by one.";
    for (const simdjson::dom::element one : list) {
      if (one.get(name) != simdjson::SUCCESS || topics.size() >= kMostTopicsAtOnce) {
        return "A list of topics holds something that is no topic.";
      }
      topics.emplace_back(name);
    }
  } else {
    return "A topic is a text or a list of texts.";
  }
  for (const std::string& topic : topics) {
    if (topic.empty() || topic.size() > kLongestTopic) return "A topic's name is empty or too long.";
  }
  return {};
}

}  // namespace

TopicRequest parseTopicRequest(std::string_view text, bool lists_allowed) {
  TopicRequest request;
  simdjson::dom::parser parser;
  simdjson::dom::element document, value;
  simdjson::dom::object object;
  if (parser.parse(text.data(), text.size()).get(document) != simdjson::SUCCESS ||
      document.get(object) != simdjson::SUCCESS) {
    request.problem = "The message is no JSON object.";
    return request;
  }
  bool named = false;
  if (object["enable_topic"].get(value) == simdjson::SUCCESS) {
    named = true;
    request.problem = appendTopics(value, lists_allowed, request.enable);
  }
  if (request.problem.empty() && object["disable_topic"].get(value) == simdjson::SUCCESS) {
    named = true;
    request.problem = appendTopics(value, lists_allowed, request.disable);
  }
  if (!named) request.problem = "The message names neither enable_topic nor disable_topic.";
  return request;
}

}  // namespace mapwright::simulator
