#include "robot/axbot/robot_urls.h"

namespace mapwright::robot::axbot {

QUrl urlOnRobot(const QUrl& base, const QString& path, const QString& query) {
  QUrl url = base;
  url.setPath(base.path(QUrl::FullyEncoded) + path, QUrl::TolerantMode);
  if (!query.isEmpty()) url.setQuery(query);
  return url;
}

QUrl robotUrl(const QUrl& base, std::string_view given) {
  const QString text = QString::fromUtf8(given.data(), qsizetype(given.size())).trimmed();
  QUrl url(text, QUrl::TolerantMode);
  QString path, query;
  if (url.isValid() && (!url.host().isEmpty() || url.scheme().startsWith(QLatin1String("http")))) {
    path = url.path(QUrl::FullyEncoded);
    query = url.query(QUrl::FullyEncoded);
  } else {
    // Not with QUrl: a colon in a file name would look like the end of a scheme.
    const QString without_fragment = text.section(QLatin1Char('#'), 0, 0);
    path = without_fragment.section(QLatin1Char('?'), 0, 0);
    query = without_fragment.section(QLatin1Char('?'), 1);
  }
  if (path.isEmpty() || path == QLatin1String("/")) return {};
  if (!path.startsWith(QLatin1Char('/'))) path.prepend(QLatin1Char('/'));
  // A robot behind a prefix may or may not know it.
  const QString prefix = base.path(QUrl::FullyEncoded);
  if (!prefix.isEmpty() && path.startsWith(prefix + QLatin1Char('/'))) path.remove(0, prefix.size());
  return urlOnRobot(base, path, query);
}

QString pathSegment(std::string_view id) {
  return QString::fromLatin1(QUrl::toPercentEncoding(QString::fromUtf8(id.data(), qsizetype(id.size()))));
}

}  // namespace mapwright::robot::axbot
