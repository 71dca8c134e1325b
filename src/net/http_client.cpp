#include "net/http_client.h"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QIODevice>
#include <QLocale>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QSet>
#include <QTimer>

#include "net/http_cache.h"
#include "net/log.h"
#include "net/openssl_exit.h"
#include "net/plain_sentences.h"
#include "net/secret.h"

namespace mapwright::net {

namespace {

constexpr int kMaxRedirects = 5;
constexpr qsizetype kMostUnusable = 100'000;
constexpr qint64 kReadAhead = qint64(1) << 20;  // how much Qt may buffer that has not been counted yet

}  // namespace

/// A body that can be read once and cannot be rewound.
class SequentialBody : public QIODevice {
 public:
  explicit SequentialBody(QByteArray bytes) : bytes_(std::move(bytes)) { open(QIODevice::ReadOnly); }
  /// Whether any of it was read: the server may have received all of it.
  bool begun() const { return begun_; }
  bool isSequential() const override { return true; }
  bool seek(qint64) override { return false; }
  bool atEnd() const override { return read_ >= bytes_.size() && QIODevice::atEnd(); }
  qint64 bytesAvailable() const override { return bytes_.size() - read_ + QIODevice::bytesAvailable(); }

 protected:
  qint64 readData(char* to, qint64 most) override {
    begun_ = true;
    const qint64 count = std::min<qint64>(most, bytes_.size() - read_);
    if (count <= 0) return -1;
    std::copy_n(bytes_.constData() + read_, count, to);
    read_ += count;
    return count;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  QByteArray bytes_;
  qint64 read_ = 0;
  bool begun_ = false;
};

/// One request in progress.
struct HttpJob {
  HttpRequest request;
  HttpClient::Reply reply;
  QUrl url;  // the current one: after redirects not the original one
  int redirects = 0;
  std::optional<CachedAnswer> stored;
  std::optional<HttpAnswer> answer;              // set: the reply only has to be delivered
  QNetworkAccessManager* own_network = nullptr;  // a fresh connection, with TLS
  QNetworkReply* network_reply = nullptr;
  SequentialBody* upload = nullptr;  // of network_reply
  bool heard_sent = false;           // of this request
  std::unique_ptr<QTimer> silence;
  QElapsedTimer since_sent;  // the last time
  QByteArray body;
  qint64 handed_over = 0;  // of the body, to HttpRequest::receive
  qint64 received() const { return body.size() + handed_over; }
};

namespace {

/// Before there was a connection, so nothing can have been sent.
bool neverConnected(QNetworkReply::NetworkError error) {
  switch (error) {
    case QNetworkReply::ConnectionRefusedError:
    case QNetworkReply::HostNotFoundError:
    case QNetworkReply::SslHandshakeFailedError:
    case QNetworkReply::ProxyConnectionRefusedError:
    case QNetworkReply::ProxyNotFoundError:
      return true;
    default:
      return false;
  }
}

QString grouped(qint64 number) { return QLocale(QLocale::English).toString(number); }

Fault unreachableReason(QNetworkReply::NetworkError error, const QString& error_text, const QUrl& url) {
  switch (error) {
    case QNetworkReply::ConnectionRefusedError:
      return faultOf(fault::ConnectionRefused, {hostAndPort(url)});
    case QNetworkReply::HostNotFoundError:
      return faultOf(fault::HostUnknown, {plainText(url.host())});
    case QNetworkReply::RemoteHostClosedError:
    case QNetworkReply::ContentReSendError:  // closed before an answer, and nothing is sent twice
      return fault::ConnectionClosed;
    case QNetworkReply::SslHandshakeFailedError:
      return faultOf(fault::ConnectionNotSecure, {hostAndPort(url), plainText(error_text)});
    case QNetworkReply::TimeoutError:
      return faultOf(fault::HostSilent, {hostAndPort(url)});
    case QNetworkReply::UnknownNetworkError:
      return faultOf(faultText("net", "the connection to %1 was lost"), {hostAndPort(url)});
    default:
      return faultOf(fault::HostNotReached, {hostAndPort(url), plainText(error_text)});
  }
}

QByteArray verbOf(HttpMethod method) {
  constexpr std::array kVerbs{"GET", "POST", "PUT", "PATCH", "DELETE"};
  return kVerbs.at(std::size_t(method));
}

/// The request for `job.url`, without its body. `trust` is for https.
QNetworkRequest requestOf(const HttpJob& job, const Secret& secret, const Trust& trust) {
  QNetworkRequest request(job.url);
  request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
  request.setAttribute(QNetworkRequest::CacheLoadControlAttribute, QNetworkRequest::AlwaysNetwork);
  request.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
  request.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
  request.setAttribute(QNetworkRequest::AuthenticationReuseAttribute, QNetworkRequest::Manual);
  request.setAttribute(QNetworkRequest::Http2AllowedAttribute, false);
  request.setDecompressedSafetyCheckThreshold(-1);
  request.setRawHeader("Accept", headerSafe(job.request.accept));
  if (const QByteArray value = secret.forUrl(job.url); !value.isEmpty()) {
    request.setRawHeader("Secret", value);
  }
  if (job.url.scheme() == QLatin1String("https")) {
    request.setSslConfiguration(configurationFor(trust));
  }
  if (job.stored && !job.stored->etag.isEmpty()) {
    request.setRawHeader("If-None-Match", headerSafe(job.stored->etag));
  }
  if (job.request.from_byte > 0) {
    request.setRawHeader("Range", "bytes=" + QByteArray::number(job.request.from_byte) + "-");
    // A weak one does not identify bytes (RFC 9110, 13.1.5).
    const QByteArray& etag = job.request.if_etag;
    if (!etag.isEmpty() && !etag.startsWith("W/")) request.setRawHeader("If-Range", headerSafe(etag));
  }
  // Left to itself Qt asks again, at once and up to three times, when the connection closes without an
  // answer: behind the back of whoever counts tries and waits between them, and of whoever changes
  // something. A body that cannot be rewound (SequentialBody), empty as it is for GET, forbids that.
  const bool changes = job.request.method != HttpMethod::Get;
  const qsizetype length = changes ? job.request.body.size() : 0;
  if (length > 0) request.setRawHeader("Content-Type", headerSafe(job.request.content_type));
  request.setHeader(QNetworkRequest::ContentLengthHeader, length);
  request.setAttribute(QNetworkRequest::DoNotBufferUploadDataAttribute, true);
  // The server may close an idle connection just when it is used again; a request sent then is lost, and
  // nobody knows whether it was received.
  if (changes) request.setRawHeader("Connection", "close");
  return request;
}

bool isRedirect(int status) {
  return status == 301 || status == 302 || status == 303 || status == 307 || status == 308;
}

/// As announced by the server; 0 = not given.
qint64 declaredLength(const QNetworkReply& reply) {
  return reply.header(QNetworkRequest::ContentLengthHeader).toLongLong();
}

/// A part of a body, with what its headers say about the whole.
HttpPart partOf(const HttpJob& job, int status, std::optional<qint64> of_bytes, const QByteArray& bytes) {
  HttpPart part{status, of_bytes, bytes};
  part.etag = job.network_reply->rawHeader("ETag");
  if (status != 206) return part;
  // "bytes 1000-1999/5000", "bytes 1000-1999/*" (RFC 9110, 14.4).
  QByteArray words = job.network_reply->rawHeader("Content-Range").trimmed();
  if (!words.toLower().startsWith("bytes ")) return part;
  words.remove(0, 6);
  const auto slash = words.indexOf('/'), dash = words.indexOf('-');
  if (slash < 0 || dash < 0 || dash > slash) return part;
  const auto number = [](const QByteArray& digits) {
    bool good = false;
    const qint64 value = digits.trimmed().toLongLong(&good);
    return good && value >= 0 ? std::optional(value) : std::nullopt;
  };
  part.from_byte = number(words.left(dash));
  part.whole_bytes = number(words.mid(slash + 1));
  return part;
}

/// The connection ended before the end of the body.
bool isShort(const HttpJob& job, int status) {
  const QNetworkReply& reply = *job.network_reply;
  if (status == 304 || status == 204 || reply.hasRawHeader("Content-Encoding") ||
      !reply.hasRawHeader("Content-Length")) {
    return false;
  }
  return job.received() < declaredLength(reply);
}

/// Whether any part of the request may have been sent, if the job ends as `kind`.
bool maySent(const HttpJob& job, HttpAnswer::Kind kind) {
  if (job.network_reply == nullptr || kind == HttpAnswer::Kind::Certificate) return false;
  if (job.redirects > 0 || job.heard_sent || job.upload->begun()) return true;
  if (job.network_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).isValid()) return true;
  if (neverConnected(job.network_reply->error())) return false;
  // A body is read only once there is a connection. Without a body only a signal of the other thread tells,
  // and that may be delayed.
  const bool has_body = job.request.method != HttpMethod::Get && !job.request.body.isEmpty();
  const bool long_ago = kind == HttpAnswer::Kind::TimedOut;
  return !has_body && !long_ago;
}

HttpAnswer failure(HttpAnswer::Kind kind, Fault reason) {
  HttpAnswer answer;
  answer.kind = kind;
  answer.reason = std::move(reason);
  return answer;
}

/// For a request without a status: why, in the words of the reply.
HttpAnswer unreachable(const HttpJob& job) {
  return failure(HttpAnswer::Kind::Unreachable,
                 unreachableReason(job.network_reply->error(), job.network_reply->errorString(), job.url));
}

HttpAnswer tooLarge(const HttpJob& job) {
  return failure(HttpAnswer::Kind::TooLarge, faultOf(fault::AnswerTooLong, {grouped(job.request.max_bytes)}));
}

HttpAnswer brokenOff(const HttpJob& job) {
  const qint64 length = declaredLength(*job.network_reply);
  return failure(HttpAnswer::Kind::Unreachable,
                 length > 0 ? faultOf(faultText("net", "the answer was cut off after %1 of %2 bytes"),
                                      {grouped(job.received()), grouped(length)})
                            : faultOf(faultText("net", "the answer was cut off after %1 bytes"),
                                      {grouped(job.received())}));
}

/// The robot's answer with `status`. Takes the body.
HttpAnswer answerOf(HttpJob& job, int status) {
  HttpAnswer answer;
  answer.kind = HttpAnswer::Kind::Answered;
  answer.status = status;
  answer.content_type = job.network_reply->rawHeader("Content-Type");
  answer.body = std::move(job.body);
  if (!answer.ok()) {
    answer.said = errorText(answer.body, answer.content_type);
    answer.reason =
        answer.said.isEmpty()
            ? Fault(faultText("net", "the robot answered %1"), {HttpStatus{status}})
            : Fault(fault::AnsweredWithStatusSaying, {HttpStatus{status}, answer.said.toStdString()});
  }
  return answer;
}

/// The answer from the disk.
HttpAnswer storedAnswer(const HttpJob& job) {
  HttpAnswer answer;
  answer.kind = HttpAnswer::Kind::Answered;
  answer.status = 200;
  answer.body = job.stored->body;
  answer.content_type = job.stored->content_type;
  answer.from_cache = true;
  return answer;
}

/// What became of it, for the log.
QString lineOf(const HttpJob& job, const HttpAnswer& answer) {
  QString line =
      QStringLiteral("%1 %2: ").arg(QString::fromLatin1(verbOf(job.request.method)), urlForLog(job.url));
  if (answer.kind == HttpAnswer::Kind::Answered) {
    line += QStringLiteral("%1, ").arg(answer.status);
    line += QStringLiteral("%1 bytes").arg(answer.body.size() + (answer.from_cache ? 0 : job.handed_over));
    if (answer.from_cache) line += QStringLiteral(", from disk");
  } else if (answer.status > 0) {
    line += QStringLiteral("%1, but ").arg(answer.status);
  }
  if (answer.kind != HttpAnswer::Kind::Answered) line += QString::fromStdString(inEnglish(answer.reason));
  if (job.since_sent.isValid()) line += QStringLiteral(" (%1 ms)").arg(job.since_sent.elapsed());
  if (!answer.said.isEmpty()) line += QStringLiteral(": ") + answer.said;
  return line;
}

}  // namespace

class HttpClient::Impl {
 public:
  Impl(HttpClient* owner, Secret secret, HttpCache* cache)
      : owner_(owner), secret_(std::move(secret)), cache_(cache) {
    // The size of unpacked bodies is limited here, request by request.
    network_.setAutoDeleteReplies(false);
  }

  ~Impl() {
    for (auto& [id, job] : jobs_) {
      drop(job);
    }
  }

  RequestId add(const HttpRequest& request, Reply reply) {
    const RequestId id = ++last_id_;
    HttpJob& job = jobs_[id];
    job.request = request;
    job.reply = std::move(reply);
    job.url = request.url;
    later([this, id] { begin(id); });
    return id;
  }

  void cancel(RequestId id) {
    if (jobs_.contains(id)) {
      finish(id, failure(HttpAnswer::Kind::Cancelled, fault::RequestCancelled));
    }
  }

  void setTrust(const Trust& trust) {
    trust_ = trust;
    network_.clearConnectionCache();
  }

  void discard(const QUrl& url) {
    if (cache_ == nullptr) return;
    cache_->remove(url);
    // A file that cannot be removed, or that another process writes again, is not trusted either.
    if (unusable_.size() < kMostUnusable) unusable_.insert(url.toEncoded());
  }

  void cancelAll() {
    for (const auto& [id, job] : jobs_) cancel(id);  // jobs leave when their answer is delivered
  }

 private:
  template <typename Call>
  void later(Call call) {
    QMetaObject::invokeMethod(owner_, std::move(call), Qt::QueuedConnection);
  }

  bool cached(const HttpJob& job) const {
    return job.request.cacheable && job.request.method == HttpMethod::Get && cache_ != nullptr;
  }

  /// The job, unless it is gone or finished.
  HttpJob* active(RequestId id) {
    const auto found = jobs_.find(id);
    return found == jobs_.end() || found->second.answer ? nullptr : &found->second;
  }

  void begin(RequestId id) {
    HttpJob* job = active(id);
    if (job == nullptr) {
      return;
    }
    const QString scheme = job->url.scheme();
    if (!job->url.isValid() || job->url.host().isEmpty() ||
        (scheme != QLatin1String("http") && scheme != QLatin1String("https"))) {
      finish(id,
             failure(HttpAnswer::Kind::Refused, faultText("net", "this is not the address of a web server")));
      return;
    }
    const bool unusable = unusable_.remove(job->url.toEncoded());
    if (cached(*job) && !unusable) {
      job->stored = cache_->find(job->url);
      if (job->stored && job->stored->fresh) {
        finish(id, storedAnswer(*job));
        return;
      }
    }
    waiting_.push_back(id);
    startWaiting();
  }

  void startWaiting() {
    for (auto at = waiting_.begin(); at != waiting_.end() && in_flight_ < kInFlight;) {
      const RequestId id = *at;
      HttpJob* const job = active(id);
      const int most = job != nullptr ? job->request.most_at_once : 0;
      if (most > 0 && bounded_in_flight_ >= most) {
        ++at;  // others may pass it
        continue;
      }
      at = waiting_.erase(at);
      if (job == nullptr) continue;
      ++in_flight_;
      bounded_in_flight_ += most > 0;
      send(id, *job);
    }
  }

  void send(RequestId id, HttpJob& job) {
    job.body.clear();
    job.handed_over = 0;
    const bool changes = job.request.method != HttpMethod::Get;
    QNetworkRequest request = requestOf(job, secret_, trust_);
    if (changes && job.url.scheme() == QLatin1String("https")) {
      // Its parent makes sure that it is destroyed with the client: deferred deletion at the end of a thread
      // would never happen.
      job.own_network = new QNetworkAccessManager(&network_);
      job.own_network->setAutoDeleteReplies(false);
    } else if (changes) {
      // Qt uses a connection again for the same address and the same name in the certificate. Without TLS
      // this name has no other use, and a connection of its own needs no thread of its own.
      request.setPeerVerifyName(QStringLiteral("change %1").arg(id));
    }
    QNetworkAccessManager& network = job.own_network ? *job.own_network : network_;
    job.upload = new SequentialBody(changes ? job.request.body : QByteArray());
    job.network_reply = network.sendCustomRequest(request, verbOf(job.request.method), job.upload);
    job.upload->setParent(job.network_reply);
    job.heard_sent = false;
    QObject::connect(job.network_reply, &QNetworkReply::uploadProgress, owner_,
                     [this, id](qint64 sent, qint64 total) { onSent(id, sent, total); });
    job.network_reply->setReadBufferSize(kReadAhead);
    QObject::connect(job.network_reply, &QNetworkReply::metaDataChanged, owner_,
                     [this, id] { checkHeaders(id); });
    QObject::connect(job.network_reply, &QNetworkReply::readyRead, owner_, [this, id] { onBytes(id); });
    QObject::connect(job.network_reply, &QNetworkReply::finished, owner_, [this, id] { conclude(id); });
    // Both are emitted before anything is sent, so a secret never reaches an untrusted server.
    QObject::connect(job.network_reply, &QNetworkReply::sslErrors, owner_,
                     [this, id](const QList<QSslError>& errors) { judge(id, errors); });
    QObject::connect(job.network_reply, &QNetworkReply::encrypted, owner_, [this, id] { judge(id, {}); });
    if (job.silence == nullptr) {
      job.silence = std::make_unique<QTimer>();
      job.silence->setSingleShot(true);
      QObject::connect(job.silence.get(), &QTimer::timeout, owner_, [this, id] {
        if (const HttpJob* silent = active(id)) {
          finish(id,
                 failure(HttpAnswer::Kind::TimedOut,
                         faultOf(fault::NoAnswerWithin, {durationWords(silent->request.timeout.count())})));
        }
      });
    }
    job.silence->start(job.request.timeout);
    job.since_sent.start();
  }

  void judge(RequestId id, const QList<QSslError>& errors) {
    HttpJob* job = active(id);
    if (job == nullptr || job->network_reply == nullptr) {
      return;
    }
    const QSslCertificate leaf = job->network_reply->sslConfiguration().peerCertificate();
    if (const auto fault = faultOf(trust_, leaf, errors, job->url)) {
      HttpAnswer answer;
      answer.kind = HttpAnswer::Kind::Certificate;
      answer.reason = reasonOf(*fault);
      answer.certificate = fault;
      finish(id, std::move(answer));
    } else if (!errors.isEmpty()) {
      job->network_reply->ignoreSslErrors(errors);
    }
  }

  void onSent(RequestId id, qint64 bytes, qint64 total) {
    HttpJob* job = active(id);
    if (job == nullptr) {
      return;
    }
    // An answer may arrive before the whole request is sent; progress after its end is ignored.
    if (bytes == 0 && total == 0 && job->network_reply->isFinished()) {
      return;
    }
    job->heard_sent = true;
    job->silence->start();
    // Qt does not know the length of a body that cannot be rewound.
    if (const qint64 length = job->request.body.size(); job->request.progress && length > 0 && bytes > 0) {
      job->request.progress({true, bytes, length});
    }
  }

  void checkHeaders(RequestId id) {
    HttpJob* job = active(id);
    if (job == nullptr || job->network_reply == nullptr) {
      return;
    }
    job->silence->start();
    if (declaredLength(*job->network_reply) > job->request.max_bytes) {
      finish(id, tooLarge(*job));
    }
  }

  /// False if the job has ended.
  bool onBytes(RequestId id) {
    HttpJob* job = active(id);
    if (job == nullptr || job->network_reply == nullptr) {
      return false;
    }
    job->silence->start();
    const qint64 before = job->received();
    while (job->network_reply->bytesAvailable() > 0) {
      const qint64 room = job->request.max_bytes - job->received();
      const QByteArray part = job->network_reply->read(std::min(room + 1, kReadAhead));
      if (part.isEmpty()) {
        break;
      }
      if (part.size() > room) {
        finish(id, tooLarge(*job));
        return false;
      }
      if (!keep(*job, part)) {
        finish(id, failure(HttpAnswer::Kind::Cancelled, fault::RequestCancelled));
        return false;
      }
    }
    if (job->request.progress && job->received() != before) {
      const qint64 length = declaredLength(*job->network_reply);
      job->request.progress({false, job->received(), length > 0 ? std::optional(length) : std::nullopt});
      return active(id) != nullptr;
    }
    return true;
  }

  /// False if the receiver wants no more.
  static bool keep(HttpJob& job, const QByteArray& part) {
    const int status = job.network_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    if (!job.request.receive || status < 200 || status >= 300) {
      job.body += part;
      return true;
    }
    const qint64 length = declaredLength(*job.network_reply);
    job.handed_over += part.size();
    return job.request.receive(partOf(job, status, length > 0 ? std::optional(length) : std::nullopt, part));
  }

  void conclude(RequestId id) {
    if (!onBytes(id)) {
      return;
    }
    HttpJob& job = *active(id);
    const QNetworkReply& reply = *job.network_reply;
    const int status = reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    const QNetworkReply::NetworkError error = reply.error();
    // Below 200 are Qt's errors of the connection and of proxies; the others only repeat the HTTP status. A
    // 307 or 308 means "send the same again", which Qt reports as an error of the empty body; it is followed
    // here.
    const bool cannot_rewind = error == QNetworkReply::ContentReSendError;
    const bool broken = cannot_rewind
                            ? !isRedirect(status)
                            : error != QNetworkReply::NoError && error < QNetworkReply::ContentAccessDenied;
    if (status == 0 || broken) {
      finish(id, status == 0 ? unreachable(job) : brokenOff(job));
      return;
    }
    // Qt uses this for a body that cannot be unpacked, and for every unknown status 4xx.
    const bool spoiled = error == QNetworkReply::UnknownContentError && status < 400;
    if (error == QNetworkReply::ProtocolFailure || spoiled || isShort(job, status)) {
      finish(id, brokenOff(job));
      return;
    }
    if (isRedirect(status) && reply.hasRawHeader("Location")) {
      follow(id, job);
      return;
    }
    finish(id, answered(job, status));
  }

  void follow(RequestId id, HttpJob& job) {
    const QUrl target = job.url.resolved(QUrl::fromEncoded(job.network_reply->rawHeader("Location")));
    if (!target.isValid() || !sameOrigin(target, job.url)) {
      finish(id,
             failure(HttpAnswer::Kind::Refused, faultOf(fault::LeadsToAnotherServer, {hostAndPort(target)})));
      return;
    }
    if (job.request.method != HttpMethod::Get) {
      finish(id, failure(HttpAnswer::Kind::Refused,
                         faultText("net", "the robot redirects to another address, which is not followed")));
      return;
    }
    if (++job.redirects > kMaxRedirects) {
      finish(id, failure(HttpAnswer::Kind::Refused, faultText("net", "the robot redirects without end")));
      return;
    }
    qCDebug(lcNet, "%s leads to %s", qUtf8Printable(urlForLog(job.url)), qUtf8Printable(urlForLog(target)));
    job.network_reply->disconnect(owner_);
    job.network_reply->deleteLater();
    job.url = target;
    job.stored.reset();  // its ETag belongs to the original address
    send(id, job);
  }

  HttpAnswer answered(HttpJob& job, int status) {
    const QNetworkReply& reply = *job.network_reply;
    const QByteArray cache_control = reply.rawHeader("Cache-Control");
    const QByteArray etag = reply.rawHeader("ETag");
    const bool caching = cached(job) && job.redirects == 0;
    if (status == 304 && job.stored) {
      cache_->refresh(job.request.url, cache_control, etag);
      return storedAnswer(job);
    }
    HttpAnswer answer = answerOf(job, status);
    if (caching && status == 200) {
      cache_->store(job.request.url, answer.body, answer.content_type, cache_control, etag,
                    job.request.content_addressed);
    } else if (caching && (status == 404 || status == 410)) {
      cache_->remove(job.request.url);
    }
    return answer;
  }

  /// Removes the job from the network; its answer is delivered from the event loop.
  void finish(RequestId id, HttpAnswer answer) {
    HttpJob& job = jobs_.at(id);
    if (job.answer) {
      return;
    }
    answer.sent = maySent(job, answer.kind);
    if (answer.status == 0 && job.network_reply != nullptr) {
      answer.status = job.network_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    }
    qCDebug(lcNet, "%s", qUtf8Printable(lineOf(job, answer)));
    job.answer = std::move(answer);
    if (job.network_reply != nullptr) {
      --in_flight_;
      bounded_in_flight_ -= job.request.most_at_once > 0;
    }
    drop(job);
    later([this, id] { deliver(id); });
    later([this] { startWaiting(); });
  }

  void drop(HttpJob& job) {
    job.silence.reset();
    if (job.network_reply != nullptr) {
      job.network_reply->disconnect(owner_);
      job.network_reply->abort();
      job.network_reply->deleteLater();
      job.network_reply = nullptr;
      job.upload = nullptr;
    }
    if (job.own_network != nullptr) {
      job.own_network->deleteLater();  // with its reply; it may be the sender of the current signal
      job.own_network = nullptr;
    }
  }

  void deliver(RequestId id) {
    auto node = jobs_.extract(id);
    if (!node.empty() && node.mapped().reply) {
      node.mapped().reply(std::move(*node.mapped().answer));  // may destroy the client
    }
  }

  HttpClient* owner_;
  Secret secret_;
  Trust trust_;
  HttpCache* cache_;
  QNetworkAccessManager network_;
  std::map<RequestId, HttpJob> jobs_;
  QSet<QByteArray> unusable_;  // addresses whose last answer was discarded
  std::deque<RequestId> waiting_;
  int in_flight_ = 0;
  int bounded_in_flight_ = 0;  // the ones with a limit of their own
  RequestId last_id_ = 0;
};

HttpClient::HttpClient(const QUrl& origin, const QByteArray& secret, HttpCache* cache, QObject* parent)
    : QObject(parent) {
  keepOpensslAtExit();
  impl_ = std::make_unique<Impl>(this, Secret(origin, secret), cache);
}

HttpClient::~HttpClient() = default;

HttpClient::RequestId HttpClient::send(const HttpRequest& request, Reply reply) {
  return impl_->add(request, std::move(reply));
}

void HttpClient::cancel(RequestId id) { impl_->cancel(id); }

void HttpClient::cancelAll() { impl_->cancelAll(); }

void HttpClient::setTrust(const Trust& trust) { impl_->setTrust(trust); }

void HttpClient::discard(const QUrl& url) { impl_->discard(url); }

}  // namespace mapwright::net

#include "moc_http_client.cpp"
