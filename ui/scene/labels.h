// The labels of all layers: collected, placed by label_plan.h, drawn above them. Private to this room.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_set>
#include <vector>

#include <QColor>
#include <QGraphicsItem>
#include <QHash>
#include <QString>

#include "geometry/view_transform.h"
#include "ui/scene/label_ink.h"
#include "ui/scene/label_plan.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui::scene {

class LayerItem;
struct LayerContext;

/// What one item wants to be labelled, and the symbols that no label may cover.
class LabelCollector {
 public:
  LabelCollector(LabelInk& ink, const MapTheme& theme, const geometry::ViewTransform& view,
                 std::uint64_t owner);

  /// Labels of other areas are not shown.
  const QRectF& area() const { return area_; }
  const MapTheme& theme() const { return theme_; }
  /// The view is close enough for every name that has room.
  bool isClose() const;
  /// Whether what lies here is to be named: farther away only the first ones in view are, besides what was
  /// chosen.
  bool named(const QRectF& mark) const;

  /// `id` tells the object from all others of this item, in every frame.
  void add(LabelWish::Position position, LabelRank rank, const QRectF& mark, std::uint64_t id,
           const QString& text, const QColor& color, bool struck_through = false);
  void symbol(const QRectF& mark);
  /// The text has room in the mark.
  bool fits(const QString& text, const QRectF& mark) const;

 private:
  friend class Labels;
  struct Look {
    QString text;
    QColor color;
    bool struck_through = false;
    bool operator==(const Look&) const = default;
  };

  QSizeF sizeOf(const QString& text) const;

  LabelInk& ink_;
  const MapTheme& theme_;
  QRectF view_, area_;
  double scale_m_per_px_;
  std::uint64_t owner_;
  std::unordered_set<std::uint64_t> keys_;
  std::vector<LabelWish> wishes_;
  std::vector<Look> looks_;
  std::vector<QRectF> symbols_;
};

/// GUI thread.
class Labels {
 public:
  /// A label in its position.
  struct Drawn {
    QRectF box;
    QString text;
    QColor color;
    bool struck_through = false;
    double opacity = 1;
    std::optional<QRectF> part;  // of the viewport: the rest is cut off
    std::optional<QLineF> leader;
    bool over = false;  // of something above the veil
    bool operator==(const Drawn&) const = default;
    /// The pixels that it may touch.
    QRectF reach() const;
  };

  /// `remembers` false: every plan is made as if it were the first.
  explicit Labels(bool remembers) : remembers_(remembers) {}

  /// An item must be asked again; null: all of them.
  void changed(const LayerItem* item);
  void viewMoved() { due_ = true; }
  bool due() const { return due_; }
  /// Asks the items (the first ones first) that have changed, and places the labels. Returns where the
  /// picture is another one.
  std::vector<QRectF> place(const LayerContext& context, const std::vector<LayerItem*>& items,
                            const std::vector<LayerItem*>& over);
  /// By their keys.
  const std::map<std::uint64_t, Drawn>& drawn() const { return by_key_; }
  LabelInk& ink() const { return ink_; }

 private:
  bool onlyPanned(const geometry::ViewTransform& view) const;

  bool remembers_, due_ = true, data_changed_ = true;
  mutable LabelInk ink_;
  std::map<const LayerItem*, std::optional<LabelCollector>> asked_;
  std::optional<geometry::ViewTransform> view_;  // when they were placed
  LabelTask task_;
  LabelMemory memory_;
  std::vector<PlacedLabel> placed_;
  std::map<std::uint64_t, Drawn> by_key_;
};

/// Draws them: those below the veil over what is no longer live, or those above.
class LabelsItem : public QGraphicsItem {
 public:
  LabelsItem(const LayerContext& context, const Labels& labels, bool over);
  QRectF boundingRect() const override;
  void viewportResized() { prepareGeometryChange(); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const LayerContext& context_;
  const Labels& labels_;
  bool over_;
};

}  // namespace mapwright::ui::scene
