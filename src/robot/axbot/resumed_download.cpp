#include "robot/axbot/resumed_download.h"

#include <cerrno>
#include <memory>
#include <utility>

#include <QFile>
#include <QFileInfo>

#include "disk/written_file.h"
#include "robot/axbot/faults.h"
#include "robot/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

constexpr qint64 kMostDownload = qint64(1) << 40;
constexpr int kRangeNotThere = 416, kPartial = 206;

/// The origin of a partial download, stored next to it. Without it, a part cannot be trusted and the download
/// starts over.
struct PartOf {
  QByteArray etag;
  std::optional<qint64> bytes;
  QByteArray identity = {};  // empty = unknown
};

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
  file.write(of.etag + '\n' + (of.bytes ? QByteArray::number(*of.bytes) : QByteArray()) + '\n' + of.identity +
             '\n');
}

struct Download {
  wire::TaskPtr task;
  net::HttpClient& http;
  DownloadOrder order;
  OutcomeTo<ResumedDownload> reply;
  disk::Existing existing = disk::existingNow(order.path.toStdString());
  QFile part = {};
  PartOf held_of = {};                  // what is there
  bool unfit = false;                   // the answer does not continue the part, or is of another file
  qint64 begun_at = 0;                  // what existed before
  std::optional<qint64> of_bytes = {};  // of the whole, as announced
  bool begun = false;
  std::optional<map::Failure> trouble = {};

  map::Failure notWritten(Fault why) const {
    return {.kind = map::FailureKind::Unsupported,
            .subject = order.subject,
            .reason = map::FailureReason::Unfit,
            .cause = {robot::fault::BagFileNotWritten, {order.path.toStdString()}, {std::move(why)}}};
  }
  map::Failure notWritten(const QString& why) const { return notWritten(fault::said(why.toStdString())); }
  void end(map::Failure failure) {
    // An empty part does not count.
    if (part.isOpen() && part.size() == 0) {
      part.remove();
      QFile::remove(besidePart(order.path));
    }
    part.close();
    reply(tl::make_unexpected(std::move(failure)));
  }
  /// It continues the existing part.
  bool goesOn(const net::HttpPart& first) const {
    if (first.from_byte != begun_at) return false;
    if (first.whole_bytes && *first.whole_bytes < begun_at) return false;
    if (first.whole_bytes && held_of.bytes && first.whole_bytes != held_of.bytes) return false;
    // A part without an ETag is of somebody else than a robot that gives one.
    if (!first.etag.isEmpty()) return first.etag == held_of.etag;
    return !held_of.identity.isEmpty() && held_of.identity == order.identity;
  }
  /// False if it cannot continue.
  bool begin(const net::HttpPart& first) {
    begun = true;
    if (first.status == kPartial && !goesOn(first)) {
      unfit = true;
      return false;
    }
    if (first.status != kPartial) {
      writePartOf(order.path, {first.etag, first.of_bytes, order.identity});
      begun_at = 0;
      if (!part.resize(0) || !part.seek(0)) {
        trouble = notWritten(part.errorString());
        return false;
      }
    }
    if (first.of_bytes) of_bytes = begun_at + *first.of_bytes;
    return true;
  }
  bool receive(const net::HttpPart& received) {
    if (!begun && !begin(received)) return false;
    // What waits in a buffer is not on the disk, which may be full. QFile does not say why only a part of it
    // was written.
    errno = 0;
    if (part.write(received.bytes) == received.bytes.size() && part.flush()) {
      task->reportProgress({part.pos(), of_bytes});
      return true;
    }
    trouble = notWritten(errno != 0 ? qt_error_string(errno) : part.errorString());
    return false;
  }
};
using DownloadPtr = std::shared_ptr<Download>;

void moveDownload(Download& download) {
  const qint64 bytes = download.part.pos();
  // If the answer has no length, a premature end looks like the end; and one that is whole by its length may
  // be something else, with which nothing goes on. A bag that is still recorded may have grown.
  const auto told = download.order.told_bytes;
  if (told && (bytes < *told || (download.order.exactly && bytes > *told))) {
    if (download.of_bytes == bytes) download.part.resize(0);
    download.of_bytes = *told;
  }
  if (download.of_bytes && *download.of_bytes != bytes) {
    download.end(
        wire::unfit(download.order.subject, {fault::BagFileOfOtherSize, {bytes, *download.of_bytes}}));
    return;
  }
  if (!download.part.flush()) {
    download.end(download.notWritten(download.part.errorString()));
    return;
  }
  download.part.close();
  QFile::remove(besidePart(download.order.path));
  if (auto problem = disk::moveInto(download.part.fileName().toStdString(), download.order.path.toStdString(),
                                    download.existing)) {
    download.end(download.notWritten(std::move(problem->cause)));
    return;
  }
  download.reply(ResumedDownload{bytes, download.begun_at > 0});
}

void sendDownload(const DownloadPtr& download);

/// Drops the part and requests the whole.
void beginAnew(const DownloadPtr& download, const net::HttpAnswer& answer) {
  if (download->order.request.from_byte == 0) {
    // The whole was asked for, and a part came.
    download->end(wire::unfit(
        download->order.subject,
        {fault::BagFileOfOtherSize, {std::int64_t(0), std::int64_t(download->of_bytes.value_or(0))}}));
    return;
  }
  if (answer.kind == net::HttpAnswer::Kind::Refused) {
    download->end(wire::failed(answer, download->order.subject));
    return;
  }
  download->unfit = download->begun = false;
  download->begun_at = 0;
  download->of_bytes.reset();
  download->held_of = {};
  download->order.request.from_byte = 0;
  download->order.request.if_etag.clear();
  if (!download->part.resize(0) || !download->part.seek(0)) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  sendDownload(download);
}

void sendDownload(const DownloadPtr& download) {
  wire::send(download->task, download->http, download->order.request,
             [download](const net::HttpAnswer& answer) {
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
                   moveDownload(*download);
                 }
               } else if (answer.status == kRangeNotThere && download->order.request.from_byte > 0) {
                 // The part is as long as the whole, or longer: it may be of another file.
                 beginAnew(download, answer);
               } else {
                 download->end(wire::failed(answer, download->order.subject));
               }
             });
}

}  // namespace

void downloadResumed(const wire::TaskPtr& task, net::HttpClient& http, DownloadOrder order,
                     OutcomeTo<ResumedDownload> reply) {
  const DownloadPtr download(new Download{task, http, std::move(order), std::move(reply)});
  net::HttpRequest& request = download->order.request;
  download->part.setFileName(download->order.path + QStringLiteral(".part"));
  if (QFileInfo(download->order.path).isDir()) {
    download->end(download->notWritten(qt_error_string(EISDIR)));
    return;
  }
  if (!download->part.open(QIODevice::ReadWrite) || !download->part.seek(download->part.size())) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  download->held_of = readPartOf(download->order.path);
  const bool unknown = download->held_of.etag.isEmpty() && download->held_of.identity.isEmpty();
  if (unknown && (!download->part.resize(0) || !download->part.seek(0))) {
    download->end(download->notWritten(download->part.errorString()));
    return;
  }
  download->begun_at = download->part.size();
  request.accept = "*/*";
  request.max_bytes = kMostDownload;
  request.from_byte = download->begun_at;
  if (download->begun_at == 0) download->held_of = {};
  request.if_etag = download->held_of.etag;
  // The request must not keep its own download alive after its end.
  request.receive = [weak = std::weak_ptr<Download>(download)](const net::HttpPart& received) {
    const DownloadPtr alive = weak.lock();
    return alive && alive->receive(received);
  };
  sendDownload(download);
}

}  // namespace mapwright::robot::axbot
