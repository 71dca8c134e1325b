#include "ui/waypoints/rename_dialog.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableView>

#include "placing/arrange.h"
#include "sentences/plural.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

using exchange::NameTrouble;

constexpr int kLongestPattern = 400, kHighestFirst = 999'999'999, kHighestStep = 1'000, kNumberBoxPx = 90;

QString troubleText(NameTrouble trouble) {
  switch (trouble) {
    case NameTrouble::None:
      return {};
    case NameTrouble::Empty:
      return RenameDialog::tr("no name is left");
    case NameTrouble::Taken:
      return RenameDialog::tr("another waypoint has this name");
    case NameTrouble::Twice:
      return RenameDialog::tr("several would get this name");
  }
  return {};
}

}  // namespace

void NewNamesModel::show(std::vector<exchange::NewName> names) {
  const bool as_many = names.size() == names_.size();
  if (!as_many) beginResetModel();
  names_ = std::move(names);
  if (!as_many) return endResetModel();
  if (!names_.empty()) Q_EMIT dataChanged(index(0, 0), index(int(names_.size()) - 1, kColumns - 1));
}

int NewNamesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(names_.size());
}
int NewNamesModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant NewNamesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const exchange::NewName& name = names_[std::size_t(index.row())];
  const UiColors colors = appColors();
  const bool bad = name.trouble != NameTrouble::None;
  if (role == Qt::ForegroundRole) {
    if (bad && index.column() != NowColumn) return colors.error_text;
    if (!name.changes()) return colors.secondary_text;
  }
  if (role == Qt::DecorationRole && bad && index.column() == TroubleColumn) return markPixmap(Mark::Bad);
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  QString text = words::plainName(index.column() == NowColumn ? name.before : name.after);
  if (index.column() == TroubleColumn)
    text = name.changes() ? troubleText(name.trouble) : RenameDialog::tr("stays");
  return role == Qt::ToolTipRole ? plainToolTip(text) : text;
}

QVariant NewNamesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= kColumns) return {};
  const std::array<QString, kColumns> names{RenameDialog::tr("Now"), RenameDialog::tr("New name"), QString()};
  return names[std::size_t(section)];
}

RenameDialog::RenameDialog(WaypointEditing* editing, std::function<std::vector<edit::Key>()> list_order,
                           QWidget* parent)
    : QDialog(parent),
      editing_(editing),
      list_order_(std::move(list_order)),
      how_(new QComboBox(this)),
      pages_(new QStackedWidget(this)),
      pattern_(new QLineEdit(this)),
      find_(new QLineEdit(this)),
      replacement_(new QLineEdit(this)),
      first_(new WholeBox(this)),
      step_(new WholeBox(this)),
      order_(new QComboBox(this)),
      reverse_(new QCheckBox(tr("Re&versed"), this)),
      case_(new QCheckBox(tr("Match &case"), this)),
      model_(new NewNamesModel(this)),
      table_(new QuietTableView(this)),
      status_(wrappedLabel({}, this)),
      rename_(new QPushButton(tr("&Rename"), this)) {
  setObjectName(QStringLiteral("renameWaypoints"));
  setWindowTitle(tr("Rename waypoints"));
  resize(620, 480);
  how_->addItems({tr("New names, counted"), tr("Replace a part")});
  how_->setAccessibleName(tr("How they are renamed"));
  pages_->addWidget(patternPage());
  pages_->addWidget(replacePage());
  pages_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  showRows(*table_, model_, tr("Present and new names"));
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (const int column : {NewNamesModel::NowColumn, NewNamesModel::NewColumn})
    header->setSectionResizeMode(column, QHeaderView::Stretch);
  header->resizeSection(NewNamesModel::TroubleColumn, 34 * fontMetrics().averageCharWidth());
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*rename_, {cancel});
  setLayout(columnOf({rowOf({how_, LayoutItem::rest()}),
                      pages_,
                      {table_, 1},
                      status_,
                      rowOf({LayoutItem::rest(), cancel, rename_}, 8)},
                     12, QMargins(16, 16, 16, 16)));

  connect(how_, &QComboBox::currentIndexChanged, this, [this](int page) {
    pages_->setCurrentIndex(page);
    (page == 0 ? pattern_ : find_)->setFocus();
    look();
  });
  for (QLineEdit* field : {pattern_, find_, replacement_})
    connect(field, &QLineEdit::textChanged, this, &RenameDialog::look);
  for (QSpinBox* box : {first_, step_}) connect(box, &QSpinBox::valueChanged, this, &RenameDialog::look);
  connect(order_, &QComboBox::currentIndexChanged, this, &RenameDialog::look);
  for (QCheckBox* box : {reverse_, case_}) connect(box, &QCheckBox::toggled, this, &RenameDialog::look);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(rename_, &QPushButton::clicked, this, &RenameDialog::apply);
  // Others may rename and delete meanwhile; what has been typed stays.
  if (editing_->document())
    connect(editing_->document(), &edit::WaypointDocument::changed, this, &RenameDialog::look);
  connect(editing_, &WaypointEditing::selectionChanged, this, &RenameDialog::look);
  connect(editing_, &WaypointEditing::opened, this, &QDialog::reject);
  look();
  pattern_->setFocus();
}

QWidget* RenameDialog::patternPage() {
  auto* const page = new QWidget(pages_);
  setLongest(*pattern_, kLongestPattern);
  pattern_->setPlaceholderText(tr("Corridor ##"));
  pattern_->setAccessibleName(tr("Pattern of the new names"));
  first_->setRange(0, kHighestFirst);
  first_->setValue(1);
  first_->setAccessibleName(tr("First number"));
  step_->setRange(1, kHighestStep);
  step_->setAccessibleName(tr("Step from number to number"));
  for (QSpinBox* box : {first_, step_}) box->setMinimumWidth(kNumberBoxPx);
  order_->addItems({tr("as they are listed"), tr("from left to right (x)"), tr("from bottom to top (y)"),
                    tr("along their line"), tr("as they were selected")});
  order_->setAccessibleName(tr("Order of the numbers"));
  auto* const about =
      wrappedLabel(tr("# is the number (## with two digits, and so on), * is the present name."), page);
  setTextColor(*about, appColors().secondary_text);
  auto* const form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  const auto labelled = [page](const QString& text, QWidget* buddy) {
    auto* const label = new QLabel(text, page);
    label->setBuddy(buddy);
    return label;
  };
  form->addRow(tr("&Names"), pattern_);
  form->addRow(QString(), about);
  form->addRow(labelled(tr("&From"), first_),
               rowOf({first_, labelled(tr("&step"), step_), step_, LayoutItem::rest()}, 8));
  form->addRow(labelled(tr("&Order"), order_), rowOf({order_, reverse_, LayoutItem::rest()}, 8));
  return page;
}

QWidget* RenameDialog::replacePage() {
  auto* const page = new QWidget(pages_);
  for (QLineEdit* field : {find_, replacement_}) setLongest(*field, kLongestPattern);
  find_->setAccessibleName(tr("What is replaced"));
  replacement_->setAccessibleName(tr("Replacement"));
  replacement_->setPlaceholderText(tr("nothing: it is removed"));
  auto* const form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  form->addRow(tr("F&ind"), find_);
  form->addRow(tr("Replace &by"), replacement_);
  form->addRow(QString(), case_);
  return page;
}

exchange::Renaming RenameDialog::renaming() const {
  using How = exchange::Renaming::How;
  return {.how = how_->currentIndex() == 0 ? How::Pattern : How::Replace,
          .pattern = pattern_->text(),
          .first = first_->value(),
          .step = step_->value(),
          .find = find_->text(),
          .replacement = replacement_->text(),
          .match_case = case_->isChecked()};
}

std::vector<edit::Key> RenameDialog::ordered() const {
  constexpr std::array kOrders{placing::Order::AsGiven, placing::Order::X, placing::Order::Y,
                               placing::Order::AlongLine, placing::Order::AsGiven};
  const bool counts = how_->currentIndex() == 0;
  const auto chosen = std::size_t(counts ? order_->currentIndex() : 0);
  const std::vector<edit::Key> given = chosen == kOrders.size() - 1 ? editing_->inOrder() : list_order_();
  std::vector<edit::Key> keys;
  for (const std::size_t i : placing::orderOf(editing_->spots(given), kOrders[chosen]))
    keys.push_back(given[i]);
  if (counts && reverse_->isChecked()) std::reverse(keys.begin(), keys.end());
  return keys;
}

void RenameDialog::look() {
  keys_ = ordered();
  QStringList names;
  for (const edit::Key& key : keys_) names << QString::fromStdString(editing_->find(key)->name);
  exchange::TakenNames others;
  if (editing_->document()) {
    for (const auto& [key, point] : editing_->document()->items()) {
      if (!editing_->selected().contains(key)) others.insert(point.name);
    }
  }
  model_->show(exchange::renamed(names, renaming(), others));
  refreshStatus();
}

void RenameDialog::refreshStatus() {
  qint64 changed = 0, empty = 0, doubled = 0;
  for (const exchange::NewName& one : model_->names()) {
    changed += one.changes() ? 1 : 0;
    empty += one.trouble == NameTrouble::Empty ? 1 : 0;
    doubled += one.trouble == NameTrouble::Taken || one.trouble == NameTrouble::Twice ? 1 : 0;
  }
  const bool may_double = editing_->keeps().name_twice;
  QStringList texts{sentences::counted(tr("%1 names change.", nullptr, sentences::formOf(changed)), changed)};
  if (doubled > 0)
    texts << sentences::counted(tr("%1 names would not be unique.", nullptr, sentences::formOf(doubled)),
                                doubled)
          << (may_double ? QString() : tr("This robot refuses that."));
  if (empty > 0)
    texts << sentences::counted(tr("%1 names would be empty.", nullptr, sentences::formOf(empty)), empty);
  status_->setText(words::paragraph(texts));
  const bool bad = empty > 0 || (doubled > 0 && !may_double);
  setTextColor(*status_, bad           ? appColors().error_text
                         : doubled > 0 ? appColors().warning_text
                                       : appColors().secondary_text);
  rename_->setEnabled(editing_->editable() && changed > 0 && !bad);
}

QString RenameDialog::statusShown() const { return status_->text(); }

void RenameDialog::apply() {
  std::vector<std::pair<edit::Key, QString>> names;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (model_->names()[i].changes()) names.emplace_back(keys_[i], model_->names()[i].after);
  }
  // Its own change needs no further look.
  if (editing_->document()) editing_->document()->disconnect(this);
  editing_->renameAll(names);
  accept();
}

}  // namespace mapwright::ui

#include "moc_rename_dialog.cpp"
