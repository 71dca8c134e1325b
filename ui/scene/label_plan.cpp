#include "ui/scene/label_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace mapwright::ui::scene {
namespace {

constexpr double kGapPx = 3;               // between a mark and its label
constexpr double kAirPx = 1;               // around a label
constexpr double kReturnPx = 4;            // more room than that for one that had none: it must not flicker
constexpr double kLeaderStepPx = 5;        // a leader line is tested at points as far apart
constexpr std::size_t kMostLabels = 1200;  // more cannot be read on any screen

/// QRectF::intersects() of areas with positive sizes; a frame asks this a million times.
struct Edges {
  double left, right, top, bottom;
  explicit Edges(const QRectF& rect)
      : left(rect.left()), right(rect.right()), top(rect.top()), bottom(rect.bottom()) {}
  bool intersects(const Edges& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Areas that are taken, by the squares of a coarse grid.
class Taken {
 public:
  explicit Taken(const QRectF& area)
      : origin_(area.topLeft()), columns_(count(area.width())), rows_(count(area.height())) {
    cells_.resize(std::size_t(columns_) * std::size_t(rows_));
  }

  bool free(const QRectF& rect) const {
    const Edges edges(rect);
    return eachCell(rect, [&](std::size_t cell) {
      const auto& here = cells_[cell];
      return std::none_of(here.begin(), here.end(),
                          [&](std::uint32_t index) { return rects_[index].intersects(edges); });
    });
  }
  void add(const QRectF& area) {
    const QRectF rect = area.normalized();
    if (rect.isEmpty()) return;
    const auto index = std::uint32_t(rects_.size());
    rects_.emplace_back(rect);
    eachCell(rect, [&](std::size_t cell) {
      cells_[cell].push_back(index);
      return true;
    });
  }

 private:
  static constexpr double kCellPx = 48, kMostCells = 400;
  static int count(double length) { return int(std::clamp(std::ceil(length / kCellPx), 1.0, kMostCells)); }
  /// The first one of a position that is no number.
  static int clamped(double at, int count) {
    return at > 0 ? int(std::min(std::floor(at / kCellPx), count - 1.0)) : 0;
  }

  /// What lies outside of the area belongs to the squares at its edge.
  /// Until `function` is false; then this is, too.
  template <class Function>
  bool eachCell(const QRectF& rect, const Function& function) const {
    const int left = clamped(rect.left() - origin_.x(), columns_),
              right = clamped(rect.right() - origin_.x(), columns_);
    const int top = clamped(rect.top() - origin_.y(), rows_),
              bottom = clamped(rect.bottom() - origin_.y(), rows_);
    for (int row = top; row <= bottom; ++row) {
      for (int column = left; column <= right; ++column) {
        if (!function(std::size_t(row) * std::size_t(columns_) + std::size_t(column))) return false;
      }
    }
    return true;
  }

  QPointF origin_;
  int columns_, rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<Edges> rects_;
};

/// Where labels go first: to the right, as one reads on; then around. As multiples of the distance aside and
/// over at which a label touches its mark.
constexpr std::array<std::array<double, 2>, 8> kAround{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -0.7}, {1, 0.7}, {-1, -0.7}, {-1, 0.7}}};
constexpr std::array<double, 3> kRingsPx{0, 14, 32};  // farther out; from the second on with a leader line
constexpr int kBesideSpots = int(kAround.size() * kRingsPx.size());
constexpr std::array<double, 3> kLines{0, -1, 1};  // above and below the middle
/// Of what was chosen, within its mark: around the middle, as multiples of the size of the label.
constexpr std::array<std::array<double, 2>, 11> kWithin{{{0, 0},
                                                         {0, -1},
                                                         {0, 1},
                                                         {0, -2.5},
                                                         {0, 2.5},
                                                         {-1.5, 0},
                                                         {1.5, 0},
                                                         {-1.5, -2.5},
                                                         {1.5, 2.5},
                                                         {-3, 0},
                                                         {3, 0}}};

bool isBeside(const LabelWish& wish) {
  const bool fits = wish.size.width() <= wish.mark.width() && wish.size.height() <= wish.mark.height();
  // What was chosen is named, however small it is.
  return wish.position == LabelWish::Position::Beside ||
         (wish.position == LabelWish::Position::Within && !fits && wish.rank == LabelRank::Chosen);
}

bool isWithin(const LabelWish& wish) {
  return wish.position == LabelWish::Position::Within && wish.rank == LabelRank::Chosen && !isBeside(wish);
}

int spotsOf(const LabelWish& wish) {
  return isBeside(wish) ? kBesideSpots : int(isWithin(wish) ? kWithin.size() : kLines.size());
}

QRectF boxAt(const LabelWish& wish, int spot) {
  QRectF box(QPointF(0, 0), wish.size);
  const QPointF middle = wish.mark.center();
  if (isWithin(wish)) {
    const auto& [x, y] = kWithin[std::size_t(spot)];
    box.moveCenter(middle + QPointF(x * (wish.size.width() + kAirPx), y * (wish.size.height() + kAirPx)));
    return box;
  }
  if (!isBeside(wish)) {
    box.moveCenter(middle + QPointF(0, kLines[std::size_t(spot)] * (wish.size.height() + kAirPx)));
    return box;
  }
  const auto& [x, y] = kAround[std::size_t(spot) % kAround.size()];
  const double ring = kRingsPx[std::size_t(spot) / kAround.size()];
  const double aside = (wish.mark.width() + wish.size.width()) / 2 + kGapPx,
               over = (wish.mark.height() + wish.size.height()) / 2 + kGapPx;
  box.moveCenter(middle + QPointF(x * (aside + ring), y * (over + ring)));
  return box;
}

std::optional<QLineF> leaderOf(const LabelWish& wish, int spot, const QRectF& box) {
  if (!isBeside(wish) || spot < int(kAround.size())) return std::nullopt;
  const QPointF from = wish.mark.center();
  const QPointF to(std::clamp(from.x(), box.left(), box.right()),
                   std::clamp(from.y(), box.top(), box.bottom()));
  QLineF line(from, to);
  // From the edge of the mark.
  const double reach = std::min(wish.mark.width(), wish.mark.height()) / 2 + 1;
  if (line.length() <= reach + 2) return std::nullopt;
  line.setP1(line.pointAt(reach / line.length()));
  return line;
}

/// The area of a leader line as small squares.
std::vector<QRectF> beadsOf(const QLineF& line) {
  std::vector<QRectF> beads;
  for (double at = kLeaderStepPx; at < line.length(); at += kLeaderStepPx)
    beads.emplace_back(line.pointAt(at / line.length()) - QPointF(1, 1), QSizeF(2, 2));
  return beads;
}

class Placing {
 public:
  Placing(const LabelTask& task, const LabelMemory& before)
      : task_(task),
        before_(before),
        area_(task.view.adjusted(-kLabelMarginPx, -kLabelMarginPx, kLabelMarginPx, kLabelMarginPx)),
        symbols_(area_),
        labels_(area_) {}

  LabelPlan made() {
    LabelPlan plan;
    if (task_.wishes.empty()) return plan;
    for (const QRectF& symbol : task_.symbols) {
      if (isFinite(symbol) && area_.intersects(symbol)) symbols_.add(symbol);
    }
    const std::vector<std::size_t> indices = order();
    std::size_t tried = 0;
    for (const std::size_t index : indices) {
      if (tried++ == kMostLabels) break;
      const LabelWish& wish = task_.wishes[index];
      const int spot = spotFor(wish);
      plan.memory[wish.key] = spot;
      if (spot == kHiddenLabel) continue;
      const QRectF box = boxAt(wish, spot);
      labels_.add(box.adjusted(-kAirPx, -kAirPx, kAirPx, kAirPx));
      const auto leader = leaderOf(wish, spot, box);
      if (leader) {
        for (const QRectF& bead : beadsOf(*leader)) labels_.add(bead);
      }
      plan.labels.push_back({index, box, leader});
    }
    return plan;
  }

 private:
  enum class Turn { First, Displaced, Moving, Last };

  std::optional<int> keptBy(const LabelWish& wish) const {
    const auto kept = before_.find(wish.key);
    if (kept == before_.end() || kept->second >= spotsOf(wish)) return std::nullopt;
    return kept->second;
  }

  std::vector<std::size_t> order() const {
    std::vector<std::tuple<bool, bool, Turn, LabelRank, bool, std::size_t>> sorted;
    for (std::size_t i = 0; i < task_.wishes.size(); ++i) {
      const LabelWish& wish = task_.wishes[i];
      if (!isFinite(wish.mark) || wish.size.isEmpty()) continue;
      if (!area_.intersects(wish.mark.adjusted(-1, -1, 1, 1))) continue;
      const auto kept = keptBy(wish);
      const bool fresh = !kept || *kept == kHiddenLabel;
      // What comes new has its rank; what had no room gets none of what robots leave behind them. One that a
      // robot drives over pushes no other one away.
      const Turn turn = !task_.steady                                ? Turn::First
                        : wish.rank == LabelRank::Robot              ? Turn::Moving
                        : kept && fresh                              ? Turn::Last
                        : kept && !symbols_.free(boxAt(wish, *kept)) ? Turn::Displaced
                                                                     : Turn::First;
      sorted.emplace_back(wish.rank != LabelRank::Chosen, task_.panned && fresh, turn, wish.rank, fresh, i);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::size_t> indices;
    for (const auto& one : sorted) indices.push_back(std::get<5>(one));
    return indices;
  }

  bool fits(const LabelWish& wish, int spot, double room) const {
    const QRectF box = boxAt(wish, spot);
    if (wish.position == LabelWish::Position::Within && !isBeside(wish) &&
        (box.top() < wish.mark.top() || box.bottom() > wish.mark.bottom() || box.left() < wish.mark.left() ||
         box.right() > wish.mark.right()))
      return false;
    const QRectF roomy = box.adjusted(-room, -room, room, room);
    if (!symbols_.free(roomy) || !labels_.free(roomy)) return false;
    const auto leader = leaderOf(wish, spot, box);
    if (!leader) return true;
    const std::vector<QRectF> beads = beadsOf(*leader);
    return std::all_of(beads.begin(), beads.end(), [this](const QRectF& bead) { return labels_.free(bead); });
  }

  int spotFor(const LabelWish& wish) const {
    const auto kept = keptBy(wish);
    // Only what was dragged over the edge may be cut there.
    const bool cut = !task_.steady && !task_.panned && kept && *kept != kHiddenLabel &&
                     task_.view.contains(wish.mark.center()) && !task_.view.contains(boxAt(wish, *kept));
    if (kept && *kept != kHiddenLabel && !cut && fits(wish, *kept, 0)) return *kept;
    const double room = kept && *kept == kHiddenLabel ? kReturnPx : 0;
    const int spots = spotsOf(wish);
    // What is in view is named in view, or not at all: half a name tells nothing.
    const bool seen = task_.view.contains(wish.mark.center());
    for (int spot = 0; spot < spots; ++spot) {
      if ((!seen || task_.view.contains(boxAt(wish, spot))) && fits(wish, spot, room)) return spot;
    }
    return kHiddenLabel;
  }

  const LabelTask& task_;
  const LabelMemory& before_;
  QRectF area_;
  Taken symbols_, labels_;  // labels with their leader lines, which may cross a symbol
};

}  // namespace

bool isFinite(const QRectF& rect) {
  return std::isfinite(rect.x()) && std::isfinite(rect.y()) && std::isfinite(rect.width()) &&
         std::isfinite(rect.height());
}

LabelPlan placeLabels(const LabelTask& task, const LabelMemory& before) {
  return Placing(task, before).made();
}

}  // namespace mapwright::ui::scene
