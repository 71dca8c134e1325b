// A WebSocket that stays: connects, notices silence, reconnects with backoff and jitter.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QUrl>

namespace mapwright::net {

struct WebSocketLinkOptions {
  std::chrono::milliseconds ping_every{5'000};
  std::chrono::milliseconds silent_after{15'000};  // no frame and no pong for this long = the link is dead
  std::chrono::milliseconds connect_timeout{10'000};
  std::chrono::milliseconds backoff_first{500};
  std::chrono::milliseconds backoff_limit{30'000};
  quint64 max_message_bytes = quint64(256) << 20;
  quint32 jitter_seed = 0;  // 0 = random; tests fix it
};

/// Lives on the thread that made it. States are told by changed(); text and binary frames by signals.
class WebSocketLink : public QObject {
  Q_OBJECT
 public:
  enum class State { Closed, Connecting, Open, Waiting };

  /// `urls` are tried in turn when the server refuses the handshake (HTTP 4xx), e.g. with and without a query
  /// that old firmware does not know. `secret` goes as the `Secret:` header and into no log or sentence.
  WebSocketLink(QList<QUrl> urls, QByteArray secret, WebSocketLinkOptions options, QObject* parent = nullptr);
  ~WebSocketLink() override;

  void open();                         // also "now, do not wait"
  void close();                        // stays closed
  void sendText(const QString& text);  // dropped unless Open

  State state() const;
  QString reason() const;                  // why it is not open, for people; plain text
  int handshakeStatus() const;             // HTTP status of a refused handshake, else 0
  int attempt() const;                     // tries since last open
  std::optional<int> retryInMs() const;    // while Waiting
  std::optional<int> roundTripMs() const;  // last ping

 Q_SIGNALS:
  void changed();
  void opened();
  void textReceived(const QByteArray& utf8);
  void binaryReceived(const QByteArray& bytes);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::net
