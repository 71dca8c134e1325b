#include "robot/axbot/bag_requests.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_bags.h"
#include "robot/wire/failures.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

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

constexpr qint64 kMostDownload = qint64(1) << 40;
constexpr int kRangeNotThere = 416, kPartial = 206;

/// The origin of a partial download, stored next to it. Without it, a part cannot be trusted and the download
/// starts over.
struct PartOf {
  QByteArray etag;
  std::optional<qint64> bytes;
  QByteArray listed = {};  // the row of the robot's list; empty = unknown
};

QByteArray identityOf(const std::optional<BagEntry>& row) {
  if (!row || !row->size_bytes || row->end_text.empty()) return {};
  return QByteArray::number(qlonglong(*row->size_bytes)) + ' ' +
         QByteArray::fromStdString(row->end_text).simplified();
}

QString besidePart(const QString& path) { return path + QStringLiteral(".part.of"); }

PartOf readPartOf(const QString& path) {
  constexpr qint64 kMostText = 4096;
  QFile file(besidePart(path));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QList<QByteArray> lines = file.read(kMostText).split('\n');
  bool good = false;
  const qint64 bytes = lines.value(1).toLongLong(&good);
  QByteArray etag = lines.value(0).trimmed();
  if (!etag.startsWith('"') && !etag.startsWith("W/")) etag.clear();  // invalid
  return {etag, good && bytes >= 0 ? std::optional(bytes) : std::nullopt, lines.value(2).trimmed()};
}

/// If it cannot be written the next download starts over.
void writePartOf(const QString& path, const PartOf& of) {
  QFile file(besidePart(path));
  if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate)) return;
  file.write(of.etag + '\n' + (of.bytes ? QByteArray::number(*of.bytes) : QByteArray()) + '\n' + of.listed +
             '\n');
}

struct Download {
  BagRequests::Task task;
  net::HttpClient& http;
  net::HttpRequest request;
  BagKey key;
  QString path;
  std::optional<BagEntry> row;  // of the robot's list, if known
  QFile part;
  PartOf held_of;                  // what is there
  bool unfit = false;              // the answer does not continue the part, or is of another file
  qint64 begun_at = 0;             // what existed before
  std::optional<qint64> of_bytes;  // of the whole, as announced
  bool begun = false;
  std::optional<map::Failure> trouble;
  OutcomeTo<BagDownload> reply;

  map::Failure notWritten(const QString& why) const {
    return {.kind = map::FailureKind::Unsupported,
            .subject = subjectOf(key),
            .reason = map::FailureReason::Unfit,
            .cause = {fault::BagFileNotWritten, {path.toStdString(), why.toStdString()}}};
  }
  void end(map::Failure failure) {
    // An empty part does not count.
    if (part.isOpen() && part.size() == 0) {
      part.remove();
      QFile::remove(besidePart(path));
    }
    part.close();
    reply(tl::make_unexpected(std::move(failure)));
  }
  /// It continues the existing part.
  bool goesOn(const net::HttpPart& first) const {
    if (first.from_byte != begun_at) return false;
    if (first.whole_bytes && *first.whole_bytes < begun_at) return false;
    if (first.whole_bytes && held_of.bytes && first.whole_bytes != held_of.bytes) return false;
    if (!first.etag.isEmpty() && !held_of.etag.isEmpty()) return first.etag == held_of.etag;
    return !held_of.listed.isEmpty() && held_of.listed == identityOf(row);
  }
  /// False if it cannot continue.
  bool begin(const net::HttpPart& first) {
    begun = true;
    if (first.status == kPartial && !goesOn(first)) {
      unfit = true;
      return false;
    }
    if (first.status != kPartial) {
      writePartOf(path, {first.etag, first.of_bytes, identityOf(row)});
      begun_at = 0;
      if (!part.resize(0) || !part.seek(0)) {
        trouble = notWritten(part.errorString());
        return false;
      }
    }
    if (first.of_bytes) of_bytes = begun_at + *first.of_bytes;
    return true;
  }
  bool take(const net::HttpPart& received) {
    if (!begun && !begin(received)) return false;
    if (part.write(received.bytes) == received.bytes.size()) {
      task->tell({part.pos(), of_bytes});
      return true;
    }
    trouble = notWritten(part.errorString());
    return false;
  }
};
using DownloadPtr = std::shared_ptr<Download>;

void placeDownload(Download& download) {
  const qint64 bytes = download.part.pos();
  // If the answer has no length, a premature end looks like the end. A bag that is still recorded may have
  // grown.
  const bool unmeasured = !download.of_bytes && download.row && download.row->size_bytes;
  if (unmeasured && bytes < *download.row->size_bytes) download.of_bytes = *download.row->size_bytes;
  if (download.of_bytes && *download.of_bytes != bytes) {
    download.end(
        wire::unfit(subjectOf(download.key), {fault::BagFileOfOtherSize, {bytes, *download.of_bytes}}));
    return;
  }
  if (!download.part.flush()) {
    download.end(download.notWritten(download.part.errorString()));
    return;
  }
  download.part.close();
  QFile::remove(besidePart(download.path));
  // Replaces an existing file atomically.
  if (std::rename(QFile::encodeName(download.part.fileName()).constData(),
                  QFile::encodeName(download.path).constData()) != 0) {
    download.end(download.notWritten(qt_error_string()));
    return;
  }
  download.reply(BagDownload{download.path, bytes, download.begun_at > 0});
}

void sendDownload(const DownloadPtr& download);

/// Drops the part and requests the whole.
void beginAnew(const DownloadPtr& download, const net::HttpAnswer& answer) {
  if (download->request.from_byte == 0) {
    // The whole was asked for, and a part came.
    download->end(wire::unfit(
        subjectOf(download->key),
        {fault::BagFileOfOtherSize, {std::int64_t(0), std::int64_t(download->of_bytes.value_or(0))}}));
    return;
  }
  if (answer.kind == net::HttpAnswer::Kind::Refused) {
    download->end(wire::failed(answer, subjectOf(download->key)));
    return;
  }
  download->unfit = download->begun = false;
  download->begun_at = 0;
  download->of_bytes.reset();
  download->held_of = {};
  download->request.from_byte = 0;
  download->request.if_etag.clear();
  if (!download->part.resize(0) || !download->part.seek(0)) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  sendDownload(download);
}

void sendDownload(const DownloadPtr& download) {
  wire::send(download->task, download->http, download->request, [download](const net::HttpAnswer& answer) {
    if (download->trouble) {
      download->end(*download->trouble);
    } else if (download->unfit) {
      beginAnew(download, answer);
    } else if (answer.ok()) {
      if (!download->begun && answer.status == kPartial) {
        beginAnew(download, answer);  // an empty part does not count
      } else if (!download->begun && !download->begin({answer.status, 0, {}})) {
        download->end(*download->trouble);
      } else {
        placeDownload(*download);
      }
    } else if (answer.status == kRangeNotThere && download->request.from_byte > 0) {
      // The part is as long as the whole, or longer: it may be of another file.
      beginAnew(download, answer);
    } else {
      download->end(wire::failed(answer, subjectOf(download->key)));
    }
  });
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
  wire::send(task, server_.http, server_.request(pathOf(key) + QStringLiteral("/player")),
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
  net::HttpRequest request = server_.request(
      pathOf(key) + QStringLiteral("/player"),
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

void BagRequests::remove(const Task& task, const BagKey& key, OutcomeTo<BagKey> reply) {
  net::HttpRequest request = server_.request(pathOf(key));
  request.method = net::HttpMethod::Delete;
  wire::send(task, server_.http, request, [key, reply = std::move(reply)](const net::HttpAnswer& answer) {
    if (answer.ok()) return reply(key);
    reply(fail(wire::failed(answer, subjectOf(key), map::AskedFor::Change)));
  });
}

void BagRequests::download(const Task& task, const BagKey& key, const QString& path,
                           OutcomeTo<BagDownload> reply) {
  const auto row =
      std::find_if(listed_.begin(), listed_.end(), [&](const BagEntry& entry) { return entry.key == key; });
  const DownloadPtr download(
      new Download{.task = task,
                   .http = server_.http,
                   .request = server_.request(pathOf(key) + QStringLiteral("/download")),
                   .key = key,
                   .path = path,
                   .row = row == listed_.end() ? std::nullopt : std::optional(*row),
                   .part = {},
                   .held_of = {},
                   .of_bytes = {},
                   .trouble = {},
                   .reply = std::move(reply)});
  download->part.setFileName(download->path + QStringLiteral(".part"));
  if (QFileInfo(download->path).isDir()) {
    download->end(download->notWritten(qt_error_string(EISDIR)));
    return;
  }
  if (!download->part.open(QIODevice::ReadWrite) || !download->part.seek(download->part.size())) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  download->held_of = readPartOf(download->path);
  const bool unknown = download->held_of.etag.isEmpty() && download->held_of.listed.isEmpty();
  if (unknown && (!download->part.resize(0) || !download->part.seek(0))) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  download->begun_at = download->part.size();
  download->request.accept = "*/*";
  download->request.max_bytes = kMostDownload;
  download->request.from_byte = download->begun_at;
  if (download->begun_at == 0) download->held_of = {};
  download->request.if_etag = download->held_of.etag;
  // The request must not keep its own download alive after its end.
  download->request.take = [weak = std::weak_ptr<Download>(download)](const net::HttpPart& received) {
    const DownloadPtr alive = weak.lock();
    return alive && alive->take(received);
  };
  sendDownload(download);
}

}  // namespace mapwright::robot::axbot
