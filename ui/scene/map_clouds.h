// The clouds on the map, for the window and for commands: indexed in the background, drawn from above by the
// layer DispatchedCloud, cut into sections, written to files.
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
#include "render/raster_tiles.h"
#include "scene/map_scene.h"

namespace mapwright::scene {

/// The content of one answer of a robot.
struct CloudPiece {
  std::shared_ptr<const map::SpatialCloud> cloud;  // never null
  bool voxels = false;                             // the middles of occupied cells
  std::optional<map::CloudRegion> region = {};     // as requested; nullopt = the whole map
};

/// What is shown and what is not.
struct CloudSums {
  std::size_t clouds = 0;
  std::uint64_t came = 0, shown = 0;  // shown: within the heights, and not replaced by newer ones
  std::uint64_t left_out = 0;         // invalid or absurdly far away
  std::uint64_t thinned = 0;          // to save memory
  std::uint64_t forgotten = 0;        // whole clouds, dropped for newer ones
  std::size_t bytes = 0;
  bool voxels = false;
  std::optional<double> voxel_m = {};  // the detected edge of the cells
  bool has_intensity = false, has_rgb = false, without_z = false;
  QStringList frames = {};  // untrusted
};

/// Points by height, regardless of the chosen range.
struct CloudHeights {
  double low_m = 0, high_m = 0;              // of all
  double usual_low_m = 0, usual_high_m = 0;  // without the outermost thousandth on each side
  std::vector<std::uint64_t> bins;           // from usual_low_m to usual_high_m
  std::uint64_t points = 0;                  // if 0, nothing else is valid
};

struct CloudRange {
  double low_m = 0, high_m = 0;
  bool operator==(const CloudRange&) const = default;
};

/// The meaning of the point colours, if they depend on a value.
struct CloudScale {
  enum class Of { Height, Intensity };  // in metres; as sent by the robot, without a unit
  Of of = Of::Height;
  double low = 0, high = 0;                // values beyond have the colour of the end
  std::vector<std::uint32_t> colors = {};  // 0x00RRGGBB, from low to high
  bool operator==(const CloudScale&) const = default;
};

/// A line on the map with the width of the strip, which is seen from its right-hand side.
struct CloudCut {
  Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
  double width_m = 0.5;
  bool operator==(const CloudCut&) const = default;
};

/// A finished section. Immutable.
class CloudSection {
 public:
  CloudCut cut;
  std::uint64_t points = 0, one_of = 1;  // in the strip; one in so many is drawn
  double low_m = 0, high_m = -1;         // low > high: there are none
  /// The point nearest to (along, height), if there is one within reach.
  std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& at, double reach_m) const;

 private:
  friend class MapClouds;
  struct Inside;
  std::shared_ptr<const Inside> inside_;
};

/// GUI thread. Data of a session is dropped with it.
class MapClouds : public QObject {
  Q_OBJECT
 public:
  /// Those of this scene; live as long as it.
  static MapClouds& of(const MapScene& scene);
  /// Made by the scene itself.
  MapClouds(MapScene* scene, std::shared_ptr<work::Workers> workers);
  ~MapClouds() override;

  /// The newest replaces older ones in its region.
  void add(CloudPiece piece);
  void clear();
  bool empty() const;
  /// Everything added is on the map, and counted.
  bool settled() const;

  /// Shows only these heights; nullopt = all.
  void setHeightRange(std::optional<CloudRange> range);
  const std::optional<CloudRange>& heightRange() const;
  /// The edge of all voxels; nullopt = as detected.
  void setVoxel(std::optional<double> metres);

  const CloudSums& sums() const;
  const CloudHeights& heights() const;
  /// nullopt: the points have one colour, or their own, or lack the chosen value.
  std::optional<CloudScale> scale() const;
  geometry::WorldRect bounds() const;  // empty without clouds

  /// Seen from above, in the style of the layer; null while empty. `ratio`: device pixels per pixel.
  render::TilePainter painter(double ratio) const;
  /// Computed in the background; a newer request replaces one that is not finished. The reply comes later,
  /// unless this is destroyed or cleared first.
  using SectionReply = std::function<void(std::shared_ptr<const CloudSection>)>;
  void cut(const CloudCut& cut, SectionReply reply);
  /// In the plane of (along, height), in the colours of the map.
  render::TilePainter sectionPainter(const std::shared_ptr<const CloudSection>& section, double ratio) const;

  /// Writes what is shown; the file extension selects PCD, PLY or CSV. The reply is the number of points, or
  /// a sentence.
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
