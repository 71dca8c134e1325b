#include "window/waypoints/waypoints_dock.h"

#include <QCollator>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "edit/open_waypoints.h"
#include "sentences/reason_sentence.h"
#include "window/docks/tree_view.h"
#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/look/ui_colors.h"
#include "window/waypoints/waypoint_form.h"
#include "window/waypoints/waypoint_text.h"

namespace mapwright::window {

namespace {

constexpr int kRowPx = 24;

void secondary(QLabel* label, bool bad) {
  const UiColors colors = appColors();
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, bad ? colors.error_text : colors.secondary_text);
  label->setPalette(palette);
}

}  // namespace

/// Finds names and tags; "Rack 2" stands before "Rack 10".
class WaypointFilter : public QSortFilterProxyModel {
 public:
  explicit WaypointFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    // The C locale compares bytes, whatever is asked of it.
    if (order_.locale().language() == QLocale::C)
      order_.setLocale(QLocale(QLocale::English, QLocale::UnitedStates));
    order_.setNumericMode(true);
    order_.setCaseSensitivity(Qt::CaseInsensitive);
  }
  void look(const QString& text) {
    wanted_ = text.trimmed();
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    if (wanted_.isEmpty()) return true;
    for (const int column : {WaypointsModel::NameColumn, WaypointsModel::TagsColumn}) {
      if (sourceModel()->index(row, column, parent).data().toString().contains(wanted_, Qt::CaseInsensitive))
        return true;
    }
    return false;
  }

  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    const QVariant one = left.data(sortRole()), other = right.data(sortRole());
    if (one.typeId() != QMetaType::QString) return QSortFilterProxyModel::lessThan(left, right);
    return order_.compare(one.toString(), other.toString()) < 0;
  }

 private:
  QString wanted_;
  QCollator order_;
};

WaypointsDock::WaypointsDock(WaypointEditing* editing, QWidget* parent)
    : QDockWidget(tr("Waypoints"), parent),
      editing_(editing),
      model_(new WaypointsModel(this)),
      sorted_(new WaypointFilter(this)),
      filter_(new QLineEdit(this)),
      table_(new QuietTableView(this)),
      empty_(new QLabel(this)),
      status_(new QLabel(this)),
      conflict_(new QLabel(this)),
      conflict_box_(buildConflict()),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Delete"), this)),
      save_(new QPushButton(tr("Save"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      retry_(new QPushButton(tr("Retry"), this)),
      form_(new WaypointForm(editing, this)) {
  setObjectName(QStringLiteral("waypoints"));
  buildTable();
  filter_->setPlaceholderText(tr("Filter by name or tag"));
  filter_->setClearButtonEnabled(true);
  filter_->setAccessibleName(tr("Filter waypoints"));
  filter_->installEventFilter(this);
  for (QLabel* label : {empty_, status_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setContentsMargins(8, 4, 8, 4);
  }
  for (QLabel* label : {empty_, status_}) label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  add_->setToolTip(tr("A new waypoint in the middle of the view. On the map: press W, then click"));
  remove_->setToolTip(tr("Delete what is selected (Delete)"));
  save_->setToolTip(tr("Write the changes where the list is kept (Ctrl+S)"));
  add_->setIcon(themedIcon(QStringLiteral("add")));
  remove_->setIcon(themedIcon(QStringLiteral("trash")));
  save_->setIcon(themedIcon(QStringLiteral("save")));
  for (QPushButton* button : {add_, remove_, save_, cancel_, retry_})
    button->setObjectName(QStringLiteral("compact"));

  auto* body = new QWidget(this);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(6, 6, 6, 4);
  top->setSpacing(4);
  top->addWidget(filter_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(8, 4, 8, 4);
  buttons->setSpacing(6);
  buttons->addWidget(add_);
  buttons->addWidget(remove_);
  buttons->addStretch();
  for (QPushButton* button : {retry_, cancel_, save_}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(empty_);
  column->addWidget(table_, 1);
  column->addWidget(conflict_box_);
  column->addWidget(form_);
  column->addLayout(buttons);
  column->addWidget(status_);
  body->setMinimumWidth(220);
  setWidget(body);

  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->look(text);
    refresh();
  });
  connect(add_, &QPushButton::clicked, this, &WaypointsDock::addWanted);
  connect(remove_, &QPushButton::clicked, editing_, &WaypointEditing::removeSelected);
  connect(save_, &QPushButton::clicked, this, &WaypointsDock::saveWanted);
  connect(cancel_, &QPushButton::clicked, this, &WaypointsDock::cancelWanted);
  connect(retry_, &QPushButton::clicked, this, &WaypointsDock::retryWanted);
  connect(mine_, &QPushButton::clicked, this, [this] { Q_EMIT decided(shown_conflict_, true); });
  connect(theirs_, &QPushButton::clicked, this, [this] { Q_EMIT decided(shown_conflict_, false); });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &WaypointsDock::takeSelection);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    Q_EMIT locateWanted(model_->key(sorted_->mapToSource(index)));
  });
  connect(editing_, &WaypointEditing::selectionChanged, this, [this] {
    showSelection();
    refresh();
  });
  connect(editing_, &WaypointEditing::opened, this, [this] {
    model_->setDocument(editing_->document());
    if (editing_->document())
      connect(editing_->document(), &edit::DocumentEvents::changed, this, &WaypointsDock::refresh);
    refresh();
  });
  refresh();
}

WaypointsDock::~WaypointsDock() {
  // As in the other docks: the table goes later than what it reports to.
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
  filter_->removeEventFilter(this);
}

void WaypointsDock::buildTable() {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(WaypointsModel::kSortRole);
  table_->setModel(sorted_);
  table_->setItemDelegate(new TableRowDelegate(table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(WaypointsModel::NameColumn, Qt::AscendingOrder);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(kRowPx);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setAccessibleName(tr("Waypoints"));
  table_->installEventFilter(this);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(22);
  header->setSectionResizeMode(WaypointsModel::StateColumn, QHeaderView::Fixed);
  header->resizeSection(WaypointsModel::StateColumn, 26);
  header->setSectionResizeMode(WaypointsModel::NameColumn, QHeaderView::Stretch);
  const auto wide = [&](const char* sample) {
    return fontMetrics().horizontalAdvance(QLatin1String(sample)) + 12;
  };
  header->resizeSection(WaypointsModel::XColumn, wide("-12.34"));
  header->resizeSection(WaypointsModel::YColumn, wide("-12.34"));
  header->resizeSection(WaypointsModel::YawColumn, wide("-179.9"));
  header->resizeSection(WaypointsModel::TagsColumn, wide("charge"));
}

QWidget* WaypointsDock::buildConflict() {
  auto* box = new QFrame(this);
  box->setObjectName(QStringLiteral("details"));
  conflict_->setTextFormat(Qt::PlainText);
  conflict_->setWordWrap(true);
  mine_ = new QPushButton(tr("Keep mine"), box);
  theirs_ = new QPushButton(tr("Take theirs"), box);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  for (QPushButton* button : {mine_, theirs_}) {
    button->setObjectName(QStringLiteral("compact"));
    row->addWidget(button);
  }
  row->addStretch();
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(8, 6, 8, 6);
  column->setSpacing(4);
  column->addWidget(conflict_);
  column->addLayout(row);
  box->hide();
  return box;
}

void WaypointsDock::setList(const edit::OpenWaypoints* list, const QString& sentence) {
  if (list_) list_->disconnect(this);
  list_ = list;
  sentence_ = sentence;
  if (list_) {
    connect(list_, &edit::OpenWaypoints::changed, this, &WaypointsDock::refresh);
    connect(list_, &QObject::destroyed, this, [this](QObject* gone) {
      if (gone == list_) list_ = nullptr;
    });
  }
  refresh();
}

void WaypointsDock::showSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  QItemSelection selection;
  QModelIndex last;
  for (const edit::Key& key : editing_->selected()) {
    last = sorted_->mapFromSource(model_->indexOf(key));
    if (last.isValid()) selection.select(last, last);
  }
  table_->selectionModel()->select(selection,
                                   QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (last.isValid()) {
    table_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    table_->scrollTo(last);
  }
  showing_selection_ = false;
}

void WaypointsDock::takeSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  std::set<edit::Key> keys;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
    const edit::Key key = model_->key(sorted_->mapToSource(row));
    if (!key.empty()) keys.insert(key);
  }
  editing_->select(std::move(keys));
  showing_selection_ = false;
}

void WaypointsDock::refresh() {
  const edit::WaypointDocument* const document = editing_->document();
  const bool editable = editing_->editable(), saving = list_ && list_->saving();
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  filter_->setEnabled(document && !document->items().empty());
  add_->setEnabled(editable);
  remove_->setEnabled(editable && !editing_->selected().empty());
  save_->setEnabled(list_ && list_->maySave());
  save_->setVisible(!saving);
  cancel_->setVisible(saving);
  retry_->setVisible(list_ && list_->failure() && !saving);
  form_->setVisible(document != nullptr);
  const bool bad =
      list_ && (list_->failure() || list_->submission().phase() == edit::SubmissionPhase::Stopped ||
                list_->draftTrouble().any());
  status_->setText(statusText());
  status_->setToolTip(plainToolTip(status_->text()));  // where there is no room for all of it
  status_->setVisible(!status_->text().isEmpty());
  secondary(status_, bad);

  // The conflict of what is selected, else the first one.
  shown_conflict_.clear();
  if (document && !document->conflicts().empty()) {
    shown_conflict_ = document->conflicts().begin()->first;
    for (const edit::Key& key : editing_->selected()) {
      if (document->conflicts().contains(key)) shown_conflict_ = key;
    }
    const auto& conflict = document->conflicts().at(shown_conflict_);
    const auto& any = conflict.mine ? conflict.mine : conflict.theirs ? conflict.theirs : conflict.base;
    const auto count = qsizetype(document->conflicts().size());
    const QString which = any ? shortWaypointName(*any) : QString();
    conflict_->setText(
        (count == 1 ? tr("%1 was changed here and elsewhere.").arg(which)
                    : tr("%1 was changed here and elsewhere, like %2 more.").arg(which).arg(count - 1)) +
        QLatin1Char('\n') + conflictText(conflict));
  }
  conflict_box_->setVisible(!shown_conflict_.empty());
}

QString WaypointsDock::statusText() const {
  const edit::WaypointDocument* const document = editing_->document();
  if (!document) return {};
  if (!editing_->editable()) return editing_->whyNot();
  if (!list_) return {};
  if (list_->saving()) return tr("Saving…");
  QStringList parts;
  const auto& submission = list_->submission();
  const bool stopped =
      submission.phase() == edit::SubmissionPhase::Stopped && submission.failure() && list_->unsaved();
  const QString not_read = list_->failure() ? failureText(*list_->failure()) : QString();
  const QString not_saved = stopped ? failureText(*submission.failure()) : QString();
  // Where one thing stands in the way of both it is told once.
  if (!not_read.isEmpty() && not_read != not_saved) parts << not_read;
  if (stopped) {
    QString text = tr("Not saved. %1").arg(not_saved);
    if (submission.rows().size() > 1 && submission.done() < submission.rows().size())
      text += QLatin1Char(' ') +
              tr("%1 of %2 requests were carried out.").arg(submission.done()).arg(submission.rows().size());
    parts << text;
  }
  if (list_->draftTrouble().any()) parts << tr("No draft is kept.");
  const auto unsaved = qsizetype(document->unsaved().size());
  QString count = waypointsText(qsizetype(document->items().size()));
  if (unsaved > 0) count += tr(", %1 not saved").arg(changesText(unsaved));
  parts << count + QLatin1Char('.');
  for (std::size_t i = 0; i < std::min<std::size_t>(list_->notes().size(), 3); ++i)
    parts << sentences::sentenceOf(list_->notes()[i]);
  return parts.join(QLatin1Char('\n'));
}

QString WaypointsDock::emptyText() const {
  const edit::WaypointDocument* const document = editing_->document();
  if (!document) return sentence_;
  if (document->items().empty())
    return editing_->editable() ? tr("No waypoints yet. Press W and click on the map to add one.")
                                : tr("There are no waypoints.");
  return sorted_->rowCount() == 0 ? tr("No waypoint matches the filter.") : QString();
}

QString WaypointsDock::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString WaypointsDock::conflictShown() const {
  return conflict_box_->isHidden() ? QString() : conflict_->text();
}
QString WaypointsDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }

bool WaypointsDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto* press = static_cast<QKeyEvent*>(event);
    if (watched == table_) {
      switch (press->key()) {
        case Qt::Key_Delete:
          editing_->removeSelected();
          return true;
        case Qt::Key_F2:
          if (form_->isEnabled()) {
            form_->nameEdit()->setFocus();
            form_->nameEdit()->selectAll();
          }
          return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
          if (editing_->only()) Q_EMIT locateWanted(*editing_->selected().begin());
          return true;
        default:
          break;
      }
    } else if (watched == filter_ && press->key() == Qt::Key_Down) {
      table_->setFocus();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::window
