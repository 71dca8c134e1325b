#include "robot/axbot/map_requests.h"

#include <optional>
#include <tuple>

#include "robot/axbot/robot_urls.h"
#include "robot/wire/http_failure.h"
#include "robot/wire/picture_facts.h"
#include "words/sentences.h"

namespace mapwright::robot::axbot {
namespace {

constexpr qint64 kMaxJsonBytes = qint64(64) << 20;
constexpr std::chrono::milliseconds kOverviewPatience{120'000};  // the robot draws it first

std::string_view view(const QByteArray& bytes) { return {bytes.constData(), std::size_t(bytes.size())}; }

QString folderOf(map::MapKind kind) {
  return kind == map::MapKind::Mapping ? QStringLiteral("/mappings/") : QStringLiteral("/maps/");
}

QString pathOf(const map::MapKey& key) { return folderOf(key.kind) + pathSegment(key.id); }

QUrl thumbnailUrl(const QUrl& base, const map::MapKey& key) {
  return urlOnRobot(base, pathOf(key) + QStringLiteral("/thumbnail"));
}

map::Problem problemOf(const map::MapKey& key, const std::string& sentence,
                       map::FailureKind failure = map::FailureKind::None,
                       map::Severity severity = map::Severity::Error) {
  return {severity, map::subjectOf(key), sentence, map::ProblemCode::Unavailable, failure};
}

std::string because(const char* what, const net::HttpAnswer& answer) {
  return words::because(what, answer.sentence.toStdString());
}

bool unknown(const net::HttpAnswer& answer) {
  return answer.kind == net::HttpAnswer::Kind::Answered && (answer.status == 404 || answer.status == 405);
}

}  // namespace

struct MapRequests::Listing {
  std::vector<map::CatalogueEntry> maps, mappings;
  CurrentMap current;
  int open = 3;
  std::vector<map::Problem> failures;  // of the two lists
  AnswerTo<std::vector<map::CatalogueEntry>> reply;
};

struct MapRequests::Fetch {
  map::WholeMap map;
  QUrl usual_picture;  // where it lies when the robot does not say, or says wrongly
  int open = 0;
  std::optional<map::Problem> failure;
  AnswerTo<map::WholeMap> reply;

  void finishPart() {
    if (--open > 0) return;
    if (failure) {
      reply(tl::make_unexpected(*failure));
    } else {
      reply(std::move(map));
    }
  }
};

MapRequests::MapRequests(net::HttpClient& http, QUrl base, Report report, Recovered recovered)
    : http_(http), base_(std::move(base)), report_(std::move(report)), recovered_(std::move(recovered)) {}

void MapRequests::getJson(const QString& path, Taken taken) {
  net::HttpRequest request;
  request.url = urlOnRobot(base_, path);
  request.max_bytes = kMaxJsonBytes;
  http_.get(request, std::move(taken));
}

void MapRequests::getList(const QString& path, Taken taken) {
  getJson(path, [this, path, taken = std::move(taken)](const net::HttpAnswer& answer) {
    if (unknown(answer)) {
      getJson(path.chopped(1), taken);
    } else {
      taken(answer);
    }
  });
}

void MapRequests::getPicture(const QUrl& url, Taken taken) {
  net::HttpRequest request;
  request.url = url;
  request.accept = "image/png,image/*;q=0.8,*/*;q=0.5";
  request.cacheable = true;
  http_.get(request, [this, url, taken = std::move(taken)](const net::HttpAnswer& answer) {
    if (answer.ok() && answer.body.isEmpty()) http_.discard(url);
    taken(answer);
  });
}

void MapRequests::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  getList(QStringLiteral("/maps/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Stored);
    finishPart(listing);
  });
  getList(QStringLiteral("/mappings/"), [this, listing](const net::HttpAnswer& answer) {
    addRows(*listing, answer, map::MapKind::Mapping);
    finishPart(listing);
  });
  getJson(QStringLiteral("/chassis/current-map"), [this, listing](const net::HttpAnswer& answer) {
    const map::Subject subject(map::SubjectKind::Catalogue, "Current map");
    if (answer.ok()) listing->current = parseCurrentMap(view(answer.body));
    // No current map is a 404 with some firmware.
    if (answer.ok() || unknown(answer)) {
      recovered_({subject});
    } else if (answer.kind != net::HttpAnswer::Kind::Cancelled) {
      report_({map::Severity::Warning, subject,
               because("Which map is the current one cannot be told: ", answer),
               map::ProblemCode::Unavailable, wire::failureOf(answer)});
    }
    finishPart(listing);
  });
}

void MapRequests::addRows(Listing& listing, const net::HttpAnswer& answer, map::MapKind kind) {
  const bool maps = kind == map::MapKind::Stored;
  const map::Subject subject(map::SubjectKind::Catalogue, maps ? "Maps" : "Mappings");
  if (!answer.ok()) {
    listing.failures.push_back({map::Severity::Warning, subject, because("The list cannot be had: ", answer),
                                map::ProblemCode::Unavailable, wire::failureOf(answer)});
    return;
  }
  auto rows = parseMapRows(view(answer.body), kind);
  if (!rows) {
    listing.failures.push_back({map::Severity::Warning, subject,
                                words::because("The list cannot be read", rows.error()),
                                map::ProblemCode::Unreadable, wire::unreadable(answer)});
    return;
  }
  recovered_({subject});
  if (rows->without_id > 0) {
    report_({map::Severity::Warning, subject,
             std::to_string(rows->without_id) + " rows without an id were left out.", map::ProblemCode::Odd});
  }
  (maps ? listing.maps : listing.mappings) = std::move(rows->entries);
}

void MapRequests::finishPart(const std::shared_ptr<Listing>& listing) {
  if (--listing->open > 0) return;
  // Mappings alone are worth showing; an empty list where the maps could not be had would be a lie.
  const bool nothing = listing->maps.empty() && listing->mappings.empty();
  if (!listing->failures.empty() && (nothing || listing->failures.size() == 2)) {
    map::Problem failure = listing->failures.front();
    failure.severity = map::Severity::Error;
    listing->reply(tl::make_unexpected(std::move(failure)));
    return;
  }
  for (const map::Problem& failure : listing->failures) report_(failure);
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

void MapRequests::detail(const map::MapKey& key, AnswerTo<MapDetail> reply) {
  if (key.id.empty() || (key.kind != map::MapKind::Stored && key.kind != map::MapKind::Mapping)) {
    reply(tl::make_unexpected(
        problemOf(key, "Only stored maps and mappings can be asked for, by their id (12, mapping:48).")));
    return;
  }
  getJson(pathOf(key), [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (!answer.ok()) {
      reply(tl::make_unexpected(
          problemOf(key, because("It cannot be had: ", answer), wire::failureOf(answer))));
      return;
    }
    auto detail = parseMapDetail(view(answer.body), key);
    if (detail) {
      reply(std::move(*detail));
    } else {
      reply(tl::make_unexpected(
          problemOf(key, words::because("It cannot be read", detail.error()), wire::unreadable(answer))));
    }
  });
}

void MapRequests::describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) {
  detail(key, [reply = std::move(reply)](const Answer<MapDetail>& detail) {
    if (detail) {
      reply(detail->entry);
    } else {
      reply(tl::make_unexpected(detail.error()));
    }
  });
}

void MapRequests::thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) {
  getPicture(thumbnailUrl(base_, key), [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (answer.ok() && !answer.body.isEmpty()) {
      reply(answer.body.toStdString());
    } else if (answer.ok()) {
      reply(tl::make_unexpected(problemOf(key, "Its small picture is empty.",
                                          map::FailureKind::MalformedAnswer, map::Severity::Info)));
    } else {
      reply(tl::make_unexpected(problemOf(key, because("Its small picture cannot be had: ", answer),
                                          wire::failureOf(answer), map::Severity::Info)));
    }
  });
}

void MapRequests::discardThumbnail(const map::MapKey& key) { http_.discard(thumbnailUrl(base_, key)); }

void MapRequests::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) http_.discard(url);
}

void MapRequests::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  auto fetch = std::make_shared<Fetch>();
  fetch->reply = std::move(reply);
  fetch->map.key = key;
  detail(key, [this, fetch](const Answer<MapDetail>& detail) {
    if (!detail) {
      fetch->reply(tl::make_unexpected(detail.error()));
    } else if (const auto why = map::whyUnusable(detail->grid)) {
      fetch->reply(tl::make_unexpected(
          problemOf(fetch->map.key, "It cannot be shown. " + *why, map::FailureKind::MalformedAnswer)));
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
  getPicture(url, [this, fetch, url](const net::HttpAnswer& answer) {
    if (unknown(answer) && url != fetch->usual_picture) {
      fetchPicture(fetch, fetch->usual_picture);
      return;
    }
    if (!answer.ok()) {
      fetch->failure =
          problemOf(fetch->map.key, because("Its picture cannot be had: ", answer), wire::failureOf(answer));
    } else if (answer.body.isEmpty()) {
      fetch->failure = problemOf(fetch->map.key, "Its picture is empty.", map::FailureKind::MalformedAnswer);
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
  });
}

void MapRequests::fetchExtra(const std::shared_ptr<Fetch>& fetch, const std::string& given_url,
                             const QString& file, std::function<void(map::WholeMap&, std::string_view)> add) {
  const QUrl given = robotUrl(base_, given_url);
  net::HttpRequest request;
  request.url = given.isValid() ? given : urlOnRobot(base_, pathOf(fetch->map.key) + QLatin1Char('/') + file);
  request.max_bytes = kMaxJsonBytes;
  http_.get(request, [fetch, file, add = std::move(add)](const net::HttpAnswer& answer) {
    if (answer.ok()) {
      add(fetch->map, view(answer.body));
    } else {
      fetch->map.notes.push_back(
          problemOf(fetch->map.key,
                    words::because("Shown without " + file.toStdString(), answer.sentence.toStdString()),
                    wire::failureOf(answer), map::Severity::Info));
    }
    fetch->finishPart();
  });
}

void MapRequests::fetchOverview(double resolution_m, AnswerTo<map::WholeMap> reply) {
  net::HttpRequest request;
  request.url = urlOnRobot(base_, QStringLiteral("/ros/slam/map_image"),
                           QStringLiteral("resolution=") + QString::number(resolution_m, 'g', 10));
  request.accept = "application/x-protobuf";
  request.timeout = kOverviewPatience;
  http_.get(request, [resolution_m, reply = std::move(reply)](const net::HttpAnswer& answer) {
    const auto fail = [&](std::string sentence, map::FailureKind failure) {
      reply(tl::make_unexpected(map::Problem{map::Severity::Warning,
                                             map::Subject(map::SubjectKind::Overview, {}),
                                             std::move(sentence), map::ProblemCode::Unavailable, failure}));
    };
    if (!answer.ok())
      return fail(because("The overview of the map cannot be had: ", answer), wire::failureOf(answer));
    auto overview = parseOverview(view(answer.body), resolution_m);
    if (!overview) return fail(overview.error(), wire::unreadable(answer));
    overview->body_bytes = std::size_t(answer.body.size());
    reply(std::move(*overview));
  });
}

}  // namespace mapwright::robot::axbot
