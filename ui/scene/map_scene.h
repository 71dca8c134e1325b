// The map as a QGraphicsScene: the same for the window and for snapshots. Scene coordinates are viewport
// pixels; the camera (geometry::ViewTransform) places the layers, so precision and speed do not depend on how
// far the map reaches.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QGraphicsScene>

#include "geometry/view_transform.h"
#include "render/sample_grid.h"
#include "render/tile_renderer.h"
#include "scene/drawn_waypoint.h"
#include "scene/layer.h"
#include "scene/map_theme.h"
#include "scene/robot_place.h"
#include "session/session.h"

namespace mapwright::scene {

/// A measured polyline in world metres.
struct Measurement {
  std::vector<Eigen::Vector2d> points;
};

class MapScene : public QGraphicsScene {
  Q_OBJECT
 public:
  /// `renderer_options.previews` false makes a scene for snapshots: only exact pictures, no animation.
  explicit MapScene(render::TileRenderer::Options renderer_options, QObject* parent = nullptr);
  ~MapScene() override;

  /// Shows a session (not owned; null = none). The session must outlive this or be taken away before.
  void setSession(session::Session* session);
  session::Session* session() const { return session_; }

  const geometry::ViewTransform& view() const { return view_; }
  void setView(const geometry::ViewTransform& view);

  void setTheme(const MapTheme& theme);
  const MapTheme& theme() const { return theme_; }
  void setColorMode(render::ColorMode mode);
  render::ColorMode colorMode() const { return color_mode_; }

  bool layerVisible(Layer layer) const;
  void setLayerVisible(Layer layer, bool visible);
  double layerOpacity(Layer layer) const;
  void setLayerOpacity(Layer layer, double opacity);  // 0..1
  const LayerStyle& layerStyle(Layer layer) const;
  void setLayerStyle(Layer layer, const LayerStyle& style);
  /// All layers, bottom first. Those whose place is fixed keep it, whatever is asked for.
  const std::vector<Layer>& layerOrder() const;
  void setLayerOrder(const std::vector<Layer>& order);

  /// Compares the session's wholeMap() with its comparedMap(); swiping without a compared map sets the
  /// submaps (left), where the robot has some, against the whole map (right).
  CompareMode compareMode() const;
  void setCompareMode(CompareMode mode);
  /// Where the swipe divides the viewport, 0 (left edge) .. 1.
  double swipeAt() const;
  void setSwipeAt(double fraction);
  /// What is to be seen left and right of the line.
  Halves halves() const;
  /// What both halves are called on the map; empty = not at all.
  void setHalfNames(const QString& left, const QString& right);
  /// So much of its top lies under strips.
  void setCoveredTop(double px);
  double coveredTop() const;

  /// The submaps to point at (selected in the tree): framed in the accent colour.
  void setHighlighted(std::set<map::SubmapId> ids);
  const std::set<map::SubmapId>& highlighted() const;
  bool highlightedAt(const Eigen::Vector2d& world_m) const;
  /// The topmost visible submap whose slice covers the point.
  std::optional<map::SubmapId> submapAt(const Eigen::Vector2d& world_m) const;

  /// Waypoints as they are being edited, in the place of those that the robot tells of that map; nullopt =
  /// none are.
  void setWaypoints(std::optional<DrawnWaypoints> waypoints);

  /// Cells as they are being edited, in the place of those that this map came with, whenever it is the whole
  /// map on screen; null = none are. They have its size and code.
  void setEditedCells(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells);
  /// Some of them have become others.
  void editedCellsChanged(const geometry::WorldRect& where);

  void setMeasurement(std::optional<Measurement> measurement);

  render::TileRenderer& renderer() { return *renderer_; }
  /// The submaps that have a picture, hidden ones too, in painting order.
  std::vector<render::PlacedTexture> placedTextures() const;
  /// The whole map that is shown or could be; nullopt while none is open.
  std::optional<render::PlacedGrid> wholeMap() const;
  /// What the tiles and the cells laid out for them take. Of the other caches it knows nothing.
  work::Budgets memory() const;
  /// Occupancy in percent (0 free .. 100 occupied) at a point; nullopt where nothing was observed.
  std::optional<int> occupancyAt(const Eigen::Vector2d& world_m) const;
  /// Every listed submap's picture is in, every visible map is read, and every visible tile is exact.
  bool settled() const;
  /// Every visible tile is exact for what has arrived so far.
  bool picturesSettled() const;
  /// Bounds of all maps that are shown; empty when there is none.
  geometry::WorldRect contentBounds() const;

  /// The robot, and all that belongs to it, is drawn only in the maps that it is in.
  const RobotPlace& robotPlace() const;
  /// Draws it all the same, or not, as long as this map is on screen; nullopt = as is known.
  void setRobotWanted(std::optional<bool> wanted);

  /// "Drawn as of" greying while the link is lost.
  void setStale(bool stale);

 Q_SIGNALS:
  void viewChanged();
  void layersChanged();
  void tilesSettled();
  void robotPlaceChanged();
  void contentChanged();  // another whole map, or its end
  void cellsEdited(const mapwright::geometry::WorldRect& where);

 protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  class Impl;
  void takeLive(int what);
  void takeFrame();
  void syncColors();
  void syncFeatures();
  void syncPlace();
  void showPlaced();
  void sendWants();
  void applyReduction();
  void noteSettled();
  bool cloudsSettled() const;
  void syncPlaced(const std::vector<map::SubmapId>& ids);
  void paintContentSoon();
  void paintContent();
  void syncAll();

  session::Session* session_ = nullptr;
  geometry::ViewTransform view_;
  MapTheme theme_;
  render::ColorMode color_mode_ = render::ColorMode::Normal;
  std::optional<render::ColorMode> drawn_color_mode_;
  std::unique_ptr<render::TileRenderer> renderer_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::scene
