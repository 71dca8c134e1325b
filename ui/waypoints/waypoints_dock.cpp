#include "ui/waypoints/waypoints_dock.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "edit/open_waypoints.h"
#include "exchange/waypoint_plan.h"
#include "sentences/fault_sentence.h"
#include "sentences/placing_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/row_selection.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_conflicts.h"
#include "ui/waypoints/waypoint_forms.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::ui {

namespace {

bool notBackedUp(const edit::OpenWaypoints& list) { return list.drafts() && list.drafts()->trouble().any(); }

constexpr int kWaypointRowPx = 24;

}  // namespace

WaypointsDock::WaypointsDock(WaypointEditing* editing, QWidget* parent)
    : QDockWidget(tr("Waypoints"), parent),
      editing_(editing),
      model_(new WaypointsModel(this)),
      sorted_(new WaypointFilter(this)),
      filter_(new QLineEdit(this)),
      table_(new QuietTableView(this)),
      pending_(new QComboBox(this)),
      empty_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      conflicts_(new ConflictBox(this)),
      add_(compactButton(tr("Add"), this,
                         tr("Add a waypoint in the centre of the view. On the map: press W, then click"))),
      remove_(compactButton(tr("Delete"), this, tr("Delete the selected waypoints (Delete)"))),
      save_(compactButton(tr("Save"), this, tr("Save the changes (Ctrl+S)"))),
      cancel_(compactButton(tr("Cancel"), this)),
      retry_(compactButton(tr("Retry"), this)),
      next_warning_(new QToolButton(this)),
      form_(new WaypointForm(editing, this)),
      group_(new GroupForm(editing, this)) {
  setObjectName(QStringLiteral("waypoints"));
  buildTable();
  buildFilter();
  for (QLabel* label : {empty_, status_}) {
    label->setContentsMargins(8, 4, 8, 4);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  add_->setIcon(themedIcon(QStringLiteral("add")));
  remove_->setIcon(themedIcon(QStringLiteral("trash")));
  save_->setIcon(themedIcon(QStringLiteral("save")));

  next_warning_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  next_warning_->setIconSize({16, 16});
  next_warning_->setFocusPolicy(Qt::StrongFocus);
  next_warning_->setToolTip(plainToolTip(tr("Show the next waypoint with a warning (F8)")));
  next_warning_->hide();

  auto* body = new QWidget(this);
  auto* buttons = rowOf({add_, remove_, LayoutItem::rest(), next_warning_, retry_, cancel_, save_}, 6);
  buttons->setContentsMargins(8, 4, 8, 4);
  body->setLayout(columnOf({rowOf({{filter_, 1}, pending_}, 4, QMargins(6, 6, 6, 4)),
                            empty_,
                            {table_, 1},
                            conflicts_,
                            form_,
                            group_},
                           0, QMargins()));
  body->setMinimumWidth(220);
  auto* end = new QWidget(this);
  end->setLayout(columnOf({buttons, status_}, 0, QMargins()));
  setScrolledWidget(*this, body, end);

  connect(add_, &QPushButton::clicked, this, &WaypointsDock::addWanted);
  connect(remove_, &QPushButton::clicked, editing_, &WaypointEditing::removeSelected);
  connect(save_, &QPushButton::clicked, this, &WaypointsDock::saveWanted);
  connect(cancel_, &QPushButton::clicked, this, &WaypointsDock::cancelWanted);
  connect(retry_, &QPushButton::clicked, this, &WaypointsDock::retryWanted);
  // Enter ends the name: what is typed next is for the map and the list again.
  connect(form_->nameEdit(), &QLineEdit::returnPressed, this, [this] { table_->setFocus(); });
  connect(conflicts_, &ConflictBox::decided, this, &WaypointsDock::decided);
  // List, form and map are about the same one.
  connect(conflicts_, &ConflictBox::locateWanted, this, [this](const edit::Key& key) {
    editing_->select(editing_->find(key) ? std::set<edit::Key>{key} : std::set<edit::Key>());
    Q_EMIT locateWanted(key);
  });
  // When all rows are rebuilt, restores the selection.
  connect(sorted_, &QAbstractItemModel::modelReset, this, &WaypointsDock::showSelection);
  connect(next_warning_, &QToolButton::clicked, this, &WaypointsDock::nextWarningWanted);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &WaypointsDock::onSelection);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    Q_EMIT locateWanted(model_->key(sorted_->mapToSource(index)));
  });
  connect(editing_, &WaypointEditing::selectionChanged, this, [this] {
    showSelection();
    refresh();
  });
  connect(qApp, &QApplication::focusChanged, this, [this](const QWidget* was, const QWidget* now) {
    const auto left = [was, now](const QWidget& form) {
      return form.isAncestorOf(was) && !form.isAncestorOf(now);
    };
    if (left(*form_)) form_->refresh();
    if (left(*form_) || left(*group_)) refresh();
  });
  connect(editing_, &WaypointEditing::opened, this, [this] {
    model_->setDocument(editing_->document());
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, &WaypointsDock::refresh);
    refresh();
  });
  refresh();
}

WaypointsDock::~WaypointsDock() {
  // As in the other docks: the table is destroyed later than the object it reports to.
  table_->selectionModel()->disconnect(this);
  qApp->disconnect(this);
  table_->removeEventFilter(this);
  filter_->removeEventFilter(this);
}

void WaypointsDock::buildTable() {
  sorted_->setSourceModel(model_);
  showRows(*table_, sorted_, tr("Waypoints"), kWaypointRowPx);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(WaypointsModel::NameColumn, Qt::AscendingOrder);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->installEventFilter(this);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QWidget::customContextMenuRequested, this, &WaypointsDock::showMenu);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(22);
  header->setSectionResizeMode(WaypointsModel::StateColumn, QHeaderView::Fixed);
  header->resizeSection(WaypointsModel::StateColumn, 26);
  const auto wide = [&](const char* sample) {
    return fontMetrics().horizontalAdvance(QLatin1String(sample)) + 12;
  };
  header->resizeSection(WaypointsModel::XColumn, wide("-12.34"));
  header->resizeSection(WaypointsModel::YColumn, wide("-12.34"));
  header->resizeSection(WaypointsModel::YawColumn, wide("-179.9"));
  header->resizeSection(WaypointsModel::TagsColumn, wide("charge"));
  new NameColumn(table_, header, WaypointsModel::NameColumn,
                 {{WaypointsModel::TagsColumn, 40, true},
                  {WaypointsModel::YawColumn},
                  {WaypointsModel::YColumn},
                  {WaypointsModel::XColumn},
                  {WaypointsModel::StateColumn, 26}});
}

void WaypointsDock::buildFilter() {
  filter_->setPlaceholderText(tr("Filter by name or tag"));
  filter_->setClearButtonEnabled(true);
  filter_->setAccessibleName(tr("Filter waypoints"));
  filter_->installEventFilter(this);
  pending_->setAccessibleName(tr("Filter unsaved waypoints"));
  pending_->addItem(tr("All"), 0);
  pending_->addItem(tr("Not saved"), int(kUnsaved));
  pending_->addItem(tr("New"), int(kNew));
  pending_->addItem(tr("Moved"), int(kMoved));
  pending_->addItem(tr("Renamed"), int(kRenamed));
  pending_->addItem(tr("Retagged"), int(kRetagged));
  pending_->addItem(tr("Deleted"), int(kDeleted));
  pending_->addItem(tr("In conflict"), int(kConflicting));
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->look(text);
    refresh();
  });
  connect(pending_, &QComboBox::currentIndexChanged, this, [this] {
    sorted_->lookForPending(pending_->currentData().toInt());
    refresh();
  });
}

void WaypointsDock::setList(const edit::OpenWaypoints* list, const QString& sentence, const QString& remark) {
  if (list_) list_->disconnect(this);
  list_ = list;
  sentence_ = sentence;
  remark_ = remark;
  if (list_) {
    connect(list_, &edit::OpenWaypoints::changed, this, &WaypointsDock::refresh);
    connect(list_, &QObject::destroyed, this, [this](QObject* gone) {
      if (gone == list_) list_ = nullptr;
    });
  }
  refresh();
}

void WaypointsDock::setWarnings(const WaypointWarnings* warnings) {
  warnings_ = warnings;
  model_->setWarnings(warnings);
  form_->setWarnings(warnings);
  connect(warnings, &WaypointWarnings::changed, this, [this] {
    showWarnings();
    status_->setText(statusText());
    table_->viewport()->update();
  });
  showWarnings();
}

void WaypointsDock::showWarnings() {
  const auto count = qint64(warnings_->count());
  next_warning_->setVisible(count > 0);
  next_warning_->setIcon(iconPixmap(QStringLiteral("problem"), 16, devicePixelRatioF(), appColors().warning));
  // Only the number: a dock is narrow.
  next_warning_->setText(QString::number(count));
  next_warning_->setAccessibleName(
      sentences::counted(tr("%1 warnings", nullptr, sentences::formOf(count)), count));
}

void WaypointsDock::showSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  std::vector<int> rows;
  for (const edit::Key& key : editing_->selected()) {
    const QModelIndex at = sorted_->mapFromSource(model_->indexOf(key));
    if (at.isValid()) rows.push_back(at.row());
  }
  selectRows(*table_, std::move(rows), WaypointsModel::NameColumn);
  showing_selection_ = false;
}

void WaypointsDock::onSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  std::set<edit::Key> keys;
  for (const QItemSelectionRange& range : table_->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) {
      const edit::Key key = model_->key(sorted_->mapToSource(sorted_->index(row, 0)));
      if (editing_->find(key)) keys.insert(key);  // those that I deleted can only be restored
    }
  }
  editing_->select(std::move(keys));
  showing_selection_ = false;
}

void WaypointsDock::refresh() {
  const edit::WaypointDocument* const document = editing_->document();
  const bool editable = editing_->editable(), saving = list_ && list_->saving();
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  const bool any_rows = document && model_->rowCount() > 0;
  filter_->setEnabled(any_rows || filter_->hasFocus());
  pending_->setEnabled(any_rows);
  add_->setEnabled(editable);
  const QString stays = editing_->notRemovedReason();
  remove_->setEnabled(editable && !editing_->selected().empty() && stays.isEmpty());
  remove_->setToolTip(editable && !stays.isEmpty() ? plainToolTip(stays)
                                                   : tr("Delete the selected waypoints (Delete)"));
  save_->setEnabled(list_ && list_->unsaved() && !saving);
  save_->setVisible(!saving);
  cancel_->setVisible(saving);
  retry_->setVisible(list_ && list_->failure() && !saving);
  const bool several = editing_->selected().size() > 1;
  // One that is being typed into stays until the focus goes elsewhere: letters are commands there.
  form_->setVisible((document && !several) || hasFocusInside(*form_));
  group_->setVisible((document && several) || hasFocusInside(*group_));
  status_bad_ =
      list_ && (list_->failure() || (list_->stoppedBy() && list_->unsaved()) || notBackedUp(*list_));
  status_->setText(statusText());
  status_->setToolTip(plainToolTip(status_->text()));  // if there is no room for all of it
  status_->setVisible(!status_->text().isEmpty());
  setTextColor(*status_, status_bad_ ? appColors().error_text : appColors().secondary_text);

  const bool deciding = conflicts_->isAncestorOf(QApplication::focusWidget());
  conflicts_->refresh(document, editing_->selected());
  // Not on to the next field: a key that is meant for the map would be typed into it.
  if (deciding && conflicts_->isHidden()) table_->setFocus();
}

QString WaypointsDock::statusText() const {
  const edit::WaypointDocument* const document = editing_->document();
  if (!document) return {};
  if (!editing_->editable()) return editing_->unavailableReason();
  if (!list_) return {};
  if (list_->saving()) return tr("Saving…");
  QStringList parts;
  const auto stopped_by = list_->unsaved() ? list_->stoppedBy() : std::nullopt;
  const QString not_saved = stopped_by ? notSavedText(*list_, *stopped_by) : QString();
  // If both have the same reason it is shown once.
  const bool told =
      stopped_by && list_->failure() && reasonText(*list_->failure()) == reasonText(*stopped_by);
  if (list_->failure() && !told) parts << failureText(*list_->failure());
  if (stopped_by) parts << not_saved;
  if (notBackedUp(*list_)) parts << tr("No draft is kept.");
  const auto unsaved = qsizetype(document->unsaved().size());
  QString count = waypointsText(qsizetype(document->items().size()));
  if (unsaved > 0) count += tr(", %1 not saved").arg(changesText(unsaved));
  parts << count + QLatin1Char('.');
  if (warnings_ && !document->items().empty() && !warnings_->looking()) {
    const QString ground = sentences::sentenceOf(warnings_->ground());
    if (!ground.isEmpty()) parts << ground;
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(list_->notes().size(), 3); ++i)
    parts << sentences::sentenceOf(list_->notes()[i]);
  const auto isDeleted = [&](const edit::Key& key) {
    return !document->find(key) && !document->conflicts().contains(key);
  };
  if (const QString stays = exchange::notRemovedReason(editing_->keeps());
      !stays.isEmpty() && std::ranges::any_of(document->unsaved(), isDeleted))
    parts << stays + QLatin1Char(' ') + tr("Restore what is deleted here before saving.");
  if (!remark_.isEmpty()) parts << remark_;
  return parts.join(QLatin1Char('\n'));
}

QString WaypointsDock::emptyText() const {
  const edit::WaypointDocument* const document = editing_->document();
  if (!document) return sentence_;
  if (model_->rowCount() == 0)
    return editing_->editable() ? tr("No waypoints yet. Press W and click on the map to add one.")
                                : tr("There are no waypoints.");
  return sorted_->rowCount() == 0 ? tr("No waypoint matches the filter.") : QString();
}

void WaypointsDock::goToConflict() {
  if (conflicts_->isHidden()) return;
  showSelection();
  // Space there only shows it: nothing is decided by a key that was meant for the map.
  conflicts_->locateButton()->setFocus();
  conflicts_->locateButton()->click();
}

QString WaypointsDock::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString WaypointsDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }

std::vector<edit::Key> WaypointsDock::selectedDeleted() const {
  std::vector<edit::Key> keys;
  for (const QItemSelectionRange& range : table_->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) {
      const edit::Key key = model_->key(sorted_->mapToSource(sorted_->index(row, 0)));
      if (!key.empty() && !editing_->find(key)) keys.push_back(key);
    }
  }
  return keys;
}

void WaypointsDock::showMenu(const QPoint& at) {
  QMenu menu(this);
  const auto deleted = selectedDeleted();
  const bool any = !editing_->selected().empty(), editable = editing_->editable();
  QAction* const show = menu.addAction(tr("&Show on the map"), this,
                                       [this] { Q_EMIT locateWanted(*editing_->selected().begin()); });
  show->setEnabled(any);
  menu.addSeparator();
  menu.addAction(tr("&Copy"), this, &WaypointsDock::copyWanted)->setEnabled(any);
  menu.addAction(tr("&Paste"), this, &WaypointsDock::pasteWanted)->setEnabled(editable);
  menu.addSeparator();
  menu.addAction(tr("Re&name…"), this, &WaypointsDock::rename)->setEnabled(editable && any);
  menu.addAction(tr("&Restore"), this, [this, deleted] { editing_->restore(deleted); })
      ->setEnabled(editable && !deleted.empty());
  const QString stays = editing_->notRemovedReason();
  menu.setToolTipsVisible(true);
  allow(menu.addAction(themedIcon(QStringLiteral("trash")), tr("&Delete"), editing_,
                       &WaypointEditing::removeSelected),
        any && editable && stays.isEmpty(), stays);
  menu.exec(table_->viewport()->mapToGlobal(at));
}

void WaypointsDock::rename() {
  if (!editing_->only()) return Q_EMIT editing_->renameSeveralWanted();
  if (!form_->isEnabled() || !form_->isVisible()) return;
  form_->nameEdit()->setFocus();
  form_->nameEdit()->selectAll();
}

std::vector<edit::Key> WaypointsDock::selectedAsListed() const {
  std::vector<edit::Key> keys;
  std::set<edit::Key> others = editing_->selected();
  for (int row = 0; row < sorted_->rowCount() && !others.empty(); ++row) {
    edit::Key key = model_->key(sorted_->mapToSource(sorted_->index(row, 0)));
    if (others.erase(key) > 0) keys.push_back(std::move(key));
  }
  // Those that the filter hides.
  for (const edit::Key& key : editing_->inOrder()) {
    if (others.contains(key)) keys.push_back(key);
  }
  return keys;
}

bool WaypointsDock::pressed(QKeyEvent* press) {
  if (press->matches(QKeySequence::Copy)) {
    Q_EMIT copyWanted();
    return true;
  }
  if (press->matches(QKeySequence::Paste)) {
    Q_EMIT pasteWanted();
    return true;
  }
  switch (press->key()) {
    case Qt::Key_Delete:
      editing_->removeSelected();
      return true;
    case Qt::Key_F2:
      rename();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (editing_->only()) Q_EMIT locateWanted(*editing_->selected().begin());
      return true;
    default:
      return false;
  }
}

bool WaypointsDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    auto* press = static_cast<QKeyEvent*>(event);
    if (watched == table_ && pressed(press)) return true;
    if (watched == filter_ && press->key() == Qt::Key_Down) {
      table_->setFocus();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_waypoints_dock.cpp"
