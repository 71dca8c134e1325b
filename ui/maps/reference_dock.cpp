#include "ui/maps/reference_dock.h"

#include <cmath>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStandardItemModel>
#include <QTableView>

#include "sentences/plural.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/kit/wrapping_row.h"
#include "ui/scene/lengths.h"
#include "ui/scene/map_theme.h"
#include "ui/scene/walls_off.h"
#include "words/fixed.h"

namespace mapwright::ui {
namespace {

/// How walls look that are off by a step, and its words.
class OffStep : public QWidget {
 public:
  OffStep(std::size_t step, const QString& words, QWidget* parent) : QWidget(parent), step_(step) {
    setLayout(rowOf({textLabel(words, this)}, 0, QMargins(kSymbolPx + 4, 0, 0, 0)));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    // As a piece of a wall on free ground.
    const scene::MapTheme theme = appColors().dark ? scene::darkMapTheme() : scene::lightMapTheme();
    const double thick = scene::kOffMarks_px[step_];
    QPainter painter(this);
    painter.fillRect(QRectF(0, (height() - kSymbolPx) / 2.0, kSymbolPx, kSymbolPx), QColor(theme.map.free));
    painter.fillRect(QRectF(0, (height() - thick) / 2, kSymbolPx, thick), scene::offColor(step_));
  }

 private:
  static constexpr int kSymbolPx = 16;
  std::size_t step_;
};

}  // namespace

ReferenceDock::ReferenceDock(QWidget* parent)
    : QDockWidget(tr("Reference map"), parent),
      map_(new PlainLabel(this)),
      told_(new PlainLabel(this)),
      choose_(compactButton(tr("Choose…"), this, tr("Choose a map file to lay under what the robot shows"))),
      remove_(compactButton(tr("Remove"), this, tr("Remove the reference map; its file stays"))),
      move_(compactButton(tr("Move"), this, tr("Drag the reference map; with Shift turn it"))),
      pair_(compactButton(tr("Add points"), this,
                          tr("Click a point of the reference map, then where it really is"))),
      align_(compactButton(tr("Align"), this,
                           tr("Find out by the walls where the reference map lies on the map on screen. "
                              "It is laid there only if that is sure."))),
      fit_(compactButton(tr("Fit again"), this, tr("Fit the map to its pairs of points again"))),
      remove_pair_(compactButton(tr("Remove point"), this)),
      clear_(compactButton(tr("Remove all"), this)),
      running_(new QWidget(this)),
      progress_(new QProgressBar(running_)),
      cancel_(compactButton(tr("Cancel"), running_)),
      said_(textLabel(QString(), this)),
      figures_(textLabel(QString(), this)),
      agreement_(new QWidget(this)),
      candidates_(new QWidget(this)),
      best_(compactButton(tr("Show the best candidate"), candidates_,
                          tr("Lay the reference map there to look at it"))),
      second_(compactButton(tr("Show the second best"), candidates_,
                            tr("Lay the reference map there to look at it"))),
      part_(compactButton(tr("Show that part"), this,
                          tr("Look at where its walls lie beside those on screen"))),
      differences_(new QCheckBox(tr("Differences"), this)),
      walls_off_(new QCheckBox(tr("Walls that are off"), this)),
      swipe_(compactButton(tr("Swipe"), this)),
      legend_(new QWidget(this)),
      none_off_(textLabel(tr("No wall is off by more than 10 cm."), this)),
      carry_(compactButton(tr("Carry over waypoints…"), this)),
      carry_overlays_(compactButton(tr("Carry over overlays…"), this)),
      model_(new QStandardItemModel(0, 3, this)),
      table_(new QuietTableView(this)) {
  setObjectName(QStringLiteral("reference"));
  map_->setMostLines(2);
  told_->setSecondary(true);
  told_->setMostLines(2);
  const auto field = [this](const QString& name, double most, const QString& unit) {
    QDoubleSpinBox* const box = numberField(this, {-most, most, 3, 0.05, unit, name, 90});
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ReferenceDock::applyTyped);
    return box;
  };
  constexpr double kFarthestM = 1e7;
  x_ = field(tr("Moved along x"), kFarthestM, QStringLiteral(" m"));
  y_ = field(tr("Moved along y"), kFarthestM, QStringLiteral(" m"));
  yaw_ = field(tr("Turned by"), 360, QStringLiteral("°"));
  model_->setHorizontalHeaderLabels({tr("Point"), tr("Where it is"), tr("Off by")});
  showRows(*table_, model_, tr("Pairs of points"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->installEventFilter(this);
  for (QPushButton* const button : {move_, pair_}) button->setCheckable(true);
  makeLine(*progress_);
  progress_->setAccessibleName(tr("Progress"));
  running_->setLayout(rowOf({{progress_, 1}, cancel_}, 8, QMargins()));
  makeAgreement();
  auto* const candidates = new WrappingRow(QMargins());
  candidates->add(best_);
  candidates->add(second_);
  candidates_->setLayout(candidates);
  auto* const tools = new WrappingRow(QMargins(), 8);
  for (QPushButton* const button : {move_, pair_, align_}) tools->add(button);
  auto* const shows = new WrappingRow(QMargins(), 12);
  for (QWidget* const shown : std::initializer_list<QWidget*>{differences_, walls_off_, swipe_})
    shows->add(shown);
  auto* const legend = new WrappingRow(QMargins(), 10);
  const QString steps[] = {tr("over 10 cm"), tr("over 30 cm"), tr("over 1 m")};
  for (std::size_t step = 0; step < scene::kOffSteps_m.size(); ++step)
    legend->add(new OffStep(step, steps[step], legend_));
  legend_->setLayout(legend);
  auto* const carries = new WrappingRow(QMargins(), 8);
  for (QPushButton* const button : {carry_, carry_overlays_}) carries->add(button);
  auto* const body = new QWidget(this);
  auto* const form = new QFormLayout;
  form->addRow(tr("&x"), x_);
  form->addRow(tr("&y"), y_);
  form->addRow(tr("&Turned by"), yaw_);
  body->setLayout(columnOf({map_,
                            rowOf({choose_, remove_, LayoutItem::rest()}, 8),
                            tools,
                            running_,
                            said_,
                            candidates_,
                            rowOf({part_, LayoutItem::rest()}),
                            figures_,
                            agreement_,
                            shows,
                            legend_,
                            none_off_,
                            carries,
                            form,
                            {table_, 1},
                            told_,
                            rowOf({fit_, remove_pair_, clear_, LayoutItem::rest()}, 8)},
                           6, QMargins(8, 6, 8, 6)));
  setWidget(body);
  connect(choose_, &QPushButton::clicked, this, &ReferenceDock::chooseWanted);
  connect(remove_, &QPushButton::clicked, this, &ReferenceDock::removeWanted);
  connect(move_, &QPushButton::clicked, this, &ReferenceDock::moveWanted);
  connect(pair_, &QPushButton::clicked, this, &ReferenceDock::pairsWanted);
  connect(align_, &QPushButton::clicked, this, &ReferenceDock::alignWanted);
  connect(cancel_, &QPushButton::clicked, this, &ReferenceDock::alignCancelled);
  connect(best_, &QPushButton::clicked, this, [this] { Q_EMIT candidateWanted(false); });
  connect(second_, &QPushButton::clicked, this, [this] { Q_EMIT candidateWanted(true); });
  connect(part_, &QPushButton::clicked, this, [this] { Q_EMIT placeWanted(part_m_); });
  connect(differences_, &QCheckBox::toggled, this, &ReferenceDock::differencesWanted);
  connect(swipe_, &QPushButton::clicked, this, &ReferenceDock::swipeWanted);
  connect(carry_, &QPushButton::clicked, this, &ReferenceDock::carryWanted);
  connect(carry_overlays_, &QPushButton::clicked, this, &ReferenceDock::carryOverlaysWanted);
  connect(remove_pair_, &QPushButton::clicked, this, &ReferenceDock::removeSelected);
  connect(fit_, &QPushButton::clicked, this, &ReferenceDock::fitWanted);
  connect(clear_, &QPushButton::clicked, this, &ReferenceDock::pairsUnwanted);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { remove_pair_->setEnabled(table_->selectionModel()->hasSelection()); });
  setMap({}, false);
  setState({}, {});
  setAlignment({});
  setWhyNoDifferences(tr("There is no reference map."));
  setWallsOff(std::nullopt);
  setWhyNotCarried(tr("There is no reference map."));
  setWhyOverlaysNotCarried(tr("There is no reference map."));
}

void ReferenceDock::makeAgreement() {
  auto* const grid = new QGridLayout(agreement_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(2);
  const auto put = [&](const QString& text, int row, int column) {
    auto* const label = textLabel(text, agreement_);
    label->setWordWrap(column == 0);
    grid->addWidget(label, row, column, column == 0 ? Qt::AlignLeft : Qt::AlignRight);
    return label;
  };
  put(tr("Walls"), 0, 0);
  put(tr("Reference"), 0, 1)->setToolTip(tr("How far the walls of the reference map are from one on screen"));
  put(tr("On screen"), 0, 2)
      ->setToolTip(tr("How far the walls of the map on screen are from those of the reference map"));
  const QString rows[] = {tr("Within 10 cm"), tr("Median"), tr("95 % within"), tr("Largest"), tr("Compared")};
  for (int row = 0; row < int(distances_.size()); ++row) {
    put(rows[row], row + 1, 0);
    for (int side = 0; side < 2; ++side)
      distances_[std::size_t(row)][std::size_t(side)] = put(QString(), row + 1, side + 1);
  }
  grid->setColumnStretch(0, 1);
  agreement_->setToolTip(tr("Distances to the nearest wall of the other map, where that knows something"));
}

ReferenceDock::~ReferenceDock() {
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void ReferenceDock::setMap(const QString& said, bool there) {
  map_->setText(said);
  for (QWidget* const of_map : std::initializer_list<QWidget*>{remove_, move_, pair_, align_, x_, y_, yaw_})
    of_map->setEnabled(there);
}

void ReferenceDock::setState(const geometry::Pose2& world_from_map,
                             const std::vector<placing::PointPair>& pairs) {
  const QScopedValueRollback quiet(setting_, true);
  x_->setValue(world_from_map.x_m);
  y_->setValue(world_from_map.y_m);
  yaw_->setValue(geometry::degreesFromRadians(world_from_map.yaw_rad));
  const std::vector<double> residuals = placing::residualsOf(pairs, world_from_map);
  model_->setRowCount(int(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const QString texts[] = {coordinatesForClipboard(pairs[i].on_map_m),
                             coordinatesForClipboard(pairs[i].in_world_m), scene::lengthText(residuals[i])};
    for (int column = 0; column < 3; ++column) {
      auto* const item = new QStandardItem(texts[column]);
      item->setEditable(false);
      model_->setItem(int(i), column, item);
    }
  }
  clear_->setEnabled(!pairs.empty());
  fit_->setEnabled(!pairs.empty());
  remove_pair_->setEnabled(table_->selectionModel()->hasSelection());
  const int count = int(pairs.size());
  told_->setText(count == 0 ? tr("Two pairs of points or more turn the map, too.")
                 : count == 1
                     ? tr("One pair moves the map; a second one turns it, too.")
                     : sentences::counted(tr("%1 pairs, off by %2 (root mean square)", nullptr, count), count)
                           .arg(scene::lengthText(placing::rootMeanSquare(residuals))));
}

void ReferenceDock::setTool(bool moving, bool pairing) {
  move_->setChecked(moving);
  pair_->setChecked(pairing);
}

void ReferenceDock::setAlignment(const AlignmentShown& shown) {
  running_->setVisible(shown.running);
  progress_->setVisible(shown.running);
  said_->setText(shown.said);
  said_->setVisible(!shown.said.isEmpty());
  figures_->setText(shown.figures);
  figures_->setVisible(!shown.figures.isEmpty());
  agreement_->setVisible(shown.agreement.has_value());
  for (int side = 0; side < 2 && shown.agreement; ++side) {
    const align::WallDistances& walls = side == 0 ? shown.agreement->forward : shown.agreement->backward;
    const auto percent = [](double share, int digits) {
      return tr("%1 %").arg(words::fixed(share * 100, digits));
    };
    const QString texts[] = {percent(walls.within_10cm, 1), scene::lengthText(walls.median_m),
                             scene::lengthText(walls.p95_m), scene::lengthText(walls.max_m),
                             percent(walls.seen_share, 0)};
    for (std::size_t row = 0; row < distances_.size(); ++row)
      distances_[row][std::size_t(side)]->setText(texts[row]);
  }
  const bool part_off = shown.agreement && shown.agreement->part && !shown.offers;
  part_->setVisible(part_off);
  if (part_off) part_m_ = shown.agreement->part->middle_m;
  candidates_->setVisible(shown.offers);
  second_->setVisible(shown.has_second);
  best_->setEnabled(!shown.best_laid);
  second_->setEnabled(!shown.second_laid);
}

void ReferenceDock::setProgress(double done) {
  progress_->setValue(int(std::lround(done * progress_->maximum())));
}

void ReferenceDock::setWhyNoDifferences(const QString& why) {
  differences_->setEnabled(why.isEmpty());
  differences_->setToolTip(
      why.isEmpty() ? tr("Show what differs between the reference map and the map on screen: red is not on "
                         "the reference map, blue is only there")
                    : why);
  swipe_->setEnabled(why.isEmpty());
  swipe_->setToolTip(why.isEmpty()
                         ? tr("Drag a divider between the map on screen and the reference map as it "
                              "lies now; Esc ends it")
                         : why);
  walls_off_->setEnabled(why.isEmpty());
  walls_off_->setToolTip(why.isEmpty()
                             ? tr("Mark the walls of both maps that are far from those of the other "
                                  "one: a bent corridor is seen by them")
                             : why);
}

void ReferenceDock::setWallsOff(std::optional<bool> none) {
  legend_->setVisible(none == false);
  none_off_->setVisible(none == true);
}

void ReferenceDock::setWhyNotCarried(const QString& why) {
  carry_->setEnabled(why.isEmpty());
  carry_->setToolTip(
      why.isEmpty() ? tr("Find out what becomes of the waypoints of the reference map on the map on screen")
                    : why);
}

void ReferenceDock::setWhyOverlaysNotCarried(const QString& why) {
  carry_overlays_->setEnabled(why.isEmpty());
  carry_overlays_->setToolTip(
      why.isEmpty() ? tr("Find out what becomes of the overlays of the reference map on the map on screen")
                    : why);
}

QString ReferenceDock::told() const { return told_->text(); }
QString ReferenceDock::alignmentSaid() const { return said_->text(); }
QString ReferenceDock::alignmentFigures() const { return figures_->text(); }

void ReferenceDock::applyTyped() {
  if (setting_) return;
  Q_EMIT typed(
      {x_->value(), y_->value(), geometry::normalizeAngle(geometry::radiansFromDegrees(yaw_->value()))});
}

void ReferenceDock::removeSelected() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (!rows.isEmpty()) Q_EMIT pairUnwanted(rows.front().row());
}

bool ReferenceDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    removeSelected();
    return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_reference_dock.cpp"
