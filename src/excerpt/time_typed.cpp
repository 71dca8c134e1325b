#include "excerpt/time_typed.h"

#include <algorithm>
#include <cmath>

#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include "words/qt_versions.h"

namespace mapwright::excerpt {
namespace {

constexpr double kEpochFromS = 1e8;  // smaller numbers count from the start, unless stamps begin at zero
constexpr double kDayS = 86'400;

/// "90", "1:30", "1:02:03.5" as a length; nullopt: invalid.
std::optional<double> lengthTyped(const QString& text) {
  static const QRegularExpression pattern(
      QStringLiteral("^(?:(?:(\\d{1,4}):)?(\\d{1,2}):)?(\\d{1,10}(?:\\.\\d*)?|\\.\\d+)\\s*s?$"));
  const QRegularExpressionMatch match = pattern.match(text);
  if (!match.hasMatch()) return std::nullopt;
  return match.captured(1).toDouble() * 3600 + match.captured(2).toDouble() * 60 +
         match.captured(3).toDouble();
}

std::optional<double> clockTyped(const QString& text, double first_s, double last_s) {
  static const QRegularExpression pattern(
      QStringLiteral("^(\\d{1,2}):(\\d{2})(?::(\\d{2}(?:\\.\\d*)?))?(?:\\s*(?:z|utc))?$"));
  const QRegularExpressionMatch match = pattern.match(text);
  if (!match.hasMatch()) return std::nullopt;
  const double hours = match.captured(1).toDouble(), minutes = match.captured(2).toDouble();
  const double seconds = match.captured(3).toDouble();
  if (hours > 23 || minutes > 59 || seconds >= 60) return std::nullopt;
  const double of_day_s = hours * 3600 + minutes * 60 + seconds;
  const double first_day_s = std::floor(first_s / kDayS) * kDayS;
  // "14:36" of a bag that begins at 14:36:17 means its start.
  const double slack_s = match.captured(3).isEmpty() ? 60 : 1;
  for (double day_s = first_day_s; day_s <= last_s; day_s += kDayS) {
    const double at_s = day_s + of_day_s;
    if (at_s > first_s - slack_s && at_s <= last_s) return std::max(at_s, first_s);
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> timeTyped(const QString& typed, double first_s, double last_s) {
  QString text = typed.trimmed().toLower();
  text.replace(QLatin1Char(','), QLatin1Char('.'));
  const auto within = [&](std::optional<double> at_s) {
    // Displayed times are truncated to milliseconds: the start may be typed slightly too early.
    if (!at_s || !std::isfinite(*at_s) || *at_s < first_s - 0.001 || *at_s > last_s + 0.001)
      return std::optional<double>();
    return std::optional(std::clamp(*at_s, first_s, last_s));
  };
  if (text.startsWith(QLatin1Char('+'))) {
    const auto length_s = lengthTyped(text.mid(1).trimmed());
    return length_s ? within(first_s + *length_s) : std::nullopt;
  }
  if (text.startsWith(QLatin1Char('-'))) {
    const auto length_s = lengthTyped(text.mid(1).trimmed());
    return length_s ? within(last_s - *length_s) : std::nullopt;
  }
  if (text.contains(QLatin1Char(':')) && !text.contains(QLatin1Char('-')))
    return clockTyped(text, first_s, last_s);
  if (const auto at_s = absoluteTimeTyped(text, first_s)) return within(at_s);
  const auto length_s = lengthTyped(text);
  return length_s ? within(first_s + *length_s) : std::nullopt;
}

std::optional<double> absoluteTimeTyped(const QString& typed, double first_s) {
  const QString text = typed.trimmed().toUpper();
  if (text.startsWith(QLatin1Char('+')) || text.startsWith(QLatin1Char('-'))) return std::nullopt;
  bool is_number = false;
  const double since = QLocale::c().toDouble(text, &is_number);
  if (is_number && std::isfinite(since) && (since >= kEpochFromS || first_s < kEpochFromS)) return since;
  if (!text.contains(QLatin1Char('-'))) return std::nullopt;
  QDateTime time =
      QDateTime::fromString(QString(text).replace(QLatin1Char(' '), QLatin1Char('T')), Qt::ISODateWithMs);
  if (!time.isValid()) return std::nullopt;
  if (time.timeSpec() == Qt::LocalTime) time = words::takenAsUtc(time);
  return double(time.toMSecsSinceEpoch()) / 1000;
}

}  // namespace mapwright::excerpt
