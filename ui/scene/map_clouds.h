// The clouds of a map that lie on the map, as window and commands see them: what came is put in order in the
// background, drawn from above by the layer DispatchedCloud, cut into sections, written into files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "geometry/rect.h"
#include "map/map_part.h"
#include "render/painted_tiles.h"
#include "scene/map_scene.h"

namespace mapwright::scene {

/// What one answer of a robot brought.
struct CloudPiece {
  std::shared_ptr<const map::SpatialCloud> cloud;  // never null
  bool voxels = false;                             // the middles of occupied cells
  std::optional<map::CloudRegion> region = {};     // as it was asked for; nullopt = the whole map
};

/// What is shown and what is not.
struct CloudSums {
  std::size_t clouds = 0;
  std::uint64_t came = 0, shown = 0;  // shown: within the heights, and not replaced by newer ones
  std::uint64_t left_out = 0;         // no numbers, or absurdly far
  std::uint64_t thinned = 0;          // for want of memory
  std::uint64_t forgotten = 0;        // whole clouds, for newer ones
  std::size_t bytes = 0;
  bool voxels = false;
  std::optional<double> voxel_m = {};  // the edge of the cells, as found
  bool has_intensity = false, has_rgb = false, without_z = false;
  QStringList frames = {};  // untrusted
};

/// Points by height, whatever the chosen range.
struct CloudHeights {
  double low_m = 0, high_m = 0;              // of all
  double usual_low_m = 0, usual_high_m = 0;  // but for the outermost thousandth
  std::vector<std::uint64_t> bins;           // from usual_low_m to usual_high_m
  std::uint64_t points = 0;                  // 0: nothing else means anything
};

struct CloudRange {
  double low_m = 0, high_m = 0;
  bool operator==(const CloudRange&) const = default;
};

/// What the colours of the points mean, where a value gives them.
struct CloudScale {
  enum class Of { Height, Intensity };  // metres; as the robot sends it, without a unit
  Of of = Of::Height;
  double low = 0, high = 0;                // what lies beyond has the colour of the end
  std::vector<std::uint32_t> colors = {};  // 0x00RRGGBB, from low to high
  bool operator==(const CloudScale&) const = default;
};

/// A line on the map with the width of the strip that is looked at from its right-hand side.
struct CloudCut {
  Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
  double width_m = 0.5;
  bool operator==(const CloudCut&) const = default;
};

/// A cut that was made. Immutable.
class CloudSection {
 public:
  CloudCut cut;
  std::uint64_t points = 0, one_of = 1;  // in the strip; of how many one is drawn
  double low_m = 0, high_m = -1;         // low > high: there are none
  /// The point nearest to (along, height), if one is within reach.
  std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& at, double reach_m) const;

 private:
  friend class MapClouds;
  struct Inside;
  std::shared_ptr<const Inside> inside_;
};

/// GUI thread. What belonged to a session is let go with it.
class MapClouds : public QObject {
  Q_OBJECT
 public:
  /// Those of this scene; live as long as it.
  static MapClouds& of(const MapScene& scene);
  /// The scene makes them for itself.
  MapClouds(MapScene* scene, std::shared_ptr<work::Workers> workers);
  ~MapClouds() override;

  /// The newest is right about its region.
  void add(CloudPiece piece);
  void clear();
  bool empty() const;
  /// What was added is all on the map, and counted.
  bool settled() const;

  /// Only these heights are shown; nullopt = all.
  void setHeightRange(std::optional<CloudRange> range);
  const std::optional<CloudRange>& heightRange() const;
  /// The edge of all voxels; nullopt = as found.
  void setVoxel(std::optional<double> metres);

  const CloudSums& sums() const;
  const CloudHeights& heights() const;
  /// nullopt: the points have one colour, or colours of their own, or not the value that was chosen.
  std::optional<CloudScale> scale() const;
  geometry::WorldRect bounds() const;  // empty without clouds

  /// From above, in the style of the layer; null while there is nothing. `ratio`: device pixels a pixel.
  render::TilePainter painter(double ratio) const;
  /// Made in the background; a cut that is wanted later takes the place of one that is not made yet. The
  /// reply comes later, unless this goes or is cleared first.
  using SectionReply = std::function<void(std::shared_ptr<const CloudSection>)>;
  void cut(const CloudCut& cut, SectionReply reply);
  /// In a plane of (along, height), in the colours of the map.
  render::TilePainter sectionPainter(const std::shared_ptr<const CloudSection>& section, double ratio) const;

  /// Writes what is shown; by the end of the name PCD, PLY or CSV. The reply is how many points, or a
  /// sentence.
  void write(const QString& path, std::function<void(tl::expected<std::uint64_t, QString>)> reply);

 Q_SIGNALS:
  void changed();  // what is drawn
  void summed();   // sums() and heights()
  void settledChanged();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::scene
