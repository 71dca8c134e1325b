#include "ui/carry/carry_dock.h"

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

namespace mapwright::ui {

namespace {

// Space and the arrow, or the mark. While the window is built there is no style sheet to ask.
constexpr int kAroundHeadPx = 48, kAroundVerdictPx = 34;

}  // namespace

CarryDock::CarryDock(const CarryWords& words, const QString& name, QWidget* parent)
    : QDockWidget(words.title, parent),
      model_(new CarryModel(words, this)),
      filtered_(new CarryFilter(*model_, this)),
      said_(textLabel({}, this)),
      again_(compactButton(tr("Check again"), this,
                           tr("Find out what becomes of them as the reference map lies now"))),
      filter_(new QComboBox(this)),
      adjust_(new QCheckBox(tr("Also adjust to the walls nearby"), this)),
      table_(new QuietTableView(this)),
      sound_(compactButton(tr("Carry over all that are sound"), this,
                           tr("They become changes of the map on screen. Nothing is sent yet."))),
      selected_(compactButton(tr("Carry over the selected"), this,
                              tr("Also what is not sound, to be placed by hand. Nothing is sent yet. In the "
                                 "list: A"))),
      leave_out_(compactButton(tr("Leave out"), this,
                               tr("Do not carry over what is selected; once more: do. In the list: X"))) {
  setObjectName(name);
  filter_->addItem(tr("All"), int(CarryFilter::Shown::All));
  filter_->addItem(tr("Sound"), int(CarryFilter::Shown::Sound));
  filter_->addItem(tr("To look at"), int(CarryFilter::Shown::ToLookAt));
  filter_->setAccessibleName(tr("Which of them are listed"));
  adjust_->setToolTip(tr("Move each a little further, to where the walls around it are now"));
  showRows(*table_, filtered_, words.named);
  table_->setToolTip(
      tr("N and P: the next and the previous that is not decided. A: carry it over. X: leave "
         "it out. Enter: show it on the map."));
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->installEventFilter(this);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setSortIndicator(-1, Qt::AscendingOrder);  // as the old map lists them
  table_->setSortingEnabled(true);
  // Long names are cut, not these: the heads with the arrow of the sorted one, and verdicts with their marks.
  const QString off = filtered_->headerData(CarryModel::WallsOff, Qt::Horizontal).toString();
  const int off_px = header->fontMetrics().horizontalAdvance(off) + kAroundHeadPx;
  const int became_px = fontMetrics().horizontalAdvance(tr("in an obstacle")) + kAroundVerdictPx;
  header->resizeSection(CarryModel::WallsOff, off_px);
  header->resizeSection(CarryModel::Became, became_px);
  new NameColumn(table_, header, CarryModel::Called,
                 {{CarryModel::WallsOff, off_px, false}, {CarryModel::Became, became_px, false}});
  auto* const buttons = new WrappingRow(QMargins(), 8);
  for (QPushButton* const button : {sound_, selected_, leave_out_}) buttons->add(button);
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
  connect(selected_, &QPushButton::clicked, this, [this] { Q_EMIT carryWanted(selected()); });
  connect(leave_out_, &QPushButton::clicked, this, [this] { Q_EMIT leaveOutWanted(selected()); });
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
  const bool may_go =
      std::any_of(chosen.begin(), chosen.end(), [&](int row) { return rows[std::size_t(row)].goes(); });
  selected_->setEnabled(editable_ && may_go);
  leave_out_->setEnabled(may_go);
}

std::vector<int> CarryDock::selected() const {
  std::vector<int> rows;
  for (const QModelIndex& at : table_->selectionModel()->selectedRows())
    rows.push_back(filtered_->mapToSource(at).row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

QString CarryDock::said() const { return said_->text(); }

std::vector<int> CarryDock::openFrom(bool forward) const {
  const int count = filtered_->rowCount(), step = forward ? 1 : -1;
  // The view makes a row the current one as soon as it has the focus: that has not been looked at.
  const int current = table_->currentIndex().row();
  const bool seen = current >= 0 && table_->selectionModel()->isRowSelected(current);
  const int from = seen ? current : forward ? -1 : count;
  std::vector<int> open;
  for (int row = from + step; row >= 0 && row < count; row += step) {
    const int listed = filtered_->mapToSource(filtered_->index(row, CarryModel::Called)).row();
    if (model_->rows()[std::size_t(listed)].state == CarryRow::State::Open) open.push_back(listed);
  }
  return open;
}

void CarryDock::showFirstOpen(const std::vector<int>& rows) {
  for (const int row : rows) {
    const QModelIndex at = filtered_->mapFromSource(model_->index(row, CarryModel::Called));
    if (!at.isValid() || model_->rows()[std::size_t(row)].state != CarryRow::State::Open) continue;
    table_->selectionModel()->setCurrentIndex(
        at, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    Q_EMIT placeWanted(row);
    return;
  }
}

std::function<void()> CarryDock::deedOf(int key) {
  switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!table_->currentIndex().isValid()) return {};
      return [this] { Q_EMIT placeWanted(filtered_->mapToSource(table_->currentIndex()).row()); };
    case Qt::Key_N:
    case Qt::Key_P:
      return [this, forward = key == Qt::Key_N] { showFirstOpen(openFrom(forward)); };
    case Qt::Key_A:
    case Qt::Key_X:
      return [this, button = key == Qt::Key_A ? selected_ : leave_out_] {
        // Before it: a row that is decided may lie elsewhere in the list, or be hidden.
        const std::vector<int> next = openFrom(true);
        button->click();
        showFirstOpen(next);
      };
    default:
      return {};
  }
}

bool CarryDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)) {
    const auto* const pressed = static_cast<QKeyEvent*>(event);
    const bool plain = !(pressed->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    if (const auto deed = plain ? deedOf(pressed->key()) : std::function<void()>()) {
      if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
      } else {
        deed();
      }
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_carry_dock.cpp"
