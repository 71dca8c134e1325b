#include "robot/axbot/robot_urls.h"

#include <algorithm>
#include <cctype>

#include "json/json_text.h"
#include "robot/wire/net_results.h"

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

QString pathSegment(std::string_view text) {
  return QString::fromLatin1(QUrl::toPercentEncoding(QString::fromUtf8(text.data(), qsizetype(text.size()))));
}

bool isPlainId(std::string_view id) {
  return !id.empty() && std::all_of(id.begin(), id.end(),
                                    [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

std::optional<QString> pathOf(const QString& folder, std::string_view id) {
  if (!isPlainId(id)) return std::nullopt;
  return folder + pathSegment(id);
}

std::optional<QString> pathOfNamed(const QString& folder, std::string_view name) {
  const QString text = QString::fromUtf8(name.data(), qsizetype(name.size()));
  const auto leads_away = [](QChar c) {
    return QStringView(u"/\\?#%").contains(c) || c.category() == QChar::Other_Control;
  };
  const bool blank = text.trimmed().isEmpty() || text == QLatin1String(".") || text == QLatin1String("..");
  if (blank || std::any_of(text.begin(), text.end(), leads_away)) return std::nullopt;
  return folder + pathSegment(name);
}

net::HttpRequest RobotServer::request(const QString& path, const QString& query) const {
  constexpr qint64 kMaxJsonBytes = qint64(64) << 20;
  net::HttpRequest request;
  request.url = urlOnRobot(base, path, query);
  request.max_bytes = kMaxJsonBytes;
  request.timeout = timeout;
  return request;
}

net::HttpRequest RobotServer::pictureRequest(const QUrl& url) const {
  net::HttpRequest request;
  request.url = url;
  request.timeout = timeout;
  request.accept = "image/png,image/*;q=0.8,*/*;q=0.5";
  request.cacheable = true;
  return request;
}

std::optional<map::Failure> refusalIn(const net::HttpAnswer& answer, const map::Subject& subject) {
  const auto json = json::JsonText::read(answer.body.toStdString());
  const auto success = json ? json->root().member("success") : std::nullopt;
  if (!success || success->kind() != json::JsonKind::False) return std::nullopt;
  const auto message = json->root().member("message");
  return map::Failure{.kind = map::FailureKind::RejectedByRobot,
                      .subject = subject,
                      .detail = message ? message->string() : std::string(),
                      .asked_for = map::AskedFor::Change};
}

Outcome<std::shared_ptr<const std::string>> pictureOf(const net::HttpAnswer& answer,
                                                      const map::Subject& subject, map::AskedFor asked_for) {
  if (!answer.ok()) return fail(wire::failed(answer, subject, asked_for));
  if (!answer.body.isEmpty()) return std::make_shared<const std::string>(answer.body.toStdString());
  return fail({.kind = map::FailureKind::MalformedAnswer,
               .subject = subject,
               .asked_for = asked_for,
               .reason = map::FailureReason::Empty});
}

}  // namespace mapwright::robot::axbot
