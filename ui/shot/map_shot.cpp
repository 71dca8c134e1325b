#include "ui/shot/map_shot.h"

#include <algorithm>
#include <utility>

namespace mapwright::ui::shot {
namespace {

// If the robot is gone, waiting ends when this much time is left, since drawing takes some, too.
constexpr double kDrawShare = 0.2, kDrawAtMostS = 5;

}  // namespace

void MapShot::enter(Stage stage, double now_s) {
  if (over()) return;
  stage_ = stage;
  entered_.emplace_back(stage, now_s);
}

std::optional<double> MapShot::enteredAt(Stage stage) const {
  for (const auto& [entered, at_s] : entered_) {
    if (entered == stage) return at_s;
  }
  return std::nullopt;
}

void MapShot::await(Awaited what, std::function<bool()> in) { conditions_.push_back({what, std::move(in)}); }

bool MapShot::awaits(Awaited what) const {
  return std::any_of(conditions_.begin(), conditions_.end(),
                     [what](const Condition& condition) { return condition.what == what; });
}

std::optional<Awaited> MapShot::missing() const {
  const auto missing = std::find_if(conditions_.begin(), conditions_.end(),
                                    [](const Condition& condition) { return !condition.in(); });
  return missing == conditions_.end() ? std::nullopt : std::optional(missing->what);
}

EndOfWaiting MapShot::end(double now_s, bool online, const std::function<bool()>& drawable) const {
  if (stage_ != Stage::Settling) return EndOfWaiting::None;
  if (!limits_.collect_s && !missing()) return EndOfWaiting::AllHere;
  if (limits_.collect_s && now_s >= collectedAt()) return EndOfWaiting::Collected;
  if (timeUp(now_s)) return EndOfWaiting::TimeUp;
  const bool lost = !limits_.collect_s && !online && limits_.timeout_s &&
                    *limits_.timeout_s - now_s < std::min(kDrawShare * *limits_.timeout_s, kDrawAtMostS);
  return lost && drawable() ? EndOfWaiting::LinkLost : EndOfWaiting::None;
}

std::optional<double> MapShot::untilLimit(double now_s) const {
  std::optional<double> next;
  const auto consider = [&](double at_s) {
    if (at_s > now_s && (!next || at_s - now_s < *next)) next = at_s - now_s;
  };
  if (limits_.timeout_s) consider(*limits_.timeout_s);
  if (limits_.timeout_s) consider(*limits_.timeout_s + limits_.grace_s);
  if (limits_.collect_s && stage_ == Stage::Settling) consider(collectedAt());
  return next;
}

}  // namespace mapwright::ui::shot
