#include "ui/layers/legend_dock.h"

#include <utility>

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "session/layer_grids.h"
#include "ui/kit/forms.h"

namespace mapwright::ui {

namespace {

constexpr int kScaleFrom = 4;  // a symbol that is so much wider than high

QLabel* symbolOf(const QImage& image, QWidget* parent) {
  auto* const symbol = new QLabel(parent);
  symbol->setPixmap(QPixmap::fromImage(image));
  symbol->setFixedSize((QSizeF(image.size()) / image.devicePixelRatio()).toSize());
  return symbol;
}

QLabel* wordsOf(const QString& text, QWidget* parent) {
  QLabel* const label = wrappedLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QWidget* lineOf(const scene::LegendRow& row, QWidget* parent) {
  constexpr QMargins kNone(0, 0, 0, 0);
  auto* const line = new QWidget(parent);
  QLabel* const symbol = symbolOf(row.symbol, line);
  const bool scale = !row.low.isEmpty() || !row.high.isEmpty();
  if (scale) {
    auto* const ends = new QWidget(line);
    ends->setFixedWidth(symbol->width());
    ends->setLayout(
        rowOf({new QLabel(row.low, ends), LayoutItem::rest(), new QLabel(row.high, ends)}, 4, kNone));
    line->setLayout(columnOf({symbol, ends}, 1, kNone));
  } else if (row.symbol.width() > row.symbol.height() * kScaleFrom) {
    line->setLayout(columnOf({symbol, wordsOf(row.text, line)}, 1, kNone));
  } else {
    line->setLayout(rowOf({symbol, {wordsOf(row.text, line), 1}}, 8, kNone));
  }
  line->setAccessibleName(scale ? LegendDock::tr("%1 to %2").arg(row.low, row.high) : row.text);
  return line;
}

}  // namespace

LegendDock::LegendDock(scene::MapScene* scene, QWidget* parent)
    : QDockWidget(tr("Legend"), parent), scene_(scene), scroll_(new QScrollArea(this)) {
  setObjectName(QStringLiteral("legend"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setMinimumWidth(200);
  scroll_->setAccessibleName(tr("Legend"));
  setWidget(scroll_);
  connect(scene_, &scene::MapScene::layersChanged, this, &LegendDock::refreshSoon);
  connect(scene_, &scene::MapScene::contentChanged, this, &LegendDock::refreshSoon);
  connect(this, &QDockWidget::visibilityChanged, this, &LegendDock::refreshSoon);
}

void LegendDock::setSession(session::Session* session) {
  if (session_) {
    session_->robot().disconnect(this);
    session_->layerGrids().disconnect(this);
  }
  session_ = session;
  grids_.clear();
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &LegendDock::refreshSoon);
    connect(&session->layerGrids(), &session::LayerGrids::changed, this, &LegendDock::updateGrid);
  }
  refreshSoon();
}

void LegendDock::updateGrid(map::GridKind kind) {
  const session::LayerGrid* const grid = session_ ? session_->layerGrids().find(kind) : nullptr;
  if (!grid) return;
  const std::pair meaning(grid->picture.palette.empty(), grid->picture.indices->code());
  const auto [known, first] = grids_.try_emplace(kind, meaning);
  if (!first && std::exchange(known->second, meaning) == meaning) return;
  refreshSoon();
}

void LegendDock::changeEvent(QEvent* event) {
  QDockWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) refreshSoon();
}

void LegendDock::refreshSoon() {
  if (due_ || !isVisible()) return;
  due_ = true;
  QMetaObject::invokeMethod(this, &LegendDock::refresh, Qt::QueuedConnection);
}

void LegendDock::refresh() {
  due_ = false;
  if (!isVisible()) return;
  std::vector<scene::LegendSection> now = scene_->legend(devicePixelRatioF());
  if (made_ && now == shown_) return;
  made_ = true;
  shown_ = std::move(now);
  auto* const body = new QWidget;
  auto* const column = new QVBoxLayout(body);
  column->setContentsMargins(10, 8, 8, 8);
  column->setSpacing(4);
  for (const scene::LegendSection& section : shown_) {
    auto* const title = new QLabel(section.title, body);
    title->setTextFormat(Qt::PlainText);
    makeHeading(*title);
    if (column->count() > 0) column->addSpacing(6);
    column->addWidget(title);
    for (const scene::LegendRow& row : section.rows) column->addWidget(lineOf(row, body));
  }
  if (shown_.empty())
    column->addWidget(wrappedLabel(tr("No visible layer has colours or shapes to explain."), body));
  column->addStretch(1);
  scroll_->setWidget(body);
}

}  // namespace mapwright::ui

#include "moc_legend_dock.cpp"
