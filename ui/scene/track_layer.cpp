#include <algorithm>
#include <array>
#include <cmath>

#include <QFontMetricsF>
#include <QLinearGradient>

#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "ui/scene/lengths.h"
#include "ui/scene/track.h"

namespace mapwright::ui::scene {
namespace {

class TrackLayerText {
  Q_DECLARE_TR_FUNCTIONS(TrackLayer)
};

enum QualityColor { Unknown, Poor, Fair, Good };
constexpr int kPoor = 3, kGood = 8;  // SlamStatus::position_quality
constexpr double kWidth = 3;
constexpr double kNearPx = 1.5;  // samples closer to the previous one are skipped
// The legend is above the scale bar.
constexpr double kLeft = 8, kAboveBottom = 48, kBarPx = 140, kBarHeight = 8, kPad = 8,
                 kSwatch = kBarHeight + 6;

/// From brown to yellow: steadily lighter, without red against green, apart from the blues, greens and
/// purples of everything else, and from every ground (test map_colors).
constexpr std::array<QRgb, 5> kGradient{0xff8a3006, 0xffaf4700, 0xffb76d02, 0xfffc9828, 0xfffdc551};

QColor gradientAt(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * double(kGradient.size() - 1);
  const std::size_t below = std::min(std::size_t(at), kGradient.size() - 2);
  const double part = at - double(below);
  const QColor a(kGradient[below]), b(kGradient[below + 1]);
  const auto mixed = [&](int from, int to) { return int(std::lround(from + part * (to - from))); };
  return {mixed(a.red(), b.red()), mixed(a.green(), b.green()), mixed(a.blue(), b.blue())};
}

double shareOf(const TrackSample& sample, const TrackScale& scale) {
  if (!(scale.most > 0)) return 0;
  return (scale.choice == TrackChoice::Time ? sample.at_s : sample.speed_m_s) / scale.most;
}

}  // namespace

QString durationText(double seconds) {
  const auto whole = std::int64_t(std::llround(seconds));
  return QStringLiteral("%1:%2:%3")
      .arg(whole / 3600)
      .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
      .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

TrackScale scaleOf(const Track& track, TrackChoice choice) {
  TrackScale scale{choice, 0};
  for (const TrackSample& sample : track)
    scale.most = std::max(scale.most, choice == TrackChoice::Time ? sample.at_s : sample.speed_m_s);
  if (choice == TrackChoice::Quality) scale.most = 0;
  if (choice == TrackChoice::Speed && scale.most > 0) {
    const double below = roundDown125(scale.most);
    scale.most = below < scale.most ? roundDown125(below * 2.6) : below;
  }
  return scale;
}

int colorIndexOf(const TrackSample& sample, const TrackScale& scale) {
  if (scale.choice == TrackChoice::Quality) {
    if (sample.quality <= 0) return Unknown;
    return sample.quality <= kPoor ? Poor : sample.quality < kGood ? Fair : Good;
  }
  return std::clamp(int(shareOf(sample, scale) * kTrackColors), 0, kTrackColors - 1);
}

std::vector<QColor> trackColors(TrackChoice choice) {
  // Okabe and Ito's colours; but their red is taken by what is new in a difference.
  if (choice == TrackChoice::Quality)
    return {QColor(128, 128, 128), QColor(kGradient.front()), QColor(230, 159, 0), QColor(0, 114, 178)};
  std::vector<QColor> colors;
  for (int i = 0; i < kTrackColors; ++i) colors.push_back(gradientAt(double(i) / (kTrackColors - 1)));
  return colors;
}

namespace {

class TrackLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override;
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.track) return bounds;
    for (const TrackSample& sample : *context_.track) extendBy(bounds, sample.position_m);
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    if (context_.track && !context_.track->empty())
      labels.symbol(legendOf(scaleOf(*context_.track, choice())).frame);
  }

 private:
  struct LegendPlate {
    QStringList names;
    QRectF frame;
  };
  struct Run {
    int color = 0;
    QPolygonF line;
    QRectF bounds;
  };
  void layOut();
  TrackChoice choice() const { return TrackChoice(std::clamp(style().choice, 0, int(TrackChoice::Quality))); }
  LegendPlate legendOf(const TrackScale& scale) const;
  void paintLegend(QPainter& painter, const QRectF& exposed) const;

  std::shared_ptr<const Track> laid_out_;  // what `runs_` were computed for
  std::optional<geometry::ViewTransform> laid_out_view_;
  TrackScale scale_;
  std::vector<Run> runs_;
};

void TrackLayer::layOut() {
  const TrackChoice choice = this->choice();
  if (laid_out_ == context_.track && laid_out_view_ == context_.view && scale_.choice == choice) return;
  if (laid_out_ != context_.track || scale_.choice != choice) scale_ = scaleOf(*context_.track, choice);
  laid_out_ = context_.track;
  laid_out_view_ = context_.view;
  runs_.clear();
  const double margin = 2 * sizeOr(kWidth);
  const QRectF seen = boundingRect().adjusted(-margin, -margin, margin, margin);
  std::optional<QPointF> before;
  bool open = false;  // the last run ends at `before`
  for (const TrackSample& sample : *context_.track) {
    const QPointF pixel = toPoint(context_.view.pixelFromWorld(sample.position_m));
    if (!std::isfinite(pixel.x()) || !std::isfinite(pixel.y())) {
      before.reset();
      open = false;
      continue;
    }
    if (sample.begins || !before) {
      before = pixel;
      open = false;
      continue;
    }
    const QPointF step = pixel - *before;
    if (std::abs(step.x()) + std::abs(step.y()) < kNearPx) continue;
    const QRectF box = QRectF(*before, pixel).normalized();
    const bool crosses = box.left() <= seen.right() && box.right() >= seen.left() &&
                         box.top() <= seen.bottom() && box.bottom() >= seen.top();
    if (crosses) {
      const int color = colorIndexOf(sample, scale_);
      if (!open || runs_.back().color != color) runs_.push_back({color, QPolygonF{*before}, {}});
      runs_.back().line << pixel;
    }
    open = crosses;
    before = pixel;
  }
  for (Run& run : runs_) run.bounds = run.line.boundingRect().adjusted(-margin, -margin, margin, margin);
}

void TrackLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (!context_.track || context_.track->empty()) return;
  layOut();
  const std::vector<QColor> colors = trackColors(scale_.choice);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  for (const Run& run : runs_) {
    if (!run.bounds.intersects(option->exposedRect)) continue;
    painter->setPen(
        QPen(colors[std::size_t(run.color)], sizeOr(kWidth), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter->drawPolyline(run.line);
  }
  paintLegend(*painter, option->exposedRect);
}

TrackLayer::LegendPlate TrackLayer::legendOf(const TrackScale& scale) const {
  const QFontMetricsF metrics(context_.theme.label_font);
  const bool qualities = scale.choice == TrackChoice::Quality;
  const QStringList names =
      qualities ? QStringList{TrackLayerText::tr("unknown"), TrackLayerText::tr("poor or lost"),
                              TrackLayerText::tr("fair"), TrackLayerText::tr("good")}
      : scale.choice == TrackChoice::Time
          ? QStringList{durationText(0), durationText(scale.most)}
          : QStringList{QStringLiteral("0"), TrackLayerText::tr("%1 m/s").arg(scale.most)};
  const double line = std::ceil(metrics.height());
  double width = kBarPx;
  if (qualities) {
    width = 0;
    for (const QString& name : names) width += kSwatch + std::ceil(metrics.horizontalAdvance(name)) + 12;
    width -= 12;
  }
  const double height = qualities ? line : line + 2 + kBarHeight;
  const double top = context_.view.height_px - kAboveBottom - height - 2 * kPad;
  return {names, QRectF(kLeft, top, width + 2 * kPad, height + 2 * kPad)};
}

void TrackLayer::paintLegend(QPainter& painter, const QRectF& exposed) const {
  const QFontMetricsF metrics(context_.theme.label_font);
  const std::vector<QColor> colors = trackColors(scale_.choice);
  const bool qualities = scale_.choice == TrackChoice::Quality;
  const auto [names, frame] = legendOf(scale_);
  if (!exposed.intersects(frame.adjusted(-2, -2, 2, 2))) return;
  QColor plate = context_.theme.text_halo;
  plate.setAlpha(190);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(frame, 4, 4);
  const double left = frame.left() + kPad, width = frame.width() - 2 * kPad;
  const auto write = [&](double x, const QString& name) {
    context_.ink->draw(painter, {x, frame.top() + kPad}, name, context_.theme, context_.theme.text);
  };
  if (qualities) {
    double x = left;
    for (qsizetype i = 0; i < names.size(); ++i) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(colors[std::size_t(i)]);
      painter.drawRect(QRectF(x, frame.center().y() - kBarHeight / 2, kBarHeight, kBarHeight));
      x += kSwatch;
      write(x, names[i]);
      x += std::ceil(metrics.horizontalAdvance(names[i])) + 12;
    }
    return;
  }
  write(left, names.front());
  write(left + width - metrics.horizontalAdvance(names.back()), names.back());
  const QRectF bar(left, frame.bottom() - kPad - kBarHeight, width, kBarHeight);
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (std::size_t i = 0; i < colors.size(); ++i)
    gradient.setColorAt(double(i) / double(colors.size() - 1), colors[i]);
  painter.setPen(Qt::NoPen);
  painter.fillRect(bar, gradient);
}

void seeTrack(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  if (!context.track) return;
  map::Polyline line;
  line.reserve(context.track->size());
  for (const TrackSample& sample : *context.track) line.push_back(sample.position_m);
  seeLine(line, see);
}

MapObject describeTrack(const LayerContext& context, FeaturesOf, std::size_t) {
  static const Track kNone;
  const Track& track = context.track ? *context.track : kNone;
  MapObject object = oneLine(ObjectText::tr("Track of the bag"), track.size(), -1);
  if (!track.empty())
    object.properties.push_back(
        {ObjectText::tr("Time in the bag"),
         ObjectText::tr("%1 to %2").arg(durationText(track.front().at_s), durationText(track.back().at_s))});
  return object;
}

constexpr LayerObjects kTrack{seeTrack, describeTrack};

void sampleTrack(LegendSample& sample, ObjectForm, std::int64_t look) {
  constexpr int kSteps = 200;
  auto track = std::make_shared<Track>();
  for (int i = 0; i <= kSteps; ++i) {
    const double share = double(i) / kSteps;
    track->push_back(
        {LegendSample::at(sample.reachPx() * (2 * share - 1), 0), share, share, int(look), i == 0});
  }
  sample.context.track = track;
}

void trackLegend(Legend& legend) {
  if (!legend.context().track) return;
  const Legend::Fill whole = [](LegendSample& sample) { sampleTrack(sample, ObjectForm::Line, 0); };
  switch (TrackChoice(legend.style().choice)) {
    case TrackChoice::Time:
      return legend.addSampleScale(LegendText::tr("start"), LegendText::tr("end of the bag"), whole);
    case TrackChoice::Speed:
      return legend.addSampleScale(LegendText::tr("standing"), LegendText::tr("fastest"), whole);
    case TrackChoice::Quality:
      break;
  }
  legend.addThing(LegendText::tr("Localization: good"), ObjectForm::Line, kGood);
  legend.addThing(LegendText::tr("Localization: fair"), ObjectForm::Line, kPoor + 1);
  legend.addThing(LegendText::tr("Localization: poor or lost"), ObjectForm::Line, kPoor);
  legend.addThing(LegendText::tr("Localization: unknown"), ObjectForm::Line, 0);
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Track>() {
  return {.name = "track",
          .title = QT_TRANSLATE_NOOP("scene", "Track of the bag"),
          .group = LayerGroup::Robot,
          .left_alone = LayerSet::Navigation | LayerSet::Mapping,
          .in_all = false,
          .not_in_all_reason = QT_TRANSLATE_NOOP("scene", "needs a whole bag"),
          .traits =
              [] {
                LayerTraits traits = lineTraits(kWidth);
                traits.color = false;
                traits.choice_title = QCoreApplication::translate("scene", "Colour");
                traits.choices = {QCoreApplication::translate("scene", "By time"),
                                  QCoreApplication::translate("scene", "By speed"),
                                  QCoreApplication::translate("scene", "By localization quality")};
                return traits;
              },
          .items = oneItem<TrackLayer>,
          .objects = &kTrack,
          .sample = sampleTrack,
          .legend = trackLegend};
}

}  // namespace mapwright::ui::scene
