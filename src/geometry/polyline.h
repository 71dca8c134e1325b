// Lengths, areas and angles of polylines, world metres. Pure.
#pragma once

#include <span>

#include <Eigen/Core>

namespace mapwright::geometry {

double lengthOf(std::span<const Eigen::Vector2d> line);
/// Of a ring, closed or not: positive counter-clockwise. Where it crosses itself the parts count against each
/// other.
double signedAreaOf(std::span<const Eigen::Vector2d> ring);
/// Between the ways to `before` and to `after`, 0 .. pi; 0 if one of them is no way.
double angleAt(const Eigen::Vector2d& corner, const Eigen::Vector2d& before, const Eigen::Vector2d& after);
double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to);

}  // namespace mapwright::geometry
