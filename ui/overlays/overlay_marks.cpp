#include "ui/overlays/overlay_marks.h"

#include <map>
#include <utility>

#include <QGraphicsItem>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "overlays/overlay_shapes.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/drawing.h"
#include "ui/scene/kept_picture.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui {
namespace {

using Kind = OverlayMark::Kind;

constexpr double kAbove = 1e6;  // all layers and names
constexpr double kPlacePx = 9, kStatePx = 5.5;
constexpr double kReachPx = 20;  // no mark of a state is larger
constexpr std::size_t kMany = 500;
constexpr QPointF kStateAside(11, -11);  // not on the thing itself

/// They differ in their dashes, too.
QPen penOf(Kind kind, const scene::MapTheme& theme) {
  switch (kind) {
    case Kind::Added:
      return QPen(theme.good, 3.5);
    case Kind::Removed:
      return QPen(theme.bad, 3.5, Qt::DashLine);
    case Kind::Before:
      return QPen(theme.warn, 2.5, Qt::DotLine);
    case Kind::After:
      return QPen(theme.accent, 3.5);
    case Kind::Way:
      return QPen(theme.accent, 3, Qt::DashDotLine);
    case Kind::BlockedWay:
      return QPen(theme.bad, 2.5, Qt::DotLine);
    case Kind::Blocked:
    case Kind::State:
      break;
  }
  return QPen(theme.bad, 3);
}

void addMarks(const overlays::Feature& feature, Kind kind, std::vector<OverlayMark>& marks) {
  for (overlays::Path& path : overlays::shapesOf(feature).paths) {
    if (!path.points.empty()) marks.push_back({kind, path.shape, std::move(path.points)});
  }
}

}  // namespace

std::vector<OverlayMark> marksOf(const overlays::OverlayChange& change,
                                 const overlays::OverlayDocument& before,
                                 const overlays::OverlayDocument& after) {
  std::vector<OverlayMark> marks;
  const bool changed = change.from && change.to;
  if (change.from) addMarks(before.features()[*change.from], changed ? Kind::Before : Kind::Removed, marks);
  if (change.to) addMarks(after.features()[*change.to], changed ? Kind::After : Kind::Added, marks);
  return marks;
}

std::vector<OverlayMark> marksOf(const overlays::Way& way) {
  std::vector<OverlayMark> marks;
  if (!way.open.empty()) marks.push_back({Kind::Way, overlays::Shape::Line, way.open});
  if (way.blocked.empty()) return marks;
  marks.push_back({Kind::BlockedWay, overlays::Shape::Line, way.blocked});
  marks.push_back({Kind::Blocked, overlays::Shape::Point, {way.blocked.front()}});
  return marks;
}

std::vector<OverlayMark> stateMarksOf(const overlays::EditingDocument& document) {
  using State = overlays::EditingDocument::State;
  using scene::WaypointMark;
  std::set<FeatureKey> in_conflict;
  for (const auto& conflict : document.conflicts()) in_conflict.insert(conflict.first);
  std::vector<OverlayMark> marks;
  for (FeatureKey key = 0; key < document.size(); ++key) {
    const State state = document.state(key);
    const bool there = document.changedThere().contains(key);
    if (state == State::Same && !there) continue;
    const auto& feature = document.find(key) ? document.find(key) : document.findBase(key);
    if (!feature) continue;
    const auto paths = overlays::shapesOf(*feature).paths;
    if (paths.empty() || paths.front().points.empty()) continue;
    const auto& points = paths.front().points;
    const WaypointMark mark = in_conflict.contains(key) ? WaypointMark::Conflict
                              : state == State::New     ? WaypointMark::New
                              : state == State::Deleted ? WaypointMark::Deleted
                              : state == State::Changed ? WaypointMark::Unsaved
                                                        : WaypointMark::Theirs;
    marks.push_back({Kind::State, overlays::Shape::Point, {points[points.size() / 2]}, mark});
  }
  return marks;
}

QIcon markSample(overlays::ChangeKind kind, const scene::MapTheme& theme) {
  constexpr int kEdge = 16;
  QPixmap picture(kEdge, kEdge);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto line = [&](Kind what, double y) {
    QPen pen = penOf(what, theme);
    pen.setWidthF(2);  // so that its dashes are seen
    painter.setPen(pen);
    painter.drawLine(QPointF(1, y), QPointF(kEdge - 1, y));
  };
  switch (kind) {
    case overlays::ChangeKind::Add:
      line(Kind::Added, kEdge / 2.0);
      break;
    case overlays::ChangeKind::Remove:
      line(Kind::Removed, kEdge / 2.0);
      break;
    case overlays::ChangeKind::Change:
      line(Kind::Before, 4);
      line(Kind::After, 11);
      break;
  }
  return picture;
}

class OverlayMarks::Item : public QGraphicsItem {
 public:
  explicit Item(const scene::MapScene* scene) : scene_(scene) {
    setZValue(kAbove);
    setAcceptedMouseButtons(Qt::NoButton);
    setFlag(ItemUsesExtendedStyleOption);  // it wants to know what is exposed
    hide();
  }
  void setMarks(std::vector<OverlayMark> marks) {
    prepareGeometryChange();
    marks_ = std::move(marks);
    ++revision_;
    setVisible(!marks_.empty());
    update();
  }
  void follow() {
    if (!isVisible()) return;
    prepareGeometryChange();
    update();
  }
  const std::vector<OverlayMark>& marks() const { return marks_; }

  /// The scene's coordinates are viewport pixels.
  QRectF boundingRect() const override {
    return {0, 0, double(scene_->view().width_px), double(scene_->view().height_px)};
  }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    if (marks_.size() < kMany) {
      kept_.forget();
      return paintMarks(*painter, option->exposedRect);
    }
    if (std::exchange(dark_, scene_->theme().dark) != scene_->theme().dark) ++revision_;
    kept_.paint(*painter, option->exposedRect, scene_->view(), revision_,
                [this](QPainter& on, const QRectF& exposed) { paintMarks(on, exposed); });
  }

 private:
  void paintMarks(QPainter& painter, const QRectF& exposed) const {
    const QRectF wanted = exposed.adjusted(-kReachPx, -kReachPx, kReachPx, kReachPx);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    std::map<scene::WaypointMark, QImage> images;
    for (const OverlayMark& mark : marks_) {
      if (mark.kind == Kind::State) {
        const QPointF at = scene::toPoint(scene_->view().pixelFromWorld(mark.points.front())) + kStateAside;
        if (!wanted.contains(at)) continue;
        if (marks_.size() < kMany) {
          paintState(painter, at, mark.state);
        } else {
          paintImage(painter, at, mark.state, images);
        }
        continue;
      }
      const QPen pen = penOf(mark.kind, scene_->theme());
      paintMark(painter, mark, QPen(scene_->theme().text_halo, pen.widthF() + 3));
      paintMark(painter, mark, pen);
    }
  }
  void paintState(QPainter& painter, const QPointF& at, scene::WaypointMark state) const {
    using scene::WaypointMark;
    const scene::MapTheme& theme = scene_->theme();
    const bool bad = state == WaypointMark::Conflict || state == WaypointMark::Deleted;
    const QColor fill = bad ? theme.bad : state == WaypointMark::Theirs ? theme.accent : theme.warn;
    scene::paintWaypointMark(painter, at, kStatePx, state, fill, theme.text_halo);
    painter.setBrush(Qt::NoBrush);
  }
  /// Many times as fast; at whole pixels.
  void paintImage(QPainter& painter, const QPointF& at, scene::WaypointMark state,
                  std::map<scene::WaypointMark, QImage>& images) const {
    constexpr int kEdge = 24;
    QImage& image = images[state];
    if (image.isNull()) {
      const qreal ratio = painter.device()->devicePixelRatioF();
      image = QImage((QSizeF(kEdge, kEdge) * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
      image.setDevicePixelRatio(ratio);
      image.fill(Qt::transparent);
      QPainter on_image(&image);
      paintState(on_image, QPointF(kEdge, kEdge) / 2, state);
    }
    painter.drawImage((at - QPointF(kEdge, kEdge) / 2).toPoint(), image);
  }
  void paintMark(QPainter& painter, const OverlayMark& mark, const QPen& pen) const {
    painter.setPen(pen);
    std::vector<Eigen::Vector2d> points = mark.points;
    const QPointF first = scene::toPoint(scene_->view().pixelFromWorld(points.front()));
    if (mark.kind == Kind::Blocked) {
      const QPointF arm(kPlacePx * 0.7, kPlacePx * 0.7), other(arm.x(), -arm.y());
      painter.drawLine(first - arm, first + arm);
      painter.drawLine(first - other, first + other);
      return;
    }
    if (mark.shape == overlays::Shape::Point) painter.drawEllipse(first, kPlacePx, kPlacePx);
    if (mark.shape == overlays::Shape::Polygon) points.push_back(points.front());
    for (const QPolygonF& line : scene::visibleLines(scene_->view(), points, 8)) painter.drawPolyline(line);
  }

  const scene::MapScene* scene_;
  std::vector<OverlayMark> marks_;
  scene::KeptPicture kept_;
  std::uint64_t revision_ = 0;
  bool dark_ = false;
};

OverlayMarks::OverlayMarks(scene::MapScene* scene, QObject* parent)
    : QObject(parent), scene_(scene), item_(std::make_unique<Item>(scene)) {
  scene_->addItem(item_.get());
  connect(scene_, &scene::MapScene::viewChanged, this, [this] { item_->follow(); });
}

OverlayMarks::~OverlayMarks() = default;  // it leaves the scene

void OverlayMarks::show(std::vector<OverlayMark> marks) {
  if (marks.empty() && item_->marks().empty()) return;
  item_->setMarks(std::move(marks));
}

const std::vector<OverlayMark>& OverlayMarks::shown() const { return item_->marks(); }

}  // namespace mapwright::ui

#include "moc_overlay_marks.cpp"
