#include "regions/answer_limit.h"

#include <algorithm>
#include <utility>

namespace mapwright::regions {
namespace {

constexpr int kMargin = 2;  // cells that the margin of a question adds to an edge

std::int64_t cellsOf(int edge) { return std::int64_t(edge + kMargin) * (edge + kMargin); }

}  // namespace

AnswerLimit::AnswerLimit(int most_cells) : most_(std::max(1, most_cells)), edge_(most_) {}

void AnswerLimit::gave(int width, int height) {
  given_ = std::max(given_, std::int64_t(width) * height);
  given_edge_ = std::max(given_edge_, std::min(width, height));
}

bool AnswerLimit::leftOut() {
  if (over_) return false;
  const int before = edge_;
  const auto halved = [&](auto fits) {
    int edge = before;
    while (edge / 2 >= std::min(kLeastCells, most_) && (edge == before || !fits(edge))) edge /= 2;
    return edge;
  };
  // By the count of cells; where so many did not come in this shape, by the square that did.
  if (cellsOf(before) > given_) {
    edge_ = halved([&](int edge) { return cellsOf(edge) <= given_; });
  } else if (before + kMargin > given_edge_) {
    edge_ = halved([&](int edge) { return edge + kMargin <= given_edge_; });
  } else {
    // It gave more than this before: what is missing is not missing because it is too much.
    edge_ = most_;
    over_ = true;
  }
  if (edge_ == before) over_ = true;
  return edge_ != before;
}

QuarterSearch::QuarterSearch(const geometry::WorldRect& whole, int cells, const Eigen::Vector2d& place)
    : first_(whole), place_(place), whole_cells_(cells), cells_(cells) {
  goOn(false);
}

geometry::WorldRect QuarterSearch::beside(int x, int y) const {
  const double wide = first_.width() * x, high = first_.height() * y;
  return {first_.min_x + wide, first_.min_y + high, first_.max_x + wide, first_.max_y + high};
}

geometry::WorldRect QuarterSearch::together() const {
  geometry::WorldRect all = first_;
  all.extend(beside(x_, y_));
  return all;
}

geometry::WorldRect QuarterSearch::asking() const {
  switch (step_) {
    case Step::First:
      break;
    case Step::Across:
      return beside(x_, 0);
    case Step::Along:
      return beside(0, y_);
    case Step::Diagonal:
      return beside(x_, y_);
    case Step::Together:
      return together();
  }
  return first_;
}

void QuarterSearch::answered(bool came) {
  if (over_) return;
  goOn(came);
  over_ = over_ || ++questions_ >= kMostQuestions;
}

void QuarterSearch::goOn(bool came) {
  switch (step_) {
    case Step::First: {
      if (came) {
        step_ = Step::Across;
        return;
      }
      // The quarter around the place.
      const Eigen::Vector2d middle = first_.center();
      const bool right = place_.x() > middle.x(), upper = place_.y() > middle.y();
      first_ = {right ? middle.x() : first_.min_x, upper ? middle.y() : first_.min_y,
                right ? first_.max_x : middle.x(), upper ? first_.max_y : middle.y()};
      x_ = right ? -1 : 1;
      y_ = upper ? -1 : 1;
      cells_ /= 2;
      over_ = cells_ < AnswerLimit::kLeastCells;
      return;
    }
    case Step::Across:
      if (came) {
        step_ = Step::Along;
        return;
      }
      x_ = -x_;
      over_ = std::exchange(turned_x_, true);
      return;
    case Step::Along:
      if (came) {
        step_ = Step::Diagonal;
        return;
      }
      y_ = -y_;
      over_ = std::exchange(turned_y_, true);
      return;
    case Step::Diagonal:
      step_ = Step::Together;
      // What they come to together has been asked for, where none of them lies beside it.
      proven_ = came && together_is_whole_ && !turned_x_ && !turned_y_;
      over_ = !came || proven_;
      return;
    case Step::Together:
      proven_ = !came;
      first_ = together();
      cells_ *= 2;
      over_ = proven_ || cells_ >= whole_cells_;
      turned_x_ = turned_y_ = together_is_whole_ = false;
      step_ = Step::Across;
      return;
  }
}

}  // namespace mapwright::regions
