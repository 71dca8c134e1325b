#include "ui/slam/closures_dock.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableView>

#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"

namespace mapwright::ui {
namespace {

enum KindChoice { LoopClosures, WithinSubmaps, AllConstraints };
constexpr int kNumberLetters = 9, kIdLetters = 10;

}  // namespace

ClosuresDock::ClosuresDock(QWidget* parent)
    : QDockWidget(tr("Loop closures"), parent),
      model_(new ClosuresModel(this)),
      summary_(wrappedLabel({}, this)),
      places_(wrappedLabel({}, this)),
      filter_(new QLineEdit(this)),
      kinds_(new QComboBox(this)),
      least_(new DecimalBox(this)),
      by_submap_(new QCheckBox(tr("By submap"), this)),
      on_map_(new QCheckBox(tr("On the map"), this)),
      only_submap_(new QPushButton(themedIcon(QStringLiteral("close")), {}, this)),
      table_(new QuietTableView(this)),
      count_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("closures"));
  filter_->setPlaceholderText(tr("Submap or node, as 0-12"));
  filter_->setAccessibleName(tr("Search submaps and nodes"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  kinds_->addItem(tr("Loop closures"), LoopClosures);
  kinds_->addItem(tr("Within submaps"), WithinSubmaps);
  kinds_->addItem(tr("All constraints"), AllConstraints);
  kinds_->setAccessibleName(tr("Which constraints are listed"));
  kinds_->setToolTip(
      tr("Loop closures tie the robot to a submap of an earlier visit (INTER_SUBMAP); the others "
         "to the submap that was being made (INTRA_SUBMAP)"));
  least_->setRange(0, 100);
  least_->setDecimals(2);
  least_->setSingleStep(0.1);
  least_->setPrefix(tr("from "));
  least_->setSuffix(tr(" m"));
  least_->setAccessibleName(tr("Smallest residual that is listed"));
  by_submap_->setToolTip(
      tr("One row for each submap: its worst constraint, and how many contradict the map; Enter lists them"));
  only_submap_->setToolTip(tr("List the constraints of all submaps again"));
  only_submap_->hide();
  places_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // It has its room at all times: a row must not move away while it is being clicked.
  places_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  showRows(*table_, model_, tr("Constraints"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setSortIndicator(-1, Qt::AscendingOrder);
  header->setSortIndicatorClearable(true);
  table_->setSortingEnabled(true);
  QFont bold = header->font();  // headers are measured in it
  bold.setBold(true);
  const int letter_px = fontMetrics().averageCharWidth(),
            arrow_px = QFontMetrics(bold).horizontalAdvance(ClosuresModel::roomForArrow()) + 2;
  // While the window is built there is no style sheet to ask for the space around a head.
  constexpr int kMorePx = 12;
  const auto widen = [&](int column, int letters) {
    header->resizeSection(
        column, std::max(letters * letter_px, header->sectionSizeHint(column) + kMorePx + arrow_px));
  };
  for (const int column : {ClosuresModel::ResidualColumn, ClosuresModel::TurnColumn})
    widen(column, kNumberLetters);
  widen(ClosuresModel::NodeColumn, kIdLetters);
  widen(ClosuresModel::TimeColumn, kIdLetters);
  columns_ = new NameColumn(table_, header, ClosuresModel::SubmapColumn,
                            {{ClosuresModel::TimeColumn},
                             {ClosuresModel::TurnColumn},
                             // Needs more in one row for each submap.
                             {ClosuresModel::NodeColumn, kIdLetters * letter_px, true},
                             {ClosuresModel::ResidualColumn}});
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->installEventFilter(this);
  count_->setSecondary(true);
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({rowOf({{summary_, 1}}, 0, QMargins(8, 6, 8, 0)),
                            rowOf({{filter_, 1}, least_}, 6, QMargins(8, 0, 8, 0)),
                            rowOf({{kinds_, 1}, by_submap_, on_map_}, 6, QMargins(8, 0, 8, 0)),
                            rowOf({only_submap_, LayoutItem::rest()}, 0, QMargins(8, 0, 8, 0)),
                            {table_, 1},
                            rowOf({{places_, 1}}, 0, QMargins(8, 0, 8, 0)),
                            rowOf({{count_, 1}}, 0, QMargins(8, 0, 8, 4))},
                           4, QMargins()));
  setWidget(body);
  connect(header, &QHeaderView::sortIndicatorChanged, this, [this] { columns_->fit(); });
  connect(filter_, &QLineEdit::textChanged, this, &ClosuresDock::applyFilter);
  connect(kinds_, &QComboBox::currentIndexChanged, this, &ClosuresDock::applyFilter);
  connect(least_, &QDoubleSpinBox::valueChanged, this, &ClosuresDock::applyFilter);
  connect(by_submap_, &QCheckBox::toggled, this, [this](bool by_submap) {
    if (by_submap) submap_.reset();
    applyFilter();
  });
  connect(only_submap_, &QPushButton::clicked, this, &ClosuresDock::listAllSubmaps);
  connect(on_map_, &QCheckBox::toggled, this, &ClosuresDock::onMapWanted);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& row) {
            if (row.isValid() && !quiet_) Q_EMIT chosen(model_->row(row.row()));
          });
  // Once more on the row that is current already: back to its place.
  connect(table_, &QTableView::clicked, this,
          [this](const QModelIndex& row) { Q_EMIT chosen(model_->row(row.row())); });
  connect(table_, &QTableView::doubleClicked, this, &ClosuresDock::openSubmap);
  connect(table_, &QTableView::customContextMenuRequested, this, &ClosuresDock::showMenu);
  count();
}

ClosuresDock::~ClosuresDock() {
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void ClosuresDock::setSummary(const QString& text) { summary_->setText(text); }

void ClosuresDock::setRows(std::vector<ClosureRow> rows) {
  model_->setRows(std::move(rows));
  if (!shows_places_ || model_->all().empty()) hidePlaces();
  columns_->fit();
  count();
}

void ClosuresDock::listAllSubmaps() {
  submap_.reset();
  applyFilter();
}

void ClosuresDock::setPlaces(const Eigen::Vector2d& at, const Eigen::Vector2d& expected) {
  const auto place = [](const Eigen::Vector2d& where) {
    return QStringLiteral("%1, %2 m").arg(where.x(), 0, 'f', 3).arg(where.y(), 0, 'f', 3);
  };
  shows_places_ = true;
  places_->setText(tr("Lies at %1\nExpected at %2").arg(place(at), place(expected)));
}

void ClosuresDock::hidePlaces() {
  shows_places_ = false;
  places_->setText(model_->all().empty() ? QString()
                   : follows_ ? tr("Choose a row, or click its line on the map, to see where it lies.")
                              : tr("Choose a row to see where it lies."));
}

void ClosuresDock::setOnMap(bool shown, bool follows) {
  follows_ = follows;
  if (!shows_places_) hidePlaces();
  const QString tip = tr("Draw loop closures on the map, coloured by how much they contradict it");
  on_map_->setToolTip(follows ? tip + QLatin1Char('\n') +
                                    tr("Those that are not listed are not drawn while this panel is open")
                              : tip);
  on_map_->setChecked(shown);
  count();
}

void ClosuresDock::point(const ClosureRow& closure) {
  const int row = model_->rowOf(closure);
  if (row < 0) return;
  const QScopedValueRollback quiet(quiet_, true);
  table_->setCurrentIndex(model_->index(row, 0));
  table_->scrollTo(table_->currentIndex());
}

void ClosuresDock::applyFilter() {
  const auto kind = KindChoice(kinds_->currentData().toInt());
  model_->setFilter({.inter = kind != WithinSubmaps,
                     .intra = kind != LoopClosures,
                     .least_m = least_->value(),
                     .text = filter_->text().trimmed(),
                     .submap = submap_,
                     .by_submap = by_submap_->isChecked()});
  if (submap_) only_submap_->setText(tr("Submap %1").arg(QString::fromStdString(map::toText(*submap_))));
  only_submap_->setVisible(submap_.has_value());
  columns_->fit();
  count();
  Q_EMIT filtered();
}

void ClosuresDock::count() {
  const int listed = model_->rowCount();
  const auto all = int(model_->all().size());
  if (by_submap_->isChecked() && all > 0 && !model_->namesSubmaps()) {
    count_->setText(tr("A robot that maps does not name the submaps of its constraints."));
  } else if (by_submap_->isChecked()) {
    count_->setText(sentences::counted(tr("%1 submaps", nullptr, listed), listed));
  } else {
    const QString some = follows_ && on_map_->isChecked() && !model_->filter().listsLoopClosures()
                             ? tr("%1 of %2 constraints, and only these on the map")
                             : tr("%1 of %2 constraints");
    count_->setText(listed == all ? sentences::counted(tr("%1 constraints", nullptr, all), all)
                                  : some.arg(countText(listed), countText(all)));
  }
}

void ClosuresDock::openSubmap() {
  const QModelIndex current = table_->currentIndex();
  if (!current.isValid()) return;
  const ClosureRow row = model_->row(current.row());
  if (!by_submap_->isChecked() || !row.submap) return;
  submap_ = row.submap;
  by_submap_->setChecked(false);
}

void ClosuresDock::showMenu(const QPoint& at) {
  // Opened by a key, it is about the current row, wherever that is.
  const QModelIndex pointed = table_->indexAt(at);
  const QModelIndex index = pointed.isValid() ? pointed : table_->currentIndex();
  if (!index.isValid()) return;
  ClosureRow row = model_->row(index.row());
  QMenu menu(this);
  menu.addAction(themedIcon(QStringLiteral("locate")), tr("Show on the map"), this,
                 [this, row] { Q_EMIT chosen(row); });
  if (by_submap_->isChecked() && row.submap) {
    menu.addAction(tr("List its constraints"), this, &ClosuresDock::openSubmap);
    row.node.reset();
  }
  Q_EMIT menuOpening(&menu, row);
  menu.exec(table_->viewport()->mapToGlobal(at));
}

void ClosuresDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  Q_EMIT shown();
}

bool ClosuresDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && table_->currentIndex().isValid()) {
      Q_EMIT chosen(model_->row(table_->currentIndex().row()));
      openSubmap();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_closures_dock.cpp"
