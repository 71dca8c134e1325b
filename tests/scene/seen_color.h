// Colours as people see them, with and without colour blindness, and how far apart they look.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QColor>

namespace mapwright::test {

enum class Eyes { Usual, Protan, Deutan, Tritan };
inline constexpr std::array kAllEyes{Eyes::Usual, Eyes::Protan, Eyes::Deutan, Eyes::Tritan};

struct Lab {
  double l = 0, a = 0, b = 0;
};

using LinearRgb = std::array<double, 3>;

/// What dichromats see: Machado, Oliveira and Fernandes 2009, severity 1, in linear RGB.
inline LinearRgb seenBy(Eyes eyes, const LinearRgb& rgb) {
  using Matrix = std::array<std::array<double, 3>, 3>;
  static constexpr Matrix kProtan{
      {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
  static constexpr Matrix kDeutan{
      {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
  static constexpr Matrix kTritan{
      {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
  if (eyes == Eyes::Usual) return rgb;
  const Matrix& matrix = eyes == Eyes::Protan ? kProtan : eyes == Eyes::Deutan ? kDeutan : kTritan;
  LinearRgb seen{};
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    for (std::size_t column = 0; column < 3; ++column) sum += matrix[row][column] * rgb[column];
    seen[row] = std::clamp(sum, 0.0, 1.0);
  }
  return seen;
}

/// CIE 1976 L*a*b* for D65, of an opaque sRGB colour.
inline Lab labOf(const QColor& color, Eyes eyes) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  const auto [r, g, b] = seenBy(eyes, {linear(color.redF()), linear(color.greenF()), linear(color.blueF())});
  const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = root((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = root(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = root((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIEDE2000. About 2 is just seen when both lie side by side.
inline double distance(const Lab& one, const Lab& other) {
  constexpr double kPi = std::numbers::pi, kDegree = kPi / 180, k25To7 = 6103515625.0;
  const double mean_chroma = (std::hypot(one.a, one.b) + std::hypot(other.a, other.b)) / 2;
  const double c7 = std::pow(mean_chroma, 7);
  const double stretch = 1 + 0.5 * (1 - std::sqrt(c7 / (c7 + k25To7)));
  const double a1 = one.a * stretch, a2 = other.a * stretch;
  const double c1 = std::hypot(a1, one.b), c2 = std::hypot(a2, other.b);
  const auto hue = [](double a, double b) {
    if (a == 0 && b == 0) return 0.0;
    const double h = std::atan2(b, a);
    return h < 0 ? h + 2 * kPi : h;
  };
  const double h1 = hue(a1, one.b), h2 = hue(a2, other.b);
  double turn = c1 * c2 == 0 ? 0 : h2 - h1;
  if (turn > kPi) turn -= 2 * kPi;
  if (turn < -kPi) turn += 2 * kPi;
  const double dl = other.l - one.l, dc = c2 - c1, dh = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2);
  const double l = (one.l + other.l) / 2, c = (c1 + c2) / 2;
  double h = h1 + h2;
  if (c1 * c2 != 0) {
    if (std::abs(h1 - h2) > kPi) h += h < 2 * kPi ? 2 * kPi : -2 * kPi;
    h /= 2;
  }
  const double t = 1 - 0.17 * std::cos(h - 30 * kDegree) + 0.24 * std::cos(2 * h) +
                   0.32 * std::cos(3 * h + 6 * kDegree) - 0.20 * std::cos(4 * h - 63 * kDegree);
  const double bend = 30 * kDegree * std::exp(-std::pow((h / kDegree - 275) / 25, 2));
  const double c_7 = std::pow(c, 7);
  const double rotation = -std::sin(2 * bend) * 2 * std::sqrt(c_7 / (c_7 + k25To7));
  const double sl = 1 + 0.015 * std::pow(l - 50, 2) / std::sqrt(20 + std::pow(l - 50, 2));
  const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
  return std::sqrt(std::pow(dl / sl, 2) + std::pow(dc / sc, 2) + std::pow(dh / sh, 2) +
                   rotation * (dc / sc) * (dh / sh));
}

/// The least of what any eyes see.
inline double distance(const QColor& one, const QColor& other) {
  double least = 1000;
  for (const Eyes eyes : kAllEyes) least = std::min(least, distance(labOf(one, eyes), labOf(other, eyes)));
  return least;
}

}  // namespace mapwright::test
