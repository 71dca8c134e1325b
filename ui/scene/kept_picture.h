// A picture of what takes long to draw, kept while it and the camera stay as they are. For windows only: the
// blending of a picture is rounded otherwise than that of the lines in it. GUI thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <QImage>
#include <QRectF>

#include "geometry/view_transform.h"

class QPainter;

namespace mapwright::ui::scene {

class KeptPicture {
 public:
  /// Draws at least what lies in `exposed`, in viewport pixels, over what is there.
  using Draw = std::function<void(QPainter& painter, const QRectF& exposed)>;
  /// `revision`: another one if it looks different.
  void paint(QPainter& painter, const QRectF& exposed, const geometry::ViewTransform& view,
             std::uint64_t revision, const Draw& draw);
  void forget() { *this = {}; }
  std::size_t bytes() const { return std::size_t(picture_.sizeInBytes()); }

 private:
  std::optional<geometry::ViewTransform> view_;  // of the last painting
  std::uint64_t revision_ = 0;
  QImage picture_;
  bool drawn_ = false;  // the picture shows that
};

}  // namespace mapwright::ui::scene
