// How often the map is painted again while its content is still coming.
#pragma once

namespace mapwright::scene {

/// Painting and decoding share the processors: a picture that is painted again for every submap that comes is
/// complete later. A view that is moved by hand does not ask here. A value; times in milliseconds of any
/// clock that does not run backwards.
class RepaintPace {
 public:
  static constexpr double kRest = 4;  // times as long as painting took; the rest is for those who decode
  static constexpr double kLongestMs = 150;

  /// The whole map was painted.
  void painted(double began_ms, double ended_ms) {
    cost_ms_ = ended_ms - began_ms;
    ended_ms_ = ended_ms;
  }
  /// How long new content is to wait; 0 = it may be painted now.
  double waitMs(double now_ms) const {
    const double rest_ms = kRest * cost_ms_ < kLongestMs ? kRest * cost_ms_ : kLongestMs;
    const double due_ms = ended_ms_ + rest_ms - now_ms;
    return due_ms > 0 ? due_ms : 0;
  }

 private:
  double cost_ms_ = 0, ended_ms_ = 0;
};

}  // namespace mapwright::scene
