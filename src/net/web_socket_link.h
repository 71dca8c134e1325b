// A WebSocket that stays: connects, notices silence, reconnects with backoff and jitter.
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
  std::chrono::milliseconds ask_after{1'000};       // one that has just been talking is asked sooner
  std::chrono::milliseconds quiet_after{3'000};     // asked, and no byte for so long = silentSince()
  std::chrono::milliseconds silent_after{15'000};   // not a byte for this long = the link is dead
  std::chrono::milliseconds healthy_after{30'000};  // open for so long = the next loss is a first one
  std::chrono::milliseconds look_every{1'000};      // for silence and health
  std::chrono::milliseconds connect_timeout{10'000};
  std::chrono::milliseconds backoff_first{500};
  std::chrono::milliseconds backoff_limit{30'000};
  quint64 max_message_bytes = quint64(256) << 20;
  quint32 jitter_seed = 0;  // 0 = random; tests fix it
  std::function<std::chrono::milliseconds()> now =
      {};                                // a clock that only goes forward; empty = the usual one
  std::function<QDateTime()> wall = {};  // the time of day; empty = the usual one
};

/// Lives on the thread that made it. States are told by changed(); text and binary frames by signals.
class WebSocketLink : public QObject {
  Q_OBJECT
 public:
  enum class State { Closed, Connecting, Open, Waiting };
  /// What kind of thing reason() tells of.
  enum class Failure {
    None,
    Unreachable,    // no connection, or it broke off, or a server error (HTTP 5xx)
    TimedOut,       // not a byte in time
    Refused,        // 401, 403
    NotAWebSocket,  // something answers there, but not as a WebSocket
    Certificate,    // certificate() says more
  };

  /// `urls` are tried in turn when the server refuses the handshake (HTTP 4xx), e.g. with and without a query
  /// that old firmware does not know. `secret` belongs to the origin of the first, and goes there only, as
  /// the `Secret:` header; into no log or sentence.
  WebSocketLink(QList<QUrl> urls, QByteArray secret, WebSocketLinkOptions options, QObject* parent = nullptr);
  ~WebSocketLink() override;

  void open();                         // also "now, do not wait"
  void close();                        // stays closed
  void sendText(const QString& text);  // dropped unless Open
  void setTrust(const Trust& trust);   // for the next connection

  qint64 unsentBytes() const;    // of what was sent: still here. 0 unless Open
  qint64 arrivingBytes() const;  // of a message that is not whole yet: here already, about. 0 unless Open

  State state() const;
  Fault reason() const;     // why it is not open
  Failure failure() const;  // None while open
  std::optional<CertificateFault> certificate() const;
  int handshakeStatus() const;                // HTTP status of a refused handshake, else 0
  int attempt() const;                        // tries since last open
  std::optional<int> retryInMs() const;       // while Waiting
  std::optional<int> roundTripMs() const;     // last ping
  std::chrono::milliseconds silence() const;  // since the last byte, be it within a message; while Open
  /// When the last byte came, once that is too long ago: an open link does not answer, and has been quicker
  /// before (one that needs long for its answers gets as long again), or it is lost. nullopt: all is well, or
  /// it has never been open.
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
