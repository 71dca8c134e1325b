// Marks where something should be on the map and is not: submaps without a picture, features of overlays that
// cannot be read, maps that could not be loaded.
#include <algorithm>
#include <cmath>

#include <QPainterPath>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "words/listed.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kBadgePx = 7.5;         // radius of the disc with the sign
constexpr double kLeastOutlinePx = 24;   // a smaller outline is drawn as a mark of fixed size
constexpr double kFixedPx = 10;          // half of its edge
constexpr std::size_t kMostMarks = 400;  // more in view are summed up in squares
constexpr double kSquarePx = 24;         // the least edge of those
constexpr int kHatchLines = 110, kTint = 26;

QColor markColor(const MapTheme& theme, MarkKind kind) {
  return kind == MarkKind::NoSlice ? theme.warn : theme.bad;
}

/// Not by colour alone.
QString signOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::Missing:
      return QStringLiteral("?");
    case MarkKind::Corrupt:
      return QString(QChar(0xd7));
    case MarkKind::NoSlice:
      return QString(QChar(0x2013));
    case MarkKind::Failed:
    case MarkKind::Unreadable:
      break;
  }
  return QStringLiteral("!");
}

QString wordOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::Missing:
      return QCoreApplication::translate("scene", "missing");
    case MarkKind::Failed:
      return QCoreApplication::translate("scene", "fetch failed");
    case MarkKind::Corrupt:
      return QCoreApplication::translate("scene", "corrupt");
    case MarkKind::NoSlice:
      return QCoreApplication::translate("scene", "no slice");
    case MarkKind::Unreadable:
      break;
  }
  return QCoreApplication::translate("scene", "unreadable");
}

/// Draws the marks of one painting.
class MarkBrush {
 public:
  MarkBrush(QPainter& painter, const LayerContext& context) : painter_(painter), context_(context) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setBrushOrigin(hatchOrigin(context.view));
  }

  /// Several at once: where they overlap, hatching lies on them once.
  void areas(const std::vector<QPolygonF>& shapes, const QColor& color) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const QPolygonF& shape : shapes) path.addPolygon(turnedAlike(shape));
    painter_.fillPath(path, translucent(color, kTint));
    painter_.fillPath(path, QBrush(translucent(color, kHatchLines), Qt::BDiagPattern));
  }
  void outline(const QPolygonF& shape, const QColor& color, bool halo = true) {
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(context_.theme.text_halo, 3, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    if (halo) painter_.drawPolygon(shape);
    painter_.setPen(QPen(color, 1.5, Qt::DashLine, Qt::FlatCap, Qt::MiterJoin));
    painter_.drawPolygon(shape);
  }
  void badge(const QPointF& at, MarkKind kind) {
    const QColor color = markColor(context_.theme, kind);
    QColor ground = context_.theme.text_halo;
    ground.setAlpha(255);
    painter_.setBrush(ground);
    painter_.setPen(QPen(color, 1.5));
    painter_.drawEllipse(at, kBadgePx, kBadgePx);
    const QString sign = signOf(kind);
    const QSizeF size = context_.ink->sizeOf(sign, context_.theme);
    context_.ink->draw(painter_, at - QPointF(size.width(), size.height()) / 2, sign, context_.theme,
                       readable(color, context_.theme));
  }
  struct Mark {
    QPolygonF shape;
    QPointF at;
    MarkKind kind;
  };
  void marks(const std::vector<Mark>& marks) {
    constexpr std::size_t kFew = 40;  // the halos of more would hide the map
    for (const bool only_slice : {true, false}) {
      std::vector<QPolygonF> shapes;
      for (const Mark& mark : marks) {
        if ((mark.kind == MarkKind::NoSlice) == only_slice) shapes.push_back(mark.shape);
      }
      areas(shapes, only_slice ? context_.theme.warn : context_.theme.bad);
    }
    for (const Mark& mark : marks)
      outline(mark.shape, markColor(context_.theme, mark.kind), marks.size() <= kFew);
    for (const Mark& mark : marks) badge(mark.at, mark.kind);
  }

 private:
  /// For one path: two that turn in opposite ways would cancel each other out.
  static QPolygonF turnedAlike(QPolygonF shape) {
    double twice_area = 0;
    for (qsizetype i = 0; i < shape.size(); ++i) {
      const QPointF &a = shape[i], &b = shape[(i + 1) % shape.size()];
      twice_area += a.x() * b.y() - b.x() * a.y();
    }
    if (twice_area < 0) std::reverse(shape.begin(), shape.end());
    if (!shape.isClosed()) shape << shape.front();
    return shape;
  }

  QPainter& painter_;
  const LayerContext& context_;
};

/// Its outline, or a square of fixed size around its middle.
QPolygonF shapeOf(const LayerContext& context, const PlacedMark& mark) {
  QPolygonF shape;
  if (mark.corners) {
    for (const Eigen::Vector2d& corner : *mark.corners) shape << toPoint(context.view.pixelFromWorld(corner));
    const QRectF box = shape.boundingRect();
    if (std::min(box.width(), box.height()) >= kLeastOutlinePx) return shape;
  }
  const QPointF at = toPoint(context.view.pixelFromWorld(mark.at_m));
  return QPolygonF(QRectF(at - QPointF(kFixedPx, kFixedPx), QSizeF(2 * kFixedPx, 2 * kFixedPx)));
}

QRectF badgeArea(const QPointF& at) {
  return QRectF(at - QPointF(kBadgePx + 1, kBadgePx + 1), QSizeF(2 * kBadgePx + 2, 2 * kBadgePx + 2));
}

/// Submaps whose picture is missing, failed, corrupt, or without the chosen slice.
class SubmapProblems : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (context_.submap_marks->size() == 0) return;
    painter->save();
    MarkBrush brush(*painter, context_);
    if (const auto marks = inView()) {
      std::vector<MarkBrush::Mark> drawn;
      for (const auto& [id, mark] : *marks) {
        drawn.push_back(
            {shapeOf(context_, mark), toPoint(context_.view.pixelFromWorld(mark.at_m)), mark.kind});
      }
      brush.marks(drawn);
    } else {
      brush.areas(squares(), context_.theme.bad);
    }
    painter->restore();
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    const auto marks = inView();
    if (!marks) return;
    for (const auto& [id, mark] : *marks) {
      const QRectF badge = badgeArea(toPoint(context_.view.pixelFromWorld(mark.at_m)));
      labels.symbol(badge);
      if (!labels.isClose()) continue;
      labels.add(LabelWish::Position::Beside, LabelRank::Thing, badge, std::hash<map::SubmapId>()(id),
                 words::about(QString::fromStdString(map::toText(id)), wordOf(mark.kind)),
                 readable(markColor(context_.theme, mark.kind), context_.theme));
    }
  }

 private:
  std::optional<std::vector<SubmapMarks::Entry>> inView() const {
    const geometry::ViewTransform& view = context_.view;
    return context_.submap_marks->within(view.visibleWorld().grown(2 * kFixedPx * view.scale_m_per_px),
                                         kMostMarks);
  }
  /// Those of a coarse grid of the world in which there are some.
  std::vector<QPolygonF> squares() const {
    const geometry::ViewTransform& view = context_.view;
    const double edge_m = std::exp2(std::ceil(std::log2(kSquarePx * view.scale_m_per_px)));
    const geometry::WorldRect seen = view.visibleWorld();
    std::vector<QPolygonF> squares;
    for (double y = std::floor(seen.min_y / edge_m) * edge_m; y < seen.max_y; y += edge_m) {
      for (double x = std::floor(seen.min_x / edge_m) * edge_m; x < seen.max_x; x += edge_m) {
        if (!context_.submap_marks->any({x, y, x + edge_m, y + edge_m})) continue;
        squares.push_back(
            toPolygon(view, {{x, y}, {x + edge_m, y}, {x + edge_m, y + edge_m}, {x, y + edge_m}}));
      }
    }
    return squares;
  }
};

/// At its outline, or where it lies if its size is not known.
void paintTrouble(MarkBrush& brush, const LayerContext& context, const MapTrouble& trouble) {
  const Eigen::Vector2d middle = (trouble.corners[0] + trouble.corners[2]) / 2;
  const QPolygonF shape = shapeOf(context, {MarkKind::Unreadable, middle, trouble.corners});
  if (!inView(context.view, shape.boundingRect())) return;
  if (trouble.nothing_shown) brush.areas({shape}, context.theme.bad);
  brush.outline(shape, context.theme.bad);
  brush.badge(trouble.nothing_shown ? shape.boundingRect().center() : shape[0], MarkKind::Unreadable);
}

/// Of the map that is laid under the others.
class ReferenceProblems : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (!context_.reference_trouble) return;
    painter->save();
    MarkBrush brush(*painter, context_);
    paintTrouble(brush, context_, *context_.reference_trouble);
    painter->restore();
  }
};

/// Of a whole map, or of the robot's present one.
class MapProblems : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const MapFeatures& features = context_.of(*of());
    painter->save();
    MarkBrush brush(*painter, context_);
    if (features.trouble) paintTrouble(brush, context_, *features.trouble);
    std::vector<MarkBrush::Mark> drawn;
    for (const map::BrokenOverlay& feature : brokenShown()) {
      if (!feature.at_m) continue;
      const QPolygonF shape = shapeOf(context_, {MarkKind::Unreadable, *feature.at_m});
      if (inView(context_.view, shape.boundingRect()))
        drawn.push_back({shape, shape.boundingRect().center(), MarkKind::Unreadable});
    }
    brush.marks(drawn);
    painter->restore();
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    for (const map::BrokenOverlay& feature : brokenShown()) {
      if (feature.at_m) labels.symbol(badgeArea(toPoint(context_.view.pixelFromWorld(*feature.at_m))));
    }
  }

 private:
  std::span<const map::BrokenOverlay> brokenShown() const {
    if (!context_.overlays_shown) return {};
    return context_.of(*of()).broken_overlays;
  }
};

std::vector<LayerItem*> problemItems(const LayerContext& context) {
  // That of the submaps is the first one: the scene puts it on their side of a comparison.
  std::vector<LayerItem*> items = itemForEachMap<MapProblems>(context);
  items.insert(items.begin(), new SubmapProblems(context));
  items.push_back(new ReferenceProblems(context));
  return items;
}

}  // namespace

ObjectId idOf(const ProblemMark& mark) {
  const QString key =
      QStringLiteral("%1 %2 %3")
          .arg(QString::number(mark.at_m.x(), 'g', 17), QString::number(mark.at_m.y(), 'g', 17), mark.title);
  return {Layer::Problems, FeaturesOf::Robot, key.toStdString(), 0};
}

std::optional<Eigen::Vector2d> placeOfMark(const ObjectId& id) {
  if (id.layer != Layer::Problems) return std::nullopt;
  const QStringList words = QString::fromStdString(id.key).split(QLatin1Char(' '));
  return words.size() < 3 ? std::nullopt
                          : std::optional(Eigen::Vector2d(words[0].toDouble(), words[1].toDouble()));
}

MapObject problemObject(const ProblemMark& mark) {
  MapObject object;
  object.id = idOf(mark);
  object.kind = ObjectText::tr("Missing");
  object.name = mark.title;
  object.at_m = mark.at_m;
  object.look = std::int64_t(mark.kind);
  object.properties = Properties().add(ObjectText::tr("Why"), mark.reason);
  if (mark.submap) object.topic = map::topicIndex<map::SubmapList>();
  return object;
}

template <>
LayerSpec layerSpec<Layer::Problems>() {
  return {.name = "problems",
          .title = QT_TRANSLATE_NOOP("scene", "What is missing"),
          .sets = LayerSet::Snapshot,
          .follows_robot = false,
          .shows_submaps = true,
          .why_empty = neverEmpty,
          .items = problemItems,
          .sample = [](LegendSample& sample, ObjectForm, std::int64_t look) {
            sample.context.submap_marks->put({}, {MarkKind(look), LegendSample::at(0, 0)});
          }};
}

}  // namespace mapwright::ui::scene
