#include "net/http_client.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <QSet>

#include "net/http_job.h"
#include "net/log.h"
#include "net/plain_sentences.h"

namespace mapwright::net {

namespace {

constexpr int kMaxRedirects = 5;
constexpr qsizetype kMostUnusable = 100'000;

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
    tls_ = configurationFor(trust);
    network_.clearConnectionCache();
  }

  void discard(const QUrl& url) {
    if (cache_ == nullptr) return;
    cache_->remove(url);
    // A file that cannot be removed, or that another process writes again, is not trusted either.
    if (unusable_.size() < kMostUnusable) unusable_.insert(url.toEncoded());
  }

  void cancelAll() {
    std::vector<RequestId> ids;
    for (const auto& [id, job] : jobs_) {
      ids.push_back(id);
    }
    for (const RequestId id : ids) {
      cancel(id);
    }
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
      finish(id, failure(HttpAnswer::Kind::Refused, fault::NoWebAddress));
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
    if (changes) {
      // Its parent makes sure that it is destroyed with the client: deferred deletion at the end of a thread
      // would never happen.
      job.own_network = new QNetworkAccessManager(&network_);
      job.own_network->setAutoDeleteReplies(false);
    }
    QNetworkAccessManager& network = changes ? *job.own_network : network_;
    job.upload = new OneWayBody(changes ? job.request.body : QByteArray());
    job.network_reply =
        network.sendCustomRequest(requestOf(job, secret_, tls_), verbOf(job.request.method), job.upload);
    job.upload->setParent(job.network_reply);
    job.heard_sent = false;
    QObject::connect(job.network_reply, &QNetworkReply::uploadProgress, owner_,
                     [this, id](qint64 sent, qint64 total) { noteSent(id, sent, total); });
    job.network_reply->setReadBufferSize(kReadAhead);
    QObject::connect(job.network_reply, &QNetworkReply::metaDataChanged, owner_,
                     [this, id] { checkHeaders(id); });
    QObject::connect(job.network_reply, &QNetworkReply::readyRead, owner_, [this, id] { takeBytes(id); });
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

  void noteSent(RequestId id, qint64 bytes, qint64 total) {
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
  bool takeBytes(RequestId id) {
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
    if (!job.request.take || status < 200 || status >= 300) {
      job.body += part;
      return true;
    }
    const qint64 length = declaredLength(*job.network_reply);
    job.handed_over += part.size();
    return job.request.take(partOf(job, status, length > 0 ? std::optional(length) : std::nullopt, part));
  }

  void conclude(RequestId id) {
    if (!takeBytes(id)) {
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
      finish(id, failure(HttpAnswer::Kind::Refused, fault::LeadsToAnotherAddress));
      return;
    }
    if (++job.redirects > kMaxRedirects) {
      finish(id, failure(HttpAnswer::Kind::Refused, fault::LeadsInCircles));
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
    later([this, id] { tell(id); });
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

  void tell(RequestId id) {
    auto node = jobs_.extract(id);
    if (!node.empty() && node.mapped().reply) {
      node.mapped().reply(std::move(*node.mapped().answer));  // may destroy the client
    }
  }

  HttpClient* owner_;
  Secret secret_;
  Trust trust_;
  QSslConfiguration tls_ = configurationFor({});
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
    : QObject(parent), impl_(std::make_unique<Impl>(this, Secret(origin, secret), cache)) {}

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
