// Where the names of all layers stand: next to what they name, and over nothing else. Values in, values out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <QLineF>
#include <QRectF>
#include <QSizeF>

namespace mapwright::ui::scene {

/// Who is placed first.
enum class LabelRank { Chosen, Robot, Waypoint, Door, Region, Landmark, Thing, Id };

/// A label that is to be placed. Viewport pixels.
struct LabelWish {
  enum class Position {
    Beside,  // next to the mark; farther away, with a leader line, where there is no room
    Within,  // in the mark, if it fits
    Over,    // on the middle of the mark, or a line above or below
  };
  std::uint64_t key = 0;  // the same in every frame, and of no other label
  LabelRank rank = LabelRank::Thing;
  Position position = Position::Beside;
  QRectF mark;  // the area of what is named
  QSizeF size;  // of the text
  bool operator==(const LabelWish&) const = default;
};

struct PlacedLabel {
  std::size_t wish = 0;  // its index
  QRectF box;
  std::optional<QLineF> leader;  // from the mark to the box
  bool operator==(const PlacedLabel&) const = default;
};

/// The spot of each label, by its key; kHiddenLabel: there was no room.
using LabelMemory = std::unordered_map<std::uint64_t, int>;
inline constexpr int kHiddenLabel = -1;

struct LabelTask {
  std::vector<LabelWish> wishes;
  std::vector<QRectF> symbols;  // must not be covered
  QRectF view;
  /// Scale and turn of the camera are those of the memory: what rests keeps its position while robots move,
  /// and their names give way.
  bool steady = false;
  /// And nothing else has changed: what has a position keeps it, whatever comes into view.
  bool panned = false;
  bool operator==(const LabelTask&) const = default;
};

struct LabelPlan {
  std::vector<PlacedLabel> labels;
  LabelMemory memory;  // for the next plan
};

/// Labels outside of the view by no more than this are placed as well, so that what comes into view while the
/// map is dragged has its position already.
inline constexpr double kLabelMarginPx = 320;

/// No coordinate is an infinity or no number.
bool isFinite(const QRectF& rect);

/// No label covers another one, or a symbol. Those of higher rank come first; among equals, those that had a
/// position, which they keep if they can; then in the order given. The same task and memory give the same
/// plan.
LabelPlan placeLabels(const LabelTask& task, const LabelMemory& before = {});

}  // namespace mapwright::ui::scene
