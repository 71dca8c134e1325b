#include "ui/clouds/section_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/kit/plot_ticks.h"
#include "ui/kit/ui_colors.h"
#include "ui/scene/drawing.h"

namespace mapwright::ui {
namespace {

constexpr int kLeftPx = 52, kBottomPx = 22, kTopPx = 6, kRightPx = 8;
constexpr double kReachPx = 8, kEdgePx = 6, kStepPx = 40, kMarginPx = 12;

render::RasterTiles::Options options(std::shared_ptr<work::Workers> workers) {
  render::RasterTiles::Options made;
  made.workers = std::move(workers);
  made.budget = std::make_shared<render::TileBudget>();
  made.budget->bytes = std::size_t(24) << 20;
  return made;
}

}  // namespace

SectionView::SectionView(std::shared_ptr<work::Workers> workers, QWidget* parent)
    : QWidget(parent), tiles_(options(std::move(workers))) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Section of the cloud"));
  setCursor(Qt::CrossCursor);
  connect(&tiles_, &render::PaintedTiles::tilesChanged, this, [this] { update(); });
}

QRect SectionView::field() const {
  return {kLeftPx, kTopPx, std::max(1, width() - kLeftPx - kRightPx),
          std::max(1, height() - kTopPx - kBottomPx)};
}

void SectionView::showSection(std::shared_ptr<const clouds::Section> section, render::TilePainter painter) {
  const bool other = !section || !section_ || section->cut.from_m != section_->cut.from_m ||
                     section->cut.to_m != section_->cut.to_m;
  section_ = std::move(section);
  tiles_.setPainter(std::move(painter));
  if (other) moved_ = false;
  if (!moved_) fit();
  reading_.reset();
  Q_EMIT readingChanged();
  update();
}

void SectionView::fit() {
  moved_ = false;
  geometry::ViewTransform next = view_;
  const QRect room = field();
  next.width_px = room.width();
  next.height_px = room.height();
  if (section_) {
    geometry::WorldRect all;
    const bool empty = section_->low_m > section_->high_m;
    all.extend(Eigen::Vector2d(0, empty ? 0 : section_->low_m));
    all.extend(
        Eigen::Vector2d((section_->cut.to_m - section_->cut.from_m).norm(), empty ? 1 : section_->high_m));
    next = next.fitted(all, kMarginPx);
  } else if (!bands_.empty()) {
    geometry::WorldRect all;
    for (const SectionBand& band : bands_) {
      all.extend(Eigen::Vector2d(0, band.low_m));
      all.extend(Eigen::Vector2d(0, band.high_m));
    }
    next = next.fitted(all, kMarginPx);
  }
  setView(next);
}

void SectionView::setBands(std::vector<SectionBand> bands) {
  if (bands == bands_) return;
  if (bands.size() != bands_.size()) held_edge_.reset();
  bands_ = std::move(bands);
  // Without a cloud they are all there is to see; but not while one of them is dragged.
  if (!section_ && !moved_ && !held_edge_) return fit();
  update();
}

std::optional<BandEdge> SectionView::edgeAt(const QPointF& px) const {
  if (!field().contains(px.toPoint())) return std::nullopt;
  return edgeNear(bands_, placeAt(px).y(), kEdgePx * view_.scale_m_per_px);
}

void SectionView::setView(const geometry::ViewTransform& view) {
  view_ = view;
  sendView();
  update();
}

void SectionView::sendView() {
  const double ratio = devicePixelRatioF();
  geometry::ViewTransform device = view_;
  device.scale_m_per_px /= ratio;
  device.width_px = int(std::ceil(view_.width_px * ratio));
  device.height_px = int(std::ceil(view_.height_px * ratio));
  tiles_.setView(device);
}

Eigen::Vector2d SectionView::placeAt(const QPointF& px) const {
  return view_.worldFromPixel({px.x() - field().left(), px.y() - field().top()});
}

QPointF SectionView::pxOf(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d px = view_.pixelFromWorld(place);
  return {px.x() + field().left(), px.y() + field().top()};
}

void SectionView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!moved_) return fit();
  geometry::ViewTransform next = view_;
  next.width_px = field().width();
  next.height_px = field().height();
  setView(next);
}

void SectionView::wheelEvent(QWheelEvent* event) {
  if (!section_ && bands_.empty()) return QWidget::wheelEvent(event);
  const QPointF at = event->position() - field().topLeft();
  moved_ = true;
  setView(view_.zoomedAt({at.x(), at.y()}, std::pow(1.2, event->angleDelta().y() / 120.0)));
  read(event->position());
  event->accept();
}

void SectionView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  held_edge_ = edgeAt(event->position());
  if (!held_edge_) grabbed_ = event->position();
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
  if (held_edge_ && held_edge_->at < bands_.size()) {
    const SectionBand to =
        withEdgeAt(bands_[held_edge_->at], held_edge_->low, placeAt(event->position()).y());
    Q_EMIT bandMoved(to.index, to.low_m, to.high_m);
  }
  setCursor(held_edge_ || edgeAt(event->position()) ? Qt::SizeVerCursor : Qt::CrossCursor);
  if (grabbed_ && (section_ || !bands_.empty())) {
    const QPointF step = event->position() - *grabbed_;
    grabbed_ = event->position();
    if (!step.isNull()) {
      moved_ = true;
      setView(view_.pannedBy({step.x(), step.y()}));
    }
  }
  read(event->position());
}

void SectionView::mouseReleaseEvent(QMouseEvent*) {
  grabbed_.reset();
  held_edge_.reset();
}

void SectionView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void SectionView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (!reading_) return;
  reading_.reset();
  Q_EMIT readingChanged();
  update();
}

/// Some keys of the section are also used by the map's menu: with the focus here they belong to the section.
bool SectionView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    constexpr std::array kOwn{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,    Qt::Key_Down,
                              Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_F};
    const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (plain && std::find(kOwn.begin(), kOwn.end(), key->key()) != kOwn.end()) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void SectionView::keyPressEvent(QKeyEvent* event) {
  const auto pan = [this](double x, double y) {
    moved_ = true;
    setView(view_.pannedBy({x, y}));
  };
  const auto zoom = [this](double factor) {
    moved_ = true;
    setView(view_.zoomedAt({view_.width_px / 2.0, view_.height_px / 2.0}, factor));
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return pan(kStepPx, 0);
    case Qt::Key_Right:
      return pan(-kStepPx, 0);
    case Qt::Key_Up:
      return pan(0, kStepPx);
    case Qt::Key_Down:
      return pan(0, -kStepPx);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(1.2);
    case Qt::Key_Minus:
      return zoom(1 / 1.2);
    case Qt::Key_F:
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

void SectionView::read(const QPointF& px) {
  reading_.reset();
  if (section_ && field().contains(px.toPoint())) {
    const Eigen::Vector2d at = placeAt(px);
    reading_ = Reading{at, clouds::nearestIn(*section_, at, kReachPx * view_.scale_m_per_px)};
  }
  Q_EMIT readingChanged();
  update();
}

void SectionView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const UiColors colors = appColors();
  const QRect room = field();
  painter.fillRect(rect(), colors.window);
  painter.fillRect(room, colors.base);
  paintAxes(painter);
  painter.save();
  painter.setClipRect(room);
  const double ratio = devicePixelRatioF();
  painter.translate(room.topLeft());
  painter.scale(1 / ratio, 1 / ratio);
  scene::drawRaster(painter, QRectF(0, 0, std::ceil(room.width() * ratio), std::ceil(room.height() * ratio)),
                    tiles_.drawing());
  painter.restore();
  paintBands(painter);
  painter.setPen(hasFocus() ? colors.focus : colors.border);
  painter.drawRect(room.adjusted(0, 0, -1, -1));
  if (reading_ && reading_->nearest) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.text, 1.5));
    painter.drawEllipse(pxOf(*reading_->nearest), 5, 5);
  }
}

std::vector<QRectF> SectionView::bandLabels() const {
  constexpr double kAsidePx = 6, kGapPx = 4;
  const QFontMetricsF metrics(font());
  const QRectF room = field();
  std::vector<QRectF> labels(bands_.size());
  // The selected one first: it is next to the edge.
  for (const bool chosen : {true, false}) {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      const SectionBand& band = bands_[i];
      const double top = pxOf({0, band.high_m}).y(), bottom = pxOf({0, band.low_m}).y();
      if (band.chosen != chosen || bottom < room.top() || top > room.bottom()) continue;
      const double width = metrics.horizontalAdvance(QString::number(band.index)) + kGapPx;
      const double lowest = std::max(room.top(), room.bottom() - metrics.height());
      QRectF label(room.right() - kAsidePx - width, std::clamp(top + 2, room.top() + 2, lowest), width,
                   metrics.height());
      const auto taken = [&](const QRectF& other) { return !other.isEmpty() && other.intersects(label); };
      while (label.left() > room.left() && std::any_of(labels.begin(), labels.end(), taken))
        label.translate(-width - kGapPx, 0);
      if (label.left() > room.left()) labels[i] = label;
    }
  }
  return labels;
}

void SectionView::paintBands(QPainter& painter) const {
  const UiColors colors = appColors();
  const QRect room = field();
  painter.save();
  painter.setClipRect(room);
  for (const SectionBand& band : bands_) {
    const double top = pxOf({0, band.high_m}).y(), bottom = pxOf({0, band.low_m}).y();
    const QRectF strip(room.left(), top, room.width(), bottom - top);
    QColor pale = colors.focus;
    pale.setAlpha(band.chosen ? 45 : 18);
    painter.fillRect(strip, pale);
    painter.setPen(QPen(colors.focus, band.chosen ? 2 : 1, band.chosen ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(strip.topLeft(), strip.topRight());
    painter.drawLine(strip.bottomLeft(), strip.bottomRight());
  }
  const std::vector<QRectF> labels = bandLabels();
  QColor plate = colors.base;
  plate.setAlpha(200);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].isEmpty()) continue;
    painter.fillRect(labels[i], plate);
    painter.setPen(bands_[i].chosen ? colors.accent : colors.text);
    painter.drawText(labels[i], Qt::AlignCenter, QString::number(bands_[i].index));
  }
  painter.restore();
}

void SectionView::paintAxes(QPainter& painter) const {
  const UiColors colors = appColors();
  const QRect room = field();
  const QFontMetrics metrics(font());
  const Eigen::Vector2d low = placeAt(room.bottomLeft()), high = placeAt(room.topRight());
  QColor line = colors.border;
  line.setAlpha(120);
  for (const PlotTick& tick : valueTicks(low.x(), high.x(), std::max(2, room.width() / 80))) {
    const int x = int(std::lround(pxOf({tick.at, low.y()}).x()));
    painter.setPen(line);
    painter.drawLine(x, room.top(), x, room.bottom());
    painter.setPen(colors.secondary_text);
    const int width = metrics.horizontalAdvance(tick.text);
    const int left = std::clamp(x - width / 2, 0, std::max(0, this->width() - width - 30));
    painter.drawText(left, height() - 6, tick.text);
  }
  for (const PlotTick& tick : valueTicks(low.y(), high.y(), std::max(2, room.height() / 32))) {
    const int y = int(std::lround(pxOf({low.x(), tick.at}).y()));
    painter.setPen(line);
    painter.drawLine(room.left(), y, room.right(), y);
    painter.setPen(colors.secondary_text);
    painter.drawText(QRect(0, y - metrics.height() / 2, kLeftPx - 6, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, tick.text);
  }
  painter.setPen(colors.secondary_text);
  painter.drawText(QRect(width() - 28, height() - metrics.height() - 3, 24, metrics.height()), Qt::AlignRight,
                   tr("m"));
}

namespace {

constexpr double kThinnestBandM = 0.05;

}  // namespace

std::optional<BandEdge> edgeNear(const std::vector<SectionBand>& bands, double height_m, double reach_m) {
  std::optional<BandEdge> best;
  double nearest = reach_m;
  bool best_is_chosen = false;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!bands[i].movable) continue;
    for (const bool low : {false, true}) {
      const double away = std::abs(height_m - (low ? bands[i].low_m : bands[i].high_m));
      if (away > reach_m || (best_is_chosen && !bands[i].chosen)) continue;
      if (best && best_is_chosen == bands[i].chosen && away >= nearest) continue;
      best = BandEdge{i, low};
      nearest = away;
      best_is_chosen = bands[i].chosen;
    }
  }
  return best;
}

SectionBand withEdgeAt(SectionBand band, bool low, double height_m) {
  if (low) {
    band.low_m = std::min(height_m, band.high_m - kThinnestBandM);
  } else {
    band.high_m = std::max(height_m, band.low_m + kThinnestBandM);
  }
  return band;
}

}  // namespace mapwright::ui

#include "moc_section_view.cpp"
