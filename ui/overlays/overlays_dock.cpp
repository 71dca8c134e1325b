#include "ui/overlays/overlays_dock.h"

#include <algorithm>
#include <utility>

#include <QButtonGroup>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/row_selection.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/overlays/overlay_form.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlays_model.h"

namespace mapwright::ui {

using overlays::EditingDocument;

OverlaysDock::OverlaysDock(edit::OverlayEditing* editing, OverlayTool* tool, QWidget* parent)
    : QDockWidget(tr("Overlays"), parent),
      editing_(editing),
      tool_(tool),
      model_(new OverlaysModel(editing, this)),
      sorted_(new OverlayFilter(this)),
      mode_row_(new QWidget(this)),
      tool_row_(new QWidget(this)),
      radius_row_(new QWidget(this)),
      body_(new QWidget(this)),
      conflict_box_(new QFrame(this)),
      offer_box_(new QFrame(this)),
      duplicate_(iconButton(QStringLiteral("copy"), 18, tr("Duplicate what is selected"), mode_row_)),
      remove_(iconButton(QStringLiteral("trash"), 18, tr("Delete what is selected (Delete)"), mode_row_)),
      robot_(iconButton(QStringLiteral("robot"), 18, tr("From the robot"), tool_row_)),
      arrange_(iconButton(QStringLiteral("arrange"), 18, tr("Arrange what is selected"), tool_row_)),
      snap_(iconButton(QStringLiteral("snap"), 18, tr("Snap overlays"), tool_row_)),
      defaults_(iconButton(QStringLiteral("settings"), 18, tr("Defaults of the map"), tool_row_)),
      radius_(numberField(radius_row_, {0, 1000, 3, 0.1, QStringLiteral(" m"), tr("Radius of new circles")})),
      new_type_(new QComboBox(this)),
      bits_(new QComboBox(this)),
      filter_(new QLineEdit(this)),
      table_(new QuietTableView(this)),
      tabs_(new QTabWidget(this)),
      form_(new OverlayForm(editing, this)),
      points_(new OverlayPoints(editing, this)),
      flaws_(new OverlayFlaws(this)),
      empty_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      conflict_(textLabel({}, conflict_box_)),
      offer_(wrappedLabel({}, offer_box_)),
      mine_(compactButton(tr("Keep mine"), conflict_box_, tr("My version replaces theirs when it is saved"))),
      theirs_(compactButton(tr("Take theirs"), conflict_box_, tr("My version of it is given up"))),
      next_(compactButton(tr("Next"), conflict_box_)),
      discard_(compactButton(tr("Discard"), this, tr("All as the robot has it; can be undone"))),
      review_(
          compactButton(tr("Review and save…"), this, tr("Shows what changes before it is sent (Ctrl+S)"))),
      restore_(compactButton(tr("Restore"), offer_box_)),
      forget_(compactButton(tr("Discard draft"), offer_box_)),
      retry_(compactButton(tr("Retry"), this)),
      history_(iconButton(QStringLiteral("history"), 18, tr("Earlier versions of the overlays"), this)) {
  setObjectName(QStringLiteral("overlays"));
  buildModes();
  buildTable();
  buildConflict();
  buildOffer();
  for (QLabel* label : {empty_, status_}) label->setContentsMargins(8, 4, 8, 4);
  auto* const scrolled = new QScrollArea(tabs_);  // a low dock has less room than the form needs
  scrolled->setWidget(form_);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tabs_->addTab(scrolled, tr("Properties"));
  tabs_->addTab(points_, tr("Points"));
  tabs_->addTab(flaws_, tr("Flaws"));
  tabs_->setDocumentMode(true);
  review_->setIcon(themedIcon(QStringLiteral("save")));

  auto* const list = new QWidget(body_);
  list->setLayout(
      columnOf({rowOf({{filter_, 1}, bits_}, 4, QMargins(6, 4, 6, 4)), {table_, 1}}, 0, QMargins()));
  // What comes and goes below the tabs takes its room from them: nothing else moves under the hand.
  auto* const below = new QWidget(body_);
  below->setLayout(columnOf({{tabs_, 1}, conflict_box_, status_}, 0, QMargins()));
  tabs_->setMinimumHeight(50);
  below->setMinimumHeight(160);  // there is room for a conflict
  auto* const split = new QSplitter(Qt::Vertical, body_);
  split->addWidget(list);
  split->addWidget(below);
  split->setChildrenCollapsible(false);
  split->setStretchFactor(0, 1);
  split->setStretchFactor(1, 1);
  body_->setLayout(columnOf({{split, 1}}, 0, QMargins()));
  auto* const whole = new QWidget(this);
  whole->setLayout(
      columnOf({mode_row_, tool_row_, radius_row_, offer_box_, empty_, {body_, 1}}, 0, QMargins()));
  whole->setMinimumWidth(240);
  auto* const end = new QWidget(this);
  end->setLayout(rowOf({discard_, history_, LayoutItem::rest(), retry_, review_}, 6, QMargins(8, 4, 8, 4)));
  setScrolledWidget(*this, whole, end);

  connect(discard_, &QPushButton::clicked, editing_, &edit::OverlayEditing::revert);
  connect(review_, &QPushButton::clicked, this, &OverlaysDock::reviewWanted);
  connect(retry_, &QPushButton::clicked, this, &OverlaysDock::retryWanted);
  connect(history_, &QToolButton::clicked, this, &OverlaysDock::historyWanted);
  connect(restore_, &QPushButton::clicked, this, &OverlaysDock::draftWanted);
  connect(forget_, &QPushButton::clicked, this, &OverlaysDock::draftNotWanted);
  connect(flaws_, &OverlayFlaws::chosen, this, [this](const ShownFlaw chosen) {
    editing_->select({chosen.key});
    chosen.at_m ? Q_EMIT placeWanted(*chosen.at_m) : Q_EMIT locateWanted(chosen.key);
    if (chosen.rule == overlays::Rule::Unreachable) Q_EMIT wayWanted(chosen.key);
  });
  connect(sorted_, &QAbstractItemModel::modelReset, this, &OverlaysDock::showSelection);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &OverlaysDock::onSelection);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    Q_EMIT locateWanted(model_->key(sorted_->mapToSource(index)));
  });
  connect(editing_, &edit::OverlayEditing::changed, this, [this] {
    // Its row may be elsewhere now.
    if (const auto key = editing_->only()) table_->scrollTo(sorted_->mapFromSource(model_->indexOf(*key)));
    refresh();
  });
  connect(editing_, &edit::OverlayEditing::selectionChanged, this, [this] {
    showSelection();
    refresh();
  });
  connect(editing_, &edit::OverlayEditing::editableChanged, this, &OverlaysDock::refresh);
  connect(tool_, &OverlayTool::modeChanged, this, &OverlaysDock::refreshMode);
  setFlaws({});
  refreshMode();
  refresh();
}

OverlaysDock::~OverlaysDock() {
  table_->selectionModel()->disconnect(this);
  table_->removeEventFilter(this);
}

void OverlaysDock::buildModes() {
  struct Choice {
    OverlayMode mode;
    const char* icon;
    QString tip;
  };
  const Choice choices[] = {
      {OverlayMode::Select, "select", tr("Select, move and reshape")},
      {OverlayMode::Point, "locate", tr("Draw a point")},
      {OverlayMode::Line, "line", tr("Draw a line")},
      {OverlayMode::Polygon, "polygon", tr("Draw a region by its outline")},
      {OverlayMode::Rectangle, "rectangle", tr("Draw a rectangular region")},
      {OverlayMode::Circle, "circle", tr("Draw a round region")},
  };
  auto* const group = new QButtonGroup(this);
  auto* const row = rowOf({}, 2, QMargins(6, 4, 6, 0));
  for (const Choice& choice : choices) {
    QToolButton* const button = iconButton(QLatin1String(choice.icon), 18, choice.tip, mode_row_);
    button->setCheckable(true);
    group->addButton(button);
    modes_[std::size_t(choice.mode)] = button;
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, mode = choice.mode] { Q_EMIT modeWanted(mode); });
  }
  new_type_->setAccessibleName(tr("Type of what is drawn"));
  new_type_->setToolTip(tr("Type of what is drawn"));
  new_type_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  new_type_->setMinimumContentsLength(4);
  // The buttons stay where they are.
  QSizePolicy keeps = new_type_->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);
  new_type_->setSizePolicy(keeps);
  row->addStretch(1);
  row->addWidget(duplicate_);
  row->addWidget(remove_);
  mode_row_->setLayout(row);
  radius_->setSpecialValueText(tr("by dragging"));
  radius_->setToolTip(tr("Radius of new circles"));
  for (QToolButton* button : {robot_, arrange_}) button->setPopupMode(QToolButton::InstantPopup);
  snap_->setPopupMode(QToolButton::MenuButtonPopup);
  tool_row_->setLayout(rowOf({{new_type_, 1}, robot_, arrange_, snap_, defaults_}, 2, QMargins(6, 2, 6, 0)));
  radius_row_->setLayout(
      rowOf({new QLabel(tr("Radius"), radius_row_), {radius_, 1}}, 6, QMargins(6, 2, 6, 0)));
  connect(radius_, &QDoubleSpinBox::valueChanged, tool_, &OverlayTool::setCircleRadius);
  connect(duplicate_, &QToolButton::clicked, editing_, &edit::OverlayEditing::duplicateSelected);
  connect(remove_, &QToolButton::clicked, editing_, &edit::OverlayEditing::removeSelected);
  connect(new_type_, &QComboBox::activated, this,
          [this] { tool_->setNewType(shapeOf(tool_->mode()), new_type_->currentData().toInt()); });
}

void OverlaysDock::setMenus(QMenu* from_robot, QMenu* arrange, QAction* snap, QMenu* snap_to,
                            QAction* defaults) {
  robot_->setMenu(from_robot);
  arrange_->setMenu(arrange);
  snap_->setDefaultAction(snap);
  snap_->setMenu(snap_to);
  snap_->setMinimumWidth(snap_->iconSize().width() + 26);  // the arrow beside the picture
  defaults_->setDefaultAction(defaults);
}

void OverlaysDock::buildTable() {
  sorted_->setSourceModel(model_);
  showRows(*table_, sorted_, tr("Overlays"), 24);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(OverlaysModel::NameColumn, Qt::AscendingOrder);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setMinimumHeight(124);  // four rows, also where the dock is low
  table_->installEventFilter(this);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QWidget::customContextMenuRequested, this, &OverlaysDock::showMenu);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setMinimumSectionSize(26);
  const auto wide = [&](const QString& sample) { return fontMetrics().horizontalAdvance(sample) + 32; };
  header->resizeSection(OverlaysModel::TypeColumn, wide(tr("Forbidden region")));
  header->resizeSection(OverlaysModel::StateColumn, wide(tr("changed, unsaved")));
  new NameColumn(table_, header, OverlaysModel::NameColumn,
                 {{OverlaysModel::TypeColumn, 40}, {OverlaysModel::StateColumn, 26}});
  filter_->setPlaceholderText(tr("Filter by name, type or id"));
  filter_->setClearButtonEnabled(true);
  filter_->setAccessibleName(tr("Filter overlays"));
  filter_->installEventFilter(this);
  bits_->setAccessibleName(tr("Filter overlays by state"));
  bits_->addItem(tr("All"), 0);
  bits_->addItem(tr("Unsaved"), int(kOverlayUnsaved));
  bits_->addItem(tr("Changed by others"), int(kOverlayChangedThere));
  bits_->addItem(tr("In conflict"), int(kOverlayInConflict));
  bits_->addItem(tr("With flaws"), int(kOverlayFlawed));
  bits_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  bits_->setMinimumContentsLength(6);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->look(text);
    refresh();
  });
  connect(bits_, &QComboBox::currentIndexChanged, this, [this] {
    sorted_->lookForBits(bits_->currentData().toInt());
    refresh();
  });
}

void OverlaysDock::buildConflict() {
  conflict_box_->setLayout(
      columnOf({conflict_, rowOf({mine_, theirs_, LayoutItem::rest(), next_}, 4)}, 4, QMargins(8, 6, 8, 6)));
  connect(mine_, &QPushButton::clicked, this, [this] {
    if (deciding_) editing_->keepMine(*deciding_);
  });
  connect(theirs_, &QPushButton::clicked, this, [this] {
    if (deciding_) editing_->useTheirs(*deciding_);
  });
  connect(next_, &QPushButton::clicked, this, [this] {
    const auto open = editing_->document().conflicts();
    const auto here = std::find(open.begin(), open.end(), deciding_);
    if (open.empty()) return;
    deciding_ = here == open.end() || here + 1 == open.end() ? open.front() : *(here + 1);
    editing_->select({deciding_->first});
    Q_EMIT locateWanted(deciding_->first);
    refreshConflict();
  });
}

void OverlaysDock::buildOffer() {
  offer_box_->setLayout(
      columnOf({offer_, rowOf({restore_, forget_, LayoutItem::rest()}, 4)}, 4, QMargins(8, 6, 8, 6)));
  offer_box_->hide();
}

void OverlaysDock::setUnavailableReason(const QString& sentence, bool may_retry) {
  unavailable_reason_ = sentence;
  may_retry_ = may_retry;
  refresh();
}

void OverlaysDock::setSaving(bool saving, bool may_save, const QString& trouble) {
  saving_ = saving;
  may_save_ = may_save;
  trouble_ = trouble;
  refresh();
}

void OverlaysDock::setOffer(const QString& sentence) {
  offer_->setText(sentence);
  offer_box_->setVisible(!sentence.isEmpty());
}

void OverlaysDock::setFlaws(std::vector<ShownFlaw> flaws) {
  std::set<FeatureKey> keys;
  for (const ShownFlaw& flaw : flaws) keys.insert(flaw.key);
  model_->setFlawed(std::move(keys));
  tabs_->setTabText(2, flaws.empty() ? tr("Flaws") : tr("Flaws (%1)").arg(flaws.size()));
  flaws_->setFlaws(std::move(flaws));
}

bool OverlaysDock::hasUnsavedFlaws() const {
  return std::any_of(flaws_->flaws().begin(), flaws_->flaws().end(),
                     [this](const ShownFlaw& flaw) { return editing_->document().isUnsaved(flaw.key); });
}

void OverlaysDock::refreshMode() {
  modeButton(tool_->mode())->setChecked(true);
  const overlays::Shape shape = shapeOf(tool_->mode());
  const bool drawing = shape != overlays::Shape::None;
  if (drawing) showTypes(*new_type_, shape, tool_->newType(shape));
  new_type_->setVisible(drawing);
  radius_row_->setVisible(tool_->mode() == OverlayMode::Circle);
}

void OverlaysDock::refresh() {
  const auto& document = editing_->document();
  const bool open = editing_->isOpen(), editable = editing_->editable();
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  body_->setVisible(open);
  mode_row_->setVisible(open);
  tool_row_->setVisible(open);
  for (QToolButton* button : modes_) button->setEnabled(editable);
  for (QToolButton* button : {duplicate_, remove_})
    button->setEnabled(editable && !editing_->selected().empty());
  const std::size_t unsaved = document.unsavedCount();
  discard_->setEnabled(editable && unsaved > 0);
  review_->setEnabled(editable && may_save_);
  restore_->setEnabled(editable);
  retry_->setVisible(may_retry_);
  const QString status = statusText();
  status_->setText(status);
  status_->setVisible(!status.isEmpty());
  setTextColor(*status_, trouble_.isEmpty() ? appColors().secondary_text : appColors().error_text);
  refreshConflict();
}

void OverlaysDock::refreshConflict() {
  const auto& document = editing_->document();
  const auto open = document.conflicts();
  if (std::find(open.begin(), open.end(), deciding_) == open.end())
    deciding_ = open.empty() ? std::nullopt : std::optional(open.front());
  const bool had_focus = conflict_box_->isAncestorOf(focusWidget());
  conflict_box_->setVisible(deciding_.has_value());
  next_->setVisible(open.size() > 1);
  for (QPushButton* button : {mine_, theirs_}) button->setEnabled(editing_->editable());
  if (!deciding_) {
    conflict_->clear();
    // Not on to the next field: a key that is meant for the map would be typed into it.
    if (had_focus) table_->setFocus();
    return;
  }
  const auto& [key, part] = *deciding_;
  const bool of_all = key == kCollectionKey;
  const auto& feature = document.find(key) ? document.find(key) : document.findBase(key);
  const auto mine = document.mineOf(*deciding_), theirs = document.theirsOf(*deciding_);
  conflict_->setText((editing_->inFile()
                          ? tr("Changed here and in the file (%1 of %2): %3, %4.\nMine: %5\nTheirs: %6")
                          : tr("Changed here and on the robot (%1 of %2): %3, %4.\nMine: %5\nTheirs: %6"))
                         .arg(std::find(open.begin(), open.end(), *deciding_) - open.begin() + 1)
                         .arg(open.size())
                         .arg(of_all    ? tr("defaults of the map")
                              : feature ? overlayCalled(*feature)
                                        : QString(),
                              partName(part), valueText(part, mine), valueText(part, theirs)));
}

void OverlaysDock::showConflicts() {
  refreshConflict();
  if (deciding_) editing_->select({deciding_->first});
}

void OverlaysDock::showSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  std::vector<int> rows;
  for (const FeatureKey key : editing_->selected()) {
    const QModelIndex at = sorted_->mapFromSource(model_->indexOf(key));
    if (at.isValid()) rows.push_back(at.row());
  }
  selectRows(*table_, std::move(rows), 0);
  showing_selection_ = false;
}

std::set<FeatureKey> OverlaysDock::rowsSelected(bool deleted) const {
  std::set<FeatureKey> keys;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
    const FeatureKey key = model_->key(sorted_->mapToSource(row));
    if (editing_->document().find(key).has_value() != deleted) keys.insert(key);
  }
  return keys;
}

void OverlaysDock::onSelection() {
  if (showing_selection_) return;
  showing_selection_ = true;
  editing_->select(rowsSelected(false));
  showing_selection_ = false;
}

void OverlaysDock::showMenu(const QPoint& at) {
  QMenu menu(this);
  const bool any = !editing_->selected().empty(), editable = editing_->editable();
  const auto deleted = rowsSelected(true);
  menu.addAction(tr("&Show on the map"), this, [this] { Q_EMIT locateWanted(*editing_->selected().begin()); })
      ->setEnabled(any);
  menu.addSeparator();
  menu.addAction(tr("&Copy"), this, &OverlaysDock::copyWanted)->setEnabled(any);
  menu.addAction(tr("C&ut"), this, &OverlaysDock::cutWanted)->setEnabled(editable && any);
  menu.addAction(tr("&Paste"), this, &OverlaysDock::pasteWanted)->setEnabled(editable);
  menu.addAction(tr("Dup&licate"), editing_, &edit::OverlayEditing::duplicateSelected)
      ->setEnabled(editable && any);
  menu.addSeparator();
  menu.addAction(tr("&Restore"), this, [this, deleted] { editing_->restore(deleted); })
      ->setEnabled(editable && !deleted.empty());
  menu.addAction(themedIcon(QStringLiteral("trash")), tr("&Delete"), editing_,
                 &edit::OverlayEditing::removeSelected)
      ->setEnabled(editable && any);
  menu.exec(table_->viewport()->mapToGlobal(at));
}

QString OverlaysDock::statusText() const {
  if (saving_) return tr("Saving…");
  if (!editing_->isOpen()) return trouble_;
  std::size_t count = 0;
  for (FeatureKey key = 0; key < editing_->document().size(); ++key)
    count += editing_->document().find(key) ? 1 : 0;
  const auto unsaved = qsizetype(editing_->document().unsavedCount());
  if (!trouble_.isEmpty())
    return unsaved > 0 ? tr("%1 %2 not saved.").arg(trouble_, overlayChangesText(unsaved)) : trouble_;
  const QString all = featuresText(qsizetype(count));
  return unsaved > 0 ? tr("%1, %2 not saved.").arg(all, overlayChangesText(unsaved)) : tr("%1.").arg(all);
}

QString OverlaysDock::emptyText() const {
  if (!editing_->isOpen()) return unavailable_reason_;
  if (model_->rowCount() == 0) return tr("There are no overlays on this map yet. Draw one on the map.");
  return sorted_->rowCount() == 0 ? tr("No overlay matches the filter.") : QString();
}

QString OverlaysDock::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString OverlaysDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }
QString OverlaysDock::conflictShown() const {
  return conflict_box_->isHidden() ? QString() : conflict_->text();
}

bool OverlaysDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDockWidget::eventFilter(watched, event);
  const auto* const press = static_cast<QKeyEvent*>(event);
  if (watched == filter_ && press->key() == Qt::Key_Down) {
    table_->setFocus();
    return true;
  }
  if (watched == table_) {
    if (press->matches(QKeySequence::Copy)) return Q_EMIT copyWanted(), true;
    if (press->matches(QKeySequence::Cut)) return Q_EMIT cutWanted(), true;
    if (press->matches(QKeySequence::Paste)) return Q_EMIT pasteWanted(), true;
    if (press->key() == Qt::Key_Delete) return editing_->removeSelected(), true;
    const bool enter = press->key() == Qt::Key_Return || press->key() == Qt::Key_Enter;
    if (enter && editing_->only()) return Q_EMIT locateWanted(*editing_->only()), true;
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_overlays_dock.cpp"
