// A secret together with the one origin that may see it.
#pragma once

#include <QByteArray>
#include <QUrl>

namespace mapwright::net {

/// The value leaves this object only for an address of its own origin. ws and wss are http and https by other
/// means: the handshake of a WebSocket goes to the same server.
class Secret {
 public:
  Secret() = default;
  /// `value` is made safe for a header; `origin` is any address on the server it belongs to.
  Secret(const QUrl& origin, const QByteArray& value);
  /// Empty for every other scheme, host or port, https -> http included.
  QByteArray forUrl(const QUrl& url) const;

 private:
  QUrl origin_;
  QByteArray value_;
};

}  // namespace mapwright::net
