#include "robot/axbot/bag_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>

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

constexpr std::chrono::milliseconds kLookAgainAfter{500};

bool holds(const std::vector<BagEntry>& rows, const BagKey& key) {
  return std::any_of(rows.begin(), rows.end(), [&](const BagEntry& row) { return row.key == key; });
}

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

struct BagRequests::Recording {
  Task task;
  std::string suffix;
  OutcomeTo<BagEntry> reply;
  std::vector<BagEntry> before = {};
  std::string name = {};                   // as the robot answered; empty = it did not say
  std::optional<map::Failure> doubt = {};  // the answer was lost, or an error of the robot's own
  std::chrono::milliseconds patience{0};   // left

  /// It has been listed since; nullptr: none.
  const BagEntry* newOf(const std::vector<BagEntry>& now) const {
    const BagEntry* found = nullptr;
    for (const BagEntry& entry : now) {
      if (holds(before, entry.key) || (!name.empty() && entry.key.name != name)) continue;
      const bool named = entry.key.name.find(suffix) != std::string::npos;
      if (!found || named) found = &entry;
    }
    return found;
  }
};

BagRequests::BagRequests(RobotServer server, std::chrono::milliseconds recording_patience)
    : server_(std::move(server)), recording_patience_(recording_patience) {
  reading_.setMaxThreadCount(1);
}

BagRequests::~BagRequests() { reading_.waitForDone(); }

void BagRequests::rows(const Task& task, BagKind kind, OutcomeTo<std::vector<BagEntry>> reply) {
  wire::send(task, server_.http, server_.request(folderOf(kind)),
             [kind, reply = std::move(reply)](const net::HttpAnswer& answer) {
               // Older firmware only records on demand, or not at all.
               if (wire::isUnknownThere(answer) && kind == BagKind::Recording)
                 return reply(std::vector<BagEntry>());
               reply(wire::outcomeOf(answer, partOf(kind),
                                     [kind](std::string_view body) { return parseBagRows(body, kind); }));
             });
}

void BagRequests::bothRows(const Task& task, std::function<void(BothRows)> reply) {
  rows(task, BagKind::Bag,
       [this, task, reply = std::move(reply)](const Outcome<std::vector<BagEntry>>& bags) {
         rows(task, BagKind::Recording, [bags, reply](Outcome<std::vector<BagEntry>> recordings) {
           BothRows both;
           for (const auto& one : {bags, recordings}) {
             if (one) {
               both.all.insert(both.all.end(), one->begin(), one->end());
             } else {
               both.failures.push_back(one.error());
             }
           }
           reply(std::move(both));
         });
       });
}

void BagRequests::list(const Task& task, OutcomeTo<std::vector<BagEntry>> reply) {
  bothRows(task, [this, reply = std::move(reply)](BothRows both) {
    const auto failed = [&](BagKind kind) {
      return std::any_of(both.failures.begin(), both.failures.end(),
                         [&](const map::Failure& failure) { return failure.subject == partOf(kind); });
    };
    for (const BagKind kind : {BagKind::Bag, BagKind::Recording}) {
      if (!failed(kind)) server_.recovered({partOf(kind)});
    }
    if (!both.failures.empty() && both.all.empty()) return reply(fail(both.failures.front()));
    for (const map::Failure& failure : both.failures)
      server_.report(map::problemOf(failure, map::Severity::Warning));
    listed_ = both.all;
    reply(std::move(both.all));
  });
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
  auto recording = std::make_shared<Recording>(Recording{task, order.suffix, std::move(reply)});
  recording->patience = recording_patience_;
  bothRows(task, [this, recording, order](BothRows before) {
    // What is new afterwards could not be told.
    if (!before.failures.empty()) {
      before.failures.front().asked_for = map::AskedFor::Addition;
      return recording->reply(fail(std::move(before.failures.front())));
    }
    recording->before = std::move(before.all);
    send(recording, order);
  });
}

void BagRequests::send(const std::shared_ptr<Recording>& recording, const BagOrder& order) {
  QJsonObject body;
  for (const auto& [name, text] : {std::pair("filename_suffix", &order.suffix),
                                   {"duration", &order.duration},
                                   {"category", &order.category}}) {
    if (!text->empty()) body[QLatin1String(name)] = QString::fromStdString(*text);
  }
  net::HttpRequest request = server_.request(folderOf(BagKind::Recording));
  request.method = net::HttpMethod::Post;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(recording->task, server_.http, request, [this, recording](const net::HttpAnswer& answer) {
    const map::Subject subject = partOf(BagKind::Recording);
    recording->doubt = answer.ok() ? refusalIn(answer, subject)
                                   : std::optional(wire::failed(answer, subject, map::AskedFor::Addition));
    if (recording->doubt) {
      recording->doubt->asked_for = map::AskedFor::Addition;
      if (recording->doubt->applied == map::Applied::No) return recording->reply(fail(*recording->doubt));
      recording->doubt->applied = map::Applied::Maybe;
    }
    // The answer depends on the firmware: a row of the list, or nothing.
    if (const auto row = parseBagRow(wire::view(answer.body), BagKind::Recording); row && answer.ok())
      recording->name = row->key.name;
    look(recording);
  });
}

void BagRequests::look(const std::shared_ptr<Recording>& recording) {
  bothRows(recording->task, [this, recording](const BothRows& now) {
    if (const BagEntry* const found = recording->newOf(now.all)) return recording->reply(*found);
    const bool cancelled =
        std::any_of(now.failures.begin(), now.failures.end(),
                    [](const map::Failure& failure) { return failure.kind == map::FailureKind::Cancelled; });
    if (recording->patience > std::chrono::milliseconds(0) && !cancelled) {
      recording->patience -= kLookAgainAfter;
      QTimer::singleShot(kLookAgainAfter, &context_, [this, recording] { look(recording); });
      return;
    }
    map::Failure unknown =
        recording->doubt ? *recording->doubt
        : !now.failures.empty()
            ? now.failures.front()
            : wire::otherwise(partOf(BagKind::Recording),
                              faultText("axbot", "The robot accepted the recording, but does not list it."));
    unknown.asked_for = map::AskedFor::Addition;
    unknown.applied = map::Applied::Maybe;
    recording->reply(fail(std::move(unknown)));
  });
}

void BagRequests::remove(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply) {
  if (!pathOfBag(key)) return reply(fail(noSuchName(key, map::AskedFor::Change)));
  // A name that is not listed may mean something else to the robot: "*", "all".
  rows(task, key.kind,
       [this, task, key, reply = std::move(reply)](const Outcome<std::vector<BagEntry>>& before) {
         if (before && holds(*before, key)) return removeListed(task, key, reply);
         map::Failure why = before ? wire::notThere(subjectOf(key)) : before.error();
         why.asked_for = map::AskedFor::Change;
         reply(fail(std::move(why)));
       });
}

void BagRequests::removeListed(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply) {
  net::HttpRequest request = server_.request(*pathOfBag(key));
  request.method = net::HttpMethod::Delete;
  wire::send(task, server_.http, request,
             [this, task, key, reply = std::move(reply)](const net::HttpAnswer& answer) {
               std::optional<map::Failure> doubt =
                   answer.ok() ? refusalIn(answer, subjectOf(key))
                               : wire::failed(answer, subjectOf(key), map::AskedFor::Change);
               if (doubt && (!answer.sent || doubt->kind == map::FailureKind::Cancelled))
                 return reply(fail(std::move(*doubt)));
               if (doubt && doubt->applied != map::Applied::No) doubt->applied = map::Applied::Maybe;
               // What it lists is what counts, also where the answer was lost.
               rows(task, key.kind, [key, doubt, reply](const Outcome<std::vector<BagEntry>>& now) {
                 if (now && !holds(*now, key)) return reply(key);
                 if (doubt) return reply(fail(*doubt));
                 if (now) return reply(fail(wire::otherwise(subjectOf(key), fault::StillThere)));
                 map::Failure unknown = now.error();
                 unknown.asked_for = map::AskedFor::Change;
                 unknown.applied = map::Applied::Maybe;
                 reply(fail(std::move(unknown)));
               });
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
