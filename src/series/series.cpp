#include "series/series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapwright::series {
namespace {

bool isEarlier(const Sample& a, const Sample& b) { return a.at_s < b.at_s; }

/// The least and the greatest of a run, and that something in it is no number, in the order of time: at most
/// three.
void addThinned(std::vector<Sample>& kept, std::span<const Sample> run) {
  const Sample *least = nullptr, *greatest = nullptr, *broken = nullptr;
  for (const Sample& each : run) {
    if (!std::isfinite(each.value)) {
      broken = &each;
      continue;
    }
    if (!least || each.value < least->value) least = &each;
    if (!greatest || each.value > greatest->value) greatest = &each;
  }
  std::vector<const Sample*> chosen;
  for (const Sample* each : {least, greatest, broken}) {
    if (each && std::find(chosen.begin(), chosen.end(), each) == chosen.end()) chosen.push_back(each);
  }
  std::sort(chosen.begin(), chosen.end());  // by their place in the run
  for (const Sample* each : chosen) kept.push_back(*each);
}

}  // namespace

void Series::insert(double from_s, double until_s, std::span<const Sample> samples) {
  if (!(from_s < until_s) || !std::isfinite(from_s) || !std::isfinite(until_s)) return;
  std::vector<Sample> own;
  own.reserve(samples.size());
  for (const Sample& each : samples) {
    if (each.at_s >= from_s && each.at_s < until_s) own.push_back(each);
  }
  if (!std::is_sorted(own.begin(), own.end(), isEarlier)) std::stable_sort(own.begin(), own.end(), isEarlier);
  blocks_.replace(blocks_.lowerBound(from_s), blocks_.lowerBound(until_s), own);
  cover(from_s, until_s);
  thin();
}

void Series::append(double at_s, double value) {
  if (!std::isfinite(at_s)) return;
  if (empty() || at_s >= lastAt()) {
    blocks_.append(at_s, value);
  } else {
    const Sample sample{at_s, value};
    const Place place = blocks_.upperBound(at_s);
    blocks_.replace(place, place, {&sample, 1});
  }
  thin();
}

void Series::cover(double from_s, double until_s) {
  if (!(from_s < until_s)) return;
  auto it = covered_.upper_bound(from_s);
  if (it != covered_.begin() && std::prev(it)->second >= from_s) {
    --it;
    from_s = it->first;
  }
  while (it != covered_.end() && it->first <= until_s) {
    until_s = std::max(until_s, it->second);
    it = covered_.erase(it);
  }
  covered_.emplace_hint(it, from_s, until_s);
}

void Series::forgetBefore(double at_s) {
  blocks_.replace(blocks_.begin(), blocks_.lowerBound(at_s), {});
  while (!covered_.empty() && covered_.begin()->first < at_s) {
    const double until_s = covered_.begin()->second;
    covered_.erase(covered_.begin());
    if (until_s > at_s) covered_.emplace(at_s, until_s);
  }
}

void Series::clear() {
  blocks_.clear();
  covered_.clear();
  thinned_ = false;
}

std::size_t Series::bytes() const { return blocks_.bytes() + covered_.size() * 48; }

bool Series::isCovered(double from_s, double until_s) const {
  const auto after = covered_.upper_bound(from_s);
  return after != covered_.begin() && std::prev(after)->second >= until_s;
}

std::optional<Sample> Series::at(double at_s) const {
  const Place after = blocks_.upperBound(at_s);
  if (after == blocks_.begin()) return std::nullopt;
  const Sample sample = blocks_.at(blocks_.previous(after));
  if (!std::isfinite(sample.value) || !isCovered(sample.at_s, at_s)) return std::nullopt;
  return sample;
}

std::vector<Sample> Series::samples(double from_s, double until_s) const {
  std::vector<Sample> found;
  const Place end = blocks_.lowerBound(until_s);
  for (Place place = blocks_.lowerBound(from_s); place < end; place = blocks_.next(place))
    found.push_back(blocks_.at(place));
  return found;
}

std::optional<std::pair<double, double>> Series::extent(double from_s, double until_s) const {
  const Summary sum = blocks_.sum(blocks_.lowerBound(from_s), blocks_.upperBound(until_s));
  if (sum.numbers == 0) return std::nullopt;
  return std::pair{sum.least, sum.greatest};
}

void Series::thin() {
  constexpr std::size_t kRun = 8;
  if (size() <= options_.most_samples) return;
  thinned_ = true;
  std::vector<Sample> kept, run;
  kept.reserve(size() / 2);
  for (Place place = blocks_.begin(); place < blocks_.end(); place = blocks_.next(place)) {
    run.push_back(blocks_.at(place));
    if (run.size() < kRun) continue;
    addThinned(kept, run);
    run.clear();
  }
  kept.insert(kept.end(), run.begin(), run.end());
  blocks_.replace(blocks_.begin(), blocks_.end(), kept);
}

}  // namespace mapwright::series
