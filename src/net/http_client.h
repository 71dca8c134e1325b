// HTTP to one robot: bounded, cancellable, secret kept to its own origin, cached on disk.
// Source: axbot.md "Requests"; submap-textures.md "Versions, cache and fetch rules".
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QUrl>

#include "net/trust.h"

namespace mapwright::net {

class HttpCache;

struct HttpRequest {
  QUrl url;  // absolute
  QByteArray accept = "application/json";
  bool post = false;  // POST of `body`; never sent twice by itself, never redirected, never cached
  QByteArray body;    // of a POST
  QByteArray content_type = "application/json";  // of `body`
  bool cacheable = false;                        // look into and fill the disk cache
  bool content_addressed =
      false;  // the URL names a version: without Cache-Control and ETag the body is kept for good
  qint64 max_bytes = qint64(256) << 20;       // a longer body is cut off and fails
  std::chrono::milliseconds timeout{30'000};  // without any byte arriving, once the request has been sent
};

struct HttpAnswer {
  enum class Kind { Answered, Unreachable, TimedOut, TooLarge, Refused, Certificate, Cancelled };
  Kind kind = Kind::Unreachable;
  int status = 0;  // HTTP status when Answered (304 is resolved to the stored 200)
  QByteArray body;
  QByteArray content_type;
  QString sentence;  // for people: why it is not a 2xx; plain text, at most 300 characters, never markup
  bool from_cache = false;                      // the body did not travel: fresh on disk, or 304
  std::optional<CertificateFault> certificate;  // of Kind::Certificate
  bool ok() const { return kind == Kind::Answered && status >= 200 && status < 300; }
};

/// Asks one robot. Lives on the thread that made it; callbacks arrive there from its event loop, exactly
/// once, never from within get(), cancel() or cancelAll(). A destroyed client calls nobody any more. At most
/// kInFlight requests are under way at once, the others wait their turn; answers that are fresh on disk do
/// not wait.
class HttpClient : public QObject {
  Q_OBJECT
 public:
  static constexpr int kInFlight = 6;

  /// `origin`: scheme, host, port that `secret` belongs to. The `Secret:` header goes to that origin only; a
  /// redirect to another origin is refused. `cache` may be null and outlives the client. No secret is ever
  /// logged or part of a sentence.
  HttpClient(const QUrl& origin, const QByteArray& secret, HttpCache* cache, QObject* parent = nullptr);
  ~HttpClient() override;

  using Reply = std::function<void(HttpAnswer)>;
  using RequestId = quint64;
  /// Sends `request`, a GET unless it says otherwise.
  RequestId get(const HttpRequest& request, Reply reply);
  /// The same as a POST.
  RequestId post(HttpRequest request, Reply reply);
  void cancel(RequestId id);  // the reply comes with Kind::Cancelled; unknown ids are ignored
  void cancelAll();
  /// Whom to believe from the next connection on; idle ones are dropped.
  void setTrust(const Trust& trust);
  /// What came from `url` is of no use: it is not kept, and the next request for it asks the robot itself,
  /// whatever is on disk and without the ETag of what was there.
  void discard(const QUrl& url);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net
