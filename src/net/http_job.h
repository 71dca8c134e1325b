// One request of an HttpClient on its way: what goes out for it, and what is answered. Who is asked when is
// the client's business.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QElapsedTimer>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QTimer>
#include <QUrl>

#include "net/http_cache.h"
#include "net/http_client.h"
#include "net/one_way_body.h"
#include "net/secret.h"

namespace mapwright::net {

struct HttpJob {
  HttpRequest request;
  HttpClient::Reply reply;
  QUrl url;  // the one under way: after redirects not the one asked for
  int redirects = 0;
  std::optional<CachedAnswer> stored;
  std::optional<HttpAnswer> answer;              // set: only waits to be told
  QNetworkAccessManager* own_network = nullptr;  // a connection that nothing was sent over before
  QNetworkReply* network_reply = nullptr;
  OneWayBody* upload = nullptr;  // of network_reply
  bool heard_sent = false;       // of this request
  std::unique_ptr<QTimer> silence;
  QElapsedTimer since_sent;  // the last time
  QByteArray body;
  qint64 handed_over = 0;  // of the body, to HttpRequest::take
  qint64 received() const { return body.size() + handed_over; }
};

inline constexpr qint64 kReadAhead = qint64(1) << 20;  // what Qt may hold back that was not counted yet

QByteArray verbOf(HttpMethod method);
/// The request as it goes out, of a job that is at `job.url`, without its body. `tls` is for https.
QNetworkRequest requestOf(const HttpJob& job, const Secret& secret, const QSslConfiguration& tls);
bool isRedirect(int status);
/// As the server announced it; 0 = it did not.
qint64 declaredLength(const QNetworkReply& reply);
/// A part of a body, with what its headers say of the whole.
HttpPart partOf(const HttpJob& job, int status, std::optional<qint64> of_bytes, const QByteArray& bytes);
/// The connection ended before the body did.
bool isShort(const HttpJob& job, int status);
/// Whether anything of the request may have left this computer, where the job ends as `kind`.
bool maySent(const HttpJob& job, HttpAnswer::Kind kind);

HttpAnswer failure(HttpAnswer::Kind kind, Fault reason);
/// No status came: why, in the reply's own words.
HttpAnswer unreachable(const HttpJob& job);
HttpAnswer tooLarge(const HttpJob& job);
HttpAnswer brokenOff(const HttpJob& job);
/// What the robot said with `status`. Takes the body.
HttpAnswer answerOf(HttpJob& job, int status);
/// What lay on the disk.
HttpAnswer storedAnswer(const HttpJob& job);
/// What became of it, for the log.
QString lineOf(const HttpJob& job, const HttpAnswer& answer);

}  // namespace mapwright::net
