// A persistent WebSocket: connects, detects silence, and reconnects with backoff and jitter.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <QAbstractSocket>
#include <QByteArray>
#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTcpSocket>
#include <QTimer>
#include <QUrl>

#include "net/backoff.h"
#include "net/faults.h"
#include "net/secret.h"
#include "net/trust.h"

class QSslSocket;
class QWebSocket;

namespace mapwright::net {

struct WebSocketLinkOptions {
  std::chrono::milliseconds ping_every{5'000};
  std::chrono::milliseconds ask_after{1'000};      // a ping after this much silence
  std::chrono::milliseconds quiet_after{3'000};    // no byte for this long after a ping = silentSince()
  std::chrono::milliseconds silent_after{15'000};  // no byte for this long = the connection is dead
  std::chrono::milliseconds healthy_after{
      30'000};  // open for this long = the next loss starts with the first backoff
  std::chrono::milliseconds look_every{1'000};  // for silence and health
  std::chrono::milliseconds connect_timeout{10'000};
  std::chrono::milliseconds backoff_first{500};
  std::chrono::milliseconds backoff_limit{30'000};
  quint64 max_message_bytes = quint64(256) << 20;
  quint32 jitter_seed = 0;                              // 0 = random; fixed in tests
  std::function<std::chrono::milliseconds()> now = {};  // a monotonic clock; empty = the default one
  std::function<QDateTime()> wall = {};                 // the time of day; empty = the default one
};

/// Lives on the thread that made it. changed() reports states; text and binary frames arrive as signals.
class WebSocketLink : public QObject {
  Q_OBJECT
 public:
  enum class State { Closed, Connecting, Open, Waiting };
  /// The kind of failure behind reason().
  enum class Failure {
    None,
    Unreachable,    // no connection, or it was lost, or a server error (HTTP 5xx)
    TimedOut,       // not a byte in time
    Refused,        // 401, 403
    NotAWebSocket,  // there is a server, but it does not speak WebSocket
    Certificate,    // certificate() says more
  };

  /// `urls` are tried in turn if the server refuses the handshake (HTTP 4xx), e.g. with and without a query
  /// that old firmware does not support. `secret` belongs to the origin of the first and is sent only there,
  /// as the `Secret:` header; never in a log or sentence.
  WebSocketLink(QList<QUrl> urls, QByteArray secret, WebSocketLinkOptions options, QObject* parent = nullptr);
  ~WebSocketLink() override;

  void open();                                           // also "now, do not wait"
  void close();                                          // stays closed
  void sendText(const QString& text);                    // dropped unless Open
  void setTrust(const Trust& trust) { trust_ = trust; }  // for the next connection

  qint64 unsentBytes() const;    // queued by sendText() and not sent yet. 0 unless Open
  qint64 arrivingBytes() const;  // approximate size received so far of an incomplete message. 0 unless Open

  State state() const { return state_; }
  Fault reason() const { return reason_; }      // why it is not open
  Failure failure() const { return failure_; }  // None while open
  std::optional<CertificateFault> certificate() const { return certificate_; }
  int handshakeStatus() const { return status_; }  // HTTP status of a refused handshake, otherwise 0
  int attempt() const { return attempt_; }         // tries since last open
  std::optional<int> retryInMs() const;            // while Waiting
  std::optional<int> roundTripMs() const { return round_trip_ms_; }  // last ping
  /// Since the last byte, even within a message; while Open.
  std::chrono::milliseconds silence() const { return options_.now() - heard_at_; }
  /// When the last byte arrived, if that is too long ago: an open connection does not answer although it was
  /// faster before (slow ones get as much time again), or it is lost. nullopt: all is well, or it was never
  /// open.
  std::optional<QDateTime> silentSince() const { return silent_since_; }

 Q_SIGNALS:
  void changed();  // of silentSince(), too
  void opened();
  void written();  // some of unsentBytes() has left
  void textReceived(const QByteArray& utf8);
  void binaryReceived(const QByteArray& bytes);

 private:
  static Fault noAnswer(std::chrono::milliseconds time);
  void startAttempt();
  /// Of what is or was connected to last, for the log.
  QByteArray name() const;
  void connectSocket();
  /// QWebSocket only reports complete frames, and a large one may take minutes on a slow connection. The
  /// socket that it reads from is its child, and reports every byte received, decrypted.
  void watchTransport();
  void onFrame(qint64 bytes, bool last);
  void judge(QSslSocket& encrypted, const QList<QSslError>& errors);
  void becomeOpen();
  void ping();
  void hear();
  void onSilence(std::chrono::milliseconds now);
  void onLastByte();
  void look();
  void onError(QAbstractSocket::SocketError error);
  void loseConnection();
  /// Automatic retries would not help.
  void refuse(Failure failure, const Fault& reason);
  void fail(Failure failure, const Fault& reason);
  void enter(State state);
  void stopTimers();
  void dropSocket();
  /// Like dropSocket, but closes an open link properly.
  void sayFarewell();

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

}  // namespace mapwright::net
