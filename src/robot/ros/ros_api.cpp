#include "robot/ros/ros_api.h"

#include <algorithm>
#include <utility>

#include <QJsonDocument>
#include <QJsonObject>
#include <QPointer>

#include "robot/ros/kabam_messages.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;

constexpr std::size_t kMostTopics = 20'000;
constexpr std::chrono::milliseconds kMostPatience{30'000};
constexpr int kMostTypeQuestions = 300;  // for servers that do not list types
constexpr int kMostSenderQuestions = 2 * kMostProjected;
constexpr const char* kManager = "/map_manager";

QByteArray withText(const char* member, const std::string& text) {
  return QJsonDocument(QJsonObject{{QLatin1String(member), QString::fromStdString(text)}})
      .toJson(QJsonDocument::Compact);
}

bool answered(const CallAnswer& answer) { return answer.kind == CallAnswer::Kind::Answered; }

/// No answer does not mean that there is nothing.
bool silent(const CallAnswer& answer) {
  return answer.kind == CallAnswer::Kind::TimedOut || answer.kind == CallAnswer::Kind::LinkLost ||
         answer.kind == CallAnswer::Kind::Cancelled;
}

std::vector<std::string> textsOf(const Field& list) {
  std::vector<std::string> texts;
  list.each([&](const Field& item) {
    if (texts.size() < kMostTopics) texts.push_back(item.text());
  });
  return texts;
}

}  // namespace

std::optional<std::string> mapManagerIn(const Found& found, const std::string& ns) {
  std::vector<std::string> places;
  const auto add = [&](const std::string& name, std::string_view member) {
    const std::string tail = kManager + std::string(member);
    if (name.ends_with(tail)) places.push_back(name.substr(0, name.size() - member.size()));
  };
  if (found.services) {
    for (const std::string& service : *found.services) add(service, "/load_map");
  }
  if (found.topics) {
    for (const FoundTopic& topic : *found.topics) {
      if (topic.type.empty() || plainType(topic.type) == "kabam_msgs/MapList") add(topic.name, "/map_list");
    }
  }
  if (places.empty()) return std::nullopt;
  return *std::min_element(places.begin(), places.end(), [&](const std::string& a, const std::string& b) {
    const auto rank = [&](const std::string& place) {
      return std::tuple(place != ns + kManager, place.size(), place);
    };
    return rank(a) < rank(b);
  });
}

std::string typeOf(const Found& found, const std::string& topic) {
  if (!found.topics) return {};
  const auto row = std::find_if(found.topics->begin(), found.topics->end(),
                                [&](const FoundTopic& one) { return one.name == topic; });
  return row == found.topics->end() ? std::string() : row->type;
}

bool lists(const Found& found, const std::string& topic) {
  return found.topics && std::any_of(found.topics->begin(), found.topics->end(),
                                     [&](const FoundTopic& one) { return one.name == topic; });
}

std::optional<std::vector<FoundTopic>> sentTopics(const Found& found) {
  std::optional<std::vector<FoundTopic>> sent = found.topics;
  if (sent) std::erase_if(*sent, [&](const FoundTopic& topic) { return found.unsent.contains(topic.name); });
  return sent;
}

RosApi::RosApi(net::rosbridge::Client& client, std::chrono::milliseconds patience)
    : client_(client), patience_(patience) {}

void RosApi::ask(const char* service, const QByteArray& args, net::rosbridge::Client::Reply reply) {
  net::rosbridge::CallRequest request;
  request.service = service;
  request.args = args;
  request.timeout = patience_;
  client_.call(std::move(request), [self = QPointer<RosApi>(this), reply = std::move(reply),
                                    sent_with = patience_](const CallAnswer& answer) {
    if (!self) return;
    // A slow one gets more time at the next look, otherwise nothing would ever be known.
    if (answer.kind == CallAnswer::Kind::TimedOut)
      self->patience_ = std::min(std::max(self->patience_, sent_with * 2), kMostPatience);
    reply(answer);
  });
}

void RosApi::step(const LookPtr& look) {
  if (--look->waits_for > 0) return;
  if (look->found.topics) {
    std::sort(look->found.topics->begin(), look->found.topics->end(),
              [](const FoundTopic& a, const FoundTopic& b) { return a.name < b.name; });
  }
  if (look->found.services) std::sort(look->found.services->begin(), look->found.services->end());
  look->then(look->found);
}

void RosApi::look(const std::string& ns, const DispatchWish& dispatch, std::function<void(Found)> then) {
  const auto look = std::make_shared<Look>();
  look->then = std::move(then);
  look->waits_for = 2;
  ask("/rosapi/topics", "{}", [this, look](const CallAnswer& answer) {
    if (answered(answer) && answer.values["topics"].isList()) {
      const std::vector<std::string> names = textsOf(answer.values["topics"]);
      std::vector<std::string> types = textsOf(answer.values["types"]);
      types.resize(names.size());
      look->found.topics.emplace();
      for (std::size_t i = 0; i < names.size(); ++i) look->found.topics->push_back({names[i], types[i]});
      askTypes(look);
    }
    look->found.topics_silent = silent(answer);
    step(look);
  });
  ask("/rosapi/services", "{}", [this, look, ns, dispatch](const CallAnswer& answer) {
    if (answered(answer) && answer.values["services"].isList()) {
      look->found.services = textsOf(answer.values["services"]);
      askServiceTypes(look, ns, dispatch);
    }
    look->found.services_silent = silent(answer);
    step(look);
  });
}

void RosApi::askTypes(const LookPtr& look) {
  int asked = 0;
  for (FoundTopic& topic : *look->found.topics) {
    if (topic.type.empty()) {
      if (const auto known = types_.find(topic.name); known != types_.end()) topic.type = known->second;
    }
    if (!topic.type.empty()) {
      askWhoSends(look, topic);
      continue;
    }
    if (++asked > kMostTypeQuestions) continue;
    ++look->waits_for;
    ask("/rosapi/topic_type", withText("topic", topic.name),
        [this, look, name = topic.name](const CallAnswer& answer) {
          const std::string type = answered(answer) ? answer.values["type"].text() : std::string();
          if (!type.empty()) types_[name] = type;
          for (FoundTopic& one : *look->found.topics) {
            if (one.name != name) continue;
            one.type = type;
            askWhoSends(look, one);
          }
          step(look);
        });
  }
}

void RosApi::askWhoSends(const LookPtr& look, const FoundTopic& topic) {
  if (dispatchType(topic.type) != "map_msgs/ProjectedMap") return;
  if (++look->senders_asked > kMostSenderQuestions) return;
  ++look->waits_for;
  countPublishers(topic.name, [this, look, name = topic.name](std::optional<std::size_t> senders) {
    if (senders == std::size_t(0)) look->found.unsent.insert(name);
    step(look);
  });
}

/// A service with the name of a map service may be something else.
void RosApi::askServiceTypes(const LookPtr& look, const std::string& ns, const DispatchWish& dispatch) {
  look->found.map_services = likeMapServices(*look->found.services, ns);
  // A name given by the user takes precedence over similar ones.
  if (const auto named = dispatch.names.find(DispatchName::GetMap); named != dispatch.names.end()) {
    const std::vector<std::string>& all = *look->found.services;
    std::erase(look->found.map_services, named->second);
    if (std::find(all.begin(), all.end(), named->second) != all.end())
      look->found.map_services.insert(look->found.map_services.begin(), named->second);
  }
  look->found.dispatch_services.emplace();
  std::vector<std::string> names = likeDispatchServices(*look->found.services, dispatch);
  for (const std::string& name : names) look->found.dispatch_services->push_back({name, {}});
  for (const std::string& name : look->found.map_services) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  const auto judge = [](const LookPtr& of, const std::string& name, const std::string& type) {
    if (plainType(type) != "nav_msgs/GetMap") std::erase(of->found.map_services, name);
    for (TypedService& service : *of->found.dispatch_services) {
      if (service.name == name) service.type = type;
    }
  };
  for (const std::string& name : names) {
    if (const auto known = service_types_.find(name); known != service_types_.end()) {
      judge(look, name, known->second);
      continue;
    }
    ++look->waits_for;
    ask("/rosapi/service_type", withText("service", name),
        [this, look, name, judge](const CallAnswer& answer) {
          const std::string type = answered(answer) ? answer.values["type"].text() : std::string();
          if (!type.empty()) service_types_[name] = type;
          judge(look, name, type);
          step(look);
        });
  }
}

void RosApi::countPublishers(const std::string& topic, std::function<void(std::optional<std::size_t>)> then) {
  ask("/rosapi/publishers", withText("topic", topic), [then = std::move(then)](const CallAnswer& answer) {
    const Field publishers = answered(answer) ? answer.values["publishers"] : Field();
    then(publishers.isList() ? std::optional(publishers.size()) : std::nullopt);
  });
}

void RosApi::define(const std::string& type, std::function<void(std::optional<RosDefinition>)> then) {
  ask("/rosapi/message_details", withText("type", type),
      [type, then = std::move(then)](const CallAnswer& answer) {
        auto definition = answered(answer) ? definitionIn(answer.values["typedefs"]) : std::nullopt;
        if (definition) definition->ros2 |= type.find("/msg/") != std::string::npos;
        then(std::move(definition));
      });
}

void RosApi::probeMapManager(const std::string& place, std::function<void(std::optional<bool>)> then) {
  // Read-only, whatever service it is.
  ask((place + "/get_waypoint").c_str(), getWaypointArgs({}),
      [then = std::move(then)](const CallAnswer& answer) {
        then(silent(answer) ? std::nullopt : std::optional(answered(answer)));
      });
}

}  // namespace mapwright::robot::ros

#include "moc_ros_api.cpp"
