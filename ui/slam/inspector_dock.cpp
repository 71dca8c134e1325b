#include "ui/slam/inspector_dock.h"

#include <utility>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "geometry/pose.h"
#include "map/live_state.h"
#include "render/tile_colors.h"
#include "robot/slam_file.h"
#include "sentences/absence_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "submap/row_version.h"
#include "submap/submap_store.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/slam/submap_row_delegate.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {
constexpr int kLowPx = 460;
}

QString slamStateText(const session::Session& session) {
  QString text = QString::fromStdString(session.live().slam.state);
  if (text.isEmpty() && session.submaps().listReceived()) {
    switch (session.submaps().slamState()) {
      case map::SlamState::Slam:
        text = QCoreApplication::translate("window", "mapping");
        break;
      case map::SlamState::Positioning:
        text = QCoreApplication::translate("window", "positioning");
        break;
      case map::SlamState::Invalid:
        // Not reported, or in unknown words.
        text = QCoreApplication::translate("window", "not reported");
        break;
    }
  } else if (text == QLatin1String("slam")) {
    text = QCoreApplication::translate("window", "mapping");
  } else if (text == QLatin1String("positioning")) {
    text = QCoreApplication::translate("window", "positioning");
  }
  if (text.isEmpty()) return QStringLiteral("–");
  if (session.live().slam.reliable) {
    text += *session.live().slam.reliable ? QCoreApplication::translate("window", ", reliable")
                                          : QCoreApplication::translate("window", ", not reliable");
  }
  return text;
}

QString submapDetails(const session::Session& session, map::SubmapId id) {
  const submap::SubmapRow* row = session.submaps().find(id);
  if (!row)
    return QCoreApplication::translate("window", "Submap %1 is no longer listed.")
        .arg(QString::fromStdString(map::toText(id)));
  QString name = QString::fromStdString(map::toText(id));
  const std::int32_t version = submap::versionOf(*row);
  if (version != map::kNoVersion) name += QStringLiteral(" v%1").arg(version);
  if (row->visible && row->shown_version >= 0 && row->shown_version != version) {
    name += InspectorDock::tr(" (v%1 on screen)").arg(row->shown_version);
  }
  SubmapFacts facts;
  facts.frozen = row->entry.is_frozen;
  facts.incremental = row->entry.is_incremental;
  facts.nearby = row->entry.is_nearby;
  QStringList lines{QStringLiteral("%1  %2").arg(name, badges(facts).join(QLatin1String(" ")).toLower())};
  const auto pose = geometry::toIsometry(row->entry.pose);
  QString where = InspectorDock::tr("no valid pose");
  if (pose && row->pose_usable) {
    const geometry::Pose2 flat = geometry::projectToPlane(*pose);
    where = QStringLiteral("x %1 y %2 m, %3")
                .arg(words::fixed(flat.x_m, 2), words::fixed(flat.y_m, 2), rotationText(flat.yaw_rad));
  }
  if (const auto slices = int(row->slices.size()); slices > 0) {
    where += QStringLiteral(", %1, %2")
                 .arg(sentences::counted(InspectorDock::tr("%1 slices", nullptr, slices), slices),
                      bytesText(qint64(row->texture_bytes)));
  }
  lines << where;
  const QString reason = sentences::sentenceOf(session.reason(id));
  lines << (reason.isEmpty() ? statusWord(session.status(id))
                             : words::about(statusWord(session.status(id)), reason));
  return lines.join(QLatin1Char('\n'));
}

InspectorDock::InspectorDock(scene::MapScene* scene, QAction* show_ids, QAction* show_outlines,
                             QWidget* parent)
    : QDockWidget(tr("SLAM inspector"), parent),
      scene_(scene),
      model_(new SubmapTreeModel(this)),
      filtered_(new SubmapFilterModel(model_, this)) {
  setObjectName(QStringLiteral("inspector"));
  auto* body = new QWidget(this);
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(buildSummary());
  column->addWidget(buildControls(show_ids, show_outlines));
  tree_ = new TreeView(this);
  details_ = textLabel({}, this);
  details_->setObjectName(QStringLiteral("details"));  // before it is laid out: the theme knows it by name
  column->addWidget(tree_, 1);
  column->addWidget(details_);
  body->setMinimumWidth(300);
  setWidget(body);
  buildTree();
  details_->setContentsMargins(8, 6, 8, 6);
  details_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // A fixed height: moving the selection through the rows must not make the
  // tree jump.
  details_->setFixedHeight(fontMetrics().lineSpacing() * 4 + 14);

  refreshSummary();
  refreshGroups();
  refreshSlices();
  refreshDetails();
}

InspectorDock::~InspectorDock() {
  // The children are destroyed after this object's own part: they must not
  // report to it any more.
  tree_->selectionModel()->disconnect(this);
  tree_->disconnect(this);
  tree_->viewport()->removeEventFilter(this);
  filter_->removeEventFilter(this);
}

QWidget* InspectorDock::buildSummary() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(8, 8, 8, 4);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  state_ = addRow(grid, tr("State"));
  uuid_ = addRow(grid, tr("Session"), 1);
  uuid_->setElideMode(Qt::ElideMiddle);
  copy_ = iconButton(QStringLiteral("copy"), 14, tr("Copy the session's uuid"), box);
  copy_->setFixedSize(22, 20);
  grid->addWidget(copy_, 1, 2);
  submaps_ = addRow(grid, tr("Submaps"));
  cache_ = addRow(grid, tr("Memory"));
  fetches_ = addRow(grid, tr("Fetches"));
  transferred_ = addRow(grid, tr("Received"));
  for (QWidget* value : {cache_, fetches_, transferred_}) {
    int row = 0, column = 0, rows = 0, columns = 0;
    grid->getItemPosition(grid->indexOf(value), &row, &column, &rows, &columns);
    where_high_.insert(where_high_.end(), {grid->itemAtPosition(row, 0)->widget(), value});
  }
  connect(copy_, &QToolButton::clicked, this,
          [this] { Q_EMIT copyWanted(uuid_->text(), tr("Session uuid copied")); });
  return box;
}

PlainLabel* InspectorDock::addRow(QGridLayout* grid, const QString& name, int columns) {
  const int row = grid->rowCount() - (grid->count() == 0 ? 1 : 0);
  auto* label = new PlainLabel(name, grid->parentWidget());
  label->setSecondary(true);
  auto* value = new PlainLabel(grid->parentWidget());
  value->setObjectName(name.toLower());
  value->setSample(QStringLiteral("x"));  // as wide as the dock allows, whatever the text
  value->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  grid->addWidget(label, row, 0);
  grid->addWidget(value, row, 1, 1, columns);
  return value;
}

void InspectorDock::refreshSummary() {
  const session::Session* const session = session_;
  const QString none = QStringLiteral("–");
  copy_->setEnabled(session && !session->submaps().uuid().empty());
  if (!session) {
    state_->setSecondary(false);
    for (PlainLabel* label : {state_, uuid_, submaps_, cache_, fetches_, transferred_}) label->setText(none);
    return;
  }
  const session::SubmapCounts counts = session->counts();
  const bool is_file = !robot::slamFileOf(session_->robot()).isEmpty();
  state_->setText(is_file ? tr("a file: nothing is being mapped") : slamStateText(*session));
  // Old values are not present ones.
  const auto stale = valuesAsOf(*session);
  if (stale) {
    state_->setText(
        tr("%1 (as of %2)").arg(state_->text(), QLocale::c().toString(*stale, QStringLiteral("HH:mm:ss"))));
  }
  state_->setSecondary(stale.has_value());
  const QString uuid = QString::fromStdString(session->submaps().uuid());
  uuid_->setText(uuid.isEmpty() ? none : uuid);
  QString submaps = counts.list_received
                        ? tr("%1 in %2")
                              .arg(countText(counts.listed),
                                   sentences::counted(tr("%1 trajectories", nullptr, counts.trajectories),
                                                      counts.trajectories))
                        : none;
  if (counts.hidden > 0) submaps += tr(", %1 hidden").arg(countText(counts.hidden));
  submaps_->setText(submaps);
  cache_->setText(tr("%1 of pictures").arg(bytesText(counts.texture_bytes)));
  fetches_->setText(
      tr("%1 to come, %2 failed").arg(countText(counts.fetching + counts.queued), countText(counts.failed)));
  transferred_->setText(
      tr("%1 in %2, %3 from disk")
          .arg(bytesText(qint64(counts.bytes_fetched)),
               sentences::counted(tr("%1 answers", nullptr, sentences::formOf(qint64(counts.fetches))),
                                  qint64(counts.fetches)),
               countText(qint64(counts.cache_hits))));
}

QWidget* InspectorDock::buildControls(QAction* show_ids, QAction* show_outlines) {
  auto* box = new QWidget(this);
  filter_ = new QLineEdit(box);
  nearby_ = addGroup(tr("Nearby"), tr("Show or hide the submaps of nearby maps"), &SubmapFacts::nearby);
  incremental_ =
      addGroup(tr("Incremental"), tr("Show or hide the incremental submaps"), &SubmapFacts::incremental);
  slice_ = new WholeBox(box);
  colors_ = new QComboBox(box);
  filter_->setPlaceholderText(tr("Filter: 12-3, v70, frozen, failed…"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  filter_->setToolTip(
      tr("Trajectory and index (12-3), index (592), version "
         "(v70), frozen, active, incremental, nearby, "
         "hidden,\nshown, updating, queued, fetching, missing, "
         "failed, corrupt. Separate several terms with "
         "spaces: all must match."));
  filter_->setAccessibleName(tr("Filter submaps"));
  colors_->addItem(tr("Normal"));
  colors_->addItem(tr("Incremental"));
  colors_->addItem(tr("Active"));
  colors_->addItem(tr("Trajectory"));
  colors_->addItem(tr("Age"));
  colors_->addItem(tr("Version"));
  colors_->setToolTip(
      tr("Colours: Incremental tints incremental submaps, Active dims frozen ones,\n"
         "the others colour by trajectory, by age and by version (the legend says how)"));
  colors_->setObjectName(QStringLiteral("colors"));
  colors_->setAccessibleName(tr("Colours"));
  slice_->setRange(0, 0);
  slice_->setPrefix(tr("Slice "));
  slice_->setAccessibleName(tr("Slice"));

  auto* first = new QHBoxLayout;
  first->setSpacing(4);
  first->addWidget(filter_, 1);
  for (QAction* action : {show_ids, show_outlines}) {
    auto* button = new QToolButton(box);
    button->setDefaultAction(action);
    button->setIconSize({16, 16});
    button->setFixedSize(26, 24);
    first->addWidget(button);
  }
  box->setLayout(columnOf(
      {rowOf({{colors_, 1}, {slice_, 1}}, 8), rowOf({incremental_, nearby_, LayoutItem::rest()}, 12), first},
      6, QMargins(8, 4, 8, 8)));

  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filtered_->setFilter(SubmapFilter(text));
    if (!text.trimmed().isEmpty()) tree_->expandAll();
  });
  connect(slice_, &QSpinBox::valueChanged, this, [this](int slice) {
    if (session_) session_->setSlice(slice);
  });
  connect(colors_, &QComboBox::currentIndexChanged, this,
          [this](int index) { Q_EMIT colorModeWanted(render::ColorMode(index)); });
  return box;
}

QCheckBox* InspectorDock::addGroup(const QString& name, const QString& tip, bool SubmapFacts::*flag) {
  auto* box = new QCheckBox(name, this);
  box->setObjectName(name.toLower());
  box->setToolTip(tip);
  // clicked and not toggled: only for user actions, and a partially checked box
  // becomes checked.
  connect(box, &QCheckBox::clicked, this,
          [this, box, flag] { setGroupVisible(flag, box->checkState() != Qt::Unchecked); });
  return box;
}

void InspectorDock::refreshSlices() {
  const int present = session_ ? session_->slice() : 0;
  const int how_many = session_ ? session_->submaps().maxSlices() : 1;
  const QSignalBlocker quiet(slice_);
  const int last = qMax(qMax(0, how_many - 1), present);
  slice_->setRange(0, last);
  slice_->setValue(present);
  slice_->setEnabled(last > 0);
  slice_->setToolTip(how_many > 1 ? tr("Slice to draw of every submap: 0 to %1").arg(how_many - 1)
                                  : tr("Slice to draw of every submap; these have only one"));
}

void InspectorDock::buildTree() {
  tree_->setModel(filtered_);
  tree_->setItemDelegate(new SubmapRowDelegate(tree_));
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(14);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setSelectionBehavior(QAbstractItemView::SelectRows);
  tree_->setExpandsOnDoubleClick(false);
  tree_->setMouseTracking(true);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setAllColumnsShowFocus(true);
  tree_->setAccessibleName(tr("Submaps"));
  QHeaderView* header = tree_->header();
  header->setMinimumSectionSize(20);
  header->setStretchLastSection(false);
  header->setSectionsMovable(false);
  header->setSectionResizeMode(QHeaderView::Fixed);
  tree_->viewport()->installEventFilter(this);
  filter_->installEventFilter(this);
  tree_->expand(filtered_->index(0, 0));

  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    const auto id = idAt(index);
    if (id && index.column() == SubmapTreeModel::LocateColumn) Q_EMIT locateWanted(*id);
  });
  connect(tree_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const auto id = idAt(index)) {
      Q_EMIT locateWanted(*id);
    } else {
      tree_->setExpanded(index.siblingAtColumn(0), !tree_->isExpanded(index.siblingAtColumn(0)));
    }
  });
  connect(static_cast<TreeView*>(tree_), &TreeView::enterPressed, this, [this] {
    const QModelIndex current = tree_->currentIndex().siblingAtColumn(0);
    if (const auto id = idAt(current)) {
      Q_EMIT locateWanted(*id);
    } else {
      tree_->setExpanded(current, !tree_->isExpanded(current));
    }
  });
  connect(tree_, &QTreeView::customContextMenuRequested, this, &InspectorDock::showMenu);
  // The selection and not the current row: that one moves by itself to a
  // neighbour of a removed row.
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &InspectorDock::onSelection);
}

void InspectorDock::setSession(session::Session* session) {
  if (session_) session_->disconnect(this);
  session_ = session;
  known_.clear();
  clearSelection();
  nearby_off_ = incremental_off_ = false;
  model_->setSession(session);
  tree_->expand(filtered_->index(0, 0));
  if (session) {
    // New rows are processed even while the dock is closed: they may belong to
    // a group that was switched off.
    connect(session, &session::Session::listChanged, this, &InspectorDock::keepHiddenGroups);
    connect(session, &session::Session::rowsTouched, this, &InspectorDock::onRows);
    connect(session, &session::Session::connectionChanged, this, [this] { refreshSummary(); });
    connect(session, &session::Session::liveChanged, this, [this](int what) {
      if (what == map::topicIndex<map::SlamStatus>()) refreshSummary();
    });
    connect(session, &session::Session::sessionRestarted, this, [this] {
      known_.clear();
      clearSelection();  // the same id now means another submap
    });
  }
  refresh();
}

void InspectorDock::resizeEvent(QResizeEvent* event) {
  QDockWidget::resizeEvent(event);
  // The tree needs the room more.
  for (QWidget* widget : where_high_) widget->setVisible(height() >= kLowPx);
}

void InspectorDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  refresh();
  Q_EMIT counted();
}

bool InspectorDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_->viewport() && event->type() == QEvent::Resize) fitColumns();
  if (watched == filter_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
    tree_->setFocus();
    return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

void InspectorDock::changeEvent(QEvent* event) {
  QDockWidget::changeEvent(event);
  const bool resized = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (resized && tree_) fitColumns();
}

void InspectorDock::fitColumns() {
  const ColumnWidths widths = shareColumns(tree_->viewport()->width(), columnNeeds(*tree_, *model_));
  QHeaderView* header = tree_->header();
  for (const auto& [column, width] : {std::pair(SubmapTreeModel::NameColumn, widths.name),
                                      {SubmapTreeModel::BadgeColumn, widths.badges},
                                      {SubmapTreeModel::StatusColumn, widths.status},
                                      {SubmapTreeModel::LocateColumn, widths.locate}}) {
    if (header->sectionSize(column) != width) header->resizeSection(column, width);
  }
}

void InspectorDock::refresh() {
  keepHiddenGroups();
  onRows({true, {}});
}

void InspectorDock::onRows(const session::TouchedRows& rows) {
  missed_rows_ |= rows.all || !isVisible();
  if (!isVisible()) return;
  const bool first_rows = model_->rowCount(model_->index(0, 0)) == 0;
  if (std::exchange(missed_rows_, false)) {
    model_->sync();
  } else {
    model_->syncRows(rows.ids);
  }
  fitColumns();
  const QModelIndex all = filtered_->index(0, 0);
  if (first_rows) {
    tree_->expand(all);
    // A single trajectory is expanded; several stay collapsed as an overview.
    if (filtered_->rowCount(all) == 1) tree_->expand(filtered_->index(0, 0, all));
  }
  refreshSummary();
  refreshGroups();
  refreshSlices();
  refreshDetails();
}

void InspectorDock::refreshGroups() {
  const auto show = [this](QCheckBox* box, const QString& name, bool SubmapFacts::*flag) {
    int count = 0;
    const Qt::CheckState state = model_->visibilityWhere(flag, &count);
    box->setEnabled(count > 0);
    box->setText(count > 0 ? QStringLiteral("%1 (%2)").arg(name, countText(count)) : name);
    box->setTristate(state == Qt::PartiallyChecked);
    box->setCheckState(count > 0 ? state : Qt::Checked);
  };
  show(nearby_, tr("Nearby"), &SubmapFacts::nearby);
  show(incremental_, tr("Incremental"), &SubmapFacts::incremental);
}

void InspectorDock::showSubmaps(const std::vector<map::SubmapId>& ids, bool visible) {
  session_->setVisible(ids, visible);
  model_->syncVisibility();
  refreshGroups();
}

void InspectorDock::keepHiddenGroups() {
  if (!session_ || (!nearby_off_ && !incremental_off_)) return;
  std::vector<map::SubmapId> newcomers;
  for (const auto& [id, row] : session_->submaps().rows()) {
    if (!known_.insert(id).second) continue;
    if (row.visible &&
        ((nearby_off_ && row.entry.is_nearby) || (incremental_off_ && row.entry.is_incremental))) {
      newcomers.push_back(id);
    }
  }
  if (!newcomers.empty()) session_->setVisible(newcomers, false);
}

void InspectorDock::setGroupVisible(bool SubmapFacts::*flag, bool visible) {
  (flag == &SubmapFacts::nearby ? nearby_off_ : incremental_off_) = !visible;
  if (!session_) return;
  known_.clear();
  for (const auto& [id, row] : session_->submaps().rows()) known_.insert(id);
  showSubmaps(model_->submapsWhere(flag), visible);
}

void InspectorDock::setColorMode(render::ColorMode mode) {
  const QSignalBlocker quiet(colors_);
  colors_->setCurrentIndex(int(mode));
}

void InspectorDock::select(map::SubmapId id) {
  const QModelIndex source = model_->indexOf(id);
  if (!source.isValid()) return;
  QModelIndex index = filtered_->mapFromSource(source);
  if (!index.isValid()) {
    filter_->clear();  // the filter hides it
    index = filtered_->mapFromSource(source);
  }
  tree_->setCurrentIndex(index);
  tree_->scrollTo(index);
}

void InspectorDock::clearSelection() {
  tree_->setCurrentIndex({});
  tree_->clearSelection();
}

std::optional<map::SubmapId> InspectorDock::idAt(const QModelIndex& proxy_index) const {
  const auto facts = model_->facts(filtered_->mapToSource(proxy_index));
  return facts ? std::optional(facts->id) : std::nullopt;
}

std::optional<map::SubmapId> InspectorDock::selected() const {
  const std::set<map::SubmapId> leaves = selectedLeaves();
  return leaves.size() == 1 ? std::optional(*leaves.begin()) : std::nullopt;
}

std::set<map::SubmapId> InspectorDock::selectedLeaves() const {
  std::set<map::SubmapId> leaves;
  for (const QModelIndex& row : tree_->selectionModel()->selectedRows()) {
    if (const auto id = idAt(row)) leaves.insert(*id);
  }
  return leaves;
}

void InspectorDock::onSelection() {
  scene_->setHighlighted(selectedLeaves());
  refreshDetails();
}

std::vector<map::SubmapId> InspectorDock::selectedIds() const {
  std::set<map::SubmapId> ids;
  for (const QModelIndex& row : tree_->selectionModel()->selectedRows()) {
    for (const map::SubmapId id : model_->submapsBelow(filtered_->mapToSource(row))) ids.insert(id);
  }
  return {ids.begin(), ids.end()};
}

void InspectorDock::showMenu(const QPoint& at) {
  const std::vector<map::SubmapId> ids = selectedIds();
  if (!session_ || ids.empty()) return;
  QMenu menu(this);
  const auto one = idAt(tree_->indexAt(at));
  if (one) {
    menu.addAction(themedIcon(QStringLiteral("locate")), tr("Locate on the map"), this,
                   [this, one] { Q_EMIT locateWanted(*one); });
  }
  menu.addAction(themedIcon(QStringLiteral("eye")), tr("Show"), this,
                 [this, ids] { showSubmaps(ids, true); });
  menu.addAction(themedIcon(QStringLiteral("eye-off")), tr("Hide"), this,
                 [this, ids] { showSubmaps(ids, false); });
  menu.addAction(tr("Show only these"), this, [this, ids] {
    session_->setVisible(model_->submapsBelow(model_->index(0, 0)), false);
    showSubmaps(ids, true);
  });
  menu.addSeparator();
  if (one) {
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy details"), this,
                   [this, one] { Q_EMIT copyWanted(submapDetails(*session_, *one), tr("Details copied")); });
  }
  const QModelIndexList rows = tree_->selectionModel()->selectedRows();
  Q_EMIT menuOpening(
      &menu, ids, rows.size() == 1 && model_->trajectory(filtered_->mapToSource(rows.front())).has_value());
  menu.addSeparator();
  menu.addAction(tr("Expand all"), tree_, &QTreeView::expandAll);
  menu.addAction(tr("Collapse all"), this, [this] {
    tree_->collapseAll();
    tree_->expand(filtered_->index(0, 0));
  });
  menu.exec(tree_->viewport()->mapToGlobal(at));
}

void InspectorDock::refreshDetails() {
  const std::set<map::SubmapId> leaves = selectedLeaves();
  QString text;
  if (session_ && leaves.size() == 1) {
    text = submapDetails(*session_, *leaves.begin());
  } else if (session_ && !leaves.empty()) {
    text = sentences::counted(tr("%1 submaps are selected.", nullptr, int(leaves.size())),
                              qint64(leaves.size()));
  } else if (session_ && !session_->robot().submapSource()) {
    text = sentences::absenceReason(robot::Capability::Submaps,
                                    session_->robot().unavailableReason(robot::Capability::Submaps));
  } else {
    text =
        tr("Select a submap to see its pose and state. Double-click one to "
           "show it on the map.");
  }
  if (const QString plain = words::plainText(text); plain != details_->text()) details_->setText(plain);
}

}  // namespace mapwright::ui

#include "moc_inspector_dock.cpp"
