// HTTP to one robot: bounded, cancellable, with the secret sent only to its own origin, answers cached on
// disk, and changes never sent twice. Source: docs/protocols/autoxing.md, "Requests";
// docs/protocols/cartographer-submaps.md, "Versions, caching and fetching".
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QUrl>

#include "net/faults.h"
#include "net/trust.h"

namespace mapwright::net {

class HttpCache;

/// All but Get are sent at most once, over a connection of their own, and are never redirected or cached.
enum class HttpMethod { Get, Post, Put, Patch, Delete };

/// How much of a body has been transferred: of the request's (`up`), later of the answer's.
struct HttpProgress {
  bool up = false;
  qint64 bytes = 0;
  std::optional<qint64> of_bytes;  // nullopt = not known
};

/// A part of a body in transfer (HttpRequest::receive).
struct HttpPart {
  int status = 0;                  // 206: continues where the request said; 200: starts over
  std::optional<qint64> of_bytes;  // of this body; nullopt = unknown
  QByteArray bytes;
  // For a 206, from its Content-Range: where it begins, and the total length; nullopt = not given.
  std::optional<qint64> from_byte = {};
  std::optional<qint64> whole_bytes = {};
  QByteArray etag = {};  // as sent; empty = none
};

struct HttpRequest {
  HttpMethod method = HttpMethod::Get;
  QUrl url;  // absolute
  QByteArray accept = "application/json";
  QByteArray body;                               // of any method but Get
  QByteArray content_type = "application/json";  // of `body`, if that is not empty
  bool cacheable = false;                        // read from and written to the disk cache
  bool content_addressed =
      false;  // the URL contains a version: without Cache-Control and ETag the body is stored permanently
  qint64 max_bytes = qint64(256) << 20;  // longer bodies are cut off and fail
  std::chrono::milliseconds timeout{
      30'000};  // without any byte sent or received, once the request has started
  std::function<void(HttpProgress)> progress = {};  // called before the answer; may cancel, must not destroy
  qint64 from_byte = 0;  // > 0: only the bytes from there on, if the server supports it (Range)
  QByteArray if_etag =
      {};  // with from_byte: restart if the content has changed (If-Range); empty = any content
  /// Gets the parts of a 2xx body instead of the answer, whose body is then empty; false ends the request as
  /// cancelled. Must neither cancel nor destroy. Cannot be combined with `cacheable`.
  std::function<bool(const HttpPart&)> receive = {};
  // Waits while this many requests that set a limit are in progress; 0 = only kInFlight counts.
  int most_at_once = 0;
};

struct HttpAnswer {
  enum class Kind { Answered, Unreachable, TimedOut, TooLarge, Refused, Certificate, Cancelled };
  Kind kind = Kind::Unreachable;
  int status = 0;  // HTTP status when Answered (304 becomes the stored 200), or as far as known
  /// Part of the request may have been sent. False is certain: the server has not seen it.
  bool sent = false;
  QByteArray body;
  QByteArray content_type;
  Fault reason;                                 // why it is not a 2xx; None = it is
  QString said;                                 // the robot's own error text; plain text, empty = none
  bool from_cache = false;                      // nothing was transferred: fresh on disk, or 304
  std::optional<CertificateFault> certificate;  // of Kind::Certificate
  bool ok() const { return kind == Kind::Answered && status >= 200 && status < 300; }
};

/// Sends requests to one robot. Lives on the thread that made it; callbacks arrive there from its event loop,
/// exactly once, never from within send(), cancel() or cancelAll(), and not after it is destroyed. At most
/// kInFlight requests are in progress at once, the others wait; answers that are fresh on disk do not wait.
class HttpClient : public QObject {
  Q_OBJECT
 public:
  static constexpr int kInFlight = 6;

  /// `origin`: scheme, host, port that `secret` belongs to. The `Secret:` header is sent to that origin only;
  /// a redirect to another origin is refused. `cache` may be null and must outlive the client. No secret is
  /// ever logged or part of a sentence.
  HttpClient(const QUrl& origin, const QByteArray& secret, HttpCache* cache, QObject* parent = nullptr);
  ~HttpClient() override;

  using Reply = std::function<void(HttpAnswer)>;
  using RequestId = quint64;
  RequestId send(const HttpRequest& request, Reply reply);
  void cancel(RequestId id);  // the reply comes with Kind::Cancelled; unknown ids are ignored
  void cancelAll();
  /// Which certificates to trust from the next connection on; idle connections are closed.
  void setTrust(const Trust& trust);
  /// The answer from `url` is unusable: it is not stored, and the next request bypasses the cache and sends
  /// no ETag.
  void discard(const QUrl& url);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net
