#include "robot/axbot/map_requests.h"

#include <optional>
#include <tuple>

#include <QJsonDocument>

#include "robot/axbot/faults.h"
#include "robot/axbot/robot_urls.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/net_results.h"
#include "robot/wire/picture_bytes.h"
#include "words/shortened.h"

namespace mapwright::robot::axbot {
namespace {

const QString kCurrentMapPath = QStringLiteral("/chassis/current-map");

QString folderOf(map::MapKind kind) {
  return kind == map::MapKind::Mapping ? QStringLiteral("/mappings/") : QStringLiteral("/maps/");
}

/// nullopt: the key has no address.
std::optional<QString> addressFor(const map::MapKey& key) {
  if (key.kind != map::MapKind::Stored && key.kind != map::MapKind::Mapping) return std::nullopt;
  return pathOf(folderOf(key.kind), key.id);
}

std::optional<QUrl> thumbnailUrl(const QUrl& base, const map::MapKey& key) {
  const auto address = addressFor(key);
  if (!address) return std::nullopt;
  return urlOnRobot(base, *address + QStringLiteral("/thumbnail"));
}

/// It cannot be requested at all.
map::Failure unasked(const map::MapKey& key) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = map::subjectOf(key),
          .arguments = {"12, mapping:48"},
          .reason = map::FailureReason::NoSuchId};
}

}  // namespace

struct MapRequests::Listing {
  std::vector<map::CatalogueEntry> maps, mappings;
  CurrentMap current;
  int open = 3;
  bool all = false;                    // a part that cannot be read is a failure
  std::vector<map::Failure> failures;  // of the two lists
  OutcomeTo<std::vector<map::CatalogueEntry>> reply;
};

struct MapRequests::Fetch {
  Task task;
  map::WholeMap map;
  QUrl usual_picture;  // its address if the robot gives none, or a wrong one
  int open = 0;
  std::optional<map::Failure> failure;
  OutcomeTo<map::WholeMap> reply;

  void finishPart() {
    if (--open > 0) return;
    if (failure) {
      reply(tl::make_unexpected(*failure));
    } else {
      reply(std::move(map));
    }
  }
};

void MapRequests::getJson(const Task& task, const QString& path, Reply reply) {
  wire::send(task, server_.http, server_.request(path), std::move(reply));
}

void MapRequests::getList(const Task& task, const QString& path, Reply reply) {
  getJson(task, path, [this, task, path, reply = std::move(reply)](const net::HttpAnswer& answer) {
    wire::isUnknownThere(answer) ? getJson(task, path.chopped(1), reply) : reply(answer);
  });
}

void MapRequests::getPicture(const Task& task, const QUrl& url, Reply reply) {
  const auto finish = [this, url, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (answer.ok() && answer.body.isEmpty()) server_.http.discard(url);
    reply(answer);
  };
  wire::send(task, server_.http, server_.pictureRequest(url), finish, true);
}

void MapRequests::list(const Task& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  fill(task, listing);
}

void MapRequests::listAll(const Task& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  listing->all = true;
  fill(task, listing);
}

void MapRequests::fill(const Task& task, const std::shared_ptr<Listing>& listing) {
  getList(task, QStringLiteral("/maps/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Stored);
    finishPart(*listing);
  });
  getList(task, QStringLiteral("/mappings/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Mapping);
    finishPart(*listing);
  });
  getJson(task, kCurrentMapPath, [this, listing](const net::HttpAnswer& answer) {
    const map::Subject subject(map::SubjectKind::Catalogue, map::kCurrentMapPart);
    if (answer.ok()) listing->current = parseCurrentMap(wire::view(answer.body));
    // Some firmware answers 404 if there is no current map.
    if (answer.ok() || wire::isUnknownThere(answer)) {
      server_.recovered({subject});
    } else if (answer.kind != net::HttpAnswer::Kind::Cancelled) {
      server_.report(map::problemOf(wire::failed(answer, subject), map::Severity::Warning));
    }
    finishPart(*listing);
  });
}

void MapRequests::addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind) {
  const bool maps = kind == map::MapKind::Stored;
  const map::Subject subject(map::SubjectKind::Catalogue, maps ? map::kMapsPart : map::kMappingsPart);
  // Firmware without mapping has no such list: there are none.
  if (!maps && wire::isUnknownThere(answer)) {
    server_.recovered({subject});
    return;
  }
  auto rows =
      wire::outcomeOf(answer, subject, [kind](std::string_view body) { return parseMapRows(body, kind); });
  if (!rows) {
    listing.failures.push_back(std::move(rows.error()));
    return;
  }
  server_.recovered({subject});
  if (rows->without_id > 0) {
    server_.report({map::Severity::Warning,
                    subject,
                    {robot::wire::fault::RowsWithoutId, {rows->without_id}},
                    map::ProblemCode::Odd});
  }
  (maps ? listing.maps : listing.mappings) = std::move(rows->entries);
}

void MapRequests::finishPart(Listing& listing) {
  if (--listing.open > 0) return;
  for (const map::Failure& failure : listing.failures) {
    // The other parts are not needed either.
    if (failure.kind == map::FailureKind::Cancelled) {
      listing.reply(fail(failure));
      return;
    }
  }
  // Mappings alone are worth showing; an empty list although maps failed would be wrong.
  const bool nothing = listing.maps.empty() && listing.mappings.empty();
  if (!listing.failures.empty() && (listing.all || nothing || listing.failures.size() == 2)) {
    listing.reply(fail(listing.failures.front()));
    return;
  }
  for (const map::Failure& failure : listing.failures)
    server_.report(map::problemOf(failure, map::Severity::Warning));
  std::vector<map::CatalogueEntry> all = std::move(listing.maps);
  int index = 0;
  for (map::CatalogueEntry& entry : all) {
    entry.is_current = listing.current.is(entry);
    entry.index = index++;
  }
  for (map::CatalogueEntry& entry : listing.mappings) {
    entry.index = index++;
    all.push_back(std::move(entry));
  }
  listing.reply(std::move(all));
}

void MapRequests::detail(const Task& task, const map::MapKey& key, OutcomeTo<MapDetail> reply) {
  const auto address = addressFor(key);
  if (!address) return reply(fail(unasked(key)));
  getJson(task, *address, [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    const auto parse = [&key](std::string_view body) { return parseMapDetail(body, key); };
    reply(wire::outcomeOf(answer, map::subjectOf(key), parse));
  });
}

void MapRequests::describe(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  detail(task, key, [key, reply = std::move(reply)](const Outcome<MapDetail>& detail) {
    // "01" may bring the map 1, and mean all of them elsewhere.
    if (detail && detail->entry.key != key) return reply(fail(wire::notThere(map::subjectOf(key))));
    reply(detail.map([](const MapDetail& known) { return known.entry; }));
  });
}

void MapRequests::thumbnail(const Task& task, const map::MapKey& key, OutcomeTo<std::string> reply) {
  const auto url = thumbnailUrl(server_.base, key);
  if (!url) return reply(fail(unasked(key)));
  getPicture(task, *url, [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    reply(pictureOf(answer, map::subjectOf(key), map::AskedFor::SmallPicture).map([](const auto& picture) {
      return *picture;
    }));
  });
}

void MapRequests::discardThumbnail(const map::MapKey& key) {
  if (const auto url = thumbnailUrl(server_.base, key)) server_.http.discard(*url);
}

void MapRequests::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) server_.http.discard(url);
}

void MapRequests::fetch(const Task& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  auto fetch = std::make_shared<Fetch>();
  fetch->task = task;
  fetch->reply = std::move(reply);
  fetch->map.key = key;
  detail(task, key, [this, fetch](const Outcome<MapDetail>& detail) {
    if (!detail) {
      fetch->reply(fail(detail.error()));
    } else if (const auto why = map::unusableReason(detail->grid)) {
      fetch->reply(fail(wire::unfit(map::subjectOf(fetch->map.key), *why)));
    } else {
      fetchParts(fetch, *detail);
    }
  });
}

void MapRequests::fetchParts(const std::shared_ptr<Fetch>& fetch, const MapDetail& detail) {
  const map::MapKey& key = fetch->map.key;
  fetch->map.name = detail.entry.name;
  fetch->map.grid = detail.grid;
  fetch->map.overlays = detail.overlays;
  fetch->map.broken_overlays = detail.broken_overlays;
  if (!detail.overlays_readable) {
    fetch->map.notes.push_back({map::Severity::Warning,
                                map::subjectOf(fetch->map.key),
                                {fault::MemberIsNoList, {"overlays"}},
                                map::ProblemCode::Odd});
  }
  fetch->usual_picture = urlOnRobot(server_.base, *addressFor(key) + QStringLiteral(".png"));
  const bool mapping = key.kind == map::MapKind::Mapping;
  fetch->open = mapping ? 3 : 1;
  const QUrl given = robotUrl(server_.base, detail.image_url);
  fetchPicture(fetch, given.isValid() ? given : fetch->usual_picture);
  if (!mapping) return;
  fetchExtra(fetch, detail.trajectories_url, QStringLiteral("trajectories.json"),
             [](map::WholeMap& map, std::string_view body) { map.trajectories = parseTrajectories(body); });
  fetchExtra(fetch, detail.landmarks_url, QStringLiteral("landmarks.json"),
             [](map::WholeMap& map, std::string_view body) { map.landmarks = parseLandmarks(body); });
}

void MapRequests::fetchPicture(const std::shared_ptr<Fetch>& fetch, const QUrl& url) {
  getPicture(fetch->task, url, [this, fetch, url](const net::HttpAnswer& answer) {
    if (wire::isUnknownThere(answer) && url != fetch->usual_picture) {
      fetchPicture(fetch, fetch->usual_picture);
      return;
    }
    auto picture = pictureOf(answer, map::subjectOf(fetch->map.key));
    if (!picture) {
      fetch->failure = std::move(picture.error());
    } else {
      fetch->map.bytes = std::move(*picture);
      fetch->map.fingerprint = wire::fingerprint(*fetch->map.bytes);
      fetch->map.body_bytes = fetch->map.bytes->size();
      fetch->map.from_cache = answer.from_cache;
      origins_.remember(fetch->map.fingerprint, url);
      if (const auto size = wire::pngSize(*fetch->map.bytes))
        std::tie(fetch->map.grid.width, fetch->map.grid.height) = *size;
    }
    fetch->finishPart();
  });
}

void MapRequests::fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url,
                             const QString& file, std::function<void(map::WholeMap&, std::string_view)> add) {
  net::HttpRequest request = server_.request(*addressFor(fetch->map.key) + QLatin1Char('/') + file);
  if (const QUrl given = robotUrl(server_.base, given_url); given.isValid()) request.url = given;
  wire::send(fetch->task, server_.http, request,
             [fetch, file, add = std::move(add)](const net::HttpAnswer& answer) {
               if (answer.ok()) {
                 add(fetch->map, wire::view(answer.body));
               } else {
                 fetch->map.notes.push_back({map::Severity::Info,
                                             map::subjectOf(fetch->map.key),
                                             {fault::FileNotHad, {file.toStdString()}, {answer.reason}},
                                             map::ProblemCode::Unavailable,
                                             wire::failureOf(answer)});
               }
               fetch->finishPart();
             });
}

void MapRequests::fetchOverview(const Task& task, double resolution_m, OutcomeTo<map::WholeMap> reply) {
  net::HttpRequest request =
      server_.request(QStringLiteral("/ros/slam/map_image"),
                      QStringLiteral("resolution=") + QString::number(resolution_m, 'g', 10));
  request.accept = "application/x-protobuf";
  request.max_bytes = net::HttpRequest().max_bytes;
  request.timeout *= 4;  // the robot has to draw it first
  const auto finish = [resolution_m, reply = std::move(reply)](const net::HttpAnswer& answer) {
    const auto parse = [&](std::string_view body) { return parseOverview(body, resolution_m); };
    auto overview = wire::outcomeOf(answer, map::SubjectKind::Overview, parse, map::FailureReason::Unfit);
    if (overview) overview->body_bytes = std::size_t(answer.body.size());
    reply(std::move(overview));
  };
  wire::send(task, server_.http, request, finish, true);
}

void GridFetcher::fetch(GridToFetch wanted) {
  const auto running = jobs_.find(wanted.grid.topic);
  if (running != jobs_.end()) {
    running->second.next = std::move(wanted);
  } else {
    start(wanted);
  }
}

void GridFetcher::start(const GridToFetch& wanted) {
  const QUrl url = robotUrl(server_.base, wanted.data_url);
  if (!url.isValid()) {
    receive_(map::UnreadableMessage{
        wanted.grid.topic, Fault(fault::PictureAddressInvalid).followedBy(Consequence::PictureBeforeStays)});
    return;
  }
  jobs_[wanted.grid.topic].request =
      server_.http.send(server_.pictureRequest(url),
                        [this, wanted, url](const net::HttpAnswer& answer) { finish(wanted, url, answer); });
}

void GridFetcher::finish(const GridToFetch& wanted, const QUrl& url, const net::HttpAnswer& answer) {
  const map::GridMessage& grid = wanted.grid;
  if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
  auto job = jobs_.extract(grid.topic);
  if (!job.empty() && job.mapped().next) start(*job.mapped().next);
  if (answer.ok() && !answer.body.isEmpty()) {
    map::GridMessage complete = grid;
    complete.png = std::make_shared<const std::string>(answer.body.toStdString());
    complete.fingerprint = wire::fingerprint(*complete.png);
    complete.body_bytes = std::size_t(answer.body.size());
    complete.from_cache = answer.from_cache;
    origins_.remember(complete.fingerprint, url);
    if (keep_) keep_(grid.topic, wanted.data_url, complete.png);
    receive_(std::move(complete));
    return;
  }
  if (answer.ok()) server_.http.discard(url);
  const Fault why = answer.ok() ? Fault(fault::AnswerIsEmpty) : answer.reason;
  receive_(map::UnreadableMessage{grid.topic,
                                  {fault::PictureNotHad,
                                   {words::shortened(url.path(), 120).toStdString()},
                                   {why},
                                   Consequence::PictureBeforeStays}});
}

void GridFetcher::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) server_.http.discard(url);
}

void GridFetcher::cancelAll() {
  for (const auto& [topic, job] : jobs_) server_.http.cancel(job.request);
  jobs_.clear();
}

}  // namespace mapwright::robot::axbot
