#include "net/web_socket_link.h"

#include <algorithm>
#include <optional>

#include <QNetworkRequest>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSslSocket>
#include <QWebSocket>

#include "net/log.h"
#include "net/openssl_exit.h"
#include "net/plain_sentences.h"
#include "words/qt_versions.h"

namespace mapwright::net {

namespace {

constexpr int kFarewellMs = 1000;  // for the closing handshake when the link is closed

quint32 seedOf(const WebSocketLinkOptions& options) {
  return options.jitter_seed != 0 ? options.jitter_seed : QRandomGenerator::global()->generate();
}

/// Qt gives the HTTP status of a refused handshake only in its error text, and 400 (since Qt 6.6 also 401) in
/// other words than the rest.
int statusIn(const QString& error_text) {
  static const QRegularExpression kStatus(QStringLiteral("status code: (\\d{3})\\b"));
  const QRegularExpressionMatch match = kStatus.match(error_text);
  if (match.hasMatch()) {
    return match.captured(1).toInt();
  }
  if (error_text.contains(QLatin1String("processHandshake: Unsupported WWW-Authenticate")) ||
      error_text.contains(QLatin1String("requires authentication"))) {
    return 401;
  }
  const bool bad_request = error_text.contains(QLatin1String("processHandshake: Unknown error condition")) ||
                           error_text.contains(QLatin1String("requests a version that we don't support"));
  return bad_request ? 400 : 0;
}

/// Whether the server answered, but not with a WebSocket handshake.
bool isForeignAnswer(QAbstractSocket::SocketError error, const QString& error_text) {
  if (error == QAbstractSocket::SslHandshakeFailedError) {
    return false;  // that of the encryption
  }
  return error_text.contains(QLatin1String("andshake")) ||
         error_text.contains(QLatin1String("protocol upgrade")) ||
         error_text.contains(QLatin1String("QWebSocket"));
}

Fault notConnectedReason(QAbstractSocket::SocketError error, const QString& error_text, const QUrl& url) {
  if (isForeignAnswer(error, error_text)) {
    return faultOf(faultText("net", "%1 does not answer as a WebSocket"), {hostAndPort(url)});
  }
  switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
      return faultOf(fault::ConnectionRefused, {hostAndPort(url)});
    case QAbstractSocket::HostNotFoundError:
      return faultOf(fault::HostUnknown, {plainText(url.host())});
    case QAbstractSocket::RemoteHostClosedError:
      return faultText("net", "the robot closed the connection before it was established");
    case QAbstractSocket::SslHandshakeFailedError:
      return faultOf(fault::ConnectionNotSecure, {hostAndPort(url), plainText(error_text)});
    case QAbstractSocket::SocketTimeoutError:
      return faultOf(fault::HostSilent, {hostAndPort(url)});
    case QAbstractSocket::UnknownSocketError:
      return faultOf(faultText("net", "the connection to %1 was lost before it was established"),
                     {hostAndPort(url)});
    default:
      return faultOf(fault::HostNotReached, {hostAndPort(url), plainText(error_text)});
  }
}

}  // namespace

WebSocketLink::WebSocketLink(QList<QUrl> urls, QByteArray secret, WebSocketLinkOptions options,
                             QObject* parent)
    : QObject(parent),
      urls_(std::move(urls)),
      secret_(urls_.value(0), secret),
      options_(options),
      backoff_(options.backoff_first, options.backoff_limit, seedOf(options)) {
  keepOpensslAtExit();
  if (!options_.now) {
    options_.now = [] {
      return std::chrono::duration_cast<std::chrono::milliseconds>(
          std::chrono::steady_clock::now().time_since_epoch());
    };
  }
  if (!options_.wall) options_.wall = [] { return QDateTime::currentDateTime(); };
  connect_limit_.setSingleShot(true);
  retry_.setSingleShot(true);
  connect(&connect_limit_, &QTimer::timeout, this,
          [this] { fail(Failure::TimedOut, noAnswer(options_.connect_timeout)); });
  connect(&look_, &QTimer::timeout, this, &WebSocketLink::look);
  connect(&retry_, &QTimer::timeout, this, &WebSocketLink::startAttempt);
  connect(&ping_, &QTimer::timeout, this, &WebSocketLink::ping);
}

WebSocketLink::~WebSocketLink() { dropSocket(); }

qint64 WebSocketLink::unsentBytes() const { return state_ == State::Open ? socket_->bytesToWrite() : 0; }

qint64 WebSocketLink::arrivingBytes() const {
  return state_ == State::Open && transport_ != nullptr ? frames_bytes_ + transport_->bytesAvailable() : 0;
}

std::optional<int> WebSocketLink::retryInMs() const {
  return state_ == State::Waiting ? std::optional(std::max(0, retry_.remainingTime())) : std::nullopt;
}

void WebSocketLink::open() {
  if (state_ == State::Open || state_ == State::Connecting) {
    return;
  }
  if (urls_.isEmpty()) {
    reason_ = faultText("net", "there is no address to connect to");
    enter(State::Closed);
    return;
  }
  if (state_ == State::Closed) {
    attempt_ = 0;
    backoff_.reset();
  }
  startAttempt();
}

void WebSocketLink::close() {
  if (state_ == State::Closed && !reason_.any()) {
    return;
  }
  sayFarewell();
  qCInfo(lcNet, "%s: closed, as asked for", name().constData());
  silent_since_.reset();
  reason_ = {};
  failure_ = Failure::None;
  certificate_.reset();
  status_ = 0;
  enter(State::Closed);
}

void WebSocketLink::sendText(const QString& text) {
  if (state_ == State::Open) {
    socket_->sendTextMessage(text);
  }
}

Fault WebSocketLink::noAnswer(std::chrono::milliseconds time) {
  return faultOf(fault::NoAnswerWithin, {durationWords(time.count())});
}

void WebSocketLink::startAttempt() {
  ++attempt_;
  refusals_ = 0;
  connectSocket();
  enter(State::Connecting);
}

/// Of what is or was connected to last, for the log.
QByteArray WebSocketLink::name() const { return urlForLog(urls_.value(url_)).toUtf8(); }

void WebSocketLink::connectSocket() {
  qCInfo(lcNet, "%s: connecting, attempt %d", name().constData(), attempt_);
  dropSocket();
  socket_ = new QWebSocket(QString(), QWebSocketProtocol::VersionLatest, this);
  socket_->setMaxAllowedIncomingFrameSize(options_.max_message_bytes);
  socket_->setMaxAllowedIncomingMessageSize(options_.max_message_bytes);
  connect(socket_, &QWebSocket::connected, this, &WebSocketLink::becomeOpen);
  connect(socket_, &QWebSocket::disconnected, this, &WebSocketLink::loseConnection);
  connect(socket_, words::socketFailed<QWebSocket>(), this, &WebSocketLink::onError);
  connect(socket_, &QWebSocket::pong, this, [this](quint64 elapsed_ms) {
    round_trip_ms_ = int(elapsed_ms);
    Q_EMIT changed();
  });
  // A message may have several frames; each leaves the transport when it is complete.
  frames_bytes_ = 0;
  connect(socket_, &QWebSocket::textFrameReceived, this,
          [this](const QString& text, bool last) { onFrame(text.size(), last); });
  connect(socket_, &QWebSocket::binaryFrameReceived, this,
          [this](const QByteArray& bytes, bool last) { onFrame(bytes.size(), last); });
  connect(socket_, &QWebSocket::textMessageReceived, this,
          [this](const QString& text) { Q_EMIT textReceived(text.toUtf8()); });
  connect(socket_, &QWebSocket::binaryMessageReceived, this,
          [this](const QByteArray& bytes) { Q_EMIT binaryReceived(bytes); });
  connect(socket_, &QWebSocket::bytesWritten, this, &WebSocketLink::written);
  connect_limit_.start(options_.connect_timeout);
  QNetworkRequest request(urls_.at(url_));
  if (const QByteArray secret = secret_.forUrl(request.url()); !secret.isEmpty()) {
    request.setRawHeader("Secret", secret);
  }
  certificate_.reset();
  if (request.url().scheme() == QLatin1String("wss")) {
    socket_->setSslConfiguration(configurationFor(trust_));
  }
  socket_->open(request);
  watchTransport();
}

/// QWebSocket only reports complete frames, and a large one may take minutes on a slow connection. The
/// socket that it reads from is its child, and reports every byte received, decrypted.
void WebSocketLink::watchTransport() {
  QTcpSocket* const transport =
      socket_ == nullptr ? nullptr : socket_->findChild<QTcpSocket*>(QString(), Qt::FindDirectChildrenOnly);
  transport_ = transport;
  if (transport == nullptr) {
    return;  // it failed at once
  }
  connect(transport, &QIODevice::readyRead, this, &WebSocketLink::hear);
  if (auto* encrypted = qobject_cast<QSslSocket*>(transport)) {
    // Both are emitted before the handshake, with the secret, is sent.
    connect(encrypted, &QSslSocket::sslErrors, this,
            [this, encrypted](const QList<QSslError>& errors) { judge(*encrypted, errors); });
    connect(encrypted, &QSslSocket::encrypted, this, [this, encrypted] { judge(*encrypted, {}); });
  }
}

void WebSocketLink::onFrame(qint64 bytes, bool last) { frames_bytes_ = last ? 0 : frames_bytes_ + bytes; }

void WebSocketLink::judge(QSslSocket& encrypted, const QList<QSslError>& errors) {
  certificate_ = faultOf(trust_, encrypted.peerCertificate(), errors, urls_.at(url_));
  if (certificate_) {
    status_ = 0;
    refuse(Failure::Certificate, reasonOf(*certificate_));
  } else if (!errors.isEmpty()) {
    encrypted.ignoreSslErrors(errors);
  }
}

void WebSocketLink::becomeOpen() {
  qCInfo(lcNet, "%s: open", name().constData());
  connect_limit_.stop();
  attempt_ = 0;
  status_ = 0;
  reason_ = {};
  failure_ = Failure::None;
  opened_at_ = heard_at_ = options_.now();
  silent_since_.reset();
  asked_at_.reset();
  look_.start(options_.look_every);
  ping_.start(options_.ping_every);
  state_ = State::Open;
  ping();
  Q_EMIT changed();
  if (state_ == State::Open) {
    Q_EMIT opened();
  }
}

void WebSocketLink::ping() {
  if (state_ != State::Open) {
    return;
  }
  if (!asked_at_) {
    asked_at_ = options_.now();
  }
  socket_->ping();
}

void WebSocketLink::hear() {
  heard_at_ = options_.now();
  talks_ = !asked_at_;
  if (asked_at_) {
    // The slowest answer is forgotten over a few pings.
    slowest_ = std::max(heard_at_ - *asked_at_, slowest_ * 7 / 8);
    asked_at_.reset();
  }
  if (silent_since_ && state_ == State::Open) {
    silent_since_.reset();
    Q_EMIT changed();
  }
}

void WebSocketLink::onSilence(std::chrono::milliseconds now) {
  const auto silent = now - heard_at_;
  if (talks_ && !asked_at_ && silent >= options_.ask_after) {
    ping();
  }
  // If a ping was sent just now its answer is not due yet.
  const auto bears = std::max(options_.quiet_after - options_.ask_after, 2 * slowest_);
  if (silent_since_ || !asked_at_ || silent < options_.quiet_after || now - *asked_at_ < bears) {
    return;
  }
  onLastByte();
  qCInfo(lcNet, "%s: nothing has come for %lld ms", name().constData(), (long long)(silent.count()));
  Q_EMIT changed();
}

void WebSocketLink::onLastByte() {
  if (!silent_since_) {
    silent_since_ = options_.wall().addMSecs(-qint64(silence().count()));
  }
}

void WebSocketLink::look() {
  const auto now = options_.now();
  // Received bytes show that the link works; healthy, which resets the backoff, takes longer: a server that
  // sends something and then closes must not be contacted too often.
  if (now - opened_at_ >= options_.healthy_after) {
    backoff_.reset();
  }
  if (now - heard_at_ > options_.silent_after) {
    fail(Failure::TimedOut, noAnswer(options_.silent_after));
  } else {
    onSilence(now);
  }
}

void WebSocketLink::onError(QAbstractSocket::SocketError error) {
  if (state_ == State::Open) {
    return;  // `disconnected` follows and knows more
  }
  const QString text = socket_->errorString();
  const int status = statusIn(text);
  if (status == 401 || status == 403) {
    status_ = status;
    refuse(Failure::Refused, {fault::ConnectionForbidden, {HttpStatus{status}}});
    return;
  }
  status_ = status;
  if (status >= 400 && status < 500) {
    url_ = (url_ + 1) % urls_.size();
    if (++refusals_ < urls_.size()) {
      connectSocket();
      return;
    }
  }
  if (status >= 400) {
    fail(status < 500 || status == 501 ? Failure::NotAWebSocket : Failure::Unreachable,
         {fault::ConnectionRejected, {HttpStatus{status}}});
    return;
  }
  fail(isForeignAnswer(error, text) ? Failure::NotAWebSocket : Failure::Unreachable,
       notConnectedReason(error, text, urls_.at(url_)));
}

void WebSocketLink::loseConnection() {
  if (state_ != State::Open) {
    // Qt may emit this before the error that explains it.
    QMetaObject::invokeMethod(
        socket_,
        [this, lost = socket_] {
          if (lost == socket_) {
            onError(socket_->error());
          }
        },
        Qt::QueuedConnection);
    return;
  }
  const QWebSocketProtocol::CloseCode code = socket_->closeCode();
  const QString words = plainText(socket_->closeReason());
  if (code == QWebSocketProtocol::CloseCodeTooMuchData) {
    fail(Failure::Unreachable, faultOf(fault::MessageTooLong, {QString::number(options_.max_message_bytes)}));
  } else {
    fail(Failure::Unreachable,
         words.isEmpty() ? Fault(fault::ConnectionClosed) : faultOf(fault::ConnectionClosedSaying, {words}));
  }
}

/// Automatic retries would not help.
void WebSocketLink::refuse(Failure failure, const Fault& reason) {
  qCInfo(lcNet, "%s: %s; not tried again", name().constData(), inEnglish(reason).c_str());
  failure_ = failure;
  reason_ = reason;
  dropSocket();
  enter(State::Closed);
}

void WebSocketLink::fail(Failure failure, const Fault& reason) {
  failure_ = failure;
  reason_ = reason;
  if (state_ == State::Open) {
    onLastByte();
  }
  dropSocket();
  const auto wait = backoff_.next();
  qCInfo(lcNet, "%s: %s; next attempt in %lld ms", name().constData(), inEnglish(reason).c_str(),
         (long long)(wait.count()));
  retry_.start(wait);
  enter(State::Waiting);
}

void WebSocketLink::enter(State state) {
  if (state != State::Waiting) {
    retry_.stop();
  }
  state_ = state;
  Q_EMIT changed();
}

void WebSocketLink::stopTimers() {
  connect_limit_.stop();
  look_.stop();
  ping_.stop();
  retry_.stop();
}

void WebSocketLink::dropSocket() {
  stopTimers();
  round_trip_ms_.reset();
  if (socket_ != nullptr) {
    socket_->disconnect(this);
    socket_->abort();
    socket_->deleteLater();
    socket_ = nullptr;
  }
}

/// Like dropSocket, but closes an open link properly.
void WebSocketLink::sayFarewell() {
  if (state_ == State::Open) {
    QWebSocket* leaving = socket_;
    socket_ = nullptr;
    leaving->disconnect(this);
    connect(leaving, &QWebSocket::disconnected, leaving, &QObject::deleteLater);
    QTimer::singleShot(kFarewellMs, leaving, &QObject::deleteLater);
    leaving->close();
  }
  dropSocket();
}

}  // namespace mapwright::net

#include "moc_web_socket_link.cpp"
