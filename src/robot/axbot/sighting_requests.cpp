#include "robot/axbot/sighting_requests.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_maps.h"
#include "robot/wire/net_results.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::axbot {
namespace {

const QString kCollectedPath = QStringLiteral("/collected_data/");
constexpr std::size_t kMostFiles = 50;  // the newest

map::Subject here() { return map::subjectOf({map::MapKind::Live, {}}); }

QString sightPath(Sight what) {
  const QString kinds[] = {QStringLiteral("charger"), QStringLiteral("rack"), QStringLiteral("pallet"),
                           QStringLiteral("trailer")};
  return QStringLiteral("/services/query_pose/%1_pose").arg(kinds[std::size_t(what)]);
}

QString edgeQuery(SightEdge edge) {
  return edge == SightEdge::Front  ? QStringLiteral("ref=center_of_front_edge")
         : edge == SightEdge::Rear ? QStringLiteral("ref=center_of_rear_edge")
                                   : QString();
}

Fault seesNone(Sight what) {
  switch (what) {
    case Sight::Charger:
      return faultText("axbot", "The robot sees no charger here.");
    case Sight::Rack:
      return faultText("axbot", "The robot sees no rack here.");
    case Sight::Pallet:
      return faultText("axbot", "The robot sees no pallet here.");
    case Sight::Trailer:
      break;
  }
  return faultText("axbot", "The robot sees no trailer here.");
}

Outcome<Sighting> sightingOf(const net::HttpAnswer& answer, Sight what) {
  if (!answer.ok()) return fail(wire::failed(answer, here()));
  if (auto refusal = refusalIn(answer, here())) {
    refusal->asked_for = map::AskedFor::All;
    return fail(std::move(*refusal));
  }
  auto sighting = parseSighting(wire::view(answer.body), what);
  if (sighting) return std::move(*sighting);
  // To see none is an answer that can be read.
  const bool none = sighting.error() == seesNone(what);
  if (!none) return fail(wire::misread(answer, here(), std::move(sighting.error())));
  return fail({.kind = map::FailureKind::RejectedByRobot,
               .subject = here(),
               .reason = map::FailureReason::Unfit,
               .cause = std::move(sighting.error())});
}

}  // namespace

QStringList sightingTopics() { return {QStringLiteral("/landmarks"), QStringLiteral("/collected_barcode")}; }

tl::expected<Sighting, Fault> parseSighting(std::string_view body, Sight what) {
  wire::JsonReader reader;
  const auto root = reader.read(body);
  if (!root || !root->is_object()) return refused(fault::SightingUnreadable);
  const auto written = wire::member(*root, {"pose"});
  if (!written) return refused(seesNone(what));
  const auto pose = wire::asPose(*written);
  if (!pose) return refused(fault::SightingUnreadable);
  return Sighting{*pose, wire::text(*root, {"ref"})};
}

tl::expected<CollectedNames, Fault> parseCollectedNames(std::string_view body) {
  wire::JsonReader reader;
  const auto root = reader.read(body);
  const auto rows = root ? wire::asList(*root, {"files"}) : std::nullopt;
  if (!rows) return refused(fault::AnswerIsNoList);
  std::vector<std::pair<std::string, std::string>> found;  // time, name
  for (const wire::Json row : *rows) {
    const bool plain = !row.is_object();
    std::string name = plain ? wire::asText(row) : wire::text(row, {"filename", "name"});
    if (name.empty()) continue;
    found.emplace_back(plain ? std::string() : wire::text(row, {"modified_time"}), std::move(name));
  }
  std::stable_sort(found.begin(), found.end());
  CollectedNames names{{}, found.size() - std::min(found.size(), kMostFiles)};
  found.erase(found.begin(), found.begin() + std::ptrdiff_t(names.older));
  for (auto& [time, name] : found) names.newest.push_back(std::move(name));
  return names;
}

void SightingRequests::look(const Task& task, Sight what, SightEdge edge, OutcomeTo<Sighting> reply) {
  net::HttpRequest request = server_.request(sightPath(what), edgeQuery(edge));
  wire::send(task, server_.http, request,
             [this, task, request, what, reply = std::move(reply)](const net::HttpAnswer& answer) mutable {
               if (!wire::isUnknownThere(answer)) return reply(sightingOf(answer, what));
               // Some firmware wants it as a POST, like other services. It changes nothing either way.
               request.method = net::HttpMethod::Post;
               request.body = "{}";
               wire::send(task, server_.http, request,
                          [what, reply](const net::HttpAnswer& posted) { reply(sightingOf(posted, what)); });
             });
}

struct SightingRequests::Collecting {
  Task task;
  OutcomeTo<CollectedLandmarks> reply;
  std::vector<std::string> names;
  std::size_t next = 0;
  CollectedLandmarks found = {};
};

void SightingRequests::collectedLandmarks(const Task& task, OutcomeTo<CollectedLandmarks> reply) {
  wire::send(task, server_.http, server_.request(kCollectedPath),
             [this, task, reply = std::move(reply)](const net::HttpAnswer& answer) {
               auto names = wire::outcomeOf(answer, here(), parseCollectedNames);
               if (!names) return reply(fail(std::move(names.error())));
               CollectedLandmarks found{{}, names->newest.size(), names->older};
               nextFile(std::make_shared<Collecting>(
                   Collecting{task, reply, std::move(names->newest), 0, std::move(found)}));
             });
}

void SightingRequests::nextFile(const std::shared_ptr<Collecting>& collecting) {
  if (collecting->next == collecting->names.size()) return collecting->reply(std::move(collecting->found));
  const QString path = kCollectedPath + pathSegment(collecting->names[collecting->next++]);
  wire::send(collecting->task, server_.http, server_.request(path),
             [this, collecting](const net::HttpAnswer& answer) {
               if (!answer.ok()) return collecting->reply(fail(wire::failed(answer, here())));
               std::vector<map::Landmark>& found = collecting->found.landmarks;
               for (const map::WholeMap::Landmark& mark : parseLandmarks(wire::view(answer.body))) {
                 if (mark.id.empty()) continue;
                 auto known = std::find_if(found.begin(), found.end(),
                                           [&](const map::Landmark& each) { return each.id == mark.id; });
                 if (known == found.end()) known = found.insert(known, map::Landmark{mark.id, {0, 0}, {}});
                 known->position_m = mark.position_m;
               }
               nextFile(collecting);
             });
}

}  // namespace mapwright::robot::axbot
