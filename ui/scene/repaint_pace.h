// How often to repaint the map while its content is still arriving.
#pragma once

namespace mapwright::ui::scene {

/// Painting and decoding compete for the processors: repainting for every new submap would delay the complete
/// picture. Does not affect manual moves of the view. A value; times in milliseconds of any monotonic clock.
class RepaintPace {
 public:
  static constexpr double kRest = 4;  // pause, as a multiple of the painting time, left for decoding
  static constexpr double kLongestMs = 150;

  /// The whole map was painted.
  void painted(double began_ms, double ended_ms) {
    cost_ms_ = ended_ms - began_ms;
    ended_ms_ = ended_ms;
  }
  /// How long new content should wait; 0 = paint now.
  double waitMs(double now_ms) const {
    const double rest_ms = kRest * cost_ms_ < kLongestMs ? kRest * cost_ms_ : kLongestMs;
    const double due_ms = ended_ms_ + rest_ms - now_ms;
    return due_ms > 0 ? due_ms : 0;
  }

 private:
  double cost_ms_ = 0, ended_ms_ = 0;
};

}  // namespace mapwright::ui::scene
