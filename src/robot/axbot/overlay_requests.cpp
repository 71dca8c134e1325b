#include "robot/axbot/overlay_requests.h"

#include <charconv>
#include <utility>

#include "json/json_text.h"
#include "robot/axbot/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

using json::JsonKind;
using json::JsonText;
using json::JsonValue;

const QString kLivePath = QStringLiteral("/ros/map/overlays");
const QString kInUsePath = QStringLiteral("/chassis/current-map");

/// nullopt: the key has no address.
std::optional<QString> addressOf(const map::MapKey& key) {
  if (key.kind == map::MapKind::Live) return kLivePath;
  if (key.kind != map::MapKind::Stored) return std::nullopt;
  return pathOf(QStringLiteral("/maps/"), key.id);
}

/// A string, or a number as written.
std::string plainText(const std::optional<JsonValue>& value) {
  if (!value) return {};
  return value->kind() == JsonKind::String   ? value->string()
         : value->kind() == JsonKind::Number ? std::string(value->text())
                                             : std::string();
}

OverlayText aboutMap(const JsonValue& map) {
  OverlayText about;
  about.map_id = plainText(map.member("id"));
  about.map_uid = plainText(map.member(map.member("uid") ? "uid" : "map_uid"));
  about.map_name = plainText(map.member(map.member("map_name") ? "map_name" : "name"));
  const std::string version = plainText(map.member("overlays_version"));
  int number = 0;
  if (std::from_chars(version.data(), version.data() + version.size(), number).ec == std::errc())
    about.version = number;
  return about;
}

map::Failure noStoredMap(const map::MapKey& key, map::AskedFor asked_for) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = map::subjectOf(key),
          .arguments = {"12"},
          .asked_for = asked_for,
          .reason = map::FailureReason::NoSuchId};
}

}  // namespace

tl::expected<OverlayText, Fault> parseOverlayText(std::string_view map) {
  const auto json = JsonText::read(std::string(map));
  if (!json || !json->root().isObject()) return refused(robot::wire::fault::AnswerIsNoMap);
  JsonValue root = json->root();
  if (!root.member("id") && !root.member("overlays")) {
    if (const auto inner = root.member("data"); inner && inner->isObject()) root = *inner;
  }
  OverlayText found = aboutMap(root);
  if (const auto overlays = root.member("overlays")) {
    switch (overlays->kind()) {
      case JsonKind::String:
        found.text = overlays->string();
        break;
      case JsonKind::Null:
        break;
      default:
        found.text = overlays->text();
    }
  }
  return found;
}

void OverlayRequests::read(const Task& task, const map::MapKey& key, OutcomeTo<OverlayText> reply) {
  if (!addressOf(key)) return reply(fail(noStoredMap(key, map::AskedFor::All)));
  key.kind == map::MapKind::Live ? readLive(task, std::move(reply)) : readStored(task, key, std::move(reply));
}

void OverlayRequests::readStored(const Task& task, const map::MapKey& key, OutcomeTo<OverlayText> reply) {
  wire::send(task, server_.http, server_.request(*addressOf(key)),
             [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               auto told = wire::outcomeOf(answer, map::subjectOf(key), parseOverlayText);
               if (told && !told->map_id.empty() && told->map_id != key.id)
                 return reply(fail(wire::notThere(map::subjectOf(key))));
               reply(std::move(told));
             });
}

void OverlayRequests::readLive(const Task& task, OutcomeTo<OverlayText> reply) {
  wire::send(
      task, server_.http, server_.request(kInUsePath),
      [this, task, reply = std::move(reply)](const net::HttpAnswer& current) {
        OverlayText about;
        if (current.ok()) {
          const auto json = JsonText::read(current.body.toStdString());
          if (json && json->root().isObject()) about = aboutMap(json->root());
        }
        wire::send(
            task, server_.http, server_.request(kLivePath), [about, reply](const net::HttpAnswer& answer) {
              reply(wire::outcomeOf(answer, map::subjectOf({map::MapKind::Live, {}}),
                                    [&about](std::string_view body) -> tl::expected<OverlayText, Fault> {
                                      OverlayText found = about;
                                      found.text = body;
                                      return found;
                                    }));
            });
      });
}

void OverlayRequests::write(const Task& task, const map::MapKey& key, const std::string& text,
                            OutcomeTo<std::monostate> reply) {
  const auto address = addressOf(key);
  if (!address) return reply(fail(noStoredMap(key, map::AskedFor::Change)));
  const bool live = key.kind == map::MapKind::Live;
  net::HttpRequest request = server_.request(*address);
  request.method = live ? net::HttpMethod::Put : net::HttpMethod::Patch;
  request.body = QByteArray::fromStdString(live ? text : R"({"overlays":)" + json::quoted(text) + '}');
  wire::send(task, server_.http, request, [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (!answer.ok()) return reply(fail(wire::failed(answer, map::subjectOf(key), map::AskedFor::Change)));
    if (auto refusal = refusalIn(answer, map::subjectOf(key))) return reply(fail(std::move(*refusal)));
    reply(std::monostate());
  });
}

}  // namespace mapwright::robot::axbot
