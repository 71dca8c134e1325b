// Places the labels on the map without overlaps.
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
  /// Starts a new frame.
  void clear() { bands_.clear(); }
  /// Takes the first of `spots` that overlaps no label of this frame; nullopt = there is no room.
  std::optional<QRectF> take(std::span<const QRectF> spots);

 private:
  bool free(const QRectF& spot) const;

  std::map<int, std::vector<QRectF>> bands_;  // by the horizontal stripes that a label touches
};

}  // namespace mapwright::scene
