// Overlays of what a robot sees or has collected: chargers and racks where it sees them, landmarks and
// barcodes. Pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

struct SeenPlace {
  Eigen::Vector2d at_m{0, 0};
  double yaw_deg = 0;
  std::string reference = {};  // properties.ref; empty: none
};

/// A new point of that type, written as its neighbours in `among` are.
Feature seenFeature(const OverlayDocument& among, int type, const SeenPlace& seen, const std::string& id,
                    const std::string& name = {});
/// The point where it is seen now.
Feature seenAgain(const Feature& point, const SeenPlace& seen);

/// Something by which robots find their place.
struct Mark {
  enum class Kind { Landmark, Barcode };
  Kind kind = Kind::Landmark;
  std::string id;
  Eigen::Vector2d at_m{0, 0};
  std::optional<double> yaw_deg = {};
};

struct MarkOffer {
  Mark mark;
  std::optional<std::size_t> present = {};  // the feature that has its id already
  double away_m = 0;                        // how far it is from there
};

/// The same place is at most this far away.
inline constexpr double kSamePlaceM = 0.01;

/// In the order of their ids, as people count. Of marks with the same id the last one counts; those that are
/// there already in the same place are left out.
std::vector<MarkOffer> offersOf(const OverlayDocument& among, const std::vector<Mark>& marks);
Feature markFeature(const OverlayDocument& among, const Mark& mark, const std::string& id);
/// The present feature in the place of the mark.
Feature withMark(const Feature& present, const Mark& mark);

}  // namespace mapwright::overlays
