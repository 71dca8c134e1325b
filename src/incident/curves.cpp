#include "incident/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <QCoreApplication>

namespace mapwright::incident {
namespace {

using series::Quantity;
using series::Sample;

class CurveText {
  Q_DECLARE_TR_FUNCTIONS(Incident)
};

constexpr std::array kShown{Quantity::Speed, Quantity::PositionQuality, Quantity::MatchingScore,
                            Quantity::Battery};
constexpr double kWidthPx = 480, kHeightPx = 126, kLeftPx = 46, kRightPx = 12, kTopPx = 14, kBottomPx = 24;
constexpr int kColumns = 400, kMostTicks = 4;

QByteArray px(double value) {
  // Never "-0.0".
  return QByteArray::number(std::round(value * 10) / 10 + 0.0, 'f', 1);
}

/// 1, 2 or 5 times a power of ten, no smaller than `least`.
double tickStep(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1., 2., 5.}) {
    if (factor * power >= least * 0.9999) return factor * power;
  }
  return 10 * power;
}

struct Axis {
  double least = 0, greatest = 1, step = 1;
  double y(double value) const {
    return kHeightPx - kBottomPx - (value - least) / (greatest - least) * (kHeightPx - kTopPx - kBottomPx);
  }
};

Axis axisOf(const Curve& curve) {
  if (curve.quantity == Quantity::PositionQuality) return {0, 10, 5};
  if (curve.quantity == Quantity::Battery) return {0, 100, 50};
  // Zero belongs to the others.
  double least = 0, greatest = 0;
  for (const series::Stroke& stroke : curve.strokes) {
    for (const Sample& sample : stroke) {
      least = std::min(least, sample.value);
      greatest = std::max(greatest, sample.value);
    }
  }
  if (!(greatest - least > 1e-6)) greatest = least + 1;
  const double step = tickStep((greatest - least) / kMostTicks);
  return {std::floor(least / step) * step, std::ceil(greatest / step) * step, step};
}

QByteArray line(const char* how, double x1, double y1, double x2, double y2) {
  return QByteArray("<path class=\"") + how + "\" d=\"M" + px(x1) + ' ' + px(y1) + 'L' + px(x2) + ' ' +
         px(y2) + "\"/>";
}

QByteArray label(const QString& text, double x, double y, const char* anchor, const char* how = "") {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchor + '"' +
         (*how ? QByteArray(" class=\"") + how + '"' : QByteArray()) + '>' + text.toHtmlEscaped().toUtf8() +
         "</text>";
}

QString number(double value) {
  QString text = QString::number(value, 'f', 2);
  while (text.endsWith(QLatin1Char('0'))) text.chop(1);
  if (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

}  // namespace

void Minute::take(const replay::Chunk& chunk) {
  if (chunk.until_s <= from() || chunk.from_s > until()) return;
  for (const Quantity quantity : kShown) {
    if (series::isOfPose(quantity)) continue;
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < chunk.order.size(); ++i) {
      const robot::BagMessage& message = chunk.at(i);
      const auto value = message.known ? series::valueOf(quantity, message.message.message) : std::nullopt;
      if (value) samples.push_back({chunk.stampAt(i), *value});
    }
    series_[quantity].insert(chunk.from_s, chunk.until_s, samples);
  }
}

void Minute::addPoses(const std::map<replay::Tick, replay::Digest>& digests) {
  for (const auto& [tick, digest] : digests) {
    if (digest.until_s <= from() || digest.from_s > until()) continue;
    std::vector<Sample> xs, ys;
    for (const replay::Digest::Pose& each : digest.poses) {
      xs.push_back({each.stamp_s, each.pose.x_m});
      ys.push_back({each.stamp_s, each.pose.y_m});
    }
    x_.insert(digest.from_s, digest.until_s, xs);
    y_.insert(digest.from_s, digest.until_s, ys);
  }
  const double from_s = at_s_ - kBesideS - series::kSpeedReach_s, until_s = std::nextafter(until(), 1e300);
  series_[Quantity::Speed].insert(from_s, until_s, series::speeds(x_, y_, from_s, until_s));
}

std::vector<Curve> Minute::curves() const {
  std::vector<Curve> all;
  const double from_s = at_s_ - kBesideS;
  for (const Quantity quantity : kShown) {
    const auto found = series_.find(quantity);
    if (found == series_.end()) continue;
    Curve curve{quantity, found->second.strokes(from_s, until(), kColumns), std::nullopt};
    // An old speed is none.
    const auto sample = found->second.at(at_s_);
    if (sample && (!series::isOfPose(quantity) || at_s_ - sample->at_s < series::kSpeedReach_s))
      curve.at_moment = sample->value;
    if (!curve.empty()) all.push_back(std::move(curve));
  }
  return all;
}

QString nameOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::Speed:
      return CurveText::tr("Speed");
    case Quantity::PositionQuality:
      return CurveText::tr("Position quality");
    case Quantity::MatchingScore:
      return CurveText::tr("Lidar matching");
    case Quantity::Battery:
      return CurveText::tr("Battery");
    default:
      return {};
  }
}

QString unitOf(Quantity quantity) {
  if (quantity == Quantity::Speed) return QStringLiteral("m/s");
  return quantity == Quantity::Battery ? QStringLiteral("%") : QString();
}

QByteArray svgOf(const Curve& curve, double at_s) {
  const Axis axis = axisOf(curve);
  const double right = kWidthPx - kRightPx, bottom = kHeightPx - kBottomPx;
  const auto x = [&](double since_s) {
    return kLeftPx + (since_s + kBesideS) / (2 * kBesideS) * (right - kLeftPx);
  };
  const QString unit = unitOf(curve.quantity);
  const QString called =
      unit.isEmpty() ? nameOf(curve.quantity) : QStringLiteral("%1 (%2)").arg(nameOf(curve.quantity), unit);
  QByteArray svg = "<svg viewBox=\"0 0 " + QByteArray::number(int(kWidthPx)) + ' ' +
                   QByteArray::number(int(kHeightPx)) + "\" role=\"img\" aria-label=\"" +
                   called.toHtmlEscaped().toUtf8() + "\">";
  for (int n = 0; axis.least + n * axis.step <= axis.greatest * (1 + 1e-9) + 1e-9; ++n) {
    const double value = axis.least + n * axis.step, y = axis.y(value);
    svg += line("line", kLeftPx, y, right, y) + label(number(value), kLeftPx - 6, y + 4, "end");
  }
  for (int since_s = -int(kBesideS); since_s <= int(kBesideS); since_s += 10) {
    svg += line("line", x(since_s), bottom, x(since_s), bottom + 4);
    const QString text =
        since_s > 0 ? QStringLiteral("+%1 s").arg(since_s) : QStringLiteral("%1 s").arg(since_s);
    svg += label(text, x(since_s), kHeightPx - 8,
                 since_s == int(kBesideS)    ? "end"
                 : since_s == -int(kBesideS) ? "start"
                                             : "middle");
  }
  for (const series::Stroke& stroke : curve.strokes) {
    QByteArray path;
    double last_x = 0, last_y = 0;
    for (const Sample& sample : stroke) {
      const double to_x = std::clamp(x(sample.at_s - at_s), kLeftPx, right);
      const double to_y = axis.y(std::clamp(sample.value, axis.least, axis.greatest));
      if (!path.isEmpty() && series::isStepped(curve.quantity)) path += 'L' + px(to_x) + ' ' + px(last_y);
      path += (path.isEmpty() ? 'M' : 'L') + px(to_x) + ' ' + px(to_y);
      last_x = to_x;
      last_y = to_y;
    }
    if (stroke.size() == 1)
      svg += "<circle class=\"dot\" cx=\"" + px(last_x) + "\" cy=\"" + px(last_y) + "\" r=\"2.5\"/>";
    else
      svg += "<path class=\"curve\" d=\"" + path + "\"/>";
  }
  svg += line("mark", x(0), kTopPx - 4, x(0), bottom);
  svg += label(called, kLeftPx, kTopPx - 4, "start", "strong");
  if (curve.at_moment) {
    const QString value = unit.isEmpty() ? number(*curve.at_moment)
                                         : QStringLiteral("%1 %2").arg(number(*curve.at_moment), unit);
    svg += label(value, x(0) + 5, kTopPx - 4, "start", "strong");
  }
  return svg + "</svg>";
}

}  // namespace mapwright::incident
