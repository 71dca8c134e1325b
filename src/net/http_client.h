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

/// A part of a body in transfer (HttpRequest::take).
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
  qint64 max_bytes = qint64(256) << 20;       // longer bodies are cut off and fail
  std::chrono::milliseconds timeout{30'000};  // without a byte going out or coming in, once it is its turn
  std::function<void(HttpProgress)> progress = {};  // told before the answer; may cancel, must not destroy
  qint64 from_byte = 0;     // > 0: only what comes from there on, where the server can (Range)
  QByteArray if_etag = {};  // with from_byte: else it is to begin anew (If-Range); empty = whatever it is
  /// Gets the parts of a 2xx body instead of the answer, which then has none; false ends the request as
  /// cancelled. Must neither cancel nor destroy. Never together with `cacheable`.
  std::function<bool(const HttpPart&)> take = {};
  // With so many under way that name a number here it waits; 0 = it only counts to kInFlight.
  int most_at_once = 0;
};

struct HttpAnswer {
  enum class Kind { Answered, Unreachable, TimedOut, TooLarge, Refused, Certificate, Cancelled };
  Kind kind = Kind::Unreachable;
  int status = 0;  // HTTP status when Answered (304 is resolved to the stored 200), or as far as that came
  /// Some of the request may have left this computer. False is certain: nobody has seen it.
  bool sent = false;
  QByteArray body;
  QByteArray content_type;
  Fault reason;  // why it is not a 2xx; None = it is
  QString said;  // what the robot itself said about its error; plain text likewise, empty = nothing
  bool from_cache = false;                      // the body did not travel: fresh on disk, or 304
  std::optional<CertificateFault> certificate;  // of Kind::Certificate
  bool ok() const { return kind == Kind::Answered && status >= 200 && status < 300; }
};

/// Asks one robot. Lives on the thread that made it; callbacks arrive there from its event loop, exactly
/// once, never from within send(), cancel() or cancelAll(). A destroyed client calls nobody any more. At most
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
  RequestId send(const HttpRequest& request, Reply reply);
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
