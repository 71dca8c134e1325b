#include "net/http_job.h"

#include <utility>

#include <QLocale>

#include "net/log.h"
#include "net/plain_sentences.h"

namespace mapwright::net {

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

Fault whyUnreachable(QNetworkReply::NetworkError error, const QString& error_text, const QUrl& url) {
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
      return faultOf(fault::ConnectionBroke, {hostAndPort(url)});
    default:
      return faultOf(fault::HostNotReached, {hostAndPort(url), plainText(error_text)});
  }
}

}  // namespace

QByteArray verbOf(HttpMethod method) {
  switch (method) {
    case HttpMethod::Get:
      break;
    case HttpMethod::Post:
      return "POST";
    case HttpMethod::Put:
      return "PUT";
    case HttpMethod::Patch:
      return "PATCH";
    case HttpMethod::Delete:
      return "DELETE";
  }
  return "GET";
}

QNetworkRequest requestOf(const HttpJob& job, const Secret& secret, const QSslConfiguration& tls) {
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
    request.setSslConfiguration(tls);
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
  // something. A body that cannot be rewound (OneWayBody), empty as it is for GET, forbids that.
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

qint64 declaredLength(const QNetworkReply& reply) {
  return reply.header(QNetworkRequest::ContentLengthHeader).toLongLong();
}

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

bool isShort(const HttpJob& job, int status) {
  const QNetworkReply& reply = *job.network_reply;
  if (status == 304 || status == 204 || reply.hasRawHeader("Content-Encoding") ||
      !reply.hasRawHeader("Content-Length")) {
    return false;
  }
  return job.received() < declaredLength(reply);
}

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

HttpAnswer unreachable(const HttpJob& job) {
  return failure(HttpAnswer::Kind::Unreachable,
                 whyUnreachable(job.network_reply->error(), job.network_reply->errorString(), job.url));
}

HttpAnswer tooLarge(const HttpJob& job) {
  return failure(HttpAnswer::Kind::TooLarge, faultOf(fault::AnswerTooLong, {grouped(job.request.max_bytes)}));
}

HttpAnswer brokenOff(const HttpJob& job) {
  const qint64 length = declaredLength(*job.network_reply);
  return failure(HttpAnswer::Kind::Unreachable,
                 length > 0 ? faultOf(fault::AnswerBrokeOffEarly, {grouped(job.received()), grouped(length)})
                            : faultOf(fault::AnswerBrokeOff, {grouped(job.received())}));
}

HttpAnswer answerOf(HttpJob& job, int status) {
  HttpAnswer answer;
  answer.kind = HttpAnswer::Kind::Answered;
  answer.status = status;
  answer.content_type = job.network_reply->rawHeader("Content-Type");
  answer.body = std::move(job.body);
  if (!answer.ok()) {
    answer.said = errorText(answer.body, answer.content_type);
    answer.reason = answer.said.isEmpty() ? Fault(fault::AnsweredWithStatus, {HttpStatus{status}})
                                          : Fault(fault::AnsweredWithStatusSaying,
                                                  {HttpStatus{status}, answer.said.toStdString()});
  }
  return answer;
}

HttpAnswer storedAnswer(const HttpJob& job) {
  HttpAnswer answer;
  answer.kind = HttpAnswer::Kind::Answered;
  answer.status = 200;
  answer.body = job.stored->body;
  answer.content_type = job.stored->content_type;
  answer.from_cache = true;
  return answer;
}

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

}  // namespace mapwright::net
