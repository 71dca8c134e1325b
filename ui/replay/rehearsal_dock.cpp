#include "ui/replay/rehearsal_dock.h"

#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTableView>

#include "carry/rehearsal_sentence.h"
#include "placing/warnings.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/kit/wrapping_row.h"
#include "ui/replay/timeline_axis.h"
#include "words/fixed.h"

namespace mapwright::ui {
namespace {

constexpr int kLeastColumnPx = 40;
constexpr Qt::Alignment kNumbers = Qt::AlignRight | Qt::AlignVCenter;

/// On the list, which has the colours of the window.
QIcon sampleOf(carry::Crossing what) {
  constexpr int kEdge = 16, kSharp = 2;
  QPixmap sample(kEdge * kSharp, kEdge * kSharp);
  sample.setDevicePixelRatio(kSharp);
  sample.fill(Qt::transparent);
  QPainter painter(&sample);
  QPen pen = penOf(what, appColors().dark ? scene::darkMapTheme() : scene::lightMapTheme());
  pen.setWidthF(pen.widthF() / 2);  // so that its dashes are seen
  painter.setPen(pen);
  painter.drawLine(QPointF(1, kEdge / 2.0), QPointF(kEdge - 1, kEdge / 2.0));
  return sample;
}

}  // namespace

QPen penOf(carry::Crossing what, const scene::MapTheme& theme) {
  switch (what) {
    case carry::Crossing::Free:
      return QPen(theme.good, 2.5);
    case carry::Crossing::Outside:
    case carry::Crossing::Unknown:
      return QPen(theme.text, 3.5, Qt::DotLine);
    case carry::Crossing::TooClose:
      return QPen(theme.warn, 4, Qt::DashLine);
    case carry::Crossing::Obstacle:
      break;
  }
  return QPen(theme.bad, 6);
}

RehearsalDock::RehearsalDock(QWidget* parent)
    : QDockWidget(tr("Rehearse"), parent),
      said_(textLabel({}, this)),
      choose_(compactButton(tr("Choose a file…"), this, tr("A recording, or a track that was exported"))),
      recordings_(compactButton(tr("On the robot…"), this)),
      again_(compactButton(tr("Again"), this, tr("Read it again, and lay it on the map as it is now"))),
      cancel_(compactButton(tr("Cancel"), this, tr("Stop reading the way"))),
      remove_(compactButton(tr("Remove"), this, tr("Take the way off the map"))),
      radius_(numberField(
          this,
          {.least = 0, .most = placing::kMostRadiusM, .decimals = 2, .name = tr("Radius of the robot")})),
      model_(new QStandardItemModel(0, 3, this)),
      table_(new QuietTableView(this)) {
  setObjectName(QStringLiteral("rehearsal"));
  model_->setHorizontalHeaderLabels({tr("Meets"), tr("Length (m)"), tr("From (UTC)")});
  showRows(*table_, model_, tr("What the way crosses"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (const int column : {1, 2}) model_->horizontalHeaderItem(column)->setTextAlignment(kNumbers);
  new NameColumn(table_, header, 0, {{2, kLeastColumnPx}, {1, kLeastColumnPx}});
  table_->installEventFilter(this);
  auto* const buttons = new WrappingRow(QMargins(), 8);
  for (QPushButton* const button : {choose_, recordings_, again_, cancel_, remove_}) buttons->add(button);
  auto* const radius = new QWidget(this);
  radius->setLayout(rowOf({new QLabel(tr("Radius"), radius), radius_}, 6, QMargins()));
  buttons->add(radius);
  radius_->setToolTip(tr("Radius of the robot: 0 is that of its own footprint"));
  setToldRadius(placing::kUsualRadiusM);
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({buttons, said_, {table_, 1}}, 6, QMargins(8, 6, 8, 6)));
  setWidget(body);
  connect(choose_, &QPushButton::clicked, this, &RehearsalDock::chooseWanted);
  connect(recordings_, &QPushButton::clicked, this, &RehearsalDock::recordingsWanted);
  connect(again_, &QPushButton::clicked, this, &RehearsalDock::againWanted);
  connect(cancel_, &QPushButton::clicked, this, &RehearsalDock::cancelWanted);
  connect(radius_, &QDoubleSpinBox::valueChanged, this, &RehearsalDock::radiusChanged);
  connect(remove_, &QPushButton::clicked, this, &RehearsalDock::removeWanted);
  connect(table_, &QTableView::clicked, this,
          [this](const QModelIndex& at) { Q_EMIT placeWanted(at.row()); });
  setChosen(false);
  setBusy(false);
}

RehearsalDock::~RehearsalDock() { table_->removeEventFilter(this); }

void RehearsalDock::setSaid(const QString& said) { said_->setText(said); }

QString RehearsalDock::said() const { return said_->text(); }

void RehearsalDock::setChosen(bool chosen) {
  again_->setEnabled(chosen);
  remove_->setEnabled(chosen);
}

void RehearsalDock::setBusy(bool busy) {
  cancel_->setVisible(busy);  // in the place of Again
  again_->setVisible(!busy);
  remove_->setDisabled(busy || !again_->isEnabled());
}

void RehearsalDock::setWhyNoRecordings(const QString& why) {
  recordings_->setEnabled(why.isEmpty());
  recordings_->setToolTip(!why.isEmpty() ? why
                                         : tr("Lists the robot's recordings: choose one, then Rehearse"));
}

std::optional<double> RehearsalDock::radius() const {
  return radius_->value() > 0 ? std::optional(radius_->value()) : std::nullopt;
}

void RehearsalDock::setToldRadius(double told_m) {
  radius_->setSpecialValueText(tr("Robot: %1 m").arg(words::fixed(told_m, 2)));
}

void RehearsalDock::setRadius(double radius_m) {
  const QSignalBlocker quiet(radius_);
  radius_->setValue(radius_m);
}

void RehearsalDock::setStretches(const std::vector<carry::Stretch>& stretches) {
  model_->setRowCount(0);
  for (const carry::Stretch& stretch : stretches) {
    auto* const what = new QStandardItem(sampleOf(stretch.what), carry::crossingText(stretch.what));
    what->setData(int(stretch.what));
    auto* const length = new QStandardItem(words::fixed(stretch.length_m, 2));
    length->setTextAlignment(kNumbers);
    auto* const when = new QStandardItem(clockText(stretch.from_s, 0));
    when->setToolTip(QStringLiteral("%1 %2").arg(dayText(stretch.from_s), when->text()));
    when->setTextAlignment(kNumbers);
    model_->appendRow({what, length, when});
  }
}

void RehearsalDock::changeEvent(QEvent* event) {
  QDockWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (int row = 0; row < model_->rowCount(); ++row) {
    QStandardItem* const what = model_->item(row);
    what->setIcon(sampleOf(carry::Crossing(what->data().toInt())));
  }
}

bool RehearsalDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && table_->currentIndex().isValid()) {
      Q_EMIT placeWanted(table_->currentIndex().row());
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_rehearsal_dock.cpp"
