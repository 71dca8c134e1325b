// Edits of features. Each touches only the values concerned: all else keeps its notation, and so do the other
// numbers of a position. Pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// Metres with at most 4 decimals: "1.25", "-3".
std::string coordinateText(double metres);

/// All its positions; heights stay.
Feature movedBy(const Feature& feature, const Eigen::Vector2d& by_m);
/// Counter-clockwise, with the yaw of a point that has one.
Feature turnedAbout(const Feature& feature, const Eigen::Vector2d& pivot_m, double by_rad);

/// The positions of points, lines and polygons, ring by ring, without the one that closes a ring; those of
/// several parts one part after the other, MultiPoint as one ring. Empty for collections, and where one of
/// them cannot be read.
struct Vertex {
  std::size_t ring = 0, index = 0;
  auto operator<=>(const Vertex&) const = default;
};
std::vector<std::vector<Eigen::Vector2d>> verticesOf(const Feature& feature);
/// A closed ring stays closed.
Feature withVertexAt(const Feature& feature, Vertex vertex, const Eigen::Vector2d& at_m);
/// After `vertex`; on lines and outlines.
Feature withVertexAfter(const Feature& feature, Vertex vertex, const Eigen::Vector2d& at_m);
/// nullopt: too few would be left.
std::optional<Feature> withoutVertex(const Feature& feature, Vertex vertex);

/// `value`: JSON; nullopt: removed. Without effect on what is no object.
Feature withProperty(const Feature& feature, std::string_view name, const std::optional<std::string>& value);
/// "type", "lineType" or "regionType", as its shape has it.
std::string_view typeProperty(Shape shape);
/// The number stays a number, a text a text.
Feature withType(const Feature& feature, int type);
/// The same for its heading, in degrees from -180 to 180; nullopt: removed.
Feature withYaw(const Feature& feature, std::optional<double> degrees);

/// As robots write ids: 24 hexadecimal digits.
using IdBytes = std::array<std::uint8_t, 12>;
std::string idOf(const IdBytes& bytes);

/// Point, Line or Polygon, written as its neighbours in `among` are: the type as a number or a text, rings
/// closed or open.
Feature newFeature(const OverlayDocument& among, Shape shape, const std::vector<Eigen::Vector2d>& points,
                   int type, const std::string& id, const std::string& name = {});
/// A copy with an id of its own; `name` empty: it has none.
Feature duplicateOf(const Feature& feature, const std::string& id, const std::string& name);
/// "W17" -> "W17 2", or the next number that no other feature of its shape in `among` has.
std::string freeName(const OverlayDocument& among, Shape shape, const std::string& name);

}  // namespace mapwright::overlays
