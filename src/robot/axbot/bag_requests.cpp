#include "robot/axbot/bag_requests.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <QJsonDocument>
#include <QJsonObject>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_bags.h"
#include "robot/axbot/resumed_download.h"
#include "robot/wire/failures.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

QString folderOf(BagKind kind) {
  return kind == BagKind::Recording ? QStringLiteral("/recording/") : QStringLiteral("/bags/");
}

std::optional<QString> pathOfBag(const BagKey& key) { return pathOfNamed(folderOf(key.kind), key.name); }

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

QByteArray identityOf(const std::optional<BagEntry>& row) {
  if (!row || !row->size_bytes || row->end_text.empty()) return {};
  return QByteArray::number(qlonglong(*row->size_bytes)) + ' ' +
         QByteArray::fromStdString(row->end_text).simplified();
}

/// It cannot be requested at all.
map::Failure noSuchName(const BagKey& key, map::AskedFor asked_for = map::AskedFor::All) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = subjectOf(key),
          .arguments = {"2023_10_31_14_36_17.bag"},
          .asked_for = asked_for,
          .reason = map::FailureReason::NoSuchId};
}

}  // namespace

struct BagRequests::Listing {
  std::vector<BagEntry> bags, recordings;
  std::vector<map::Failure> failures;
  int open = 2;
  OutcomeTo<std::vector<BagEntry>> reply;
};

BagRequests::BagRequests(RobotServer server) : server_(std::move(server)) { reading_.setMaxThreadCount(1); }

BagRequests::~BagRequests() { reading_.waitForDone(); }

void BagRequests::list(const Task& task, OutcomeTo<std::vector<BagEntry>> reply) {
  auto listing = std::make_shared<Listing>();
  listing->reply = std::move(reply);
  for (const BagKind kind : {BagKind::Bag, BagKind::Recording}) {
    wire::send(task, server_.http, server_.request(folderOf(kind)),
               [this, listing, kind](const net::HttpAnswer& answer) { addRows(*listing, answer, kind); });
  }
}

void BagRequests::addRows(Listing& listing, const net::HttpAnswer& answer, BagKind kind) {
  auto rows = wire::outcomeOf(answer, partOf(kind),
                              [kind](std::string_view body) { return parseBagRows(body, kind); });
  // Older firmware only records on demand, or not at all.
  const bool none = wire::isUnknownThere(answer) && kind == BagKind::Recording;
  if (rows || none) {
    server_.recovered({partOf(kind)});
  } else {
    listing.failures.push_back(std::move(rows.error()));
  }
  if (rows) (kind == BagKind::Bag ? listing.bags : listing.recordings) = std::move(*rows);
  if (--listing.open > 0) return;
  std::vector<BagEntry> all = std::move(listing.bags);
  std::move(listing.recordings.begin(), listing.recordings.end(), std::back_inserter(all));
  if (!listing.failures.empty() && all.empty()) {
    listing.reply(fail(listing.failures.front()));
    return;
  }
  for (const map::Failure& failure : listing.failures)
    server_.report(map::problemOf(failure, map::Severity::Warning));
  listed_ = all;
  listing.reply(std::move(all));
}

void BagRequests::info(const Task& task, const BagKey& key, OutcomeTo<BagInfo> reply) {
  const auto path = pathOfBag(key);
  if (!path) return reply(fail(noSuchName(key)));
  wire::send(task, server_.http, server_.request(*path + QStringLiteral("/player")),
             [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               reply(wire::outcomeOf(answer, subjectOf(key), parseBagInfo));
             });
}

void BagRequests::messages(const Task& task, const BagKey& key, const BagRange& range,
                           OutcomeTo<BagChunkPtr> reply) {
  if (!std::isfinite(range.from_s) || !std::isfinite(range.until_s) || range.until_s < range.from_s) {
    reply(fail(notAsked(key, range)));
    return;
  }
  const auto path = pathOfBag(key);
  if (!path) return reply(fail(noSuchName(key)));
  net::HttpRequest request = server_.request(
      *path + QStringLiteral("/player"),
      QStringLiteral("start_time=%1&end_time=%2").arg(seconds(range.from_s), seconds(range.until_s)));
  request.cacheable = true;
  request.max_bytes = range.max_bytes;
  const auto finish = [this, key, range, url = request.url,
                       reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (!answer.ok()) {
      reply(fail(wire::failed(answer, subjectOf(key))));
      return;
    }
    reading_.start([this, key, range, url, reply, answer] {
      auto chunk = parseBagChunk(wire::view(answer.body), range);
      if (chunk) chunk->from_cache = answer.from_cache;
      auto outcome = std::make_shared<decltype(chunk)>(std::move(chunk));
      const auto deliver = [this, key, url, reply, answer, outcome] {
        if (*outcome) {
          reply(std::make_shared<const BagChunk>(std::move(**outcome)));
          return;
        }
        server_.http.discard(url);
        reply(fail(wire::misread(answer, subjectOf(key), outcome->error())));
      };
      QMetaObject::invokeMethod(&context_, deliver, Qt::QueuedConnection);
    });
  };
  wire::send(task, server_.http, request, finish, true);
}

void BagRequests::picture(const Task& task, const std::string& topic, const std::string& url,
                          OutcomeTo<std::shared_ptr<const std::string>> reply) {
  const map::Subject subject(map::SubjectKind::Topic, topic);
  const QUrl at = robotUrl(server_.base, url);
  if (!at.isValid()) {
    reply(fail(wire::unfit(subject, fault::PictureAddressInvalid)));
    return;
  }
  wire::send(task, server_.http, server_.pictureRequest(at),
             [this, subject, at, reply = std::move(reply)](const net::HttpAnswer& answer) {
               if (answer.ok() && answer.body.isEmpty()) server_.http.discard(at);
               reply(pictureOf(answer, subject));
             });
}

void BagRequests::record(const Task& task, const BagOrder& order, OutcomeTo<BagEntry> reply) {
  QJsonObject body;
  for (const auto& [name, text] : {std::pair("filename_suffix", &order.suffix),
                                   {"duration", &order.duration},
                                   {"category", &order.category}}) {
    if (!text->empty()) body[QLatin1String(name)] = QString::fromStdString(*text);
  }
  net::HttpRequest request = server_.request(folderOf(BagKind::Recording));
  request.method = net::HttpMethod::Post;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(task, server_.http, request, [reply = std::move(reply)](const net::HttpAnswer& answer) {
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

Outcome<BagKey> BagRequests::goneFrom(const net::HttpAnswer& list, const BagKey& key) {
  const auto rows = wire::outcomeOf(list, subjectOf(key),
                                    [&key](std::string_view body) { return parseBagRows(body, key.kind); });
  if (!rows) {
    map::Failure failure = rows.error();
    failure.asked_for = map::AskedFor::Change;
    failure.applied = map::Applied::Maybe;
    return fail(std::move(failure));
  }
  const bool there =
      std::any_of(rows->begin(), rows->end(), [&](const BagEntry& entry) { return entry.key == key; });
  if (!there) return key;
  return fail(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                           .subject = subjectOf(key),
                           .asked_for = map::AskedFor::Change,
                           .reason = map::FailureReason::Unfit,
                           .cause = fault::StillThere});
}

void BagRequests::remove(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply) {
  const auto path = pathOfBag(key);
  if (!path) return reply(fail(noSuchName(key, map::AskedFor::Change)));
  net::HttpRequest request = server_.request(*path);
  request.method = net::HttpMethod::Delete;
  wire::send(task, server_.http, request,
             [this, task, key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               if (!answer.ok())
                 return reply(fail(wire::failed(answer, subjectOf(key), map::AskedFor::Change)));
               // What it lists is what counts.
               wire::send(task, server_.http, server_.request(folderOf(key.kind)),
                          [key, reply](const net::HttpAnswer& list) { reply(goneFrom(list, key)); });
             });
}

void BagRequests::download(const Task& task, const BagKey& key, const QString& path,
                           OutcomeTo<BagDownload> reply) {
  const auto from = pathOfBag(key);
  if (!from) return reply(fail(noSuchName(key)));
  const auto row =
      std::find_if(listed_.begin(), listed_.end(), [&](const BagEntry& entry) { return entry.key == key; });
  const auto listed = row == listed_.end() ? std::nullopt : std::optional(*row);
  downloadResumed(task, server_.http,
                  {.request = server_.request(*from + QStringLiteral("/download")),
                   .subject = subjectOf(key),
                   .path = path,
                   .identity = identityOf(listed),
                   .told_bytes = listed ? listed->size_bytes : std::nullopt},
                  [path, reply = std::move(reply)](Outcome<ResumedDownload> done) {
                    if (!done) return reply(fail(std::move(done.error())));
                    reply(BagDownload{path, done->bytes, done->resumed});
                  });
}

}  // namespace mapwright::robot::axbot
