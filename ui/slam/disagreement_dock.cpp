#include "ui/slam/disagreement_dock.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

#include "sentences/plural.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/wrapping_row.h"
#include "words/fixed.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

constexpr std::array kTolerances{0, 1, 4};

QString submapNames(const std::vector<agreement::Part>& submaps) {
  QStringList names;
  for (const agreement::Part& part : submaps) names << QString::fromStdString(map::toText(part.id));
  return words::listed(names);
}

/// What each of them says, a line each.
QString submapClaims(const std::vector<agreement::Part>& submaps) {
  constexpr std::size_t kMost = 12;
  QStringList lines;
  for (std::size_t at = 0; at < std::min(submaps.size(), kMost); ++at)
    lines << PlacesModel::tr("%1: %2").arg(QString::fromStdString(map::toText(submaps[at].id)),
                                           claimText(submaps[at]));
  if (submaps.size() > kMost) {
    const auto more = qint64(submaps.size() - kMost);
    lines << sentences::counted(PlacesModel::tr("and %1 others", nullptr, sentences::formOf(more)), more);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

QString claimText(const agreement::Part& part) {
  return PlacesModel::tr("occupied in %1 cells, free in %2")
      .arg(countText(part.occupied), countText(part.free));
}

void PlacesModel::setPlaces(Places places) {
  const bool same =
      std::equal(places->begin(), places->end(), places_->begin(), places_->end(),
                 [](const agreement::Place& a, const agreement::Place& b) {
                   return a.x == b.x && a.y == b.y && a.cells == b.cells && a.submaps == b.submaps;
                 });
  if (same) return;  // where the list is scrolled to stays
  beginResetModel();
  places_ = std::move(places);
  endResetModel();
}

int PlacesModel::rowOf(const agreement::Place& place) const {
  const auto found = std::find_if(places_->begin(), places_->end(), [&](const agreement::Place& other) {
    return other.x == place.x && other.y == place.y;
  });
  return found == places_->end() ? -1 : int(found - places_->begin());
}

QVariant PlacesModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const agreement::Place& place = this->place(index.row());
  const bool submaps = index.column() == SubmapsColumn;
  if (role == Qt::TextAlignmentRole)
    return int((submaps ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && submaps) return plainToolTip(submapClaims(place.submaps));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case CellsColumn:
      return countText(qint64(place.cells));
    case XColumn:
      return words::fixed(place.x, 1);
    case YColumn:
      return words::fixed(place.y, 1);
    case SubmapsColumn:
      return submapNames(place.submaps);
  }
  return {};
}

QVariant PlacesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == SubmapsColumn ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && section == CellsColumn)
    return tr("How many cells contradict within a square of 1 m");
  if (role == Qt::ToolTipRole && section == SubmapsColumn)
    return tr("Those that disagree, in most of the cells first; point at a row for what each of them says");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case CellsColumn:
      return tr("Cells");
    case XColumn:
      return tr("x (m)");
    case YColumn:
      return tr("y (m)");
    case SubmapsColumn:
      return tr("Submaps");
  }
  return {};
}

DisagreementDock::DisagreementDock(QWidget* parent)
    : QDockWidget(tr("Disagreement"), parent),
      model_(new PlacesModel(this)),
      tolerance_(new QComboBox(this)),
      layer_(new QCheckBox(tr("On the map"), this)),
      summary_(textLabel({}, this)),
      progress_(new QProgressBar(this)),
      work_(compactButton(tr("Cancel"), this)),
      table_(new QuietTableView(this)),
      steps_(new QWidget(this)),
      shown_(new PlainLabel(this)),
      blink_(compactButton(tr("Blink"), this, tr("Show the submaps that disagree in turn"))),
      next_(compactButton(tr("Next submap"), this, tr("Of those that disagree, show only the next one"))),
      all_(compactButton(tr("All"), this, tr("Show everything as before"))),
      hide_(compactButton(tr("Hide"), this)),
      show_hidden_(compactButton(tr("Show hidden"), this, tr("Show all submaps that you have hidden"))) {
  setObjectName(QStringLiteral("disagreement"));
  for (const int cells : kTolerances) {
    tolerance_->addItem(
        cells == 0 ? tr("Exact") : sentences::counted(tr("Within %1 cells", nullptr, cells), cells), cells);
  }
  tolerance_->setAccessibleName(tr("Tolerance"));
  layer_->setToolTip(tr("Show the layer Disagreement"));
  makeLine(*progress_);
  progress_->setAccessibleName(tr("Progress"));
  showRows(*table_, model_, tr("Places where submaps disagree"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->installEventFilter(this);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  const int number_px = fontMetrics().horizontalAdvance(QStringLiteral("-1,234.5")) + 16;
  for (const int column : {PlacesModel::CellsColumn, PlacesModel::XColumn, PlacesModel::YColumn})
    header->resizeSection(column, number_px);
  new NameColumn(table_, header, PlacesModel::SubmapsColumn,
                 {{PlacesModel::CellsColumn, number_px, false},
                  {PlacesModel::XColumn, number_px, false},
                  {PlacesModel::YColumn, number_px, false}});
  blink_->setCheckable(true);
  shown_->setSample(QStringLiteral("x"));
  shown_->setMostLines(2);
  shown_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* const tools = new WrappingRow;
  for (QPushButton* button : {blink_, next_, all_, hide_}) tools->add(button);
  tools->add(shown_, 1, 120);
  steps_->setLayout(tools);
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({rowOf({{tolerance_, 1}, layer_}, 8, QMargins(8, 6, 8, 0)),
                            rowOf({{summary_, 1}}, 0, QMargins(8, 0, 8, 0)),
                            rowOf({show_hidden_, LayoutItem::rest()}, 0, QMargins(8, 0, 8, 0)),
                            rowOf({{progress_, 1}, work_}, 8, QMargins(8, 0, 8, 0)),
                            {table_, 1},
                            steps_,
                            LayoutItem(static_cast<QWidget*>(nullptr))},  // while there is no table
                           6, QMargins()));
  setWidget(body);
  connect(table_, &QTableView::clicked, this,
          [this](const QModelIndex& index) { Q_EMIT placeWanted(index.row()); });
  setTolerance(kTolerances.back(), agreement::Rules().cell_m);
  setPlaces(std::make_shared<std::vector<agreement::Place>>());
  setWork(Work::Done, 1);
  setSteps(false, false, {}, InHand::None);
  setHidden(false);
}

DisagreementDock::~DisagreementDock() { table_->removeEventFilter(this); }

void DisagreementDock::setText(const QString& text) {
  if (text != summary_->text()) summary_->setText(text);
}

void DisagreementDock::setPlaces(PlacesModel::Places places) {
  table_->setVisible(!places->empty());
  steps_->setVisible(!places->empty() || blink_->isEnabled());
  const QModelIndex current = table_->currentIndex();
  // The focus alone makes a row the current one.
  const auto selected = [this](const QModelIndex& index) {
    return index.isValid() && table_->selectionModel()->isSelected(index);
  };
  if (selected(current)) chosen_ = model_->place(current.row());
  const bool in_view =
      current.isValid() && table_->viewport()->rect().intersects(table_->visualRect(current));
  const int row_before = current.row(), top_before = table_->verticalScrollBar()->value();
  model_->setPlaces(std::move(places));
  const int row = chosen_ ? model_->rowOf(*chosen_) : -1;
  if (row < 0 || selected(model_->index(row, 0))) return;
  table_->setAutoScroll(false);  // the user may look at others
  table_->setCurrentIndex(model_->index(row, 0));
  table_->setAutoScroll(true);
  table_->doItemsLayout();
  const int step =
      table_->verticalScrollMode() == QAbstractItemView::ScrollPerItem ? 1 : table_->rowHeight(row);
  table_->verticalScrollBar()->setValue(top_before + (in_view ? (row - row_before) * step : 0));
}

void DisagreementDock::setWork(Work work, double share_made) {
  progress_->setVisible(work == Work::Goes);
  progress_->setValue(int(std::lround(share_made * progress_->maximum())));
  work_->setVisible(work != Work::Done);
  work_->setText(work == Work::Goes ? tr("Cancel") : tr("Go on"));
}

void DisagreementDock::setSteps(bool possible, bool stepping, const QString& text, InHand in_hand) {
  hide_->setEnabled(in_hand != InHand::None);
  hide_->setText(in_hand == InHand::Show ? tr("Show") : tr("Hide"));
  hide_->setToolTip(in_hand == InHand::Show
                        ? tr("Show this submap on the map again")
                        : tr("Hide this submap, as in the SLAM inspector, and show the others"));
  for (QPushButton* button : {blink_, next_}) button->setEnabled(possible);
  all_->setEnabled(stepping);
  steps_->setVisible(possible || model_->rowCount() > 0);
  shown_->setText(text);
}

void DisagreementDock::setHidden(bool any) { show_hidden_->setVisible(any); }

void DisagreementDock::setTolerance(int cells, double cell_m) {
  for (int i = 0; i < tolerance_->count(); ++i) {
    const int of_item = tolerance_->itemData(i).toInt();
    if (of_item == cells) tolerance_->setCurrentIndex(i);
    tolerance_->setItemData(i,
                            of_item == 0 ? tr("A wall that is seen a cell beside contradicts")
                                         : tr("A wall that is seen up to %1 cm beside is the same wall")
                                               .arg(words::fixed(100 * of_item * cell_m, 0)),
                            Qt::ToolTipRole);
  }
  tolerance_->setToolTip(tolerance_->currentData(Qt::ToolTipRole).toString());
}

int DisagreementDock::tolerance() const { return tolerance_->currentData().toInt(); }

void DisagreementDock::clearSelection() {
  chosen_.reset();
  table_->setCurrentIndex({});
  table_->clearSelection();
}

bool DisagreementDock::eventFilter(QObject* watched, QEvent* event) {
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

#include "moc_disagreement_dock.cpp"
