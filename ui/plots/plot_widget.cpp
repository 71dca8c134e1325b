#include "ui/plots/plot_widget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QEvent>

#include "ui/kit/plot_ticks.h"

namespace mapwright::window {

namespace {
constexpr double kPlotMargin = 0.06, kShortest_s = 0.01;
}

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Plot"));
}

void PlotWidget::setCurves(std::vector<PlotCurve> curves) {
  curves_ = std::move(curves);
  QStringList names;
  for (const PlotCurve& curve : curves_) names << plotName(curve.wish);
  setAccessibleDescription(names.join(QStringLiteral(", ")));
  refresh();
}

void PlotWidget::refresh() {
  stale_ = true;
  auto_.reset();
  update();
}

void PlotWidget::setSpan(Range span) {
  if (!(span.second - span.first >= kShortest_s / 2) || span == span_) return;
  span_ = span;
  refresh();
}

void PlotWidget::setCurrent(std::optional<double> at_s) {
  if (std::exchange(cursor_s_, at_s) != at_s) update();
}

void PlotWidget::setPresent(std::optional<double> at_s) {
  if (std::exchange(present_s_, at_s) != at_s) update();
}

void PlotWidget::setPointed(std::optional<double> at_s) {
  if (std::exchange(pointed_s_, at_s) != at_s) update();
}

void PlotWidget::setFixedValues(std::optional<Range> values) {
  if (values && !(values->first < values->second && std::isfinite(values->second - values->first))) return;
  if (std::exchange(fixed_, values) != values) refresh();
}

void PlotWidget::setSince(std::optional<double> since_s) {
  if (std::exchange(since_s_, since_s) != since_s) refresh();
}

void PlotWidget::setHint(const QString& hint) {
  if (std::exchange(hint_, hint) != hint) refresh();
}

PlotWidget::Range PlotWidget::autoValues() const {
  std::optional<Range> all;
  const auto add = [&](double least, double greatest) {
    all = all ? Range{std::min(all->first, least), std::max(all->second, greatest)} : Range{least, greatest};
  };
  for (const PlotCurve& curve : curves_) {
    if (!curve.series) continue;
    if (const auto extent = curve.series->extent(span_.first, span_.second))
      add(extent->first, extent->second);
    // The line begins at the sample before.
    if (const auto before = curve.series->at(span_.first)) add(before->value, before->value);
  }
  if (!all) return {0, 1};
  double high = all->second - all->first;
  // A single value: a range around it.
  if (!(high > std::max(std::abs(all->first), std::abs(all->second)) * 1e-9))
    high = std::max(std::abs(all->first) * 0.2, 1.0);
  if (!std::isfinite(high)) return {-1e300, 1e300};
  const double middle = all->first / 2 + all->second / 2;
  const double half = high / 2 * (1 + 2 * kPlotMargin);
  return {middle - half, middle + half};
}

PlotWidget::Range PlotWidget::values() const {
  if (fixed_) return *fixed_;
  if (!auto_) auto_ = autoValues();
  return *auto_;
}

double PlotWidget::timeAt(double x_px) const {
  const QRect area = this->area();
  return span_.first + (x_px - area.left()) / area.width() * (span_.second - span_.first);
}

double PlotWidget::xOf(double at_s) const {
  const QRect area = this->area();
  return area.left() + (at_s - span_.first) / (span_.second - span_.first) * area.width();
}

double PlotWidget::yOf(double value) const {
  const QRect area = this->area();
  const auto [least, greatest] = values();
  return area.bottom() - (value - least) / (greatest - least) * area.height();
}

QString PlotWidget::valueAtCursor(std::size_t curve) const {
  const std::optional<double> at_s = pointed_s_ ? pointed_s_ : cursor_s_ ? cursor_s_ : present_s_;
  const PlotCurve& of = curves_[curve];
  const auto sample = at_s && of.series ? of.series->at(*at_s) : std::nullopt;
  // No value here, or none anywhere: an invalid name must not look like a gap.
  if (!sample && of.series && of.series->empty() && !of.series->covered().empty()) return tr("none yet");
  if (!sample) return QStringLiteral("–");
  const QString unit = plotUnit(of.wish);
  return unit.isEmpty() ? valueText(sample->value) : valueText(sample->value) + QChar(QChar::Nbsp) + unit;
}

void PlotWidget::want(double from_s, double until_s) {
  if (!std::isfinite(from_s) || !std::isfinite(until_s)) return;
  Q_EMIT spanWanted(from_s, until_s);
}

void PlotWidget::zoomTime(double factor, double about_s) {
  const double long_s = span_.second - span_.first,
               most_s = std::max(bounds_.second - bounds_.first, kShortest_s) * 1.1;
  factor = std::clamp(factor, kShortest_s / long_s, std::max(most_s / long_s, 1.0));
  want(about_s - (about_s - span_.first) * factor, about_s + (span_.second - about_s) * factor);
}

void PlotWidget::moveTime(double by_s) {
  // Part of the bag stays visible.
  const double keep_s = (span_.second - span_.first) / 10;
  by_s = std::clamp(by_s, std::min(bounds_.first - span_.second + keep_s, 0.0),
                    std::max(bounds_.second - span_.first - keep_s, 0.0));
  want(span_.first + by_s, span_.second + by_s);
}

void PlotWidget::zoomValues(double factor, double about) {
  const auto [least, greatest] = values();
  setFixedValues(Range{about - (about - least) * factor, about + (greatest - about) * factor});
}

void PlotWidget::moveValues(double by) {
  const auto [least, greatest] = values();
  setFixedValues(Range{least + by, greatest + by});
}

void PlotWidget::resizeEvent(QResizeEvent*) { refresh(); }

void PlotWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange ||
      event->type() == QEvent::FontChange)
    refresh();
  QWidget::changeEvent(event);
}

}  // namespace mapwright::window

#include "moc_plot_widget.cpp"
