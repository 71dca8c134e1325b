#include <algorithm>
#include <cmath>
#include <utility>

#include "series/series.h"

namespace mapwright::series {
namespace {

constexpr std::size_t kFew = 4;  // samples in a column that are drawn as they are

/// Joins points to lines that break where they must.
class Pen {
 public:
  explicit Pen(const std::map<double, double>& covered) : covered_(covered) {}

  void add(double at_s, double value) {
    if (broken_ || at_s > covered_until_s_) {
      strokes_.emplace_back();
      broken_ = false;
    }
    if (at_s > covered_until_s_) {
      const auto after = covered_.upper_bound(at_s);
      covered_until_s_ = after == covered_.begin() ? at_s : std::max(std::prev(after)->second, at_s);
    }
    strokes_.back().push_back({at_s, value});
  }
  void lift() { broken_ = true; }
  std::vector<Stroke> taken() { return std::move(strokes_); }

 private:
  const std::map<double, double>& covered_;
  std::vector<Stroke> strokes_;
  double covered_until_s_ = -std::numeric_limits<double>::infinity();
  bool broken_ = true;
};

void addSample(Pen& pen, const Sample& sample) {
  if (std::isfinite(sample.value)) {
    pen.add(sample.at_s, sample.value);
  } else {
    pen.lift();
  }
}

void addColumn(Pen& pen, const Summary& sum) {
  if (sum.numbers == 0 || sum.broken_before) pen.lift();
  if (sum.numbers == 0) return;
  pen.add(sum.first.at_s, sum.first.value);
  if (sum.numbers > 1) {
    const double middle_s = sum.first.at_s + (sum.last.at_s - sum.first.at_s) / 2;
    if (sum.least < std::min(sum.first.value, sum.last.value)) pen.add(middle_s, sum.least);
    if (sum.greatest > std::max(sum.first.value, sum.last.value)) pen.add(middle_s, sum.greatest);
    pen.add(sum.last.at_s, sum.last.value);
  }
  if (sum.broken_after) pen.lift();
}

}  // namespace

std::vector<Stroke> Series::strokes(double from_s, double until_s, int columns) const {
  if (!(from_s < until_s) || columns < 1) return {};
  Pen pen(covered_);
  Place place = blocks_.lowerBound(from_s);
  const Place end = blocks_.upperBound(until_s);
  if (blocks_.begin() < place) addSample(pen, blocks_.at(blocks_.previous(place)));
  const double width_s = (until_s - from_s) / columns;
  while (place < end) {
    // Columns without samples cost nothing.
    const double column = std::floor((blocks_.at(place).at_s - from_s) / width_s);
    Place next =
        column + 1 >= columns ? end : std::min(blocks_.lowerBound(from_s + (column + 1) * width_s), end);
    if (!(place < next)) next = blocks_.next(place);  // what rounding left behind
    const Summary sum = blocks_.sum(place, next);
    if (sum.count > kFew) {
      addColumn(pen, sum);
      place = next;
    } else {
      for (; place < next; place = blocks_.next(place)) addSample(pen, blocks_.at(place));
    }
  }
  if (end < blocks_.end()) addSample(pen, blocks_.at(end));
  return pen.taken();
}

}  // namespace mapwright::series
