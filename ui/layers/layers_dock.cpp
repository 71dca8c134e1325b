#include "ui/layers/layers_dock.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QMenu>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/icons.h"
#include "ui/layers/layer_row.h"
#include "ui/layers/layer_settings.h"

namespace mapwright::window {

using scene::Layer;

LayersDock::LayersDock(scene::MapScene* scene, QWidget* parent)
    : QDockWidget(tr("Layers"), parent),
      scene_(scene),
      scroll_(new QScrollArea(this)),
      body_(new QWidget),
      column_(new QVBoxLayout(body_)) {
  setObjectName(QStringLiteral("layers"));
  column_->setContentsMargins(0, 4, 0, 4);
  column_->setSpacing(0);
  const std::vector<Layer>& order = scene_->layerOrder();
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    auto* row = new LayerRow(scene_, *it, body_);
    rows_.push_back(row);
    connect(row, &LayerRow::dragged, this, [this, row](int y) { drag(row, y); });
    connect(row, &LayerRow::dropped, this, [this] {
      dragging_ = false;
      commit();
    });
    if (const auto stream = scene::chosenStream(*it))
      connect(row, &LayerRow::topicChosen, this,
              [this, stream = *stream](const QString& topic) { chooseTopic(stream, topic); });
    connect(row, &LayerRow::moveWanted, this, [this, row](int rows) { move(row, rows); });
    connect(row, &LayerRow::focusWanted, this, [this, row](int rows) { focusNext(row, rows); });
  }
  place();
  scroll_->setWidget(body_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setMinimumWidth(200);
  setWidget(scroll_);
  connect(scene_, &scene::MapScene::layersChanged, this, &LayersDock::sync);
}

void LayersDock::setSession(session::Session* session) {
  if (session_) session_->robot().disconnect(this);
  session_ = session;
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &LayersDock::noteAvailability);
  }
  noteAvailability();
}

void LayersDock::noteAvailability() {
  for (LayerRow* row : rows_) {
    row->setUnavailable(session_ ? scene::specOf(row->layer()).why_empty(session_->robot()) : QString());
    noteTopics(row);
  }
}

void LayersDock::noteTopics(LayerRow* row) {
  const auto stream = scene::chosenStream(row->layer());
  if (!stream) return;
  robot::OffersTopics* const of = session_ ? robot::topicsOfferedBy(session_->robot()) : nullptr;
  if (!of) return row->setTopics({}, {}, {});
  const robot::TopicChoices chosen = of->chosen();
  const auto own = chosen.find(*stream);
  robot::LiveTopics* const live = session_->robot().liveTopics();
  const QStringList usual = live && own == chosen.end() ? live->topicsOf(*stream) : QStringList();
  row->setTopics(of->choicesFor(*stream), own == chosen.end() ? QString() : own->second, usual.value(0));
}

void LayersDock::chooseTopic(map::Stream stream, const QString& topic) {
  robot::OffersTopics* const of = session_ ? robot::topicsOfferedBy(session_->robot()) : nullptr;
  if (!of) return;
  robot::TopicChoices choices = of->chosen();
  if (topic.isEmpty()) {
    choices.erase(stream);
  } else {
    choices[stream] = topic;
  }
  of->choose(choices);
  noteAvailability();
  Q_EMIT topicsChosen(choices);
}

void LayersDock::place() {
  while (QLayoutItem* item = column_->takeAt(0)) delete item;
  for (LayerRow* row : rows_) column_->addWidget(row);
  column_->addStretch(1);
  for (std::size_t i = 1; i < rows_.size(); ++i) setTabOrder(rows_[i - 1], rows_[i]);
}

void LayersDock::sync() {
  const std::vector<Layer>& order = scene_->layerOrder();
  const bool same = std::equal(rows_.begin(), rows_.end(), order.rbegin(), order.rend(),
                               [](const LayerRow* row, Layer layer) { return row->layer() == layer; });
  if (!same && !dragging_) {
    std::vector<LayerRow*> sorted;
    for (auto it = order.rbegin(); it != order.rend(); ++it) sorted.push_back(row(*it));
    rows_ = std::move(sorted);
    place();
  }
  for (LayerRow* row : rows_) row->sync();
}

void LayersDock::drag(LayerRow* row, int y) {
  dragging_ = true;
  scroll_->ensureVisible(0, y, 0, 36);
  const auto here = std::find(rows_.begin(), rows_.end(), row);
  // It takes the place of the row whose middle it has passed.
  std::size_t target = 0;
  for (LayerRow* other : rows_) {
    if (other == row) continue;
    if (y > other->geometry().center().y() || scene::specOf(other->layer()).order_fixed) ++target;
  }
  if (target == std::size_t(here - rows_.begin())) return;
  rows_.erase(here);
  rows_.insert(rows_.begin() + std::ptrdiff_t(target), row);
  place();
}

void LayersDock::commit() {
  std::vector<Layer> order;
  for (auto it = rows_.rbegin(); it != rows_.rend(); ++it) order.push_back((*it)->layer());
  scene_->setLayerOrder(order);
}

void LayersDock::move(LayerRow* row, int rows) {
  const auto here = std::find(rows_.begin(), rows_.end(), row) - rows_.begin();
  const auto there = here + rows;
  if (there < 0 || there >= std::ptrdiff_t(rows_.size()) || scene::specOf(row->layer()).order_fixed ||
      scene::specOf(rows_[std::size_t(there)]->layer()).order_fixed)
    return;
  std::swap(rows_[std::size_t(here)], rows_[std::size_t(there)]);
  place();
  commit();
  row->setFocus();
  scroll_->ensureWidgetVisible(row, 0, 24);
}

void LayersDock::focusNext(LayerRow* row, int rows) {
  const auto there = std::find(rows_.begin(), rows_.end(), row) - rows_.begin() + rows;
  if (there < 0 || there >= std::ptrdiff_t(rows_.size())) return;
  rows_[std::size_t(there)]->setFocus();
  scroll_->ensureWidgetVisible(rows_[std::size_t(there)], 0, 24);
}

void LayersDock::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(themedIcon(QStringLiteral("reset")), tr("Reset order and styles"), this,
                 [this] { resetOrderAndStyles(*scene_); });
  menu.addAction(tr("Restore the original layers and styles"), this, [this] { resetVisibility(*scene_); });
  menu.exec(event->globalPos());
}

LayerRow* LayersDock::row(Layer layer) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const LayerRow* row) { return row->layer() == layer; });
  return found == rows_.end() ? nullptr : *found;
}

QToolButton* LayersDock::eye(Layer layer) const { return row(layer) ? row(layer)->eye() : nullptr; }
QSlider* LayersDock::opacity(Layer layer) const { return row(layer) ? row(layer)->opacity() : nullptr; }

}  // namespace mapwright::window

#include "moc_layers_dock.cpp"
