#include "robot/axbot/map_requests.h"

#include <optional>
#include <tuple>

#include <QJsonDocument>

#include "robot/axbot/faults.h"
#include "robot/axbot/robot_urls.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/http_errand.h"
#include "robot/wire/http_failure.h"
#include "robot/wire/picture_facts.h"

namespace mapwright::robot::axbot {
namespace {

const QString kCurrentMapPath = QStringLiteral("/chassis/current-map");
constexpr qint64 kMaxJsonBytes = qint64(64) << 20;

QString folderOf(map::MapKind kind) {
  return kind == map::MapKind::Mapping ? QStringLiteral("/mappings/") : QStringLiteral("/maps/");
}

QString pathOf(const map::MapKey& key) { return folderOf(key.kind) + pathSegment(key.id); }

QUrl thumbnailUrl(const QUrl& base, const map::MapKey& key) {
  return urlOnRobot(base, pathOf(key) + QStringLiteral("/thumbnail"));
}

/// It cannot be requested at all.
map::Failure unasked(const map::MapKey& key) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = map::subjectOf(key),
          .arguments = {"12, mapping:48"},
          .reason = map::FailureReason::NoSuchId};
}

/// It arrived, but is empty.
map::Failure empty(const map::MapKey& key, map::AskedFor asked_for) {
  return {.kind = map::FailureKind::MalformedAnswer,
          .subject = map::subjectOf(key),
          .asked_for = asked_for,
          .reason = map::FailureReason::Empty};
}

}  // namespace

struct MapRequests::Listing {
  std::vector<map::CatalogueEntry> maps, mappings;
  CurrentMap current;
  int open = 3;
  std::vector<map::Failure> failures;  // of the two lists
  OutcomeTo<std::vector<map::CatalogueEntry>> reply;
};

struct MapRequests::Fetch {
  Errand errand;
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

MapRequests::MapRequests(net::HttpClient& http, QUrl base, std::chrono::milliseconds patience, Report report,
                         Recovered recovered)
    : http_(http),
      base_(std::move(base)),
      patience_(patience),
      report_(std::move(report)),
      recovered_(std::move(recovered)) {}

net::HttpRequest MapRequests::requestTo(QUrl url) const {
  net::HttpRequest request;
  request.url = std::move(url);
  request.max_bytes = kMaxJsonBytes;
  request.timeout = patience_;
  return request;
}

void MapRequests::getJson(Errand errand, const QString& path, Taken taken) {
  wire::send(errand, http_, requestTo(urlOnRobot(base_, path)), std::move(taken));
}

void MapRequests::getList(Errand errand, const QString& path, Taken taken) {
  getJson(errand, path, [this, errand, path, taken = std::move(taken)](const net::HttpAnswer& answer) {
    if (wire::isUnknownThere(answer)) {
      getJson(errand, path.chopped(1), taken);
    } else {
      taken(answer);
    }
  });
}

void MapRequests::getPicture(Errand errand, const QUrl& url, Taken taken, bool tells) {
  net::HttpRequest request;
  request.url = url;
  request.timeout = patience_;
  request.accept = "image/png,image/*;q=0.8,*/*;q=0.5";
  request.cacheable = true;
  wire::send(
      errand, http_, request,
      [this, url, taken = std::move(taken)](const net::HttpAnswer& answer) {
        if (answer.ok() && answer.body.isEmpty()) http_.discard(url);
        taken(answer);
      },
      tells);
}

void MapRequests::list(Errand errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  getList(errand, QStringLiteral("/maps/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Stored);
    finishPart(listing);
  });
  getList(errand, QStringLiteral("/mappings/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Mapping);
    finishPart(listing);
  });
  getJson(errand, kCurrentMapPath, [this, listing](const net::HttpAnswer& answer) {
    const map::Subject subject(map::SubjectKind::Catalogue, map::kCurrentMapPart);
    if (answer.ok()) listing->current = parseCurrentMap(wire::view(answer.body));
    // Some firmware answers 404 if there is no current map.
    if (answer.ok() || wire::isUnknownThere(answer)) {
      recovered_({subject});
    } else if (answer.kind != net::HttpAnswer::Kind::Cancelled) {
      report_(map::problemOf(wire::failed(answer, subject), map::Severity::Warning));
    }
    finishPart(listing);
  });
}

void MapRequests::addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind) {
  const bool maps = kind == map::MapKind::Stored;
  const map::Subject subject(map::SubjectKind::Catalogue, maps ? map::kMapsPart : map::kMappingsPart);
  // Firmware without mapping has no such list: there are none.
  if (!maps && wire::isUnknownThere(answer)) {
    recovered_({subject});
    return;
  }
  if (!answer.ok()) {
    listing.failures.push_back(wire::failed(answer, subject));
    return;
  }
  auto rows = parseMapRows(wire::view(answer.body), kind);
  if (!rows) {
    listing.failures.push_back(wire::misread(answer, subject, rows.error()));
    return;
  }
  recovered_({subject});
  if (rows->without_id > 0) {
    report_({map::Severity::Warning,
             subject,
             {robot::wire::fault::RowsWithoutId, {rows->without_id}},
             map::ProblemCode::Odd});
  }
  (maps ? listing.maps : listing.mappings) = std::move(rows->entries);
}

void MapRequests::finishPart(const std::shared_ptr<Listing>& listing) {
  if (--listing->open > 0) return;
  for (const map::Failure& failure : listing->failures) {
    // The other parts are not needed either.
    if (failure.kind == map::FailureKind::Cancelled) {
      listing->reply(fail(failure));
      return;
    }
  }
  // Mappings alone are worth showing; an empty list although maps failed would be wrong.
  const bool nothing = listing->maps.empty() && listing->mappings.empty();
  if (!listing->failures.empty() && (nothing || listing->failures.size() == 2)) {
    listing->reply(fail(listing->failures.front()));
    return;
  }
  for (const map::Failure& failure : listing->failures)
    report_(map::problemOf(failure, map::Severity::Warning));
  std::vector<map::CatalogueEntry> all = std::move(listing->maps);
  int index = 0;
  for (map::CatalogueEntry& entry : all) {
    entry.is_current = listing->current.is(entry);
    entry.index = index++;
  }
  for (map::CatalogueEntry& entry : listing->mappings) {
    entry.index = index++;
    all.push_back(std::move(entry));
  }
  listing->reply(std::move(all));
}

void MapRequests::detail(Errand errand, const map::MapKey& key, OutcomeTo<MapDetail> reply) {
  if (key.id.empty() || (key.kind != map::MapKind::Stored && key.kind != map::MapKind::Mapping)) {
    reply(fail(unasked(key)));
    return;
  }
  getJson(std::move(errand), pathOf(key), [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (!answer.ok()) {
      reply(fail(wire::failed(answer, map::subjectOf(key))));
    } else if (auto detail = parseMapDetail(wire::view(answer.body), key)) {
      reply(std::move(*detail));
    } else {
      reply(fail(wire::misread(answer, map::subjectOf(key), detail.error())));
    }
  });
}

void MapRequests::describe(Errand errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  detail(std::move(errand), key, [reply = std::move(reply)](const Outcome<MapDetail>& detail) {
    if (detail) {
      reply(detail->entry);
    } else {
      reply(fail(detail.error()));
    }
  });
}

void MapRequests::thumbnail(Errand errand, const map::MapKey& key, OutcomeTo<std::string> reply) {
  getPicture(
      std::move(errand), thumbnailUrl(base_, key),
      [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
        if (!answer.ok()) {
          reply(fail(wire::failed(answer, map::subjectOf(key), map::AskedFor::SmallPicture)));
        } else if (answer.body.isEmpty()) {
          reply(fail(empty(key, map::AskedFor::SmallPicture)));
        } else {
          reply(answer.body.toStdString());
        }
      },
      true);
}

void MapRequests::discardThumbnail(const map::MapKey& key) { http_.discard(thumbnailUrl(base_, key)); }

void MapRequests::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) http_.discard(url);
}

void MapRequests::fetch(Errand errand, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  auto fetch = std::make_shared<Fetch>();
  fetch->errand = errand;
  fetch->reply = std::move(reply);
  fetch->map.key = key;
  detail(std::move(errand), key, [this, fetch](const Outcome<MapDetail>& detail) {
    if (!detail) {
      fetch->reply(fail(detail.error()));
    } else if (const auto why = map::whyUnusable(detail->grid)) {
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
  if (!detail.overlays_readable) {
    fetch->map.notes.push_back({map::Severity::Warning,
                                map::subjectOf(fetch->map.key),
                                {fault::MemberIsNoList, {"overlays"}},
                                map::ProblemCode::Odd});
  }
  fetch->usual_picture = urlOnRobot(base_, pathOf(key) + QStringLiteral(".png"));
  const bool mapping = key.kind == map::MapKind::Mapping;
  fetch->open = mapping ? 3 : 1;
  const QUrl given = robotUrl(base_, detail.image_url);
  fetchPicture(fetch, given.isValid() ? given : fetch->usual_picture);
  if (!mapping) return;
  fetchExtra(fetch, detail.trajectories_url, QStringLiteral("trajectories.json"),
             [](map::WholeMap& map, std::string_view body) { map.trajectories = parseTrajectories(body); });
  fetchExtra(fetch, detail.landmarks_url, QStringLiteral("landmarks.json"),
             [](map::WholeMap& map, std::string_view body) { map.landmarks = parseLandmarks(body); });
}

void MapRequests::fetchPicture(const std::shared_ptr<Fetch>& fetch, const QUrl& url) {
  getPicture(
      fetch->errand, url,
      [this, fetch, url](const net::HttpAnswer& answer) {
        if (wire::isUnknownThere(answer) && url != fetch->usual_picture) {
          fetchPicture(fetch, fetch->usual_picture);
          return;
        }
        if (!answer.ok()) {
          fetch->failure = wire::failed(answer, map::subjectOf(fetch->map.key), map::AskedFor::Picture);
        } else if (answer.body.isEmpty()) {
          fetch->failure = empty(fetch->map.key, map::AskedFor::Picture);
        } else {
          fetch->map.bytes = std::make_shared<const std::string>(answer.body.toStdString());
          fetch->map.fingerprint = wire::fingerprint(*fetch->map.bytes);
          fetch->map.body_bytes = fetch->map.bytes->size();
          fetch->map.from_cache = answer.from_cache;
          origins_.note(fetch->map.fingerprint, url);
          if (const auto size = wire::pngSize(*fetch->map.bytes)) {
            std::tie(fetch->map.grid.width, fetch->map.grid.height) = *size;
          }
        }
        fetch->finishPart();
      },
      true);
}

void MapRequests::fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url,
                             const QString& file, std::function<void(map::WholeMap&, std::string_view)> add) {
  const QUrl given = robotUrl(base_, given_url);
  const QUrl url =
      given.isValid() ? given : urlOnRobot(base_, pathOf(fetch->map.key) + QLatin1Char('/') + file);
  wire::send(fetch->errand, http_, requestTo(url),
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

void MapRequests::fetchOverview(Errand errand, double resolution_m, OutcomeTo<map::WholeMap> reply) {
  net::HttpRequest request;
  request.url = urlOnRobot(base_, QStringLiteral("/ros/slam/map_image"),
                           QStringLiteral("resolution=") + QString::number(resolution_m, 'g', 10));
  request.accept = "application/x-protobuf";
  request.timeout = 4 * patience_;  // the robot has to draw it first
  wire::send(
      errand, http_, request,
      [resolution_m, reply = std::move(reply)](const net::HttpAnswer& answer) {
        const map::Subject subject(map::SubjectKind::Overview);
        if (!answer.ok()) {
          reply(fail(wire::failed(answer, subject)));
        } else if (auto overview = parseOverview(wire::view(answer.body), resolution_m)) {
          overview->body_bytes = std::size_t(answer.body.size());
          reply(std::move(*overview));
        } else {
          reply(fail(wire::misread(answer, subject, overview.error(), map::FailureReason::Unfit)));
        }
      },
      true);
}

void MapRequests::rename(Errand errand, const map::MapKey& key, const std::string& name,
                         OutcomeTo<map::CatalogueEntry> reply) {
  change(
      std::move(errand), net::HttpMethod::Patch, pathOf(key),
      {{QStringLiteral("map_name"), QString::fromStdString(name)}}, key,
      [name](const map::CatalogueEntry& now) { return now.name == name; }, std::move(reply));
}

void MapRequests::load(Errand errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  const QString id = QString::fromStdString(key.id);
  bool whole = false;
  const qlonglong number = id.toLongLong(&whole);
  change(
      std::move(errand), net::HttpMethod::Post, kCurrentMapPath,
      {{QStringLiteral("map_id"), whole ? QJsonValue(number) : QJsonValue(id)}}, key,
      [](const map::CatalogueEntry& now) { return now.is_current; }, std::move(reply));
}

void MapRequests::change(Errand errand, net::HttpMethod method, const QString& path, const QJsonObject& body,
                         const map::MapKey& key, Holds holds, OutcomeTo<map::CatalogueEntry> reply) {
  if (key.id.empty() || key.kind != map::MapKind::Stored) {
    map::Failure failure = unasked(key);
    failure.asked_for = map::AskedFor::Change;
    failure.arguments = {"12"};
    reply(fail(std::move(failure)));
    return;
  }
  net::HttpRequest request = requestTo(urlOnRobot(base_, path));
  request.method = method;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(
      errand, http_, request,
      [this, errand, key, holds = std::move(holds), reply = std::move(reply)](const net::HttpAnswer& answer) {
        if (answer.ok()) {
          // Answers to a change depend on the firmware: read the map again.
          lookAt(errand, key, [reply](Outcome<map::CatalogueEntry> now) {
            if (!now) {
              now.error().asked_for = map::AskedFor::Change;
              now.error().applied = map::Applied::Yes;
            }
            reply(std::move(now));
          });
          return;
        }
        const map::Failure failure = wire::failed(answer, map::subjectOf(key), map::AskedFor::Change);
        if (failure.applied != map::Applied::Maybe || failure.kind == map::FailureKind::Cancelled) {
          reply(fail(failure));
          return;
        }
        // Reading the map may replace the lost answer. If it is not changed yet that proves nothing: the
        // robot may still be working.
        lookAt(errand, key, [holds, failure, reply](Outcome<map::CatalogueEntry> now) {
          if (now && holds(*now)) {
            reply(std::move(now));
          } else {
            reply(fail(failure));
          }
        });
      });
}

void MapRequests::lookAt(const Errand& errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  getJson(
      errand, kCurrentMapPath, [this, errand, key, reply = std::move(reply)](const net::HttpAnswer& current) {
        const CurrentMap of_robot = current.ok() ? parseCurrentMap(wire::view(current.body)) : CurrentMap();
        describe(errand, key, [of_robot, reply](Outcome<map::CatalogueEntry> now) {
          if (now) now->is_current = of_robot.is(*now);
          reply(std::move(now));
        });
      });
}

}  // namespace mapwright::robot::axbot
