#include "ui/clouds/clouds_dock.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/clouds/cloud_text.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr double kFarthestM = 100'000;

QLabel* cloudHeading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

QDoubleSpinBox* metresBox(double low, double high, int decimals, const QString& name, QWidget* parent) {
  auto* box = new DecimalBox(parent);
  box->setRange(low, high);
  box->setDecimals(decimals);
  box->setSingleStep(0.1);
  box->setSuffix(CloudsDock::tr(" m"));
  // Typed numbers count when complete: half a number would be a height of its own.
  box->setKeyboardTracking(false);
  box->setAccessibleName(name);
  box->setMinimumWidth(70);
  return box;
}

QHBoxLayout* fromTo(QDoubleSpinBox* from, QDoubleSpinBox* to, QWidget* parent) {
  return rowOf({{from, 1}, new QLabel(CloudsDock::tr("to"), parent), {to, 1}});
}

}  // namespace

CloudsDock::CloudsDock(QWidget* parent)
    : QDockWidget(tr("Clouds"), parent), absence_(textLabel({}, this)), body_(new QWidget(this)) {
  setObjectName(QStringLiteral("clouds"));
  auto* const column = new QVBoxLayout(body_);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  buildAsking(column);
  buildLook(column);
  buildEnd(column);
  column->addStretch();
  absence_->setContentsMargins(8, 4, 8, 4);
  auto* const all = new QWidget(this);
  all->setLayout(columnOf({absence_, {body_, 1}}, -1, QMargins()));
  all->setMinimumWidth(240);
  setScrolledWidget(*this, all);
  setClouds({}, {}, {});
  setProgress({});
  setAbsence({});
}

void CloudsDock::buildAsking(QVBoxLayout* column) {
  asking_ = new QWidget(body_);
  auto* const rows = new QVBoxLayout(asking_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(cloudHeading(tr("Fetch"), asking_));
  auto* const form = new QFormLayout;
  kind_ = new QComboBox(asking_);
  kind_->addItems({tr("Points"), tr("Occupied cells")});
  kind_->setAccessibleName(tr("What to fetch"));
  form->addRow(tr("What"), kind_);
  ask_low_ = metresBox(-kFarthestM, kFarthestM, 2, tr("Lowest height to fetch"), asking_);
  ask_high_ = metresBox(-kFarthestM, kFarthestM, 2, tr("Highest height to fetch"), asking_);
  ask_low_->setValue(-50);
  ask_high_->setValue(50);
  form->addRow(tr("Heights"), fromTo(ask_low_, ask_high_, asking_));
  shape_ = new QComboBox(asking_);
  shape_->addItems({tr("Box"), tr("Sphere")});
  shape_->setAccessibleName(tr("Shape of the region"));
  form->addRow(tr("Shape"), shape_);
  rows->addLayout(form);
  view_ = compactButton(tr("In view"), asking_);
  region_ = compactButton(tr("Draw region"), asking_);
  whole_ = compactButton(tr("Everything…"), asking_);
  rows->addLayout(rowOf({view_, region_, whole_}));

  question_ = new QWidget(asking_);
  auto* const text = textLabel(
      tr("The robot does not report the size of its whole cloud. Fetching it may need much time and memory."),
      question_);
  sure_ = compactButton(tr("Fetch everything"), question_);
  auto* const no = compactButton(tr("Cancel"), question_);
  question_->setLayout(columnOf({text, rowOf({sure_, no, LayoutItem::rest()})}, -1, QMargins()));
  question_->hide();
  rows->addWidget(question_);
  column->addWidget(asking_);

  progress_row_ = new QWidget(body_);
  progress_ = new PlainLabel(progress_row_);
  cancel_ = compactButton(tr("Cancel"), progress_row_);
  progress_row_->setLayout(rowOf({{progress_, 1}, cancel_}, -1, QMargins()));
  column->addWidget(progress_row_);
  outcome_ = textLabel({}, body_);
  column->addWidget(outcome_);

  connect(whole_, &QPushButton::clicked, question_, &QWidget::show);
  connect(no, &QPushButton::clicked, question_, &QWidget::hide);
  connect(sure_, &QPushButton::clicked, this, [this] {
    question_->hide();
    Q_EMIT wholeWanted();
  });
}

void CloudsDock::buildLook(QVBoxLayout* column) {
  column->addWidget(cloudHeading(tr("Show"), body_));
  const scene::LayerTraits traits = scene::specOf(scene::Layer::DispatchedCloud).traits();
  auto* const form = new QFormLayout;
  color_ = new QComboBox(body_);
  color_->addItems(traits.choices);
  color_->setAccessibleName(tr("Colour of the points"));
  form->addRow(tr("Colour"), color_);
  scale_ = new ColorScale(body_);
  form->addRow(scale_);
  size_ = new DecimalBox(body_);
  size_->setRange(traits.size_px->first, traits.size_px->second);
  size_->setDecimals(0);
  size_->setSuffix(tr(" px"));
  size_->setAccessibleName(tr("Size of the points"));
  form->addRow(tr("Point size"), size_);
  voxel_ = metresBox(0, 10, 3, tr("Size of the cells"), body_);
  voxel_->setSingleStep(0.01);
  voxel_->setSpecialValueText(tr("detected"));
  form->addRow(tr("Cell size"), voxel_);
  column->addLayout(form);
  slider_ = new HeightSlider(body_);
  column->addWidget(slider_);
  low_ = metresBox(-1e7, 1e7, 2, tr("Lowest height to show"), body_);
  high_ = metresBox(-1e7, 1e7, 2, tr("Highest height to show"), body_);
  column->addLayout(fromTo(low_, high_, body_));
  auto* const all = compactButton(tr("All heights"), body_);
  column->addWidget(all, 0, Qt::AlignLeft);
  connect(slider_, &HeightSlider::rangeChosen, this, &CloudsDock::rangeChosen);
  connect(low_, &QDoubleSpinBox::valueChanged, this, &CloudsDock::typedRange);
  connect(high_, &QDoubleSpinBox::valueChanged, this, &CloudsDock::typedRange);
  connect(all, &QPushButton::clicked, this, [this] { Q_EMIT rangeChosen(std::nullopt); });
}

void CloudsDock::buildEnd(QVBoxLayout* column) {
  counts_ = textLabel({}, body_);
  column->addWidget(counts_);
  save_ = compactButton(tr("Save as…"), body_);
  clear_ = compactButton(tr("Clear"), body_);
  column->addLayout(rowOf({save_, clear_, LayoutItem::rest()}));
}

clouds::HeightRange CloudsDock::askedHeights() const {
  return {std::min(ask_low_->value(), ask_high_->value()), std::max(ask_low_->value(), ask_high_->value())};
}

void CloudsDock::typedRange() {
  if (low_->value() > high_->value()) {
    // The other end gives way to the typed one.
    QDoubleSpinBox* const typed = qobject_cast<QDoubleSpinBox*>(sender());
    QDoubleSpinBox* const other = typed == low_ ? high_ : low_;
    const QSignalBlocker quiet(other);
    other->setValue((typed ? typed : low_)->value());
  }
  Q_EMIT rangeChosen(clouds::HeightRange{low_->value(), high_->value()});
}

void CloudsDock::setAbsence(const QString& sentence) {
  absence_->setText(sentence);
  absence_->setVisible(!sentence.isEmpty());
  asking_->setVisible(sentence.isEmpty());
  refresh();
}

void CloudsDock::setOffer(const CloudOffer& offer) {
  offer_ = offer;
  refresh();
}

void CloudsDock::setProgress(const QString& words) {
  busy_ = !words.isEmpty();
  progress_->setText(words);
  progress_row_->setVisible(busy_);
  if (busy_) question_->hide();
  refresh();
}

void CloudsDock::setOutcome(const QString& sentence, bool bad) {
  outcome_->setText(sentence);
  outcome_->setVisible(!sentence.isEmpty());
  setTextColor(*outcome_, bad ? appColors().error_text : appColors().secondary_text);
}

void CloudsDock::refresh() {
  for (QPushButton* const button : {view_, region_}) {
    button->setEnabled(!busy_ && offer_.region);
    button->setToolTip(offer_.region ? QString() : plainToolTip(offer_.unavailable_reason));
  }
  whole_->setEnabled(!busy_ && offer_.whole);
  whole_->setToolTip(offer_.whole ? QString() : plainToolTip(offer_.unavailable_reason));
  save_->setEnabled(has_clouds_);
  clear_->setEnabled(has_clouds_);
}

void CloudsDock::setClouds(const clouds::CloudSums& sums, const clouds::Heights& heights,
                           const std::optional<clouds::HeightRange>& range) {
  has_clouds_ = sums.clouds > 0;
  counts_->setText(cloudSumsText(sums));
  slider_->setHeights(heights);
  slider_->setRange(range);
  const QSignalBlocker quiet_low(low_), quiet_high(high_);
  // Rounded outwards, so that the two decimals do not cut off the ends.
  low_->setValue(range ? range->low_m : std::floor(heights.low_m * 100) / 100);
  high_->setValue(range ? range->high_m : std::ceil(heights.high_m * 100) / 100);
  low_->setEnabled(has_clouds_);
  high_->setEnabled(has_clouds_);
  voxel_->setEnabled(sums.voxels);
  refresh();
}

void CloudsDock::setScale(const std::optional<scene::CloudScale>& scale) { scale_->setScale(scale); }

void CloudsDock::setSorting() { counts_->setText(tr("Preparing the cloud…")); }

void CloudsDock::setStyle(const scene::LayerStyle& style) {
  const QSignalBlocker quiet(size_);
  color_->setCurrentIndex(style.choice);
  size_->setValue(style.size > 0 ? style.size
                                 : scene::specOf(scene::Layer::DispatchedCloud).traits().default_size_px);
}

}  // namespace mapwright::ui

#include "moc_clouds_dock.cpp"
