// A secret together with the only origin that may receive it.
#pragma once

#include <QByteArray>
#include <QUrl>

#include "net/plain_sentences.h"

namespace mapwright::net {

/// The value is only returned for an address of its own origin. ws and wss count as http and https: a
/// WebSocket handshake goes to the same server.
class Secret {
 public:
  Secret() = default;
  /// `value` is made safe for a header; `origin` is any address on its server.
  Secret(const QUrl& origin, const QByteArray& value) : origin_(asWeb(origin)), value_(headerSafe(value)) {}
  /// Empty for any other scheme, host or port, including https -> http.
  QByteArray forUrl(const QUrl& url) const {
    const bool belongs = url.isValid() && !url.host().isEmpty() && sameOrigin(asWeb(url), origin_);
    return belongs ? value_ : QByteArray();
  }

 private:
  static QUrl asWeb(QUrl url) {
    if (url.scheme() == QLatin1String("ws")) url.setScheme(QStringLiteral("http"));
    if (url.scheme() == QLatin1String("wss")) url.setScheme(QStringLiteral("https"));
    return url;
  }

  QUrl origin_;
  QByteArray value_;
};

}  // namespace mapwright::net
