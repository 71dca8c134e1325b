// Height ranges shown as bands over a section, with edges that can be dragged.
#pragma once

#include <optional>
#include <vector>

namespace mapwright::window {

struct SectionBand {
  int index = 0;  // the displayed number
  double low_m = 0, high_m = 0;
  bool chosen = false;
  bool movable = false;
  bool operator==(const SectionBand&) const = default;
};

struct BandEdge {
  std::size_t at = 0;  // of the bands
  bool low = false;
};

/// The edge nearest to a height, within `reach_m`; of several that of the selected band. Only of movable
/// bands.
std::optional<BandEdge> edgeNear(const std::vector<SectionBand>& bands, double height_m, double reach_m);
/// The band with that edge at a height; its ends stay in order and apart.
SectionBand withEdgeAt(SectionBand band, bool low, double height_m);

}  // namespace mapwright::window
