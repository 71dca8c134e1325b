#include "ui/layers/layers_dock.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "robot/robot.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/ui_colors.h"
#include "ui/layers/fold_header.h"
#include "ui/layers/layer_row.h"
#include "ui/layers/layer_settings.h"
#include "ui/scene/layer_reason.h"

namespace mapwright::ui {

using scene::Layer;
using scene::LayerGroup;

namespace {

const QString kGroupedKey = QStringLiteral("layers/grouped");
const QString kFoldedKey = QStringLiteral("layers/folded");
const QString kUnavailableKey = QStringLiteral("layers/unavailableOpen");
constexpr int kReasonFromPx = 26;

}  // namespace

LayersDock::LayersDock(scene::MapScene* scene, QWidget* parent)
    : QDockWidget(tr("Layers"), parent),
      scene_(scene),
      unavailable_(nullptr),
      filter_(new QLineEdit(this)),
      in_order_(iconButton(QStringLiteral("list"), 16,
                           tr("One list in the order of painting, the top layer first, without groups"), this,
                           tr("In the order of painting"))),
      presets_(new QToolButton(this)),
      solo_strip_(new QFrame(this)),
      solo_text_(new PlainLabel(solo_strip_)),
      solo_end_(compactButton(tr("Back"), solo_strip_, tr("Show all layers that were shown before"))),
      nothing_(nullptr),
      scroll_(new QScrollArea(this)),
      body_(new QWidget),
      column_(new QVBoxLayout(body_)) {
  setObjectName(QStringLiteral("layers"));
  column_->setContentsMargins(0, 4, 0, 4);
  column_->setSpacing(0);
  makeHead();
  makeRows();
  scroll_->setWidget(body_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setMinimumWidth(200);
  scroll_->setFocusPolicy(Qt::NoFocus);
  auto* const whole = new QWidget(this);
  whole->setLayout(columnOf(
      {rowOf({{filter_, 1}, in_order_, presets_}, 4, QMargins(6, 6, 6, 2)), {scroll_, 1}, solo_strip_}, 0,
      QMargins(0, 0, 0, 0)));
  setWidget(whole);
  layOut();
  connect(scene_, &scene::MapScene::layersChanged, this, &LayersDock::sync);
  updateCounts();
}

void LayersDock::makeHead() {
  filter_->setObjectName(QStringLiteral("filterLayers"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setAccessibleName(tr("Filter layers"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  filter_->setMinimumWidth(60);
  in_order_->setObjectName(QStringLiteral("layersInOrder"));
  in_order_->setCheckable(true);
  presets_->setObjectName(QStringLiteral("layerPresetsButton"));
  presets_->setText(tr("Presets"));
  presets_->setToolTip(tr("Sets of layers to choose from; save your own"));
  presets_->setPopupMode(QToolButton::InstantPopup);
  presets_->setFocusPolicy(Qt::TabFocus);
  presets_->hide();
  solo_text_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  solo_text_->setSample(QStringLiteral("xxxx"));
  solo_strip_->setObjectName(QStringLiteral("soloStrip"));
  solo_strip_->setLayout(rowOf({{solo_text_, 1}, solo_end_}, 6, QMargins(8, 2, 6, 2)));
  solo_strip_->hide();
  connect(filter_, &QLineEdit::textChanged, this, &LayersDock::layOut);
  connect(in_order_, &QToolButton::toggled, this, [this](bool on) { setGrouped(!on); });
  connect(solo_end_, &QPushButton::clicked, this, &LayersDock::endSolo);
}

void LayersDock::makeRows() {
  const auto header = [this](const QString& title, const QString& name) {
    auto* const made = new FoldHeader(title, body_);
    made->setObjectName(QStringLiteral("group-") + name);
    connect(made, &FoldHeader::foldWanted, this, [this, made](bool open) { fold(made, open); });
    connect(made, &FoldHeader::focusWanted, this, [this, made](int rows) { focusNext(made, rows); });
    return made;
  };
  for (const LayerGroup group : scene::kLayerGroups)
    headers_[group] = header(scene::groupTitle(group), scene::groupName(group));
  unavailable_ = header({}, QStringLiteral("unavailable"));
  unavailable_->setOpen(false);
  nothing_ = wrappedLabel({}, body_);
  nothing_->setTextFormat(Qt::PlainText);
  nothing_->setMargin(8);
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
    connect(row, &LayerRow::soloWanted, this, [this, row] { toggleSolo(row->layer()); });
  }
}

void LayersDock::setPresets(QMenu* menu) {
  presets_->setMenu(menu);
  presets_->show();
}

void LayersDock::setSession(session::Session* session) {
  if (session_) session_->robot().disconnect(this);
  session_ = session;
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &LayersDock::updateAvailability);
  }
  updateAvailability();
}

void LayersDock::updateAvailability() {
  bool changed = false;
  for (LayerRow* row : rows_) {
    const QString reason = session_ ? scene::whyEmpty(row->layer(), session_->robot()) : QString();
    changed |= reason != row->unavailable();
    row->setUnavailable(reason);
    updateTopics(row);
  }
  if (!changed) return;
  layOut();
  updateCounts();
}

void LayersDock::updateTopics(LayerRow* row) {
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
  updateAvailability();
  Q_EMIT topicsChosen(choices);
}

bool LayersDock::fits(const LayerRow& row) const {
  const QString wanted = filter_->text().trimmed();
  const auto says = [&](const QString& text) { return text.contains(wanted, Qt::CaseInsensitive); };
  return wanted.isEmpty() || says(scene::layerTitle(row.layer())) || says(scene::layerName(row.layer()));
}

void LayersDock::put(QWidget* widget) {
  column_->addWidget(widget);
  laid_out_.insert(widget);
  if (widget->focusPolicy() & Qt::TabFocus) steps_.push_back(widget);
}

void LayersDock::layOut() {
  while (QLayoutItem* item = column_->takeAt(0)) delete item;
  steps_.clear();
  laid_out_.clear();
  const bool filtered = !filter_->text().trimmed().isEmpty();
  const auto belongs = [&](const LayerRow* row, LayerGroup group) {
    return row->unavailable().isEmpty() && fits(*row) &&
           (!grouped_ || scene::specOf(row->layer()).group == group);
  };
  for (const auto& [group, header] : headers_) {
    const auto in_it = [&, of = group](const LayerRow* row) { return belongs(row, of); };
    const bool any = std::any_of(rows_.begin(), rows_.end(), in_it);
    if (grouped_ && any) put(header);
    // What was looked for is not hidden.
    for (LayerRow* const row : rows_) {
      if (in_it(row) && (!grouped_ || filtered || header->open())) put(row);
    }
    if (!grouped_) break;
  }
  layOutUnavailable();
  nothing_->setText(tr("There is no layer called “%1”.").arg(filter_->text().trimmed()));
  if (steps_.empty()) put(nothing_);
  column_->addStretch(1);
  for (QWidget* const row : rows_) row->setVisible(laid_out_.contains(row));
  for (const auto& [group, header] : headers_) header->setVisible(laid_out_.contains(header));
  unavailable_->setVisible(laid_out_.contains(unavailable_));
  nothing_->setVisible(laid_out_.contains(nothing_));
  orderTabsAsLaidOut(*widget());
}

void LayersDock::layOutUnavailable() {
  for (QLabel* const label : reasons_) delete label;
  reasons_.clear();
  std::vector<LayerRow*> lacking;
  std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(lacking),
               [this](const LayerRow* row) { return !row->unavailable().isEmpty() && fits(*row); });
  if (lacking.empty()) return;
  const bool files = session_ && session_->robot().unavailableReason(robot::Capability::Live).reason ==
                                     robot::Absence::Reason::LocalFiles;
  const bool one_file = files && session_->robot().liveTopics();  // a map has several
  const auto count = qint64(lacking.size());
  const int form = sentences::formOf(count);
  unavailable_->setTitle(
      sentences::counted(one_file ? tr("%1 layers that this file has no data for", nullptr, form)
                         : files  ? tr("%1 layers that these files have no data for", nullptr, form)
                                  : tr("%1 layers that this robot has no data for", nullptr, form),
                         count));
  put(unavailable_);
  if (!unavailable_->open() && filter_->text().trimmed().isEmpty()) return;
  // Many have the same reason: it is said once.
  std::vector<QString> told;
  for (const LayerRow* const one : lacking) {
    const QString reason = one->unavailable();
    if (std::find(told.begin(), told.end(), reason) != told.end()) continue;
    told.push_back(reason);
    QLabel* const label = wrappedLabel(reason, body_);
    label->setTextFormat(Qt::PlainText);
    label->setContentsMargins(kReasonFromPx, 4, 8, 2);
    setTextColor(*label, appColors().secondary_text);
    reasons_.push_back(label);
    put(label);
    label->show();
    for (LayerRow* const row : lacking) {
      if (row->unavailable() == reason) put(row);
    }
  }
}

QStringList LayersDock::reasonsShown() const {
  QStringList texts;
  for (const QLabel* const label : reasons_) texts << label->text();
  return texts;
}

void LayersDock::updateCounts() {
  for (const auto& [group, header] : headers_) {
    int all = 0, shown = 0;
    for (const LayerRow* const row : rows_) {
      if (scene::specOf(row->layer()).group != group || !row->unavailable().isEmpty()) continue;
      ++all;
      shown += scene_->layerVisible(row->layer());
    }
    header->setNote(tr("%1 of %2").arg(shown).arg(all));
  }
}

void LayersDock::sync() {
  const std::vector<Layer>& order = scene_->layerOrder();
  const bool same = std::equal(rows_.begin(), rows_.end(), order.rbegin(), order.rend(),
                               [](const LayerRow* row, Layer layer) { return row->layer() == layer; });
  if (!same && !dragging_) {
    std::vector<LayerRow*> sorted;
    for (auto it = order.rbegin(); it != order.rend(); ++it) sorted.push_back(row(*it));
    rows_ = std::move(sorted);
    layOut();
  }
  for (LayerRow* row : rows_) row->sync();
  updateCounts();
}

void LayersDock::setGrouped(bool grouped) {
  if (grouped == grouped_) return;
  grouped_ = grouped;
  in_order_->setChecked(!grouped);
  layOut();
}

void LayersDock::setFolded(bool folded) {
  for (const auto& [group, header] : headers_) header->setOpen(!folded);
  layOut();
}

void LayersDock::fold(FoldHeader* header, bool open) {
  if (header->open() == open) return;
  header->setOpen(open);
  layOut();
}

std::vector<LayerRow*> LayersDock::peers(const LayerRow* row) const {
  std::vector<LayerRow*> found;
  for (LayerRow* const other : rows_) {
    if (!laid_out_.contains(other) || !other->unavailable().isEmpty()) continue;
    if (!grouped_ || scene::specOf(other->layer()).group == scene::specOf(row->layer()).group)
      found.push_back(other);
  }
  return found;
}

// It comes to lie next to the one that it has passed: the order of all others stays.
void LayersDock::putAt(LayerRow* row, std::size_t index_among_peers) {
  std::vector<LayerRow*> others = peers(row);
  const auto own = std::find(others.begin(), others.end(), row);
  const auto before = std::size_t(own - others.begin());
  if (own == others.end() || index_among_peers == before || index_among_peers >= others.size()) return;
  LayerRow* const passed = others[index_among_peers];
  rows_.erase(std::find(rows_.begin(), rows_.end(), row));
  const auto at = std::find(rows_.begin(), rows_.end(), passed);
  rows_.insert(index_among_peers > before ? at + 1 : at, row);
  layOut();
}

void LayersDock::drag(LayerRow* row, int y) {
  dragging_ = true;
  scroll_->ensureVisible(0, y, 0, 36);
  // It takes the position of the row whose middle it has passed.
  std::size_t target = 0;
  for (const LayerRow* const other : peers(row)) {
    if (other == row) continue;
    if (y > other->geometry().center().y() || scene::specOf(other->layer()).order_fixed) ++target;
  }
  putAt(row, target);
}

void LayersDock::commit() {
  std::vector<Layer> order;
  for (auto it = rows_.rbegin(); it != rows_.rend(); ++it) order.push_back((*it)->layer());
  scene_->setLayerOrder(order);
}

void LayersDock::move(LayerRow* row, int rows) {
  const std::vector<LayerRow*> others = peers(row);
  const auto there = std::find(others.begin(), others.end(), row) - others.begin() + rows;
  if (there < 0 || there >= std::ptrdiff_t(others.size()) || scene::specOf(row->layer()).order_fixed ||
      scene::specOf(others[std::size_t(there)]->layer()).order_fixed)
    return;
  putAt(row, std::size_t(there));
  commit();
  row->setFocus();
  scroll_->ensureWidgetVisible(row, 0, 24);
}

void LayersDock::focusNext(QWidget* from, int rows) {
  const auto there = std::find(steps_.begin(), steps_.end(), from) - steps_.begin() + rows;
  if (there < 0 || there >= std::ptrdiff_t(steps_.size())) return;
  steps_[std::size_t(there)]->setFocus();
  scroll_->ensureWidgetVisible(steps_[std::size_t(there)], 0, 24);
}

void LayersDock::toggleSolo(Layer layer) {
  if (solo_ && solo_->layer == layer) return endSolo();
  if (!solo_) {
    solo_.emplace();
    for (const Layer each : scene::allLayers()) {
      if (scene_->layerVisible(each)) solo_->before.insert(each);
    }
  }
  solo_->layer = layer;
  scene_->setLayersVisible({layer});
  updateSolo();
}

std::optional<Layer> LayersDock::solo() const { return solo_ ? std::optional(solo_->layer) : std::nullopt; }

void LayersDock::endSolo() {
  if (!solo_) return;
  const std::set<Layer> before = solo_->before;
  forgetSolo();
  scene_->setLayersVisible(before);
}

void LayersDock::forgetSolo() {
  solo_.reset();
  updateSolo();
}

void LayersDock::updateSolo() {
  if (solo_) solo_text_->setText(tr("Only: %1").arg(scene::layerTitle(solo_->layer)));
  solo_strip_->setVisible(solo_.has_value());
}

void LayersDock::fillMenu(QMenu& menu, std::optional<Layer> layer) {
  menu.setToolTipsVisible(true);
  if (layer && row(*layer)->unavailable().isEmpty()) {
    const bool alone = solo() == layer;
    QAction* const only =
        menu.addAction(alone ? tr("Show what was shown before") : tr("Show only this layer"), this,
                       [this, layer = *layer] { toggleSolo(layer); });
    only->setObjectName(QStringLiteral("soloLayer"));
    QAction* const zoom = menu.addAction(themedIcon(QStringLiteral("fit")), tr("Zoom to this layer"), this,
                                         [this, layer = *layer] { Q_EMIT zoomWanted(layer); });
    zoom->setObjectName(QStringLiteral("zoomToLayer"));
    allow(zoom, !scene_->layerBounds(*layer).empty(),
          scene_->layerVisible(*layer) ? tr("Nothing in this layer has a position")
                                       : tr("Its content is unknown while it is hidden"));
    menu.addSeparator();
  }
  QAction* const groups = menu.addAction(tr("In groups"), this, [this](bool on) { setGrouped(on); });
  groups->setCheckable(true);
  groups->setChecked(grouped_);
  if (grouped_) {
    menu.addAction(tr("Fold all groups"), this, [this] { setFolded(true); });
    menu.addAction(tr("Unfold all groups"), this, [this] { setFolded(false); });
  }
  menu.addSeparator();
  menu.addAction(themedIcon(QStringLiteral("reset")), tr("Reset order and styles"), this,
                 [this] { resetOrderAndStyles(*scene_); });
  menu.addAction(tr("Show the original layers"), this, [this] {
    forgetSolo();
    resetVisibility(*scene_);
  });
}

void LayersDock::contextMenuEvent(QContextMenuEvent* event) {
  std::optional<Layer> layer;
  for (QWidget* at = childAt(event->pos()); at && at != this; at = at->parentWidget()) {
    if (const auto* const of = qobject_cast<LayerRow*>(at)) layer = of->layer();
  }
  QMenu menu(this);
  fillMenu(menu, layer);
  menu.exec(event->globalPos());
}

void LayersDock::saveFolds(QSettings& settings) const {
  QStringList folded;
  for (const auto& [group, header] : headers_) {
    if (!header->open()) folded << scene::groupName(group);
  }
  settings.setValue(kFoldedKey, folded);
  settings.setValue(kGroupedKey, grouped_);
  settings.setValue(kUnavailableKey, unavailable_->open());
}

void LayersDock::restoreFolds(const QSettings& settings) {
  const QStringList folded = settings.value(kFoldedKey).toStringList();
  for (const auto& [group, header] : headers_) header->setOpen(!folded.contains(scene::groupName(group)));
  unavailable_->setOpen(settings.value(kUnavailableKey, false).toBool());
  setGrouped(settings.value(kGroupedKey, true).toBool());
  layOut();
}

void LayersDock::resetFolds() {
  filter_->clear();
  for (const auto& [group, header] : headers_) header->setOpen(true);
  unavailable_->setOpen(false);
  setGrouped(true);
  layOut();
}

LayerRow* LayersDock::row(Layer layer) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const LayerRow* row) { return row->layer() == layer; });
  return found == rows_.end() ? nullptr : *found;
}

QToolButton* LayersDock::eye(Layer layer) const { return row(layer) ? row(layer)->eye() : nullptr; }
QSlider* LayersDock::opacity(Layer layer) const { return row(layer) ? row(layer)->opacity() : nullptr; }

}  // namespace mapwright::ui

#include "moc_layers_dock.cpp"
