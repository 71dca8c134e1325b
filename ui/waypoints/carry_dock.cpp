#include "ui/waypoints/carry_dock.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/wrapping_row.h"

namespace mapwright::window {

CarryDock::CarryDock(QWidget* parent)
    : QDockWidget(tr("Carry over"), parent),
      model_(new CarryModel(this)),
      filtered_(new CarryFilter(*model_, this)),
      said_(textLabel({}, this)),
      again_(compactButton(tr("Check again"), this,
                           tr("Find out what becomes of the waypoints as the reference map lies now"))),
      filter_(new QComboBox(this)),
      adjust_(new QCheckBox(tr("Also adjust to the walls nearby"), this)),
      table_(new QuietTableView(this)),
      sound_(compactButton(tr("Carry over all that are sound"), this,
                           tr("They become new waypoints of the map on screen. Nothing is sent yet."))),
      selected_(compactButton(tr("Carry over the selected"), this,
                              tr("Also what is not sound, to be placed by hand. Nothing is sent yet."))) {
  setObjectName(QStringLiteral("carryOver"));
  filter_->addItem(tr("All"), int(CarryFilter::Shown::All));
  filter_->addItem(tr("Sound"), int(CarryFilter::Shown::Sound));
  filter_->addItem(tr("To look at"), int(CarryFilter::Shown::ToLookAt));
  filter_->setAccessibleName(tr("Which waypoints are listed"));
  adjust_->setToolTip(tr("Move each a little further, to where the walls around it are now"));
  showRows(*table_, filtered_, tr("What becomes of the waypoints"));
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->installEventFilter(this);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setSortIndicator(-1, Qt::AscendingOrder);  // as the old map lists them
  table_->setSortingEnabled(true);
  const auto wide = [this](const QString& text) { return fontMetrics().horizontalAdvance(text) + 28; };
  header->resizeSection(
      CarryModel::WallsOff,
      wide(model_->headerData(CarryModel::WallsOff, Qt::Horizontal, Qt::DisplayRole).toString()));
  header->resizeSection(CarryModel::Became, wide(tr("on the new map already")));
  new NameColumn(table_, header, CarryModel::Called,
                 {{CarryModel::WallsOff, 60, false}, {CarryModel::Became, 90, false}});
  auto* const buttons = new WrappingRow(QMargins(), 8);
  for (QPushButton* const button : {sound_, selected_}) buttons->add(button);
  auto* const options = new WrappingRow(QMargins(), 8);
  options->add(filter_);
  options->add(adjust_);
  auto* const body = new QWidget(this);
  body->setLayout(columnOf({said_, rowOf({again_, LayoutItem::rest()}), options, {table_, 1}, buttons}, 6,
                           QMargins(8, 6, 8, 6)));
  setWidget(body);
  connect(filter_, &QComboBox::currentIndexChanged, this, [this] {
    filtered_->show(CarryFilter::Shown(filter_->currentData().toInt()));
    allowButtons();
  });
  connect(adjust_, &QCheckBox::toggled, this, &CarryDock::lookWanted);
  connect(again_, &QPushButton::clicked, this, &CarryDock::lookWanted);
  connect(sound_, &QPushButton::clicked, this, &CarryDock::soundWanted);
  connect(selected_, &QPushButton::clicked, this, &CarryDock::selectedWanted);
  connect(table_, &QTableView::clicked, this,
          [this](const QModelIndex& at) { Q_EMIT placeWanted(filtered_->mapToSource(at).row()); });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &CarryDock::allowButtons);
  setState({});
}

CarryDock::~CarryDock() {
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void CarryDock::setState(const CarryShown& shown) {
  said_->setText(shown.said);
  again_->setVisible(shown.again);
  editable_ = shown.editable;
  allowButtons();
}

void CarryDock::allowButtons() {
  const auto& rows = model_->rows();
  sound_->setEnabled(editable_ &&
                     std::any_of(rows.begin(), rows.end(), [](const CarryRow& row) { return row.sound(); }));
  const std::vector<int> chosen = selected();
  selected_->setEnabled(editable_ && std::any_of(chosen.begin(), chosen.end(), [&](int row) {
                          return rows[std::size_t(row)].state == CarryRow::State::Open;
                        }));
}

std::vector<int> CarryDock::selected() const {
  std::vector<int> rows;
  for (const QModelIndex& at : table_->selectionModel()->selectedRows())
    rows.push_back(filtered_->mapToSource(at).row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

QString CarryDock::said() const { return said_->text(); }

bool CarryDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && table_->currentIndex().isValid()) {
      Q_EMIT placeWanted(filtered_->mapToSource(table_->currentIndex()).row());
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_carry_dock.cpp"
