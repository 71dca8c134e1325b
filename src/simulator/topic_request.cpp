#include "simulator/topic_request.h"

#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostTopicsAtOnce = 256;
constexpr std::size_t kLongestTopic = 255;

/// Appends the topics that a value names; a sentence when it cannot be used.
std::string appendTopics(const Value& value, bool lists_allowed, std::vector<std::string>& topics) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr && value.as<std::string>() == nullptr) return "A topic is a text or a list of texts.";
  if (list != nullptr && !lists_allowed)
    return "A list of topics is not supported by this robot; enable them one by one.";
  for (const Value& one : list != nullptr ? *list : Value::List{value}) {
    if (one.as<std::string>() == nullptr || topics.size() >= kMostTopicsAtOnce)
      return "A list of topics holds something that is no topic.";
    if (one.text().empty() || one.text().size() > kLongestTopic)
      return "A topic's name is empty or too long.";
    topics.push_back(one.text());
  }
  return {};
}

}  // namespace

TopicRequest parseTopicRequest(std::string_view text, bool lists_allowed) {
  TopicRequest request;
  const std::optional<Value> message = fromJson(text);
  if (!message || message->as<Value::Object>() == nullptr) {
    request.problem = "The message is no JSON object.";
  } else if (!message->has("enable_topic") && !message->has("disable_topic")) {
    request.problem = "The message names neither enable_topic nor disable_topic.";
  } else {
    for (const auto& [key, topics] :
         {std::pair("enable_topic", &request.enable), std::pair("disable_topic", &request.disable)}) {
      if (request.problem.empty() && message->has(key))
        request.problem = appendTopics((*message)[key], lists_allowed, *topics);
    }
  }
  return request;
}

}  // namespace mapwright::simulator
