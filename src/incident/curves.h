// The curves of the minute around a moment, out of the ranges of a bag. Pure.
#pragma once

#include <map>
#include <vector>

#include <QByteArray>
#include <QString>

#include "replay/chunks.h"
#include "replay/digest.h"
#include "series/fields.h"
#include "series/series.h"

namespace mapwright::incident {

inline constexpr double kBesideS = 30;  // how much is shown before and after the moment

struct Curve {
  series::Quantity quantity = series::Quantity::Speed;
  std::vector<series::Stroke> strokes;  // seconds since the epoch
  std::optional<double> at_moment;      // its value then
  bool empty() const { return strokes.empty(); }
};

/// Takes the ranges in any order.
class Minute {
 public:
  explicit Minute(double at_s) : at_s_(at_s) {}
  double at() const { return at_s_; }
  /// What is sent rarely is looked for this long before.
  double from() const { return at_s_ - kLookBackS; }
  double until() const { return at_s_ + kBesideS; }
  void take(const replay::Chunk& chunk);
  void addPoses(const std::map<replay::Tick, replay::Digest>& digests);
  /// Those that have something to show.
  std::vector<Curve> curves() const;

 private:
  static constexpr double kLookBackS = 120;
  double at_s_;
  series::Series x_, y_;
  std::map<series::Quantity, series::Series> series_;
};

QString nameOf(series::Quantity quantity);
/// "m/s"; empty: none.
QString unitOf(series::Quantity quantity);
/// As an SVG element with axes and a mark at the moment; seconds from the moment on.
QByteArray svgOf(const Curve& curve, double at_s);

}  // namespace mapwright::incident
