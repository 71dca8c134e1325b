// One request of an HttpClient in progress: what is sent and what is answered. The client decides when.
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
  QUrl url;  // the current one: after redirects not the original one
  int redirects = 0;
  std::optional<CachedAnswer> stored;
  std::optional<HttpAnswer> answer;              // set: the reply only has to be delivered
  QNetworkAccessManager* own_network = nullptr;  // a fresh connection
  QNetworkReply* network_reply = nullptr;
  OneWayBody* upload = nullptr;  // of network_reply
  bool heard_sent = false;       // of this request
  std::unique_ptr<QTimer> silence;
  QElapsedTimer since_sent;  // the last time
  QByteArray body;
  qint64 handed_over = 0;  // of the body, to HttpRequest::take
  qint64 received() const { return body.size() + handed_over; }
};

inline constexpr qint64 kReadAhead = qint64(1) << 20;  // how much Qt may buffer that has not been counted yet

QByteArray verbOf(HttpMethod method);
/// The request for `job.url`, without its body. `tls` is for https.
QNetworkRequest requestOf(const HttpJob& job, const Secret& secret, const QSslConfiguration& tls);
bool isRedirect(int status);
/// As announced by the server; 0 = not given.
qint64 declaredLength(const QNetworkReply& reply);
/// A part of a body, with what its headers say about the whole.
HttpPart partOf(const HttpJob& job, int status, std::optional<qint64> of_bytes, const QByteArray& bytes);
/// The connection ended before the end of the body.
bool isShort(const HttpJob& job, int status);
/// Whether any part of the request may have been sent, if the job ends as `kind`.
bool maySent(const HttpJob& job, HttpAnswer::Kind kind);

HttpAnswer failure(HttpAnswer::Kind kind, Fault reason);
/// For a request without a status: why, in the words of the reply.
HttpAnswer unreachable(const HttpJob& job);
HttpAnswer tooLarge(const HttpJob& job);
HttpAnswer brokenOff(const HttpJob& job);
/// The robot's answer with `status`. Takes the body.
HttpAnswer answerOf(HttpJob& job, int status);
/// The answer from the disk.
HttpAnswer storedAnswer(const HttpJob& job);
/// What became of it, for the log.
QString lineOf(const HttpJob& job, const HttpAnswer& answer);

}  // namespace mapwright::net
