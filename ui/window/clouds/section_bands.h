// Ranges of height that lie as bands over a section, and their edges, which can be taken hold of.
#pragma once

#include <optional>
#include <vector>

namespace mapwright::window {

struct SectionBand {
  int index = 0;  // as it is called
  double low_m = 0, high_m = 0;
  bool chosen = false;
  bool movable = false;
  bool operator==(const SectionBand&) const = default;
};

struct BandEdge {
  std::size_t at = 0;  // of the bands
  bool low = false;
};

/// The edge nearest to a height, no farther than `reach_m`; that of the chosen band where several are. Of
/// movable bands only.
std::optional<BandEdge> edgeNear(const std::vector<SectionBand>& bands, double height_m, double reach_m);
/// The band with that edge at a height, its ends in their order and never in one place.
SectionBand withEdgeAt(SectionBand band, bool low, double height_m);

}  // namespace mapwright::window
