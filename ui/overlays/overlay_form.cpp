#include "ui/overlays/overlay_form.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "overlays/overlay_shapes.h"
#include "sentences/fault_sentence.h"
#include "sentences/overlay_name.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/overlays/overlay_text.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using overlays::JsonText;
using overlays::Shape;

namespace {

constexpr double kNoYaw = -181;  // the minimum of its field means none
constexpr int kLongestOverlayName = 500;
constexpr int kMostRows = 2'000;
enum PropertyColumn { kKeyColumn, kValueColumn };

map::OverlayShape namedShape(Shape shape) {
  return shape == Shape::Line      ? map::OverlayShape::Line
         : shape == Shape::Polygon ? map::OverlayShape::Polygon
                                   : map::OverlayShape::Point;
}

bool isPlain(Shape shape) { return shape == Shape::Point || shape == Shape::Line || shape == Shape::Polygon; }

/// It has a field of its own.
bool hasField(const Feature& feature, const std::string& property) {
  const Shape shape = overlays::partShapeOf(feature);
  return property == "name" || (isPlain(shape) && property == overlays::typeProperty(shape)) ||
         (feature.shape() == Shape::Point && property == "yaw");
}

QTableWidgetItem* cell(const QString& text, bool editable) {
  auto* const item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled |
                 (editable ? Qt::ItemIsEditable : Qt::NoItemFlags));
  return item;
}

}  // namespace

void showTypes(QComboBox& picker, Shape shape, int type) {
  const QSignalBlocker quiet(picker);
  picker.clear();
  const map::OverlayShape named = namedShape(shape);
  std::vector<int> types = sentences::knownTypes(named);
  if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
  for (const int each : types) {
    const QString name = sentences::nameOf(named, each);
    picker.addItem(each == 0 ? OverlayForm::tr("none") : QStringLiteral("%1 (%2)").arg(name).arg(each), each);
  }
  picker.setCurrentIndex(picker.findData(type));
}

OverlayForm::OverlayForm(edit::OverlayEditing* editing, QWidget* parent)
    : QWidget(parent),
      editing_(editing),
      about_(wrappedLabel({}, this)),
      more_(wrappedLabel({}, this)),
      problem_(wrappedLabel({}, this)),
      yaw_label_(new QLabel(tr("Heading"), this)),
      name_(new QLineEdit(this)),
      new_key_(new QLineEdit(this)),
      type_(new QComboBox(this)),
      yaw_(numberField(this, {kNoYaw, 180, 2, 5, QString(QChar(0xb0)), tr("Heading of the overlay")})),
      properties_(new QTableWidget(0, 2, this)),
      add_(compactButton(tr("Add"), this, tr("Add this property"))),
      remove_(compactButton(tr("Remove"), this, tr("Remove the selected property"))) {
  setLongest(*name_, kLongestOverlayName);
  name_->setAccessibleName(tr("Name of the overlay"));
  type_->setAccessibleName(tr("Type of the overlay"));
  type_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  type_->setMinimumContentsLength(10);
  yaw_->setSpecialValueText(tr("none"));
  yaw_->setToolTip(tr("Counter-clockwise from the x axis of the map"));
  yaw_->setKeyboardTracking(false);
  new_key_->setPlaceholderText(tr("New property"));
  new_key_->setAccessibleName(tr("Name of the new property"));
  properties_->setAccessibleName(tr("Properties of the overlay"));
  properties_->setHorizontalHeaderLabels({tr("Property"), tr("Value (JSON)")});
  properties_->verticalHeader()->hide();
  properties_->verticalHeader()->setDefaultSectionSize(22);
  properties_->setSelectionBehavior(QAbstractItemView::SelectRows);
  properties_->setSelectionMode(QAbstractItemView::SingleSelection);
  properties_->setTabKeyNavigation(false);
  properties_->setWordWrap(false);
  properties_->setMinimumHeight(70);
  properties_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // what room is left
  properties_->horizontalHeader()->setHighlightSections(false);
  properties_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  properties_->horizontalHeader()->resizeSection(kValueColumn, 150);
  new NameColumn(properties_, properties_->horizontalHeader(), kKeyColumn, {{kValueColumn, 80}});
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Type"), type_);
  form->addRow(yaw_label_, yaw_);
  auto* const column = columnOf({about_, form}, 4, QMargins(8, 6, 8, 6));
  column->addWidget(properties_, 1);
  column->addWidget(more_);
  column->addLayout(rowOf({{new_key_, 1}, add_, remove_}, 4));
  column->addWidget(problem_);
  setLayout(column);
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::selectionChanged})
    connect(editing_, signal, this, &OverlayForm::refresh);
  connect(editing_, &edit::OverlayEditing::editableChanged, this, &OverlayForm::refreshUsable);
  // Dragging changes no property but the heading of one.
  connect(editing_, &edit::OverlayEditing::previewChanged, this, [this] {
    if (shown_) refresh();
  });
  connect(name_, &QLineEdit::editingFinished, this, &OverlayForm::applyName);
  connect(type_, &QComboBox::activated, this, [this] {
    const int type = type_->currentData().toInt();
    editing_->changeSelected(editing_->saying(tr("change the type of %1")),
                             [type](const Feature& each) { return overlays::withType(each, type); });
  });
  connect(yaw_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
    if (refreshing_ || editing_->selected().empty()) return;
    editing_->changeSelected(editing_->saying(tr("turn %1")), [degrees](const Feature& each) {
      return overlays::withYaw(each, degrees <= kNoYaw ? std::nullopt : std::optional(degrees));
    });
  });
  connect(properties_, &QTableWidget::cellChanged, this, [this](int row, int changed) {
    if (!refreshing_ && changed == kValueColumn) applyValue(row);
  });
  connect(properties_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(isEnabled() && !properties_->selectedItems().isEmpty()); });
  connect(new_key_, &QLineEdit::textChanged, this, [this](const QString& key) {
    add_->setEnabled(editing_->editable() && !editing_->selected().empty() && !key.trimmed().isEmpty());
  });
  connect(new_key_, &QLineEdit::returnPressed, this, &OverlayForm::addProperty);
  connect(add_, &QPushButton::clicked, this, &OverlayForm::addProperty);
  connect(remove_, &QPushButton::clicked, this, &OverlayForm::removeProperty);
  refresh();
}

const Feature* OverlayForm::feature() const { return shown_ ? editing_->find(*shown_) : nullptr; }

QString OverlayForm::moreShown() const { return more_->isHidden() ? QString() : more_->text(); }
QString OverlayForm::problemShown() const { return problem_->isHidden() ? QString() : problem_->text(); }

void OverlayForm::say(const QString& problem) {
  setTextColor(*problem_, appColors().error_text);
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

void OverlayForm::refresh() {
  const auto key = editing_->only();
  if (key != shown_) {
    applyName();  // of the one before
    name_->setModified(false);
    new_key_->clear();
    say({});
    shown_feature_.reset();
  }
  shown_ = key;
  const Feature* const now = feature();
  refreshing_ = true;
  const bool any = !editing_->selected().empty();
  name_->setPlaceholderText(any && !now ? tr("several values") : QString());
  properties_->setEnabled(any);
  const auto count = qsizetype(editing_->selected().size());
  about_->setText(count == 0 ? tr("Nothing is selected.")
                  : count > 1
                      ? tr("%1 selected.").arg(featuresText(count))
                      : tr("Id %1").arg(words::plainName(now && !now->id().empty() ? now->id() : "–")));
  const bool turns = now && now->shape() == Shape::Point;
  yaw_label_->setVisible(turns);
  yaw_->setVisible(turns);
  showType();
  if (!now) {
    name_->clear();
    shown_feature_.reset();
    showCommon();
  } else if (!shown_feature_ || &shown_feature_->text() != &now->text()) {
    shown_feature_ = *now;
    if (!name_->isModified()) showWhole(*name_, QString::fromStdString(now->name()));
    const auto yaw = overlays::yawOf(*now);
    const QSignalBlocker quiet(yaw_);
    yaw_->setValue(yaw ? std::remainder(*yaw, 360.0) : kNoYaw);
    showProperties(*now);
  }
  refreshUsable();
  refreshing_ = false;
}

void OverlayForm::refreshUsable() {
  const bool usable = !editing_->selected().empty() && editing_->editable();
  name_->setEnabled(feature() && usable);
  type_->setEnabled(type_->count() > 0 && usable);
  new_key_->setEnabled(usable);
  yaw_->setEnabled(usable);
  properties_->setEditTriggers(usable ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                                      : QAbstractItemView::NoEditTriggers);
  add_->setEnabled(usable && !new_key_->text().trimmed().isEmpty());
  remove_->setEnabled(usable && !properties_->selectedItems().isEmpty());
}

void OverlayForm::showType() {
  // Of all that are selected, if they are of one shape.
  std::set<Shape> shapes;
  std::set<int> types;
  for (const FeatureKey key : editing_->selected()) {
    shapes.insert(overlays::partShapeOf(*editing_->find(key)));
    types.insert(editing_->find(key)->type());
  }
  const bool one = shapes.size() == 1 && isPlain(*shapes.begin());
  if (!one) return type_->clear();
  showTypes(*type_, *shapes.begin(), *types.begin());
  if (types.size() > 1) type_->setCurrentIndex(-1);
}

void OverlayForm::showProperties(const Feature& feature) {
  std::vector<std::pair<QString, QString>> rows;
  qsizetype more = 0;
  const auto properties = feature.root().member("properties");
  for (const auto& member : properties ? properties->children() : std::vector<overlays::JsonValue>()) {
    if (!properties->isObject() || hasField(feature, member.key())) continue;
    if (rows.size() == std::size_t(kMostRows)) {
      ++more;
      continue;
    }
    rows.emplace_back(QString::fromStdString(member.key()),
                      QString::fromStdString(std::string(member.text())));
  }
  showRows(rows);
  sayMore(more == 0
              ? QString()
              : sentences::counted(tr("%1 more are not listed.", nullptr, sentences::formOf(more)), more));
}

void OverlayForm::showCommon() {
  std::vector<std::pair<QString, QString>> rows;
  const auto& keys = editing_->selected();
  std::vector<std::pair<std::string, std::optional<overlays::JsonValue>>> common;  // nullopt: several values
  bool first = true, cut = false;
  for (const FeatureKey key : keys) {
    const auto& feature = editing_->document().find(key);
    if (!feature) continue;
    if (std::exchange(first, false)) {
      const auto properties = feature->root().member("properties");
      if (!properties || !properties->isObject()) break;
      for (const auto& member : properties->children()) {
        if (member.key() != "yaw" && hasField(*feature, member.key())) continue;
        cut = common.size() == std::size_t(kMostRows);
        if (cut) break;
        common.emplace_back(member.key(), member);
      }
      continue;
    }
    std::erase_if(common, [&](auto& each) {
      const auto value = feature->property(each.first);
      if (value && each.second && !json::sameValue(*each.second, *value)) each.second.reset();
      return !value;
    });
    if (common.empty()) break;
  }
  for (const auto& [name, value] : common) {
    rows.emplace_back(QString::fromStdString(name),
                      value ? QString::fromStdString(std::string(value->text())) : tr("several values"));
  }
  showRows(rows);
  sayMore(cut ? tr("Only the first %1 properties are compared.").arg(countText(kMostRows)) : QString());
}

void OverlayForm::showRows(const std::vector<std::pair<QString, QString>>& rows) {
  properties_->setRowCount(int(rows.size()));
  for (int row = 0; row < int(rows.size()); ++row) {
    const auto& [key, value] = rows[std::size_t(row)];
    QTableWidgetItem* const name = cell(words::plainName(key), false);
    name->setData(Qt::UserRole, key);
    properties_->setItem(row, kKeyColumn, name);
    properties_->setItem(row, kValueColumn, cell(value, true));
    if (!shown_ && value == tr("several values"))
      properties_->item(row, kValueColumn)->setForeground(appColors().secondary_text);
  }
}

void OverlayForm::sayMore(const QString& sentence) {
  more_->setText(sentence);
  more_->setVisible(!sentence.isEmpty());
}

void OverlayForm::applyName() {
  const Feature* const now = feature();
  if (refreshing_ || !now || !name_->isModified()) return;
  name_->setModified(false);
  if (name_->text().toStdString() == now->name()) return;
  const auto set = overlays::withProperty(*now, "name", json::quoted(name_->text().toStdString()));
  editing_->set(*shown_, set, tr("rename %1").arg(overlayCalled(*now)));
}

void OverlayForm::applyValue(int row) {
  if (editing_->selected().empty()) return;
  const QString shown_key = properties_->item(row, kKeyColumn)->data(Qt::UserRole).toString();
  const std::string key = shown_key.toStdString();
  const std::string typed = properties_->item(row, kValueColumn)->text().trimmed().toStdString();
  const auto value = JsonText::read(typed);
  if (!value) {
    say(tr("This is not JSON: %1. Texts stand in quotes.")
            .arg(sentences::wordsOf(json::faultOf(value.error()))));
  } else {
    say({});
    // What has it already keeps its notation.
    editing_->changeSelected(
        editing_->saying(tr("set %1 of %2").arg(words::plainName(shown_key), QStringLiteral("%1"))),
        [&](const Feature& each) {
          const auto before = each.property(key);
          return before && json::sameValue(*before, value->root()) ? each
                                                                   : overlays::withProperty(each, key, typed);
        });
  }
  // Whatever was typed, it shows what is.
  shown_feature_.reset();
  refresh();
}

void OverlayForm::addProperty() {
  const QString key = new_key_->text().trimmed();
  const std::string name = key.toStdString();
  if (editing_->selected().empty() || key.isEmpty() || !editing_->editable()) return;
  bool all_have = true;
  for (const FeatureKey each : editing_->selected())
    all_have &= editing_->find(each)->property(name).has_value();
  if (all_have) return say(tr("There is a property %1 already.").arg(words::plainName(key)));
  say({});
  new_key_->clear();
  editing_->changeSelected(
      editing_->saying(tr("set %1 of %2").arg(words::plainName(key), QStringLiteral("%1"))),
      [&](const Feature& each) {
        return each.property(name) ? each : overlays::withProperty(each, name, "\"\"");
      });
  for (int row = 0; row < properties_->rowCount(); ++row) {
    if (properties_->item(row, kKeyColumn)->data(Qt::UserRole).toString() != key) continue;
    properties_->setCurrentCell(row, kValueColumn);
    properties_->editItem(properties_->item(row, kValueColumn));
  }
}

void OverlayForm::removeProperty() {
  const int row = properties_->currentRow();
  if (editing_->selected().empty() || row < 0) return;
  const QString key = properties_->item(row, kKeyColumn)->data(Qt::UserRole).toString();
  editing_->changeSelected(
      editing_->saying(tr("remove %1 of %2").arg(words::plainName(key), QStringLiteral("%1"))),
      [&](const Feature& each) { return overlays::withProperty(each, key.toStdString(), std::nullopt); });
}

OverlayPoints::OverlayPoints(edit::OverlayEditing* editing, QWidget* parent)
    : QWidget(parent),
      editing_(editing),
      about_(wrappedLabel({}, this)),
      table_(new QTableWidget(0, 2, this)) {
  table_->setAccessibleName(tr("Points of the overlay"));
  table_->setHorizontalHeaderLabels({tr("x m"), tr("y m")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setDefaultSectionSize(22);
  table_->setTabKeyNavigation(false);
  setLayout(columnOf({about_, {table_, 1}}, 4, QMargins(8, 6, 8, 6)));
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged,
                            &edit::OverlayEditing::previewChanged, &edit::OverlayEditing::selectionChanged})
    connect(editing_, signal, this, &OverlayPoints::refresh);
  connect(table_, &QTableWidget::cellChanged, this, [this](int row, int changed) {
    if (!refreshing_) onCellChanged(row, changed);
  });
  refresh();
}

QString OverlayPoints::aboutShown() const { return about_->text(); }

void OverlayPoints::refresh() {
  const auto key = editing_->only();
  const Feature* const now = key ? editing_->find(*key) : nullptr;
  table_->setEditTriggers(editing_->editable()
                              ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                              : QAbstractItemView::NoEditTriggers);
  if (key == shown_ && now && shown_feature_ && &shown_feature_->text() == &now->text()) return;
  shown_ = key;
  shown_feature_ = now ? std::optional(*now) : std::nullopt;
  refreshing_ = true;
  vertices_.clear();
  std::vector<Eigen::Vector2d> points;
  std::size_t count = 0;
  const auto rings = now ? overlays::verticesOf(*now) : std::vector<std::vector<Eigen::Vector2d>>();
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    count += rings[ring].size();
    for (std::size_t i = 0; i < rings[ring].size() && points.size() < std::size_t(kMostRows); ++i) {
      vertices_.push_back({ring, i});
      points.push_back(rings[ring][i]);
    }
  }
  table_->setRowCount(int(points.size()));
  for (int row = 0; row < int(points.size()); ++row) {
    for (const int axis : {0, 1}) {
      QTableWidgetItem* const item =
          cell(QString::fromStdString(overlays::coordinateText(points[std::size_t(row)][axis])), true);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, axis, item);
    }
  }
  about_->setText(
      !now             ? tr("Nothing is selected.")
      : points.empty() ? tr("Its points cannot be edited here, only moved as a whole.")
      : points.size() < count
          ? tr("%1 of %2 points are shown.").arg(countText(qint64(points.size())), countText(qint64(count)))
          : QString());
  about_->setVisible(!about_->text().isEmpty());
  refreshing_ = false;
}

void OverlayPoints::onCellChanged(int row, int column) {
  const Feature* const now = shown_ ? editing_->find(*shown_) : nullptr;
  if (!now || std::size_t(row) >= vertices_.size()) return;
  const overlays::Vertex vertex = vertices_[std::size_t(row)];
  Eigen::Vector2d at = overlays::verticesOf(*now)[vertex.ring][vertex.index];
  bool is_number = false;
  QString typed = table_->item(row, column)->text().trimmed();
  const double metres = typed.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&is_number);
  if (is_number && std::abs(metres) <= overlays::kFarthestM) {
    at[column] = metres;
    editing_->set(*shown_, overlays::withVertexAt(*now, vertex, at),
                  tr("reshape %1").arg(overlayCalled(*now)));
  }
  shown_feature_.reset();  // whatever was typed, it shows what is
  refresh();
}

}  // namespace mapwright::ui

#include "moc_overlay_form.cpp"
