#include "net/secret.h"

#include "net/plain_sentences.h"

namespace mapwright::net {
namespace {

QUrl asWeb(QUrl url) {
  if (url.scheme() == QLatin1String("ws")) url.setScheme(QStringLiteral("http"));
  if (url.scheme() == QLatin1String("wss")) url.setScheme(QStringLiteral("https"));
  return url;
}

}  // namespace

Secret::Secret(const QUrl& origin, const QByteArray& value)
    : origin_(asWeb(origin)), value_(headerSafe(value)) {}

QByteArray Secret::forUrl(const QUrl& url) const {
  const bool belongs = url.isValid() && !url.host().isEmpty() && sameOrigin(asWeb(url), origin_);
  return belongs ? value_ : QByteArray();
}

}  // namespace mapwright::net
