#include "net/log.h"

#include <QRegularExpression>
#include <QUrlQuery>

namespace mapwright::net {

Q_LOGGING_CATEGORY(lcNet, "mapwright.net", QtWarningMsg)
Q_LOGGING_CATEGORY(lcCache, "mapwright.cache", QtWarningMsg)

QString urlForLog(const QUrl& url) {
  static const QRegularExpression kNumber(QStringLiteral("^[-+]?[0-9]{1,9}([.][0-9]{1,9})?$"));
  static const QRegularExpression kSecretName(
      QStringLiteral("secret|token|pass|pwd|pin|key|auth|sig|mac|code|cred|session|user|login"),
      QRegularExpression::CaseInsensitiveOption);
  QUrl fit = url.adjusted(QUrl::RemoveUserInfo | QUrl::RemoveFragment | QUrl::RemoveQuery);
  QString text = fit.toString(QUrl::FullyEncoded);
  QChar before = QLatin1Char('?');
  for (const auto& [name, value] : QUrlQuery(url).queryItems()) {
    const bool told = kNumber.match(value).hasMatch() && !kSecretName.match(name).hasMatch();
    text += before + (value.isEmpty() ? QStringLiteral("…")  // a token may stand alone
                                      : name + QLatin1Char('=') + (told ? value : QStringLiteral("…")));
    before = QLatin1Char('&');
  }
  return text;
}

}  // namespace mapwright::net
