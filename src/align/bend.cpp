#include "align/bend.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace mapwright::align {
namespace {

using geometry::Pose2;

constexpr int kTerms = 10;  // of each coordinate: all products of x and y up to the third degree
using Terms = Eigen::Matrix<double, kTerms, 1>;
using Matrix = Eigen::Matrix<double, 2 * kTerms, 2 * kTerms>;
using Vector = Eigen::Matrix<double, 2 * kTerms, 1>;

/// The displacement at a place as a polynomial of it.
class Field {
 public:
  Field(const Eigen::Vector2d& middle, double radius) : middle_(middle), radius_(radius) {}

  Terms termsAt(const Eigen::Vector2d& at) const {
    const Eigen::Vector2d p = (at - middle_) / radius_;
    const double x = p.x(), y = p.y();
    Terms terms;
    terms << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
    return terms;
  }
  Eigen::Vector2d at(const Eigen::Vector2d& place) const {
    const Terms terms = termsAt(place);
    return {terms.dot(factors.head<kTerms>()), terms.dot(factors.tail<kTerms>())};
  }
  double turnAt(const Eigen::Vector2d& place) const {
    constexpr double kStep_m = 0.5;
    const Eigen::Vector2d x(kStep_m, 0), y(0, kStep_m);
    return ((at(place + x) - at(place - x)).y() - (at(place + y) - at(place - y)).x()) / (4 * kStep_m);
  }

  Vector factors = Vector::Zero();

 private:
  Eigen::Vector2d middle_;
  double radius_;
};

/// Where walls of the old map lie beside walls of the new one.
std::vector<Eigen::Vector2d> comparedOf(const Sheets& sheets, const Points& points, const Pose2& pose) {
  constexpr double kBeside_m = 0.3;
  std::vector<Eigen::Vector2d> out;
  const Mover move(pose);
  for (const Eigen::Vector2d& wall : points.of_old) {
    const auto distance = sheets.of_new.distanceAt(move(wall));
    if (distance && distance->metres < kBeside_m) out.push_back(move(wall));
  }
  return out;
}

/// One step of the fit of the field; false where nothing is left to do.
bool improve(Field& field, const Sheets& sheets, const Points& points, const Pose2& pose, double cutoff_m) {
  constexpr double kRigid = 1e-4, kStiff = 3e-3;  // where no wall tells, the map stays as it is
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
  double total = 0;
  const auto add = [&](double metres, const Eigen::Vector2d& slope, const Terms& terms) {
    const double ratio = metres / cutoff_m;
    if (ratio >= 1) return;
    const double weight = (1 - ratio * ratio) * (1 - ratio * ratio);
    Vector row;
    row << slope.x() * terms, slope.y() * terms;
    normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right -= weight * metres * row;
    total += weight;
  };
  const Mover move(pose), move_back(pose.inverse());
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  for (const Eigen::Vector2d& p : points.of_old) {
    const Eigen::Vector2d at = move(p);
    if (const auto distance = sheets.of_new.distanceAt(at + field.at(at)))
      add(distance->metres, distance->slope, field.termsAt(at));
  }
  for (const Eigen::Vector2d& q : points.of_new) {
    if (const auto distance = sheets.of_old.distanceAt(move_back(q - field.at(q))))
      add(distance->metres, -(turn * distance->slope), field.termsAt(q));
  }
  Vector held = Vector::Constant(kStiff * total);
  held[0] = held[kTerms] = kRigid * total;
  normal.diagonal() += held + Vector::Constant(1e-9);
  right -= held.cwiseProduct(field.factors);
  const Vector step = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  field.factors += step;
  return step.norm() > 1e-4;
}

}  // namespace

Bend bendOf(const Sheets& sheets, const Points& all, const Pose2& pose) {
  constexpr std::size_t kFewest = 100, kEnds = 60;
  const Points points = facedAlike(sheets, all.of_old, all.of_new, pose);
  const std::vector<Eigen::Vector2d> compared = comparedOf(sheets, points, pose);
  if (compared.size() < kFewest) return {};
  Eigen::Vector2d middle(0, 0);
  for (const Eigen::Vector2d& at : compared) middle += at / double(compared.size());
  double radius = 1;
  for (const Eigen::Vector2d& at : compared) radius = std::max(radius, (at - middle).norm());
  Field field(middle, radius);
  for (const double cutoff_m : {0.3, 0.2, 0.15}) {
    for (int round = 0; round < 5 && improve(field, sheets, points, pose, cutoff_m); ++round) {
    }
  }
  Bend out;
  const auto exact = [&](const Eigen::Vector2d& at) {
    const auto distance = sheets.of_new.distanceAt(at);
    return double(distance && distance->metres < Bend::kExact_m) / double(compared.size());
  };
  for (const Eigen::Vector2d& at : compared) out.gain += exact(at + field.at(at)) - exact(at);
  std::vector<double> off;
  const std::size_t every = compared.size() / kEnds + 1;
  for (std::size_t one = 0; one < compared.size(); one += every) {
    const double turn = field.turnAt(compared[one]);
    for (std::size_t other = 0; other < compared.size(); other += every) {
      const Eigen::Vector2d arm = compared[other] - compared[one];
      off.push_back(
          (field.at(compared[other]) - field.at(compared[one]) - turn * Eigen::Vector2d(-arm.y(), arm.x()))
              .norm());
    }
  }
  std::sort(off.begin(), off.end());
  out.off_m = off[off.size() * 95 / 100];
  return out;
}

}  // namespace mapwright::align
