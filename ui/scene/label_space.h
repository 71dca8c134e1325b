// Where the names on the map go: none covers another.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include <QRectF>

namespace mapwright::scene {

/// The labels of one frame, in viewport pixels. GUI thread.
class LabelSpace {
 public:
  /// A new frame begins.
  void clear() { bands_.clear(); }
  /// Takes the first of `spots` that touches no label of this frame; nullopt = there is room at none.
  std::optional<QRectF> take(std::span<const QRectF> spots);

 private:
  bool free(const QRectF& spot) const;

  std::map<int, std::vector<QRectF>> bands_;  // by the horizontal stripes that a label touches
};

}  // namespace mapwright::scene
