#include "ui/slam/inspector_dock.h"

#include <utility>

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTreeView>
#include <QVBoxLayout>

#include "sentences/absence_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/slam/inspector_controls.h"
#include "ui/slam/inspector_summary.h"
#include "ui/slam/submap_row_delegate.h"
#include "words/qt_plain.h"

namespace mapwright::window {

InspectorDock::InspectorDock(scene::MapScene* scene, QAction* show_ids, QAction* show_outlines,
                             QWidget* parent)
    : QDockWidget(tr("SLAM inspector"), parent),
      scene_(scene),
      model_(new SubmapTreeModel(this)),
      filtered_(new SubmapFilterModel(model_, this)),
      summary_(new InspectorSummary(this)),
      controls_(new InspectorControls(show_ids, show_outlines, this)),
      tree_(new TreeView(this)),
      details_(new QLabel(this)) {
  setObjectName(QStringLiteral("inspector"));
  buildTree();
  details_->setObjectName(QStringLiteral("details"));
  details_->setTextFormat(Qt::PlainText);
  details_->setWordWrap(true);
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_->setContentsMargins(8, 6, 8, 6);
  details_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // A fixed height: moving the selection through the rows must not make the tree jump.
  details_->setFixedHeight(fontMetrics().lineSpacing() * 4 + 14);

  auto* body = new QWidget(this);
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(summary_);
  column->addWidget(controls_);
  column->addWidget(tree_, 1);
  column->addWidget(details_);
  body->setMinimumWidth(300);
  setWidget(body);

  connect(summary_, &InspectorSummary::copyWanted, this, &InspectorDock::copyWanted);
  connect(controls_, &InspectorControls::filterChanged, this, [this](const QString& text) {
    filtered_->setFilter(SubmapFilter(text));
    if (!text.trimmed().isEmpty()) tree_->expandAll();
  });
  connect(controls_, &InspectorControls::nearbyWanted, this,
          [this](bool visible) { setGroupVisible(&SubmapFacts::nearby, visible); });
  connect(controls_, &InspectorControls::incrementalWanted, this,
          [this](bool visible) { setGroupVisible(&SubmapFacts::incremental, visible); });
  connect(controls_, &InspectorControls::sliceWanted, this, [this](int slice) {
    if (session_) session_->setSlice(slice);
  });
  connect(controls_, &InspectorControls::colorModeWanted, this, &InspectorDock::colorModeWanted);
  refreshDetails();
}

InspectorDock::~InspectorDock() {
  // The children are destroyed after this object's own part: they must not report to it any more.
  tree_->selectionModel()->disconnect(this);
  tree_->disconnect(this);
  tree_->viewport()->removeEventFilter(this);
  controls_->filterEdit()->removeEventFilter(this);
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
  controls_->filterEdit()->installEventFilter(this);
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
  // The selection and not the current row: that one moves by itself to a neighbour of a removed row.
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &InspectorDock::takeSelection);
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
    // New rows are processed even while the dock is closed: they may belong to a group that was switched off.
    connect(session, &session::Session::listChanged, this, &InspectorDock::keepHiddenGroups);
    connect(session, &session::Session::rowsTouched, this, &InspectorDock::takeRows);
    connect(session, &session::Session::connectionChanged, this, [this] { summary_->refresh(session_); });
    connect(session, &session::Session::liveChanged, this, [this](int what) {
      if (what == map::topicIndex<map::SlamStatus>()) summary_->refresh(session_);
    });
    connect(session, &session::Session::sessionRestarted, this, [this] {
      known_.clear();
      clearSelection();  // the same id now means another submap
    });
  }
  refresh();
}

void InspectorDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  refresh();
  Q_EMIT counted();
}

bool InspectorDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_->viewport() && event->type() == QEvent::Resize) fitColumns();
  if (watched == controls_->filterEdit() && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
    tree_->setFocus();
    return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

void InspectorDock::changeEvent(QEvent* event) {
  QDockWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitColumns();
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
  takeRows({true, {}});
}

void InspectorDock::takeRows(const session::TouchedRows& rows) {
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
  summary_->refresh(session_);
  refreshGroups();
  controls_->setSlices(session_ ? session_->slice() : 0, session_ ? session_->submaps().maxSlices() : 1);
  refreshDetails();
}

void InspectorDock::refreshGroups() {
  int nearby_count = 0, incremental_count = 0;
  const Qt::CheckState nearby = model_->visibilityWhere(&SubmapFacts::nearby, &nearby_count);
  const Qt::CheckState incremental = model_->visibilityWhere(&SubmapFacts::incremental, &incremental_count);
  controls_->setGroups(nearby, nearby_count, incremental, incremental_count);
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

void InspectorDock::setColorMode(render::ColorMode mode) { controls_->setColorMode(mode); }

void InspectorDock::select(map::SubmapId id) {
  const QModelIndex source = model_->indexOf(id);
  if (!source.isValid()) return;
  QModelIndex index = filtered_->mapFromSource(source);
  if (!index.isValid()) {
    controls_->filterEdit()->clear();  // the filter hides it
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

void InspectorDock::takeSelection() {
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
  menu.addAction(tr("Expand all"), tree_, &QTreeView::expandAll);
  menu.addAction(tr("Collapse all"), this, [this] {
    tree_->collapseAll();
    tree_->expand(filtered_->index(0, 0));
  });
  menu.exec(tree_->viewport()->mapToGlobal(at));
}

QString InspectorDock::detailsText() const { return details_->text(); }

void InspectorDock::refreshDetails() {
  const std::set<map::SubmapId> leaves = selectedLeaves();
  QString text;
  if (session_ && leaves.size() == 1) {
    text = submapDetails(*session_, *leaves.begin());
  } else if (session_ && !leaves.empty()) {
    text = sentences::counted(tr("%1 submaps are selected.", nullptr, int(leaves.size())),
                              qint64(leaves.size()));
  } else if (session_ && !session_->robot().submapSource()) {
    text = sentences::whyAbsent(robot::Capability::Submaps,
                                session_->robot().whyNot(robot::Capability::Submaps));
  } else {
    text = tr("Select a submap to see its pose and state. Double-click one to show it on the map.");
  }
  if (const QString plain = words::plainText(text); plain != details_->text()) details_->setText(plain);
}

}  // namespace mapwright::window

#include "moc_inspector_dock.cpp"
