#include "ui/replay/timeline_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QDateTime>
#include <QLocale>

#include "replay/player.h"
#include "words/qt_versions.h"

namespace mapwright::ui {

namespace {

constexpr std::array kSteps{0.001,  0.002,   0.005,   0.01,    0.02,    0.05,    0.1,   0.2,
                            0.5,    1.0,     2.0,     5.0,     10.0,    15.0,    30.0,  60.0,
                            120.0,  300.0,   600.0,   900.0,   1800.,   3600.,   7200., 10800.,
                            21600., 43200.0, 86400.0, 172800., 604800., 2592000.};
constexpr std::size_t kMostTicks = 2'000;
constexpr double kDayS = 86'400;
constexpr double kFarthestS = 1e11;  // limit for QDateTime

QDateTime utc(double at_s) {
  return words::utcOfMs(qint64(std::floor(std::clamp(at_s, -kFarthestS, kFarthestS) * 1000 + 1e-3)));
}

}  // namespace

TimelineAxis TimelineAxis::zoomed(double factor, double at_s, double first_s, double last_s) const {
  const double whole_s = std::max(last_s - first_s, kNearestS);
  const double length_s = std::clamp((until_s - from_s) * factor, kNearestS, whole_s);
  TimelineAxis axis = *this;
  axis.from_s = at_s - (at_s - from_s) * length_s / (until_s - from_s);
  axis.until_s = axis.from_s + length_s;
  return axis.movedBy(0, first_s, last_s);
}

TimelineAxis TimelineAxis::movedBy(double by_s, double first_s, double last_s) const {
  const double length_s = until_s - from_s;
  const double latest_s = std::max(first_s, last_s - length_s);
  TimelineAxis axis = *this;
  axis.from_s = std::clamp(from_s + by_s, first_s, latest_s);
  axis.until_s = axis.from_s + length_s;
  return axis;
}

TimelineAxis TimelineAxis::showing(double at_s, double first_s, double last_s) const {
  if (at_s >= from_s && at_s <= until_s) return *this;
  const double length_s = until_s - from_s;
  // It entered from the other side: most of the page is ahead.
  const double into_s = at_s > until_s ? length_s / 20 : length_s * 19 / 20;
  return movedBy(at_s - into_s - from_s, first_s, last_s);
}

std::vector<AxisTick> axisTicks(const TimelineAxis& axis, double label_px) {
  const double wanted_s = axis.secondsPerPixel() * label_px;
  const auto at_least = [](double s) {
    const auto found = std::lower_bound(kSteps.begin(), kSteps.end(), s * (1 - 1e-9));
    return found == kSteps.end() ? kSteps.back() : *found;
  };
  const double step_s = at_least(wanted_s);
  const double small_s = std::min(step_s, at_least(std::max(wanted_s / 5, kSteps.front())));
  const int decimals = step_s >= 1 ? 0 : step_s >= 0.1 ? 1 : step_s >= 0.01 ? 2 : 3;
  std::vector<AxisTick> ticks;
  for (double n = std::ceil(axis.from_s / small_s);; ++n) {
    const double at_s = n * small_s;
    if (!(at_s <= axis.until_s) || ticks.size() >= kMostTicks) break;
    const double labels = at_s / step_s;
    const bool labelled = std::abs(labels - std::round(labels)) * step_s < small_s / 4;
    QString label;
    if (labelled) {
      label = step_s >= kDayS ? dayText(at_s + 1e-4)
              : step_s >= 60  ? utc(at_s).toString(QStringLiteral("HH:mm"))
                              : clockText(at_s + 1e-5, decimals);
    }
    ticks.push_back({at_s, label});
  }
  return ticks;
}

QString clockText(double at_s, int decimals) {
  const QString text = utc(at_s).toString(QStringLiteral("HH:mm:ss.zzz"));
  return decimals > 0 ? text.left(9 + std::min(decimals, 3)) : text.left(8);
}

QString dayText(double at_s) { return utc(at_s).toString(QStringLiteral("yyyy-MM-dd")); }

QString elapsedText(double length_s) {
  const qint64 tenths = qint64(std::floor(std::clamp(length_s, 0.0, kFarthestS) * 10 + 1e-6));
  const qint64 seconds = tenths / 10;
  const auto two = [](qint64 n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
  const QString rest = QStringLiteral("%1.%2").arg(two(seconds % 60)).arg(tenths % 10);
  return seconds >= 3600 ? QStringLiteral("%1:%2:%3").arg(seconds / 3600).arg(two(seconds / 60 % 60), rest)
                         : QStringLiteral("%1:%2").arg(seconds / 60).arg(rest);
}

QString speedText(double speed) { return QStringLiteral("%1x").arg(speed, 0, 'g', 3); }

std::optional<double> speedTyped(const QString& typed) {
  QString text = typed.trimmed().toLower();
  text.replace(QLatin1Char(','), QLatin1Char('.'));
  text.replace(QChar(0x2212), QLatin1Char('-'));
  if (text.endsWith(QLatin1Char('x')) || text.endsWith(QChar(0xD7))) text.chop(1);
  bool is_number = false;
  const double speed = QLocale::c().toDouble(text.trimmed(), &is_number);
  const double size = std::abs(speed);
  if (!is_number || !(size >= replay::Player::kSlowest && size <= replay::Player::kFastest))
    return std::nullopt;
  return speed;
}

}  // namespace mapwright::ui
