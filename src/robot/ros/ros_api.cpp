#include "robot/ros/ros_api.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <QJsonDocument>
#include <QJsonObject>
#include <QPointer>

#include "robot/ros/kabam_messages.h"
#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::Field;

constexpr std::size_t kMostTypes = 1000, kMostFields = 10'000;

/// ROS 2 gives some types by their IDL names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kOfIdl{
    {{"boolean", "bool"}, {"float", "float32"}, {"double", "float64"}, {"octet", "byte"}}};

constexpr std::array<std::string_view, 18> kPlain{
    "bool",  "byte",   "char",    "int8",    "uint8",  "int16",   "uint16", "int32",    "uint32",
    "int64", "uint64", "float32", "float64", "string", "wstring", "time",   "duration", "octet"};

struct Member {
  std::string type, name, array;  // "geometry_msgs/Point", "points", "[]"
};
struct Type {
  std::string name;
  std::vector<Member> members;
};

/// "string<10>" is a "string", "float, 5" a "float".
std::string plainOf(std::string type) {
  type = type.substr(0, type.find_first_of("<,"));
  for (const auto& [idl, plain] : kOfIdl) {
    if (type == idl) return std::string(plain);
  }
  return type;
}

/// "sequence<double, 5>" and "double[5]", where only the type says that it is an array.
Member memberOf(std::string type, std::string name, std::int64_t length) {
  Member member;
  member.name = std::move(name);
  if (length >= 0) member.array = length == 0 ? "[]" : '[' + std::to_string(length) + ']';
  constexpr std::string_view kSequence = "sequence<";
  if (type.starts_with(kSequence)) {
    type = type.substr(kSequence.size(), type.find_last_of('>') - kSequence.size());
    member.array = "[]";
  } else if (const std::size_t bracket = type.find('['); bracket != std::string::npos) {
    member.array = type.substr(bracket);
    type.resize(bracket);
  }
  member.type = plainOf(std::move(type));
  return member;
}

std::optional<Type> typeIn(const Field& told) {
  Type type;
  type.name = told["type"].text();
  std::vector<std::string> names, types;
  std::vector<std::int64_t> lengths;
  told["fieldnames"].each([&](const Field& one) { names.push_back(one.text()); });
  told["fieldtypes"].each([&](const Field& one) { types.push_back(one.text()); });
  told["fieldarraylen"].each([&](const Field& one) { lengths.push_back(one.integer().value_or(-1)); });
  if (type.name.empty() || names.size() != types.size() || names.size() != lengths.size() ||
      names.size() > kMostFields)
    return std::nullopt;
  // ROS 2 gives the names of its own variables: "_header".
  const bool own = std::all_of(names.begin(), names.end(),
                               [](const std::string& name) { return name.size() > 1 && name[0] == '_'; });
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = own ? names[i].substr(1) : names[i];
    if (name.empty() || name == "check_fields") continue;
    type.members.push_back(memberOf(types[i], name, lengths[i]));
  }
  return type;
}

void write(std::string& out, const Type& type) {
  // Some readers reject an empty definition.
  if (type.members.empty()) out += "# no fields\n";
  for (const Member& member : type.members) out += member.type + member.array + ' ' + member.name + '\n';
}

void rule(std::string& out, const std::string& type) {
  out += std::string(80, '=') + "\nMSG: " + type + '\n';
}

using net::rosbridge::CallAnswer;

constexpr std::size_t kMostTopics = 20'000;
constexpr std::chrono::milliseconds kLongestTimeout{30'000};
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

/// null: the robot does not list it.
const Endpoint* findTopic(const RosGraph& found, const std::string& topic) {
  if (!found.topics) return nullptr;
  const auto row = std::find_if(found.topics->begin(), found.topics->end(),
                                [&](const Endpoint& one) { return one.name == topic; });
  return row == found.topics->end() ? nullptr : &*row;
}

}  // namespace

std::optional<RosDefinition> definitionIn(const Field& typedefs) {
  std::vector<Type> types;
  bool fine = true;
  typedefs.each([&](const Field& told) {
    if (!fine || types.size() > kMostTypes) return;
    const std::string name = told["type"].text();
    // Built-in types of ROS 1.
    if (name == "time" || name == "duration") return;
    std::optional<Type> type = typeIn(told);
    fine = type.has_value();
    if (type) types.push_back(std::move(*type));
  });
  if (!fine || types.empty()) return std::nullopt;
  RosDefinition definition;
  std::set<std::string> known(kPlain.begin(), kPlain.end());
  known.insert("Header");
  for (const Type& type : types) known.insert(type.name);
  for (const Type& type : types) {
    for (const Member& member : type.members) {
      if (!known.contains(member.type)) return std::nullopt;
      definition.ros2 |= member.type.starts_with("builtin_interfaces/");
    }
  }
  std::set<std::string> written;
  for (const Type& type : types) {
    if (!written.insert(type.name).second) continue;
    if (written.size() > 1) rule(definition.text, type.name);
    write(definition.text, type);
  }
  return definition;
}

RosDefinition definitionAround(const RosDefinition& inner, const std::string& type, const std::string& name) {
  RosDefinition around{inner.ros2, type + ' ' + name + '\n'};
  rule(around.text, type);
  around.text += inner.text;
  return around;
}

std::optional<std::string> mapManagerIn(const RosGraph& found, const std::string& ns) {
  std::vector<std::string> namespaces;
  const auto add = [&](const std::string& name, std::string_view member) {
    const std::string tail = kManager + std::string(member);
    if (name.ends_with(tail)) namespaces.push_back(name.substr(0, name.size() - member.size()));
  };
  if (found.services) {
    for (const std::string& service : *found.services) add(service, "/load_map");
  }
  if (found.topics) {
    for (const Endpoint& topic : *found.topics) {
      if (topic.type.empty() || plainType(topic.type) == "kabam_msgs/MapList") add(topic.name, "/map_list");
    }
  }
  if (namespaces.empty()) return std::nullopt;
  return *std::min_element(namespaces.begin(), namespaces.end(),
                           [&](const std::string& a, const std::string& b) {
                             const auto rank = [&](const std::string& manager_ns) {
                               return std::tuple(manager_ns != ns + kManager, manager_ns.size(), manager_ns);
                             };
                             return rank(a) < rank(b);
                           });
}

std::string typeOf(const RosGraph& found, const std::string& topic) {
  const Endpoint* const listed = findTopic(found, topic);
  return listed ? listed->type : std::string();
}

bool lists(const RosGraph& found, const std::string& topic) { return findTopic(found, topic) != nullptr; }

std::optional<std::vector<Endpoint>> sentTopics(const RosGraph& found) {
  std::optional<std::vector<Endpoint>> sent = found.topics;
  if (sent) std::erase_if(*sent, [&](const Endpoint& topic) { return found.unsent.contains(topic.name); });
  return sent;
}

RosApi::RosApi(net::rosbridge::Client& client, std::chrono::milliseconds timeout)
    : client_(client), timeout_(timeout) {}

void RosApi::ask(const char* service, const QByteArray& args, net::rosbridge::Client::Reply reply) {
  net::rosbridge::CallRequest request;
  request.service = service;
  request.args = args;
  request.timeout = timeout_;
  client_.call(std::move(request), [self = QPointer<RosApi>(this), reply = std::move(reply),
                                    sent_with = timeout_](const CallAnswer& answer) {
    if (!self) return;
    // A slow one gets more time at the next look, otherwise nothing would ever be known.
    if (answer.kind == CallAnswer::Kind::TimedOut)
      self->timeout_ = std::min(std::max(self->timeout_, sent_with * 2), kLongestTimeout);
    reply(answer);
  });
}

void RosApi::step(const LookPtr& look) {
  if (--look->waits_for > 0) return;
  if (look->found.topics) {
    std::sort(look->found.topics->begin(), look->found.topics->end(),
              [](const Endpoint& a, const Endpoint& b) { return a.name < b.name; });
  }
  if (look->found.services) std::sort(look->found.services->begin(), look->found.services->end());
  look->then(look->found);
}

void RosApi::look(const std::string& ns, const DispatchSettings& dispatch,
                  std::function<void(RosGraph)> then) {
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

void RosApi::askType(const LookPtr& look, const char* kind, const std::string& name,
                     std::function<void(const std::string& type)> then) {
  if (const auto known = types_.find({kind, name}); known != types_.end()) return then(known->second);
  ++look->waits_for;
  ask((std::string("/rosapi/") + kind + "_type").c_str(), withText(kind, name),
      [this, look, kind, name, then = std::move(then)](const CallAnswer& answer) {
        const std::string type = answered(answer) ? answer.values["type"].text() : std::string();
        if (!type.empty()) types_[{kind, name}] = type;
        then(type);
        step(look);
      });
}

void RosApi::askTypes(const LookPtr& look) {
  int asked = 0;
  for (std::size_t i = 0; i < look->found.topics->size(); ++i) {
    const Endpoint& topic = (*look->found.topics)[i];
    if (!topic.type.empty()) {
      askWhoSends(look, topic);
    } else if (types_.contains({"topic", topic.name}) || ++asked <= kMostTypeQuestions) {
      askType(look, "topic", topic.name, [this, look, i](const std::string& type) {
        (*look->found.topics)[i].type = type;
        askWhoSends(look, (*look->found.topics)[i]);
      });
    }
  }
}

void RosApi::askWhoSends(const LookPtr& look, const Endpoint& topic) {
  if (dispatchType(topic.type) != "map_msgs/ProjectedMap") return;
  if (++look->senders_asked > kMostSenderQuestions) return;
  ++look->waits_for;
  countPublishers(topic.name, [this, look, name = topic.name](std::optional<std::size_t> senders) {
    if (senders == std::size_t(0)) look->found.unsent.insert(name);
    step(look);
  });
}

/// A service with the name of a map service may be something else.
void RosApi::askServiceTypes(const LookPtr& look, const std::string& ns, const DispatchSettings& dispatch) {
  look->found.map_services = likeMapServices(*look->found.services, ns);
  // A name given by the user takes precedence over similar ones.
  if (const auto named = dispatch.names.find(DispatchService::Grid); named != dispatch.names.end()) {
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
  for (const std::string& name : names) {
    askType(look, "service", name, [look, name](const std::string& type) {
      if (plainType(type) != "nav_msgs/GetMap") std::erase(look->found.map_services, name);
      for (Endpoint& service : *look->found.dispatch_services) {
        if (service.name == name) service.type = type;
      }
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

void RosApi::probeMapManager(const std::string& manager_ns, std::function<void(std::optional<bool>)> then) {
  // Read-only, whatever service it is.
  ask((manager_ns + "/get_waypoint").c_str(), getWaypointArgs({}),
      [then = std::move(then)](const CallAnswer& answer) {
        then(silent(answer) ? std::nullopt : std::optional(answered(answer)));
      });
}

}  // namespace mapwright::robot::ros

#include "moc_ros_api.cpp"
