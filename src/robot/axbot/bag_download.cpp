#include "robot/axbot/bag_download.h"

#include <cstdio>
#include <memory>
#include <utility>

#include <QFile>
#include <QFileInfo>

#include "robot/axbot/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/http_errand.h"
#include "robot/wire/http_failure.h"

namespace mapwright::robot::axbot {
namespace {

constexpr qint64 kMost = qint64(1) << 40;
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
  wire::ErrandPtr errand;
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
      errand->tell({part.pos(), of_bytes});
      return true;
    }
    trouble = notWritten(part.errorString());
    return false;
  }
};
using DownloadPtr = std::shared_ptr<Download>;

void place(Download& download) {
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

void send(const DownloadPtr& download);

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
  send(download);
}

void send(const DownloadPtr& download) {
  wire::send(download->errand, download->http, download->request, [download](const net::HttpAnswer& answer) {
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
        place(*download);
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

void startDownload(wire::ErrandPtr errand, net::HttpClient& http, net::HttpRequest request, BagKey key,
                   std::optional<BagEntry> row, QString path, OutcomeTo<BagDownload> reply) {
  const DownloadPtr download(new Download{.errand = std::move(errand),
                                          .http = http,
                                          .request = std::move(request),
                                          .key = std::move(key),
                                          .path = std::move(path),
                                          .row = std::move(row),
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
  download->request.max_bytes = kMost;
  download->request.from_byte = download->begun_at;
  if (download->begun_at == 0) download->held_of = {};
  download->request.if_etag = download->held_of.etag;
  // The request must not keep its own download alive after its end.
  download->request.take = [weak = std::weak_ptr<Download>(download)](const net::HttpPart& received) {
    const DownloadPtr alive = weak.lock();
    return alive && alive->take(received);
  };
  send(download);
}

}  // namespace mapwright::robot::axbot
