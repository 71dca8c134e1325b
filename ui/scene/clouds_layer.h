// The clouds of a map, seen from above, and what their colours mean. The same colours for sections.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "clouds/cloud_store.h"
#include "render/raster_tiles.h"
#include "ui/scene/layer.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui::scene {

/// The meaning of the point colours, if they depend on a value.
struct CloudScale {
  enum class Of { Height, Intensity };  // in metres; as sent by the robot, without a unit
  Of of = Of::Height;
  double low = 0, high = 0;                // values beyond have the colour of the end
  std::vector<std::uint32_t> colors = {};  // 0x00RRGGBB, from low to high
  bool operator==(const CloudScale&) const = default;
};
/// nullopt: the points have one colour, or their own, or lack the chosen value.
std::optional<CloudScale> cloudScale(const clouds::CloudStore& clouds, const LayerStyle& style,
                                     const MapTheme& theme);

/// From above, in the style of the layer; null while there are none. `ratio`: device pixels per pixel.
render::TilePainter cloudPainter(const clouds::CloudStore& clouds, const LayerStyle& style,
                                 const MapTheme& theme, double ratio);
/// In the plane of (along, height).
render::TilePainter sectionPainter(const std::shared_ptr<const clouds::Section>& section,
                                   const clouds::CloudStore& clouds, const LayerStyle& style,
                                   const MapTheme& theme, double ratio);

}  // namespace mapwright::ui::scene
