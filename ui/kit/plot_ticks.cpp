#include "ui/kit/plot_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QDateTime>

namespace mapwright::ui {

namespace {

constexpr std::array kSteps_s{0.001, 0.002, 0.005, 0.01,   0.02,   0.05,   0.1,    0.2,     0.5,    1.,
                              2.,    5.,    10.,   15.,    30.,    60.,    120.,   300.,    600.,   900.,
                              1800., 3600., 7200., 10800., 21600., 43200., 86400., 172800., 604800.};
constexpr double kDay_s = 86400;

/// 1, 2 or 5 times a power of ten, no smaller than `least`.
double roundStep(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1., 2., 5.}) {
    if (factor * power >= least * 0.9999) return factor * power;
  }
  return 10 * power;
}

int decimalsOf(double step) { return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9); }

/// No "-0.0".
QString number(double value, int decimals) {
  if (std::abs(value) < std::pow(10, -decimals) / 2) value = 0;
  return QString::number(value, 'f', decimals);
}

std::vector<PlotTick> roundTicks(double least, double greatest, double step, double origin) {
  std::vector<PlotTick> ticks;
  const bool large = std::max(std::abs(least - origin), std::abs(greatest - origin)) >= 1e7 || step < 1e-6;
  for (double n = std::ceil((least - origin) / step - 1e-9);
       origin + n * step <= greatest + step * 1e-9 && ticks.size() < 100; ++n) {
    const double value = n * step;
    ticks.push_back(
        {origin + value, large ? QString::number(value, 'g', 6) : number(value, decimalsOf(step))});
  }
  return ticks;
}

QDateTime dateTime(double at_s) { return QDateTime::fromMSecsSinceEpoch(qint64(std::llround(at_s * 1000))); }

}  // namespace

std::vector<PlotTick> valueTicks(double least, double greatest, int most) {
  if (!(least < greatest) || !std::isfinite(greatest - least)) return {};
  const double step = roundStep((greatest - least) / std::max(most, 1));
  // Numbers too close together for a double.
  if (!(step > 0) || std::max(std::abs(least), std::abs(greatest)) / step > 1e14) return {};
  return roundTicks(least, greatest, step, 0);
}

std::vector<PlotTick> timeTicks(double from_s, double until_s, int most, std::optional<double> since_s) {
  if (!(from_s < until_s) || !std::isfinite(until_s - from_s)) return {};
  const double least = (until_s - from_s) / std::max(most, 1);
  if (since_s) return roundTicks(from_s, until_s, std::max(roundStep(least), 0.001), *since_s);
  const auto found = std::lower_bound(kSteps_s.begin(), kSteps_s.end(), least * 0.9999);
  const double step = found == kSteps_s.end() ? std::ceil(least / kSteps_s.back()) * kSteps_s.back() : *found;
  // Round local times.
  const double local_s = double(dateTime(from_s).offsetFromUtc());
  std::vector<PlotTick> ticks;
  for (double n = std::ceil((from_s + local_s) / step - 1e-9);
       n * step - local_s <= until_s && ticks.size() < 100; ++n) {
    const double at_s = n * step - local_s;
    const QDateTime at = dateTime(at_s);
    const bool day_begins = std::abs(std::remainder(n * step, kDay_s)) < step / 4;
    const QString format = day_begins   ? QCoreApplication::translate("window", "d MMM")
                           : step >= 60 ? QStringLiteral("HH:mm")
                           : step >= 1  ? QStringLiteral("HH:mm:ss")
                                        : QStringLiteral("HH:mm:ss.zzz");
    ticks.push_back({at_s, at.toString(format)});
  }
  return ticks;
}

QString timeText(double at_s, std::optional<double> since_s) {
  if (since_s) return number(at_s - *since_s, 3);
  return dateTime(at_s).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString zoneText(double at_s) {
  const int minutes = dateTime(at_s).offsetFromUtc() / 60, apart = std::abs(minutes);
  QString text = QStringLiteral("UTC");
  if (minutes != 0) text += QLatin1Char(minutes < 0 ? '-' : '+') + QString::number(apart / 60);
  if (apart % 60 != 0) text += QStringLiteral(":%1").arg(apart % 60, 2, 10, QLatin1Char('0'));
  return text;
}

QString valueText(double value) {
  const double size = std::abs(value);
  if (value != 0 && (size < 1e-4 || size >= 1e9)) return QString::number(value, 'g', 6);
  if (value == std::floor(value)) return QString::number(value, 'f', 0);
  return number(value,
                std::clamp(5 - int(std::floor(std::log10(size))), 0, 6) > 3 ? 3 + (size < 0.1 ? 3 : 0) : 2);
}

}  // namespace mapwright::ui
