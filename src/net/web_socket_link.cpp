#include "net/web_socket_link.h"

#include <algorithm>
#include <optional>

#include <QNetworkRequest>
#include <QPointer>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSslSocket>
#include <QTimer>
#include <QWebSocket>

#include "net/backoff.h"
#include "net/log.h"
#include "net/plain_sentences.h"
#include "net/secret.h"

namespace mapwright::net {

namespace {

constexpr int kFarewellMs = 1000;  // for the closing handshake when the link is closed

quint32 seedOf(const WebSocketLinkOptions& options) {
  return options.jitter_seed != 0 ? options.jitter_seed : QRandomGenerator::global()->generate();
}

/// Qt gives the HTTP status of a refused handshake only in its error text, and 400 in other words than the
/// rest.
int statusIn(const QString& error_text) {
  static const QRegularExpression kStatus(QStringLiteral("status code: (\\d{3})\\b"));
  const QRegularExpressionMatch match = kStatus.match(error_text);
  if (match.hasMatch()) {
    return match.captured(1).toInt();
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

Fault whyNotConnected(QAbstractSocket::SocketError error, const QString& error_text, const QUrl& url) {
  if (isForeignAnswer(error, error_text)) {
    return faultOf(fault::NoWebSocketThere, {hostAndPort(url)});
  }
  switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
      return faultOf(fault::ConnectionRefused, {hostAndPort(url)});
    case QAbstractSocket::HostNotFoundError:
      return faultOf(fault::HostUnknown, {plainText(url.host())});
    case QAbstractSocket::RemoteHostClosedError:
      return fault::ClosedBeforeOpen;
    case QAbstractSocket::SslHandshakeFailedError:
      return faultOf(fault::ConnectionNotSecure, {hostAndPort(url), plainText(error_text)});
    case QAbstractSocket::SocketTimeoutError:
      return faultOf(fault::HostSilent, {hostAndPort(url)});
    case QAbstractSocket::UnknownSocketError:
      return faultOf(fault::BrokeBeforeOpen, {hostAndPort(url)});
    default:
      return faultOf(fault::HostNotReached, {hostAndPort(url), plainText(error_text)});
  }
}

}  // namespace

class WebSocketLink::Impl {
 public:
  Impl(WebSocketLink* owner, QList<QUrl> urls, const QByteArray& secret, const WebSocketLinkOptions& options)
      : owner_(owner),
        urls_(std::move(urls)),
        secret_(urls_.value(0), secret),
        options_(options),
        backoff_(options.backoff_first, options.backoff_limit, seedOf(options)) {
    if (!options_.now) {
      options_.now = [] {
        return std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::steady_clock::now().time_since_epoch());
      };
    }
    connect_limit_.setSingleShot(true);
    retry_.setSingleShot(true);
    QObject::connect(&connect_limit_, &QTimer::timeout, owner_,
                     [this] { fail(Failure::TimedOut, noAnswer(options_.connect_timeout)); });
    QObject::connect(&look_, &QTimer::timeout, owner_, [this] { look(); });
    QObject::connect(&retry_, &QTimer::timeout, owner_, [this] { startAttempt(); });
    if (!options_.wall) {
      options_.wall = [] { return QDateTime::currentDateTime(); };
    }
    QObject::connect(&ping_, &QTimer::timeout, owner_, [this] { ping(); });
  }

  ~Impl() { dropSocket(); }

  void open() {
    if (state_ == State::Open || state_ == State::Connecting) {
      return;
    }
    if (urls_.isEmpty()) {
      reason_ = fault::NoAddressToConnectTo;
      enter(State::Closed);
      return;
    }
    if (state_ == State::Closed) {
      attempt_ = 0;
      backoff_.reset();
    }
    startAttempt();
  }

  void close() {
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

  void setTrust(const Trust& trust) { trust_ = trust; }

  void send(const QString& text) {
    if (state_ == State::Open) {
      socket_->sendTextMessage(text);
    }
  }

  qint64 unsent() const { return state_ == State::Open ? socket_->bytesToWrite() : 0; }

  State state() const { return state_; }
  const Fault& reason() const { return reason_; }
  Failure failure() const { return failure_; }
  std::optional<CertificateFault> certificate() const { return certificate_; }
  int status() const { return status_; }
  int attempt() const { return attempt_; }
  std::optional<int> retryInMs() const {
    return state_ == State::Waiting ? std::optional(std::max(0, retry_.remainingTime())) : std::nullopt;
  }
  std::optional<int> roundTripMs() const { return round_trip_ms_; }
  qint64 arriving() const {
    return state_ == State::Open && transport_ != nullptr ? frames_bytes_ + transport_->bytesAvailable() : 0;
  }
  std::chrono::milliseconds silence() const { return options_.now() - heard_at_; }
  const std::optional<QDateTime>& silentSince() const { return silent_since_; }

 private:
  static Fault noAnswer(std::chrono::milliseconds time) {
    return faultOf(fault::NoAnswerWithin, {durationWords(time.count())});
  }

  void startAttempt() {
    ++attempt_;
    refusals_ = 0;
    connectSocket();
    enter(State::Connecting);
  }

  /// Of what is or was connected to last, for the log.
  QByteArray name() const { return urlForLog(urls_.value(url_)).toUtf8(); }

  void connectSocket() {
    qCInfo(lcNet, "%s: connecting, attempt %d", name().constData(), attempt_);
    dropSocket();
    socket_ = new QWebSocket(QString(), QWebSocketProtocol::VersionLatest, owner_);
    socket_->setMaxAllowedIncomingFrameSize(options_.max_message_bytes);
    socket_->setMaxAllowedIncomingMessageSize(options_.max_message_bytes);
    QObject::connect(socket_, &QWebSocket::connected, owner_, [this] { becomeOpen(); });
    QObject::connect(socket_, &QWebSocket::disconnected, owner_, [this] { loseConnection(); });
    QObject::connect(socket_, QOverload<QAbstractSocket::SocketError>::of(&QWebSocket::error), owner_,
                     [this](QAbstractSocket::SocketError error) { takeError(error); });
    QObject::connect(socket_, &QWebSocket::pong, owner_, [this](quint64 elapsed_ms) {
      round_trip_ms_ = int(elapsed_ms);
      Q_EMIT owner_->changed();
    });
    // A message may have several frames; each leaves the transport when it is complete.
    frames_bytes_ = 0;
    QObject::connect(socket_, &QWebSocket::textFrameReceived, owner_,
                     [this](const QString& text, bool last) { noteFrame(text.size(), last); });
    QObject::connect(socket_, &QWebSocket::binaryFrameReceived, owner_,
                     [this](const QByteArray& bytes, bool last) { noteFrame(bytes.size(), last); });
    QObject::connect(socket_, &QWebSocket::textMessageReceived, owner_,
                     [this](const QString& text) { Q_EMIT owner_->textReceived(text.toUtf8()); });
    QObject::connect(socket_, &QWebSocket::binaryMessageReceived, owner_,
                     [this](const QByteArray& bytes) { Q_EMIT owner_->binaryReceived(bytes); });
    QObject::connect(socket_, &QWebSocket::bytesWritten, owner_, &WebSocketLink::written);
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
  void watchTransport() {
    QTcpSocket* const transport =
        socket_ == nullptr ? nullptr : socket_->findChild<QTcpSocket*>(QString(), Qt::FindDirectChildrenOnly);
    transport_ = transport;
    if (transport == nullptr) {
      return;  // it failed at once
    }
    QObject::connect(transport, &QIODevice::readyRead, owner_, [this] { hear(); });
    if (auto* encrypted = qobject_cast<QSslSocket*>(transport)) {
      // Both are emitted before the handshake, with the secret, is sent.
      QObject::connect(encrypted, &QSslSocket::sslErrors, owner_,
                       [this, encrypted](const QList<QSslError>& errors) { judge(*encrypted, errors); });
      QObject::connect(encrypted, &QSslSocket::encrypted, owner_,
                       [this, encrypted] { judge(*encrypted, {}); });
    }
  }

  void noteFrame(qint64 bytes, bool last) { frames_bytes_ = last ? 0 : frames_bytes_ + bytes; }

  void judge(QSslSocket& encrypted, const QList<QSslError>& errors) {
    certificate_ = faultOf(trust_, encrypted.peerCertificate(), errors, urls_.at(url_));
    if (certificate_) {
      status_ = 0;
      refuse(Failure::Certificate, reasonOf(*certificate_));
    } else if (!errors.isEmpty()) {
      encrypted.ignoreSslErrors(errors);
    }
  }

  void becomeOpen() {
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
    Q_EMIT owner_->changed();
    if (state_ == State::Open) {
      Q_EMIT owner_->opened();
    }
  }

  void ping() {
    if (state_ != State::Open) {
      return;
    }
    if (!asked_at_) {
      asked_at_ = options_.now();
    }
    socket_->ping();
  }

  void hear() {
    heard_at_ = options_.now();
    talks_ = !asked_at_;
    if (asked_at_) {
      // The slowest answer is forgotten over a few pings.
      slowest_ = std::max(heard_at_ - *asked_at_, slowest_ * 7 / 8);
      asked_at_.reset();
    }
    if (silent_since_ && state_ == State::Open) {
      silent_since_.reset();
      Q_EMIT owner_->changed();
    }
  }

  void noteSilence(std::chrono::milliseconds now) {
    const auto silent = now - heard_at_;
    if (talks_ && !asked_at_ && silent >= options_.ask_after) {
      ping();
    }
    // If a ping was sent just now its answer is not due yet.
    const auto bears = std::max(options_.quiet_after - options_.ask_after, 2 * slowest_);
    if (silent_since_ || !asked_at_ || silent < options_.quiet_after || now - *asked_at_ < bears) {
      return;
    }
    noteLastByte();
    qCInfo(lcNet, "%s: nothing has come for %lld ms", name().constData(), (long long)(silent.count()));
    Q_EMIT owner_->changed();
  }

  void noteLastByte() {
    if (!silent_since_) {
      silent_since_ = options_.wall().addMSecs(-qint64(silence().count()));
    }
  }

  void look() {
    const auto now = options_.now();
    // Received bytes show that the link works; healthy, which resets the backoff, takes longer: a server that
    // sends something and then closes must not be contacted too often.
    if (now - opened_at_ >= options_.healthy_after) {
      backoff_.reset();
    }
    if (now - heard_at_ > options_.silent_after) {
      fail(Failure::TimedOut, noAnswer(options_.silent_after));
    } else {
      noteSilence(now);
    }
  }

  void takeError(QAbstractSocket::SocketError error) {
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
         whyNotConnected(error, text, urls_.at(url_)));
  }

  void loseConnection() {
    if (state_ != State::Open) {
      // Qt may emit this before the error that explains it.
      QMetaObject::invokeMethod(
          socket_,
          [this, lost = socket_] {
            if (lost == socket_) {
              takeError(socket_->error());
            }
          },
          Qt::QueuedConnection);
      return;
    }
    const QWebSocketProtocol::CloseCode code = socket_->closeCode();
    const QString words = plainText(socket_->closeReason());
    if (code == QWebSocketProtocol::CloseCodeTooMuchData) {
      fail(Failure::Unreachable,
           faultOf(fault::MessageTooLong, {QString::number(options_.max_message_bytes)}));
    } else {
      fail(Failure::Unreachable, words.isEmpty() ? Fault(fault::ConnectionClosed)
                                                 : faultOf(fault::ConnectionClosedSaying, {words}));
    }
  }

  /// Automatic retries would not help.
  void refuse(Failure failure, const Fault& reason) {
    qCInfo(lcNet, "%s: %s; not tried again", name().constData(), inEnglish(reason).c_str());
    failure_ = failure;
    reason_ = reason;
    dropSocket();
    enter(State::Closed);
  }

  void fail(Failure failure, const Fault& reason) {
    failure_ = failure;
    reason_ = reason;
    if (state_ == State::Open) {
      noteLastByte();
    }
    dropSocket();
    const auto wait = backoff_.next();
    qCInfo(lcNet, "%s: %s; next attempt in %lld ms", name().constData(), inEnglish(reason).c_str(),
           (long long)(wait.count()));
    retry_.start(wait);
    enter(State::Waiting);
  }

  void enter(State state) {
    if (state != State::Waiting) {
      retry_.stop();
    }
    state_ = state;
    Q_EMIT owner_->changed();
  }

  void stopTimers() {
    connect_limit_.stop();
    look_.stop();
    ping_.stop();
    retry_.stop();
  }

  void dropSocket() {
    stopTimers();
    round_trip_ms_.reset();
    if (socket_ != nullptr) {
      socket_->disconnect(owner_);
      socket_->abort();
      socket_->deleteLater();
      socket_ = nullptr;
    }
  }

  /// Like dropSocket, but closes an open link properly.
  void sayFarewell() {
    if (state_ == State::Open) {
      QWebSocket* leaving = socket_;
      socket_ = nullptr;
      leaving->disconnect(owner_);
      QObject::connect(leaving, &QWebSocket::disconnected, leaving, &QObject::deleteLater);
      QTimer::singleShot(kFarewellMs, leaving, &QObject::deleteLater);
      leaving->close();
    }
    dropSocket();
  }

  WebSocketLink* owner_;
  QList<QUrl> urls_;
  Secret secret_;
  Trust trust_;
  WebSocketLinkOptions options_;
  Backoff backoff_;
  QTimer connect_limit_, look_, ping_, retry_;
  std::chrono::milliseconds opened_at_{0}, heard_at_{0};
  std::optional<std::chrono::milliseconds> asked_at_;  // of the last ping, if nothing has arrived since
  std::chrono::milliseconds slowest_{0};               // of its answers, lately
  bool talks_ = false;                                 // the last byte was not an answer to a ping
  std::optional<QDateTime> silent_since_;
  QPointer<QTcpSocket> transport_;  // goes with its socket
  qint64 frames_bytes_ = 0;         // of an incomplete message; for text in characters
  QWebSocket* socket_ = nullptr;    // a child of the owner
  State state_ = State::Closed;
  Fault reason_;
  Failure failure_ = Failure::None;
  std::optional<CertificateFault> certificate_;
  qsizetype url_ = 0;
  int refusals_ = 0;  // in this attempt, one for every URL tried
  int status_ = 0;
  int attempt_ = 0;
  std::optional<int> round_trip_ms_;
};

WebSocketLink::WebSocketLink(QList<QUrl> urls, QByteArray secret, WebSocketLinkOptions options,
                             QObject* parent)
    : QObject(parent), impl_(std::make_unique<Impl>(this, std::move(urls), secret, options)) {}

WebSocketLink::~WebSocketLink() = default;

void WebSocketLink::open() { impl_->open(); }
void WebSocketLink::close() { impl_->close(); }
void WebSocketLink::sendText(const QString& text) { impl_->send(text); }
qint64 WebSocketLink::unsentBytes() const { return impl_->unsent(); }
qint64 WebSocketLink::arrivingBytes() const { return impl_->arriving(); }
WebSocketLink::State WebSocketLink::state() const { return impl_->state(); }
void WebSocketLink::setTrust(const Trust& trust) { impl_->setTrust(trust); }
Fault WebSocketLink::reason() const { return impl_->reason(); }
WebSocketLink::Failure WebSocketLink::failure() const { return impl_->failure(); }
std::optional<CertificateFault> WebSocketLink::certificate() const { return impl_->certificate(); }
std::optional<QDateTime> WebSocketLink::silentSince() const { return impl_->silentSince(); }
int WebSocketLink::handshakeStatus() const { return impl_->status(); }
int WebSocketLink::attempt() const { return impl_->attempt(); }
std::optional<int> WebSocketLink::retryInMs() const { return impl_->retryInMs(); }
std::optional<int> WebSocketLink::roundTripMs() const { return impl_->roundTripMs(); }
std::chrono::milliseconds WebSocketLink::silence() const { return impl_->silence(); }

}  // namespace mapwright::net

#include "moc_web_socket_link.cpp"
