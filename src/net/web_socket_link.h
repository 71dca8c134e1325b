// A persistent WebSocket: connects, detects silence, and reconnects with backoff and jitter.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUrl>

#include "net/faults.h"
#include "net/trust.h"

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

  void open();                         // also "now, do not wait"
  void close();                        // stays closed
  void sendText(const QString& text);  // dropped unless Open
  void setTrust(const Trust& trust);   // for the next connection

  qint64 unsentBytes() const;    // queued by send() and not sent yet. 0 unless Open
  qint64 arrivingBytes() const;  // approximate size received so far of an incomplete message. 0 unless Open

  State state() const;
  Fault reason() const;     // why it is not open
  Failure failure() const;  // None while open
  std::optional<CertificateFault> certificate() const;
  int handshakeStatus() const;                // HTTP status of a refused handshake, otherwise 0
  int attempt() const;                        // tries since last open
  std::optional<int> retryInMs() const;       // while Waiting
  std::optional<int> roundTripMs() const;     // last ping
  std::chrono::milliseconds silence() const;  // since the last byte, even within a message; while Open
  /// When the last byte arrived, if that is too long ago: an open connection does not answer although it was
  /// faster before (slow ones get as much time again), or it is lost. nullopt: all is well, or it was never
  /// open.
  std::optional<QDateTime> silentSince() const;

 Q_SIGNALS:
  void changed();  // of silentSince(), too
  void opened();
  void written();  // some of unsentBytes() has left
  void textReceived(const QByteArray& utf8);
  void binaryReceived(const QByteArray& bytes);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net
