#include "robot/axbot/transfer_requests.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QJsonDocument>
#include <QJsonObject>

#include "robot/axbot/faults.h"
#include "robot/axbot/resumed_download.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

const QString kAllMapsPath = QStringLiteral("/maps/");

QJsonValue base64Of(const std::shared_ptr<const std::string>& bytes) {
  if (!bytes) return QString();
  const auto view = QByteArray::fromRawData(bytes->data(), qsizetype(bytes->size()));
  return QString::fromLatin1(view.toBase64());
}

QByteArray identityOf(const MapFacts& facts) {
  if (facts.uid.empty() || !facts.map_version || !facts.data_bytes) return {};
  return QByteArray::fromStdString(facts.uid).simplified() + ' ' + QByteArray::number(*facts.map_version) +
         ' ' + QByteArray::number(qlonglong(*facts.data_bytes));
}

map::Failure noStoredMapOf(const map::MapKey& key) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = map::subjectOf(key),
          .arguments = {"12"},
          .reason = map::FailureReason::NoSuchId};
}

std::optional<QString> storedPath(const map::MapKey& key) {
  return key.kind == map::MapKind::Stored ? pathOf(kAllMapsPath, key.id) : std::nullopt;
}

}  // namespace

struct TransferRequests::Addition {
  Task task;
  NewMap map;
  OutcomeTo<MapParts> reply;
  std::set<std::string> ids_before = {};
  map::Subject subject() const { return {map::SubjectKind::Map, {}, map.name}; }
};

void TransferRequests::facts(const Task& task, const map::MapKey& key, OutcomeTo<MapFacts> reply) {
  const auto path = storedPath(key);
  if (!path) return reply(fail(noStoredMapOf(key)));
  wire::send(task, server_.http, server_.request(*path),
             [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               reply(wire::outcomeOf(answer, map::subjectOf(key),
                                     [&](std::string_view body) { return parseMapFacts(body, key); }));
             });
}

void TransferRequests::parts(const Task& task, const map::MapKey& key, OutcomeTo<MapParts> reply) {
  facts(task, key, [this, task, key, reply = std::move(reply)](Outcome<MapFacts> facts) {
    if (!facts) return reply(fail(std::move(facts.error())));
    maps_.fetch(task, key, [facts = std::move(*facts), reply](Outcome<map::WholeMap> whole) mutable {
      if (!whole) return reply(fail(std::move(whole.error())));
      facts.grid = whole->grid;
      reply(MapParts{std::move(facts), whole->bytes});
    });
  });
}

void TransferRequests::download(const Task& task, const MapFacts& of, const QString& path,
                                OutcomeTo<DataDownload> reply) {
  const auto from = storedPath(of.key);
  if (!from) return reply(fail(noStoredMapOf(of.key)));
  downloadResumed(task, server_.http,
                  {.request = server_.request(*from + QStringLiteral(".pbstream")),
                   .subject = map::subjectOf(of.key, of.name),
                   .path = path,
                   .identity = identityOf(of),
                   .told_bytes = of.data_bytes,
                   .exactly = true},
                  [this, task, of, path, reply = std::move(reply)](Outcome<ResumedDownload> done) {
                    if (!done) return reply(fail(std::move(done.error())));
                    // Another map under the same id is not what was asked for.
                    facts(task, of.key, [of, path, done = *done, reply](Outcome<MapFacts> now) {
                      if (!now) return reply(fail(std::move(now.error())));
                      const bool same = now->uid == of.uid && now->map_version == of.map_version &&
                                        now->data_bytes == of.data_bytes;
                      if (!same) {
                        return reply(fail(map::Failure{.kind = map::FailureKind::Conflict,
                                                       .subject = map::subjectOf(of.key, of.name),
                                                       .reason = map::FailureReason::Unfit,
                                                       .cause = {fault::ChangedMeanwhile}}));
                      }
                      reply(DataDownload{path, done.bytes, done.resumed});
                    });
                  });
}

void TransferRequests::add(const Task& task, const NewMap& map, OutcomeTo<MapParts> reply) {
  const auto addition = std::make_shared<Addition>(Addition{task, map, std::move(reply)});
  maps_.listAll(task, [this, addition](Outcome<std::vector<map::CatalogueEntry>> list) {
    if (!list) {
      list.error().asked_for = map::AskedFor::Addition;
      return addition->reply(fail(std::move(list.error())));
    }
    for (const map::CatalogueEntry& entry : *list) {
      if (entry.key.kind != map::MapKind::Stored) continue;
      addition->ids_before.insert(entry.key.id);
      if (addition->map.uid.empty() || entry.uid != addition->map.uid) continue;
      return addition->reply(
          fail(map::Failure{.kind = map::FailureKind::Conflict,
                            .subject = addition->subject(),
                            .asked_for = map::AskedFor::Addition,
                            .reason = map::FailureReason::Unfit,
                            .cause = {faultText("axbot", "the robot already has this map: %2 (id %1)"),
                                      {entry.key.id, entry.name}}}));
    }
    send(addition);
  });
}

void TransferRequests::send(const AdditionPtr& addition) {
  const NewMap& map = addition->map;
  QJsonObject body{{QStringLiteral("map_name"), QString::fromStdString(map.name)},
                   {QStringLiteral("grid_origin_x"), map.grid.origin.x_m},
                   {QStringLiteral("grid_origin_y"), map.grid.origin.y_m},
                   {QStringLiteral("grid_resolution"), map.grid.resolution_m},
                   {QStringLiteral("occupancy_grid"), base64Of(map.picture)},
                   {QStringLiteral("carto_map"), base64Of(map.data)}};
  if (!map.overlays.empty()) body[QStringLiteral("overlays")] = QString::fromStdString(map.overlays);
  if (!map.uid.empty()) body[QStringLiteral("uid")] = QString::fromStdString(map.uid);
  if (map.map_version) body[QStringLiteral("map_version")] = *map.map_version;
  if (map.overlays_version) body[QStringLiteral("overlays_version")] = *map.overlays_version;
  net::HttpRequest request = server_.request(kAllMapsPath);
  request.method = net::HttpMethod::Post;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  const auto onAnswer = [this, addition](const net::HttpAnswer& answer) {
    if (answer.ok()) {
      auto refusal = refusalIn(answer, addition->subject());
      const std::string id = refusal ? std::string() : parseNewId(wire::view(answer.body));
      return findNew(addition, id, std::move(refusal));
    }
    map::Failure failure = wire::failed(answer, addition->subject(), map::AskedFor::Addition);
    if (!answer.sent || failure.kind == map::FailureKind::Cancelled)
      return addition->reply(fail(std::move(failure)));
    if (failure.applied != map::Applied::No) failure.applied = map::Applied::Maybe;
    findNew(addition, {}, std::move(failure));
  };
  wire::send(addition->task, server_.http, std::move(request), onAnswer, true);
}

void TransferRequests::findNew(const AdditionPtr& addition, const std::string& told_id,
                               std::optional<map::Failure> doubt) {
  maps_.listAll(addition->task,
                [this, addition, told_id, doubt](Outcome<std::vector<map::CatalogueEntry>> list) {
                  if (!list) {
                    map::Failure failure = doubt ? *doubt : std::move(list.error());
                    failure.asked_for = map::AskedFor::Addition;
                    failure.applied = map::Applied::Maybe;
                    return addition->reply(fail(std::move(failure)));
                  }
                  const map::CatalogueEntry* found = nullptr;
                  for (const map::CatalogueEntry& entry : *list) {
                    if (entry.key.kind != map::MapKind::Stored || addition->ids_before.contains(entry.key.id))
                      continue;
                    const bool is = !told_id.empty()             ? entry.key.id == told_id
                                    : !addition->map.uid.empty() ? entry.uid == addition->map.uid
                                                                 : entry.name == addition->map.name;
                    if (is) found = &entry;
                  }
                  if (!found) {
                    if (doubt) return addition->reply(fail(*doubt));
                    return addition->reply(fail(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                                             .subject = addition->subject(),
                                                             .asked_for = map::AskedFor::Addition,
                                                             .reason = map::FailureReason::Unfit,
                                                             .cause = wire::fault::NotListedYet}));
                  }
                  readBack(addition, found->key);
                });
}

void TransferRequests::readBack(const AdditionPtr& addition, const map::MapKey& key) {
  parts(addition->task, key, [this, addition, key](Outcome<MapParts> now) {
    if (now) return addition->reply(std::move(now));
    map::Failure failure = std::move(now.error());
    failure.asked_for = map::AskedFor::Addition;
    failure.applied = map::Applied::Yes;  // it is listed
    // That it sends no picture of it is how it keeps the map.
    facts(addition->task, key, [addition, failure](Outcome<MapFacts> told) {
      if (told) return addition->reply(MapParts{std::move(*told), nullptr});
      addition->reply(fail(failure));
    });
  });
}

}  // namespace mapwright::robot::axbot
