#include "ui/scene/labels.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QStyleOptionGraphicsItem>

#include "ui/scene/layer_item.h"

namespace mapwright::ui::scene {

LabelCollector::LabelCollector(LabelInk& ink, const MapTheme& theme, const geometry::ViewTransform& view,
                               std::uint64_t owner)
    : ink_(ink),
      theme_(theme),
      view_(0, 0, view.width_px, view.height_px),
      area_(view_.adjusted(-kLabelMarginPx, -kLabelMarginPx, kLabelMarginPx, kLabelMarginPx)),
      scale_m_per_px_(view.scale_m_per_px),
      owner_(owner) {}

bool LabelCollector::isClose() const { return scale_m_per_px_ <= kNameFromMPerPx; }

bool LabelCollector::named(const QRectF& mark) const {
  constexpr std::size_t kMostFarAway = 100;  // of thousands of them
  if (isClose()) return area_.intersects(mark);
  return wishes_.size() < kMostFarAway && view_.intersects(mark);
}

void LabelCollector::add(LabelWish::Position position, LabelRank rank, const QRectF& mark, std::uint64_t id,
                         const QString& text, const QColor& color, bool struck_through) {
  if (text.isEmpty() || !isFinite(mark) || !area_.intersects(mark.adjusted(-1, -1, 1, 1))) return;
  const QSizeF size = sizeOf(text);
  // Ids of robots are not always unique.
  std::uint64_t key = qHashMulti(owner_, id);
  while (!keys_.insert(key).second) ++key;
  wishes_.push_back({key, rank, position, mark, size});
  looks_.push_back({text, color, struck_through});
}

// One pixel for the halo on each side.
QSizeF LabelCollector::sizeOf(const QString& text) const { return ink_.sizeOf(text, theme_) + QSizeF(2, 0); }

bool LabelCollector::fits(const QString& text, const QRectF& mark) const {
  const QSizeF size = sizeOf(text);
  return size.width() <= mark.width() && size.height() <= mark.height();
}

void LabelCollector::symbol(const QRectF& mark) {
  if (isFinite(mark) && area_.intersects(mark)) symbols_.push_back(mark);
}

QRectF Labels::Drawn::reach() const {
  QRectF reach = box.adjusted(-4, -4, 4, 4);
  if (leader) reach |= QRectF(leader->p1(), leader->p2()).normalized().adjusted(-3, -3, 3, 3);
  return reach;
}

void Labels::changed(const LayerItem* item) {
  due_ = true;
  data_changed_ |= !item || item->labelUse() == LabelUse::Names;
  if (!item) {
    asked_.clear();
  } else {
    asked_.erase(item);
  }
}

bool Labels::onlyPanned(const geometry::ViewTransform& view) const {
  if (!view_) return false;
  geometry::ViewTransform there = view;
  there.center_m = view_->center_m;
  return there == *view_;
}

std::vector<QRectF> Labels::place(const LayerContext& context, const std::vector<LayerItem*>& items,
                                  const std::vector<LayerItem*>& over) {
  due_ = false;
  LabelTask task;
  task.view = QRectF(0, 0, context.view.width_px, context.view.height_px);
  task.steady = onlyPanned(context.view);
  task.panned = task.steady && !data_changed_;
  task.symbols = context.covered;
  if (context.covered_top_px > 0)
    task.symbols.emplace_back(0, 0, context.view.width_px, context.covered_top_px);
  if (view_ != context.view) asked_.clear();
  data_changed_ = false;
  struct Origin {
    const LayerItem* item;
    const LabelCollector::Look* look;
    bool over;
  };
  std::vector<Origin> origins;
  std::uint64_t owner = 0;
  const auto ask = [&](const LayerItem* item, bool is_over) {
    ++owner;  // of hidden ones, too: the others keep theirs
    if (item->labelUse() == LabelUse::None || !item->isVisible()) return;
    std::optional<LabelCollector>& asked = asked_[item];
    if (!asked) {
      asked.emplace(ink_, context.theme, context.view, owner);
      item->collectLabels(*asked);
    }
    // What lies on the other half of a comparison is not drawn.
    const auto& part = item->part();
    for (std::size_t i = 0; i < asked->wishes_.size(); ++i) {
      if (part && !part->contains(asked->wishes_[i].mark.center())) continue;
      task.wishes.push_back(asked->wishes_[i]);
      origins.push_back({item, &asked->looks_[i], is_over});
    }
    std::copy_if(asked->symbols_.begin(), asked->symbols_.end(), std::back_inserter(task.symbols),
                 [&part](const QRectF& symbol) { return !part || part->intersects(symbol); });
  };
  for (const LayerItem* item : items) ask(item, false);
  for (const LayerItem* item : over) ask(item, true);

  if (view_ != context.view || !(task == task_)) {
    LabelPlan plan = placeLabels(task, remembers_ ? memory_ : LabelMemory());
    memory_ = std::move(plan.memory);
    placed_ = std::move(plan.labels);
  }
  view_ = context.view;

  std::map<std::uint64_t, Drawn> now;
  for (const PlacedLabel& label : placed_) {
    const Origin& origin = origins[label.wish];
    now[task.wishes[label.wish].key] = {label.box,
                                        origin.look->text,
                                        origin.look->color,
                                        origin.look->struck_through,
                                        origin.item->opacity(),
                                        origin.item->part(),
                                        label.leader,
                                        origin.over};
  }
  task_ = std::move(task);
  std::vector<QRectF> different;
  for (const auto& [key, label] : by_key_) {
    const auto still = now.find(key);
    if (still == now.end() || !(still->second == label)) different.push_back(label.reach());
  }
  for (const auto& [key, label] : now) {
    const auto before = by_key_.find(key);
    if (before == by_key_.end() || !(before->second == label)) different.push_back(label.reach());
  }
  by_key_ = std::move(now);
  return different;
}

LabelsItem::LabelsItem(const LayerContext& context, const Labels& labels, bool over)
    : context_(context), labels_(labels), over_(over) {
  setFlag(ItemUsesExtendedStyleOption);
  setAcceptedMouseButtons(Qt::NoButton);
}

QRectF LabelsItem::boundingRect() const {
  return {0, 0, qreal(context_.view.width_px), qreal(context_.view.height_px)};
}

void LabelsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const qreal opacity = painter->opacity();
  for (const auto& [key, label] : labels_.drawn()) {
    if (label.over != over_ || !label.reach().intersects(option->exposedRect)) continue;
    painter->setOpacity(opacity * label.opacity);
    if (label.part) {
      painter->save();
      painter->setClipRect(*label.part, Qt::IntersectClip);
    }
    if (label.leader) {
      painter->setRenderHint(QPainter::Antialiasing);
      for (const auto& [color, width] :
           {std::pair(context_.theme.text_halo, 3.0), std::pair(label.color, 1.0)}) {
        painter->setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
        painter->drawLine(*label.leader);
      }
    }
    labels_.ink().draw(*painter, label.box.topLeft() + QPointF(1, 0), label.text, context_.theme, label.color,
                       label.struck_through);
    if (label.part) painter->restore();
  }
  painter->setOpacity(opacity);
}

}  // namespace mapwright::ui::scene
