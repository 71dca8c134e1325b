#include "app/snapshot_content.h"

#include <utility>

#include "app/fetch_ahead.h"
#include "app/layer_wish.h"
#include "app/robot_factory.h"

namespace mapwright::app {
namespace {

constexpr double kFitMarginPx = 16;

}  // namespace

SnapshotOptions decided(SnapshotOptions options, robot::Robot& robot) {
  if (options.mode == SnapshotMode::Automatic) {
    options.mode = robot.submapSource() ? SnapshotMode::Submaps : SnapshotMode::Whole;
  }
  return options;
}

bool wantsSubmaps(const SnapshotOptions& options) {
  return options.mode == SnapshotMode::Submaps || options.layers.contains(scene::Layer::Submaps);
}

bool wantsWhole(const SnapshotOptions& options) {
  if (options.region) return false;
  return options.mode == SnapshotMode::Whole || options.layers.contains(scene::Layer::WholeMap);
}

session::Session::Options sessionFor(const SnapshotOptions& options,
                                     const std::shared_ptr<work::Workers>& workers) {
  session::Session::Options session;
  session.workers = workers;
  session.scheduler.max_concurrent = kFetchAhead;
  session.sidecar_folder = gridCacheFolder();
  session.overview = false;  // a picture shows exact data, or none
  session.maps = false;
  session.basics = LayerWish::basics(options.layers, wantsSubmaps(options));
  return session;
}

geometry::ViewTransform viewOf(const SnapshotOptions& options, const session::Session& session,
                               const MapWish& map) {
  geometry::ViewTransform view;
  view.width_px = options.size_px.width();
  view.height_px = options.size_px.height();
  view.rotation_rad = options.rotation_rad;
  if (options.region) {
    view.center_m = options.region->center();
    if (options.scale_m_per_px > 0) view.scale_m_per_px = options.scale_m_per_px;
    return view;
  }
  if (!options.center_m) {
    geometry::WorldRect bounds;
    if (wantsSubmaps(options)) bounds.extend(session.contentBounds());
    const auto grid = wantsWhole(options) ? map.grid() : std::nullopt;
    if (grid) bounds.extend(grid->reference.bounds());
    if (bounds.empty() && options.layers.contains(scene::Layer::Cloud)) {
      for (const auto& [topic, cloud] : session.live().clouds) {
        if (!cloud) continue;
        for (const map::CloudPoint& point : *cloud) bounds.extend(Eigen::Vector2d(point.x_m, point.y_m));
      }
    }
    return view.fitted(bounds, kFitMarginPx);
  }
  view.center_m = *options.center_m;
  view.scale_m_per_px = options.scale_m_per_px;
  return view;
}

SnapshotContent contentOf(const SnapshotOptions& options, const session::Session& session, const MapWish& map,
                          const geometry::ViewTransform& view) {
  SnapshotContent content;
  content.view = view;
  content.submaps = wantsSubmaps(options);
  content.whole = options.raw ? options.mode == SnapshotMode::Whole : wantsWhole(options) && map.grid();
  if (!options.raw || options.region) return content;
  if (content.whole) {
    content.grid = map.grid();
    return content;
  }
  for (const auto& [id, row] : session.submaps().rows()) {
    if (const auto placement = session.submaps().placement(id, options.slice)) {
      content.textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  return content;
}

}  // namespace mapwright::app
