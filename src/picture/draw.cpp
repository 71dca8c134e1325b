#include "picture/draw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mapwright::picture {

namespace {

// The cursor may be far outside the map; integers must not overflow there.
constexpr double kFarthest = 1e8;
// A cell exactly on the edge of the brush is inside, in spite of rounding.
constexpr double kSlack = 1e-9;

Eigen::Vector2d bounded(const Eigen::Vector2d& at) {
  const auto one = [](double value) {
    return std::isfinite(value) ? std::clamp(value, -kFarthest, kFarthest) : kFarthest;
  };
  return {one(at.x()), one(at.y())};
}

struct Span {
  double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();
  void add(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

void addCircle(Span& span, const Eigen::Vector2d& centre, double radius, double y) {
  const double rest = radius * radius - (y - centre.y()) * (y - centre.y());
  if (rest < -kSlack) return;
  const double half = std::sqrt(std::max(rest, 0.0));
  span.add(centre.x() - half);
  span.add(centre.x() + half);
}

void addEdge(Span& span, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double y) {
  if (y < std::min(a.y(), b.y()) || y > std::max(a.y(), b.y())) return;
  if (a.y() == b.y()) {
    span.add(a.x());
    span.add(b.x());
  } else {
    span.add(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
}

void paintSpan(Canvas& canvas, int row, double from, double to, const Ink& ink) {
  if (!(from <= to)) return;
  canvas.paintRow(row, int(std::ceil(from - 0.5 - kSlack)), int(std::floor(to - 0.5 + kSlack)) + 1, ink);
}

}  // namespace

Eigen::Vector2d brushCentre(const Eigen::Vector2d& at, int across) {
  const Eigen::Vector2d near = bounded(at);
  if (across % 2 != 0) return {std::floor(near.x()) + 0.5, std::floor(near.y()) + 0.5};
  return {std::round(near.x()), std::round(near.y())};
}

void drawLine(Canvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Brush& brush) {
  const int across = std::clamp(brush.across, 1, kWidestBrush);
  const Eigen::Vector2d a = brushCentre(from, across), b = brushCentre(to, across);
  const double radius = across / 2.0;
  const Eigen::Vector2d way = b - a;
  const double length = way.norm();
  const Eigen::Vector2d side =
      length > 0 ? Eigen::Vector2d(-way.y(), way.x()) * (radius / length) : Eigen::Vector2d(0, 0);
  const int top = std::max(int(std::floor(std::min(a.y(), b.y()) - radius)), 0);
  const int bottom = std::min(int(std::ceil(std::max(a.y(), b.y()) + radius)) + 1, canvas.all().bottom);
  for (int row = top; row < bottom; ++row) {
    const double y = row + 0.5;
    Span span;
    addCircle(span, a, radius, y);
    if (length > 0) {
      addCircle(span, b, radius, y);
      addEdge(span, a + side, b + side, y);
      addEdge(span, a - side, b - side, y);
      addEdge(span, a - side, a + side, y);
      addEdge(span, b - side, b + side, y);
    }
    paintSpan(canvas, row, span.from, span.to, brush.ink);
  }
}

CellRect rectangleOf(const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite) {
  const Eigen::Vector2d a = bounded(corner), b = bounded(opposite);
  return {int(std::floor(std::min(a.x(), b.x()))), int(std::floor(std::min(a.y(), b.y()))),
          int(std::floor(std::max(a.x(), b.x()))) + 1, int(std::floor(std::max(a.y(), b.y()))) + 1};
}

void drawRectangle(Canvas& canvas, const CellRect& rect, const Ink& ink) {
  const CellRect inside = rect.intersected(canvas.all());
  for (int row = inside.top; row < inside.bottom; ++row) canvas.paintRow(row, inside.left, inside.right, ink);
}

void drawPolygon(Canvas& canvas, std::span<const Eigen::Vector2d> corners, const Ink& ink) {
  if (corners.size() < 3) return;
  std::vector<Eigen::Vector2d> points;
  points.reserve(corners.size());
  double least = kFarthest, most = -kFarthest;
  for (const Eigen::Vector2d& corner : corners) {
    points.push_back(bounded(corner));
    least = std::min(least, points.back().y());
    most = std::max(most, points.back().y());
  }
  const int top = std::max(int(std::floor(least)), 0);
  const int bottom = std::min(int(std::ceil(most)) + 1, canvas.all().bottom);
  std::vector<double> crossings;
  for (int row = top; row < bottom; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      paintSpan(canvas, row, crossings[i], crossings[i + 1], ink);
    }
  }
}

CellRect Stroke::to(const Eigen::Vector2d& at) {
  Canvas canvas(grid_);
  drawLine(canvas, last_.value_or(at), at, brush_);
  last_ = at;
  const Patch step = canvas.take();
  if (step.empty()) return {};
  grid_.apply(step);
  patch_.append(step);
  return step.cells;
}

}  // namespace mapwright::picture
