// The map as a QGraphicsScene, for the window and for snapshots. Scene coordinates are viewport pixels; the
// camera (geometry::ViewTransform) places the layers, so precision and speed do not depend on the size of the
// map.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QElapsedTimer>
#include <QGraphicsScene>
#include <QImage>
#include <QTimer>

#include "geometry/view_transform.h"
#include "map/grid_reference.h"
#include "session/session.h"
#include "ui/scene/drawn_overlays.h"
#include "ui/scene/drawn_waypoint.h"
#include "ui/scene/layer.h"
#include "ui/scene/legend_section.h"
#include "ui/scene/map_object.h"
#include "ui/scene/problem_marks.h"
#include "ui/scene/repaint_pace.h"
#include "ui/scene/robot_place.h"
#include "ui/scene/track.h"

namespace mapwright::agreement {
struct TileKey;
class Tile;
using Tiles = std::map<TileKey, std::shared_ptr<const Tile>>;
}  // namespace mapwright::agreement
namespace mapwright::clouds {
class CloudStore;
}
namespace mapwright::map {
struct Closures;
}
namespace mapwright::grids {
class GridPyramid;
}
namespace mapwright::regions {
class RegionMap;
}
namespace mapwright::render {
enum class ColorMode;
struct PlacedGrid;
struct PlacedTexture;
class TileRenderer;
struct TileRendererOptions;
}  // namespace mapwright::render

namespace mapwright::ui::scene {

struct MapTheme;
struct WallsOff;
class SceneItems;

class MapScene : public QGraphicsScene {
  Q_OBJECT
 public:
  /// `renderer_options.previews` false makes a scene for snapshots: only exact pictures, no animation, and
  /// the session is asked for nothing. `clouds`: those of the map; null = there are none.
  explicit MapScene(render::TileRendererOptions renderer_options,
                    std::shared_ptr<clouds::CloudStore> clouds = nullptr, QObject* parent = nullptr);
  ~MapScene() override;

  /// Shows a session (not owned; null = none). The session must outlive this or be removed first.
  void setSession(session::Session* session);
  session::Session* session() const { return session_; }

  const geometry::ViewTransform& view() const { return view_; }
  void setView(const geometry::ViewTransform& view);

  void setTheme(const MapTheme& theme);
  const MapTheme& theme() const;
  void setColorMode(render::ColorMode mode);
  render::ColorMode colorMode() const { return color_mode_; }

  bool layerVisible(Layer layer) const;
  void setLayerVisible(Layer layer, bool visible);
  /// The same for all layers at once: these and no others.
  void setLayersVisible(const std::set<Layer>& layers);
  double layerOpacity(Layer layer) const;
  void setLayerOpacity(Layer layer, double opacity);  // 0..1
  const LayerStyle& layerStyle(Layer layer) const;
  void setLayerStyle(Layer layer, const LayerStyle& style);
  /// All layers, bottom first. Those with a fixed position keep it.
  const std::vector<Layer>& layerOrder() const;
  void setLayerOrder(const std::vector<Layer>& order);

  /// Compares the session's wholeMap() with its comparedMap(); without a compared map a swipe shows the
  /// submaps (left), if there are any, against the whole map (right).
  CompareMode compareMode() const;
  void setCompareMode(CompareMode mode);
  /// The position of the divider, 0 (left edge) .. 1.
  double swipeAt() const;
  void setSwipeAt(double fraction);
  /// The content left and right of the divider.
  Halves halves() const;
  /// The labels of the two halves; empty = none.
  void setHalfNames(const QString& left, const QString& right);
  /// The height of the strips at its top.
  void setCoveredTop(double px);
  double coveredTop() const;
  /// What else lies over it: names keep clear of it.
  void setCovered(std::vector<QRectF> areas);

  /// The submaps to highlight (selected in the tree): framed in the accent colour.
  void setHighlighted(std::set<map::SubmapId> ids);
  const std::set<map::SubmapId>& highlighted() const;
  /// The layers Outlines and Ids leave out all other submaps; nullopt: they leave out none. Dropped with the
  /// session.
  void setOutlined(std::optional<std::set<map::SubmapId>> ids);
  bool highlightedAt(const Eigen::Vector2d& world_m) const;
  /// The topmost visible submap whose slice covers the point.
  std::optional<map::SubmapId> submapAt(const Eigen::Vector2d& world_m) const;

  /// The things that visible layers show at a point, those that are most likely meant first: points, lines,
  /// areas from small to large, submaps. A few dozen at most.
  std::vector<ObjectId> objectsAt(const Eigen::Vector2d& world_m, double reach_px) const;
  /// nullopt: it is gone, or no longer shown.
  std::optional<MapObject> object(const ObjectId& id) const;
  /// All things that visible layers show, except submaps and the points of sensors; at most `most`.
  std::vector<MapObject> objects(std::size_t most) const;
  /// What it looks like on the map, as in the legend.
  QImage symbolOf(const MapObject& object, int size_px, qreal pixel_ratio) const;
  /// Frames a thing as it lies now; nullopt = none.
  void setMarked(std::optional<MapObject> object);
  /// Marks a place, world metres; nullopt = none.
  void setMarker(std::optional<Eigen::Vector2d> world_m);
  const std::optional<Eigen::Vector2d>& marker() const;

  /// What is missing within `reach_px` of the point, and why: only while the marks of the layer Problems are
  /// shown there.
  std::vector<ProblemMark> problemMarksAt(const Eigen::Vector2d& world_m, double reach_px) const;
  /// Submaps that only lack the chosen slice are marked, too (default).
  void setSlicesMarked(bool marked);

  /// The edited waypoints, shown instead of the robot's waypoints of that map; nullopt = none.
  void setWaypoints(std::optional<DrawnWaypoints> waypoints);

  /// The edited overlays, shown instead of those of that map; nullopt = none.
  void setOverlays(std::optional<DrawnOverlays> overlays);
  /// Those of this map are on screen, and they are the edited ones.
  bool showsEditedOverlays(FeaturesOf of) const;

  /// The edited cells, shown instead of the map's own whenever it is on screen; null = none. They have its
  /// size and code.
  void setEditedCells(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells);
  /// Some of them have changed.
  void editedCellsChanged(const geometry::WorldRect& where);

  /// A map from elsewhere, laid under the others; nullopt = none.
  void setReference(std::optional<render::PlacedGrid> placed);
  /// Half transparent above the others: while it is laid by hand.
  void setReferenceAbove(bool above);
  bool referenceAbove() const;
  /// What differs between it and the whole map, in its place above the maps.
  void setReferenceDifferences(bool shown);
  bool referenceDifferences() const;
  /// Walls that are far from those of the other map; null = not known.
  void setWallsOff(std::shared_ptr<const WallsOff> walls);
  /// What is wrong with it; nullopt = all is well.
  void setReferenceTrouble(std::optional<MapTrouble> trouble);
  /// More of its cells have been read.
  void referenceRowsArrived();

  /// World metres; empty = none. `closed`: they are a ring.
  void setMeasurement(std::vector<Eigen::Vector2d> points, bool closed = false);

  /// The map by regions (not owned; it may be destroyed first); null = none.
  void setRegions(regions::RegionMap* regions);
  regions::RegionMap* regions() const;
  /// The extent of the whole map as reported by its robot; nullopt: not reported. Ignored without a map by
  /// regions.
  void setRegionsExtent(const std::optional<map::GridReference>& extent);

  /// There are clouds of the map, and they are shown.
  bool showsClouds() const;

  /// The robot's path through a whole bag; null = none. Dropped with the session.
  void setTrack(std::shared_ptr<const Track> track);

  /// What the layer Closures shows instead of all loop closures of the session; null = those. Dropped with
  /// the session.
  void setClosures(std::shared_ptr<const map::Closures> closures);

  /// What the layers Disagreement and Coverage show, in cells of this edge; null = nothing. Dropped with the
  /// session.
  void setAgreement(std::shared_ptr<const agreement::Tiles> tiles, double cell_m);

  /// Where the robot is between two samples of a replay: drawn instead of the session's pose, world metres;
  /// nullopt: the session's. Without a session's pose nothing is drawn. Dropped with the session.
  void setPoseBetween(const std::optional<geometry::Pose2>& pose);
  /// Where the robot is drawn at present, if anywhere.
  std::optional<geometry::Pose2> robotPose() const;

  render::TileRenderer& renderer() { return *renderer_; }
  /// The submaps with a picture, including hidden ones, in painting order.
  std::vector<render::PlacedTexture> placedTextures() const;
  /// The whole map, shown or not; nullopt if none is open.
  std::optional<render::PlacedGrid> wholeMap() const;
  /// Memory of the tiles and the cells prepared for them. It does not know the other caches.
  work::Budgets memory() const;
  /// Occupancy in percent (0 free .. 100 occupied) at a point; nullopt if nothing was observed there.
  std::optional<int> occupancyAt(const Eigen::Vector2d& world_m) const;
  /// Every listed submap's picture is loaded, every visible map is read, and every visible tile is exact.
  bool settled() const;
  /// Every visible tile is exact for the data received so far.
  bool picturesSettled() const;
  /// Bounds of all maps shown; empty if there is none.
  geometry::WorldRect contentBounds() const;
  /// Bounds of what a layer holds, shown or not; empty: nothing, or nothing that has a place.
  geometry::WorldRect layerBounds(Layer layer) const;
  /// What the visible layers show means, the top one first. Symbols are made for `pixel_ratio` device pixels
  /// per pixel. (legend.cpp)
  std::vector<LegendSection> legend(qreal pixel_ratio) const;

  /// The robot, and everything that belongs to it, is only drawn in the maps that it is in.
  const RobotPlace& robotPlace() const;
  /// The user's choice to draw it or not while this map is on screen; nullopt = automatic.
  void setRobotWanted(std::optional<bool> wanted);

  /// Greys the map while the connection is lost.
  void setStale(bool stale);

 Q_SIGNALS:
  void viewChanged();
  void layersChanged();
  void tilesSettled();
  void robotPlaceChanged();
  void poseBetweenChanged();
  void contentChanged();  // another whole map, or none
  void cellsEdited(const mapwright::geometry::WorldRect& where);

 protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void onLive(int what);
  void onFrame();
  void syncColors();
  void syncFeatures();
  void syncPlace();
  void syncClosures();
  void showPlaced();
  void sendWants();
  void applyReduction();
  void emitSettled();
  void syncPlaced(const std::vector<map::SubmapId>& ids);
  void paintContentSoon();
  void paintContent();
  void syncAll();
  void syncAges();
  /// The marks of submaps without a picture; true if one has changed.
  bool syncMark(map::SubmapId id);
  void syncMarks(const session::TouchedRows& rows);
  QString reasonOf(map::SubmapId id, MarkKind kind) const;
  void repaintAll();
  void placeLabelsSoon();
  double nowMs() const { return double(clock_.nsecsElapsed()) * 1e-6; }

  session::Session* session_ = nullptr;
  geometry::ViewTransform view_;
  render::ColorMode color_mode_;
  std::optional<render::ColorMode> drawn_color_mode_;
  std::unique_ptr<render::TileRenderer> renderer_;
  std::unique_ptr<SceneItems> items_;
  std::shared_ptr<const map::Closures> chosen_closures_;  // null = all loop closures
  RepaintPace pace_;
  QElapsedTimer clock_;
  QTimer repaint_timer_;  // runs while new tiles wait to be painted
  bool slices_marked_ = true;
  double began_ms_ = 0;  // of the painting in progress
};

}  // namespace mapwright::ui::scene
