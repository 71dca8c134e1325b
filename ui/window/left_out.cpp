#include "ui/window/left_out.h"

#include <algorithm>

#include <QDir>
#include <QHash>
#include <QRegularExpression>
#include <QSysInfo>

namespace mapwright::ui {
namespace {

/// Shorter names would be found everywhere; two Chinese characters are a word.
constexpr qsizetype kShortestName = 3, kShortestChineseName = 2;

/// Numbers robots as they are met.
class RobotNumbers {
 public:
  explicit RobotNumbers(const QList<QStringList>& robots) {
    for (const QStringList& names : robots) {
      // The robot at hand is also one of those that were used lately.
      const auto known = std::find_if(names.begin(), names.end(),
                                      [&](const QString& name) { return numbers_.contains(name.toLower()); });
      const int number = known != names.end() ? numbers_.value(known->toLower()) : ++count_;
      for (const QString& name : names) {
        if (!name.isEmpty()) numbers_.insert(name.toLower(), number);
      }
    }
  }
  QString of(const QString& host) {
    int& number = numbers_[host.toLower()];
    if (number == 0) number = ++count_;
    return QStringLiteral("robot-%1").arg(number);
  }
  /// Longest first, so that "dock" does not cut "dock-3.local".
  QStringList known() const {
    QStringList names = numbers_.keys();
    std::sort(names.begin(), names.end(), [](const QString& one, const QString& other) {
      return one.size() != other.size() ? one.size() > other.size() : one < other;
    });
    return names;
  }

 private:
  QHash<QString, int> numbers_;
  int count_ = 0;
};

template <typename Instead>
QString replaced(const QString& text, const QRegularExpression& what, const Instead& instead) {
  QString result;
  qsizetype from = 0;
  for (auto it = what.globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    result += text.mid(from, match.capturedStart() - from) + instead(match);
    from = match.capturedEnd();
  }
  return result + text.mid(from);
}

/// As a word of its own, in any case; Chinese has no blanks between words.
QString withoutName(const QString& text, const QString& name, const QString& instead) {
  const bool chinese =
      std::any_of(name.begin(), name.end(), [](QChar one) { return one.script() == QChar::Script_Han; });
  if (name.size() < (chinese ? kShortestChineseName : kShortestName)) return text;
  const QString written = QRegularExpression::escape(name);
  const QRegularExpression word(
      chinese ? written : QStringLiteral("(?<![\\p{Latin}\\p{N}_])%1(?![\\p{Latin}\\p{N}_])").arg(written),
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
  return replaced(text, word, [&](const QRegularExpressionMatch&) { return instead; });
}

}  // namespace

Privacy privacyHere() {
  Privacy here;
  here.home = QDir::homePath();
  here.user = qEnvironmentVariable("USER", qEnvironmentVariable("LOGNAME"));
  here.computer = QSysInfo::machineHostName();
  return here;
}

QString withoutPrivate(const QString& text, const Privacy& privacy) {
  static const QRegularExpression secret(
      QStringLiteral(
          "\\b(\\w*(?:secret|token|password|passwd|authorization|api[_-]?key)\\w*[\"']?\\s*[=:]\\s*)"
          "(?:(?:Secret|Bearer|Basic)\\s+)?[^\\s&,;，；。]+"),
      QRegularExpression::CaseInsensitiveOption);
  // User, password, path and query go with it.
  static const QRegularExpression url(
      QStringLiteral("\\b([a-z][a-z0-9+.-]*://)(?:[^\\s/@]*@)?(\\[[^\\]\\s]*\\]|[^\\s/"
                     ":?#\"'<>)\\],;，；。：）”]*)[^\\s\"'<>),;，；。：）”]*"),
      QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression mac(QStringLiteral("\\b[0-9a-f]{2}(?:[:-][0-9a-f]{2}){5}\\b"),
                                      QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression ip4(
      QStringLiteral("(?<![\\d.])(\\d{1,3}(?:\\.\\d{1,3}){3})(?::\\d+)?(?![\\d.]*\\d)"));
  // Not the time of day: two colons in a row, or seven of them.
  static const QRegularExpression ip6(QStringLiteral("(?<![\\w:])\\[?((?=[0-9a-f:]*::|(?:[0-9a-f]*:){7})[0-"
                                                     "9a-f]*:[0-9a-f:]+(?:%\\w+)?)(?:\\]:\\d+|\\])?"),
                                      QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression others_home(QStringLiteral("/home/[^/\\s]+"));

  RobotNumbers robots(privacy.robots);
  QString left =
      replaced(text, secret, [](const auto& match) { return match.captured(1) + QLatin1String("***"); });
  left = replaced(left, url, [&](const auto& match) {
    // A file's folder is left to the rules below.
    if (match.captured(2).isEmpty()) return match.captured(0);
    return match.captured(1) + robots.of(match.captured(2).remove(QLatin1Char('[')).remove(QLatin1Char(']')));
  });
  if (privacy.home.size() > 1) left.replace(privacy.home, QLatin1String("~"));
  left = replaced(left, others_home, [](const auto&) { return QStringLiteral("~"); });
  left = replaced(left, mac, [](const auto&) { return QStringLiteral("hardware-address"); });
  for (const auto& address : {ip4, ip6})
    left = replaced(left, address, [&](const auto& match) { return robots.of(match.captured(1)); });
  for (const QString& name : robots.known()) left = withoutName(left, name, robots.of(name));
  left = withoutName(left, privacy.computer, QStringLiteral("computer"));
  return withoutName(left, privacy.user, QStringLiteral("user"));
}

}  // namespace mapwright::ui
