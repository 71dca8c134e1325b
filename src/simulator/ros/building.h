// A building of five storeys, too large for memory: cells and points are functions of their position,
// computed on demand.
#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>

namespace mapwright::simulator::ros {

/// Around the point (0, 0), along the axes of the map. Immutable, safe from any thread.
class Building {
 public:
  static constexpr int kStoreys = 5;
  static constexpr double kStoreyM = 3.5;      // from floor to floor; the first is at z = 0
  static constexpr int kPointsPerColumn = 40;  // per square metre, all storeys together
  static constexpr double kVoxelM = 0.25;

  /// `edge_m`: whole metres, 10..2000; 1000 m gives 40 million points.
  Building(double edge_m, std::uint32_t seed) : edge_m_(edge_m), seed_(seed) {}

  double edge_m() const { return edge_m_; }
  std::int64_t pointCount() const { return std::int64_t(edge_m_) * std::int64_t(edge_m_) * kPointsPerColumn; }
  /// The cell at a position between two heights: -1, 0 or 100.
  std::int8_t cellAt(double x_m, double y_m, double from_z_m = 0.1, double to_z_m = 2) const;

  struct Point {
    Eigen::Vector3d at_m;
    float intensity;    // 0..255
    std::uint32_t rgb;  // of the storey
  };
  /// The points of the square metres that the box touches, in a fixed order.
  void pointsNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m,
                  const std::function<void(const Point&)>& take) const;
  /// How many these are.
  double countNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) const;

 private:
  bool wallAt(double x_m, double y_m, int storey) const;

  double edge_m_;
  std::uint32_t seed_;
};

}  // namespace mapwright::simulator::ros
