#include "net/web_socket_link.h"

#include <algorithm>
#include <optional>

#include <QNetworkRequest>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTimer>
#include <QWebSocket>

#include "net/backoff.h"
#include "net/plain_sentences.h"

namespace mapwright::net {

namespace {

constexpr int kFarewellMs = 1000;  // for the closing handshake of a link that was told to close

quint32 seedOf(const WebSocketLinkOptions& options) {
  return options.jitter_seed != 0 ? options.jitter_seed : QRandomGenerator::global()->generate();
}

/// Qt tells the HTTP status of a refused handshake only inside its error text, and 400 in other words than
/// the rest.
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

/// Whether there was a connection, but what came over it was no handshake.
bool isForeignAnswer(const QString& error_text) {
  return error_text.contains(QLatin1String("andshake")) ||
         error_text.contains(QLatin1String("protocol upgrade")) ||
         error_text.contains(QLatin1String("QWebSocket"));
}

QString connectSentence(QAbstractSocket::SocketError error, const QString& error_text, const QUrl& url) {
  if (isForeignAnswer(error_text)) {
    return QStringLiteral("%1 does not answer as a WebSocket").arg(hostAndPort(url));
  }
  switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
      return QStringLiteral("connection refused by %1").arg(hostAndPort(url));
    case QAbstractSocket::HostNotFoundError:
      return QStringLiteral("the host %1 is not known").arg(url.host());
    case QAbstractSocket::RemoteHostClosedError:
      return QStringLiteral("the robot closed the connection before it was open");
    case QAbstractSocket::SslHandshakeFailedError:
      return QStringLiteral("no secure connection to %1 can be made").arg(hostAndPort(url));
    default:
      return QStringLiteral("%1 cannot be reached: %2").arg(hostAndPort(url), error_text);
  }
}

}  // namespace

class WebSocketLink::Impl {
 public:
  Impl(WebSocketLink* owner, QList<QUrl> urls, const QByteArray& secret, const WebSocketLinkOptions& options)
      : owner_(owner),
        urls_(std::move(urls)),
        secret_(headerSafe(secret)),
        options_(options),
        backoff_(options.backoff_first, options.backoff_limit, seedOf(options)) {
    connect_limit_.setSingleShot(true);
    silence_.setSingleShot(true);
    retry_.setSingleShot(true);
    QObject::connect(&connect_limit_, &QTimer::timeout, owner_,
                     [this] { fail(noAnswer(options_.connect_timeout)); });
    QObject::connect(&silence_, &QTimer::timeout, owner_, [this] { fail(noAnswer(options_.silent_after)); });
    QObject::connect(&retry_, &QTimer::timeout, owner_, [this] { startAttempt(); });
    QObject::connect(&ping_, &QTimer::timeout, owner_, [this] {
      if (socket_ != nullptr) {
        socket_->ping();
      }
    });
  }

  ~Impl() { dropSocket(); }

  void open() {
    if (state_ == State::Open || state_ == State::Connecting) {
      return;
    }
    if (urls_.isEmpty()) {
      reason_ = QStringLiteral("there is no address to connect to");
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
    if (state_ == State::Closed && reason_.isEmpty()) {
      return;
    }
    sayFarewell();
    reason_.clear();
    status_ = 0;
    enter(State::Closed);
  }

  void send(const QString& text) {
    if (state_ == State::Open) {
      socket_->sendTextMessage(text);
    }
  }

  State state() const { return state_; }
  QString reason() const { return reason_; }
  int status() const { return status_; }
  int attempt() const { return attempt_; }
  std::optional<int> retryInMs() const {
    return state_ == State::Waiting ? std::optional(std::max(0, retry_.remainingTime())) : std::nullopt;
  }
  std::optional<int> roundTripMs() const { return round_trip_ms_; }

 private:
  static QString noAnswer(std::chrono::milliseconds time) {
    return QStringLiteral("no answer for %1").arg(durationWords(time.count()));
  }

  void startAttempt() {
    ++attempt_;
    refusals_ = 0;
    connectSocket();
    enter(State::Connecting);
  }

  void connectSocket() {
    dropSocket();
    socket_ = new QWebSocket(QString(), QWebSocketProtocol::VersionLatest, owner_);
    socket_->setMaxAllowedIncomingFrameSize(options_.max_message_bytes);
    socket_->setMaxAllowedIncomingMessageSize(options_.max_message_bytes);
    QObject::connect(socket_, &QWebSocket::connected, owner_, [this] { becomeOpen(); });
    QObject::connect(socket_, &QWebSocket::disconnected, owner_, [this] { loseConnection(); });
    QObject::connect(socket_, QOverload<QAbstractSocket::SocketError>::of(&QWebSocket::error), owner_,
                     [this](QAbstractSocket::SocketError error) { takeError(error); });
    QObject::connect(socket_, &QWebSocket::textFrameReceived, owner_, [this] { hear(); });
    QObject::connect(socket_, &QWebSocket::binaryFrameReceived, owner_, [this] { hear(); });
    QObject::connect(socket_, &QWebSocket::pong, owner_, [this](quint64 elapsed_ms) {
      hear();
      round_trip_ms_ = int(elapsed_ms);
      Q_EMIT owner_->changed();
    });
    QObject::connect(socket_, &QWebSocket::textMessageReceived, owner_,
                     [this](const QString& text) { Q_EMIT owner_->textReceived(text.toUtf8()); });
    QObject::connect(socket_, &QWebSocket::binaryMessageReceived, owner_,
                     [this](const QByteArray& bytes) { Q_EMIT owner_->binaryReceived(bytes); });
    connect_limit_.start(options_.connect_timeout);
    QNetworkRequest request(urls_.at(url_));
    if (!secret_.isEmpty()) {
      request.setRawHeader("Secret", secret_);
    }
    socket_->open(request);
  }

  void becomeOpen() {
    connect_limit_.stop();
    attempt_ = 0;
    status_ = 0;
    reason_.clear();
    silence_.start(options_.silent_after);
    ping_.start(options_.ping_every);
    socket_->ping();
    state_ = State::Open;
    Q_EMIT owner_->changed();
    if (state_ == State::Open) {
      Q_EMIT owner_->opened();
    }
  }

  void hear() {
    silence_.start();
    // A server that opens and closes at once must not be asked ever so often: only a sign of life counts as
    // success.
    backoff_.reset();
  }

  void takeError(QAbstractSocket::SocketError error) {
    if (state_ == State::Open) {
      return;  // `disconnected` follows and knows more
    }
    const QString text = socket_->errorString();
    const int status = statusIn(text);
    if (status == 401 || status == 403) {
      status_ = status;
      reason_ = QStringLiteral("the robot refuses the connection: %1; the secret may be missing or wrong")
                    .arg(statusWords(status));
      dropSocket();
      enter(State::Closed);
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
    fail(status >= 400 ? QStringLiteral("the robot refused the connection: %1").arg(statusWords(status))
                       : plainText(connectSentence(error, text, urls_.at(url_))));
  }

  void loseConnection() {
    if (state_ != State::Open) {
      // Qt may tell this before the error that explains it.
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
      fail(QStringLiteral("a message was longer than the %1 bytes allowed").arg(options_.max_message_bytes));
    } else {
      fail(words.isEmpty() ? QStringLiteral("the robot closed the connection")
                           : plainText(QStringLiteral("the robot closed the connection: %1").arg(words)));
    }
  }

  void fail(const QString& reason) {
    reason_ = reason;
    dropSocket();
    retry_.start(backoff_.next());
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
    silence_.stop();
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

  /// As dropSocket, but an open link says good-bye first.
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
  QByteArray secret_;
  WebSocketLinkOptions options_;
  Backoff backoff_;
  QTimer connect_limit_, silence_, ping_, retry_;
  QWebSocket* socket_ = nullptr;  // a child of the owner
  State state_ = State::Closed;
  QString reason_;
  qsizetype url_ = 0;
  int refusals_ = 0;  // of this attempt, one for every URL tried
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
WebSocketLink::State WebSocketLink::state() const { return impl_->state(); }
QString WebSocketLink::reason() const { return impl_->reason(); }
int WebSocketLink::handshakeStatus() const { return impl_->status(); }
int WebSocketLink::attempt() const { return impl_->attempt(); }
std::optional<int> WebSocketLink::retryInMs() const { return impl_->retryInMs(); }
std::optional<int> WebSocketLink::roundTripMs() const { return impl_->roundTripMs(); }

}  // namespace mapwright::net
