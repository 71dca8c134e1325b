#include "robot/axbot/bag_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QJsonDocument>
#include <QJsonObject>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_bags.h"
#include "robot/axbot/robot_urls.h"
#include "robot/wire/failures.h"
#include "robot/wire/http_errand.h"
#include "robot/wire/http_failure.h"

namespace mapwright::robot::axbot {
namespace {

constexpr qint64 kMaxListBytes = qint64(64) << 20;

QString folderOf(BagKind kind) {
  return kind == BagKind::Recording ? QStringLiteral("/recording/") : QStringLiteral("/bags/");
}

QString pathOf(const BagKey& key) { return folderOf(key.kind) + pathSegment(key.name); }

/// Ranges usually begin and end at multiples of a power of two of a second: six decimals are exact.
QString seconds(double epoch_s) { return QString::number(epoch_s, 'f', 6); }

map::Subject partOf(BagKind kind) {
  return {map::SubjectKind::Catalogue, kind == BagKind::Bag ? map::kBagsPart : map::kRecordingsPart};
}

map::Failure notAsked(const BagKey& key, const BagRange& range) {
  const QString words = seconds(range.from_s) + QStringLiteral(" - ") + seconds(range.until_s);
  return {.kind = map::FailureKind::Unsupported,
          .subject = subjectOf(key),
          .reason = map::FailureReason::Unfit,
          .cause = {fault::BagNotAsked, {words.toStdString()}}};
}

}  // namespace

struct BagRequests::Listing {
  std::vector<BagEntry> bags, recordings;
  std::vector<map::Failure> failures;
  int open = 2;
  OutcomeTo<std::vector<BagEntry>> reply;
};

BagRequests::BagRequests(net::HttpClient& http, QUrl base, std::chrono::milliseconds patience, Report report,
                         Recovered recovered)
    : http_(http),
      base_(std::move(base)),
      patience_(patience),
      report_(std::move(report)),
      recovered_(std::move(recovered)) {
  reading_.setMaxThreadCount(1);
}

BagRequests::~BagRequests() { reading_.waitForDone(); }

net::HttpRequest BagRequests::requestTo(const QString& path, const QString& query) const {
  net::HttpRequest request;
  request.url = urlOnRobot(base_, path, query);
  request.max_bytes = kMaxListBytes;
  request.timeout = patience_;
  return request;
}

void BagRequests::list(Errand errand, OutcomeTo<std::vector<BagEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  for (const BagKind kind : {BagKind::Bag, BagKind::Recording}) {
    wire::send(errand, http_, requestTo(folderOf(kind)),
               [this, listing, kind](const net::HttpAnswer& answer) { addRows(listing, answer, kind); });
  }
}

void BagRequests::addRows(const std::shared_ptr<Listing>& listing, const net::HttpAnswer& answer,
                          BagKind kind) {
  if (!answer.ok()) {
    // Older firmware only records on demand, or not at all.
    if (wire::isUnknownThere(answer) && kind == BagKind::Recording) {
      recovered_({partOf(kind)});
    } else {
      listing->failures.push_back(wire::failed(answer, partOf(kind)));
    }
  } else if (auto rows = parseBagRows(wire::view(answer.body), kind)) {
    recovered_({partOf(kind)});
    (kind == BagKind::Bag ? listing->bags : listing->recordings) = std::move(*rows);
  } else {
    listing->failures.push_back(wire::misread(answer, partOf(kind), rows.error()));
  }
  if (--listing->open > 0) return;
  std::vector<BagEntry> all = std::move(listing->bags);
  for (BagEntry& entry : listing->recordings) all.push_back(std::move(entry));
  if (!listing->failures.empty() && all.empty()) {
    listing->reply(fail(listing->failures.front()));
    return;
  }
  for (const map::Failure& failure : listing->failures)
    report_(map::problemOf(failure, map::Severity::Warning));
  listed_ = all;
  listing->reply(std::move(all));
}

void BagRequests::info(Errand errand, const BagKey& key, OutcomeTo<BagInfo> reply) {
  wire::send(errand, http_, requestTo(pathOf(key) + QStringLiteral("/player")),
             [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               if (!answer.ok()) {
                 reply(fail(wire::failed(answer, subjectOf(key))));
               } else if (auto info = parseBagInfo(wire::view(answer.body))) {
                 reply(*info);
               } else {
                 reply(fail(wire::misread(answer, subjectOf(key), info.error())));
               }
             });
}

void BagRequests::messages(Errand errand, const BagKey& key, const BagRange& range,
                           OutcomeTo<BagChunkPtr> reply) {
  if (!std::isfinite(range.from_s) || !std::isfinite(range.until_s) || range.until_s < range.from_s) {
    reply(fail(notAsked(key, range)));
    return;
  }
  net::HttpRequest request = requestTo(
      pathOf(key) + QStringLiteral("/player"),
      QStringLiteral("start_time=%1&end_time=%2").arg(seconds(range.from_s), seconds(range.until_s)));
  request.cacheable = true;
  request.max_bytes = range.max_bytes;
  wire::send(
      errand, http_, request,
      [this, key, range, url = request.url, reply = std::move(reply)](const net::HttpAnswer& answer) {
        if (!answer.ok()) {
          reply(fail(wire::failed(answer, subjectOf(key))));
          return;
        }
        reading_.start([this, key, range, url, reply, answer] {
          auto chunk = parseBagChunk(wire::view(answer.body), range);
          if (chunk) chunk->from_cache = answer.from_cache;
          auto outcome = std::make_shared<decltype(chunk)>(std::move(chunk));
          QMetaObject::invokeMethod(
              &context_,
              [this, key, url, reply, answer, outcome] {
                if (*outcome) {
                  reply(std::make_shared<const BagChunk>(std::move(**outcome)));
                  return;
                }
                http_.discard(url);
                reply(fail(wire::misread(answer, subjectOf(key), outcome->error())));
              },
              Qt::QueuedConnection);
        });
      },
      true);
}

void BagRequests::picture(Errand errand, const std::string& topic, const std::string& url,
                          OutcomeTo<std::shared_ptr<const std::string>> reply) {
  const map::Subject subject(map::SubjectKind::Topic, topic);
  net::HttpRequest request;
  request.url = robotUrl(base_, url);
  request.timeout = patience_;
  request.accept = "image/png,image/*;q=0.8,*/*;q=0.5";
  request.cacheable = true;
  if (!request.url.isValid()) {
    reply(fail(wire::unfit(subject, fault::PictureAddressInvalid)));
    return;
  }
  wire::send(errand, http_, request,
             [this, subject, at = request.url, reply = std::move(reply)](const net::HttpAnswer& answer) {
               if (!answer.ok()) {
                 reply(fail(wire::failed(answer, subject, map::AskedFor::Picture)));
               } else if (answer.body.isEmpty()) {
                 http_.discard(at);
                 reply(fail({.kind = map::FailureKind::MalformedAnswer,
                             .subject = subject,
                             .asked_for = map::AskedFor::Picture,
                             .reason = map::FailureReason::Empty}));
               } else {
                 reply(std::make_shared<const std::string>(answer.body.toStdString()));
               }
             });
}

void BagRequests::record(Errand errand, const BagOrder& order, OutcomeTo<BagEntry> reply) {
  QJsonObject body;
  const auto put = [&](const QString& name, const std::string& text) {
    if (!text.empty()) body[name] = QString::fromStdString(text);
  };
  put(QStringLiteral("filename_suffix"), order.suffix);
  put(QStringLiteral("duration"), order.duration);
  put(QStringLiteral("category"), order.category);
  net::HttpRequest request = requestTo(QStringLiteral("/recording/"));
  request.method = net::HttpMethod::Post;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(errand, http_, request, [reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (!answer.ok()) {
      reply(fail(wire::failed(answer, partOf(BagKind::Recording), map::AskedFor::Change)));
      return;
    }
    // The answer depends on the firmware: a row of the list, or nothing.
    BagEntry entry;
    entry.key.kind = BagKind::Recording;
    reply(parseBagRow(wire::view(answer.body), BagKind::Recording).value_or(entry));
  });
}

void BagRequests::remove(Errand errand, const BagKey& key, OutcomeTo<BagKey> reply) {
  net::HttpRequest request = requestTo(pathOf(key));
  request.method = net::HttpMethod::Delete;
  wire::send(errand, http_, request, [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (answer.ok()) {
      reply(key);
    } else {
      reply(fail(wire::failed(answer, subjectOf(key), map::AskedFor::Change)));
    }
  });
}

void BagRequests::download(Errand errand, const BagKey& key, const QString& path,
                           OutcomeTo<BagDownload> reply) {
  const auto row =
      std::find_if(listed_.begin(), listed_.end(), [&](const BagEntry& entry) { return entry.key == key; });
  startDownload(std::move(errand), http_, requestTo(pathOf(key) + QStringLiteral("/download")), key,
                row == listed_.end() ? std::nullopt : std::optional(*row), path, std::move(reply));
}

}  // namespace mapwright::robot::axbot
