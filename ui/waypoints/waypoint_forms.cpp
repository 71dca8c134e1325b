#include "ui/waypoints/waypoint_forms.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <QApplication>
#include <QComboBox>
#include <QCompleter>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStringListModel>

#include "geometry/pose.h"
#include "map/waypoint.h"
#include "sentences/placing_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_warnings.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr double kFarthestFieldM = 1e9;
constexpr double kNoHeading = -181;  // the minimum of its field means none
constexpr int kLongestName = 500;

constexpr double kFarthestShiftM = 1e6;
constexpr int kMostTagsShown = 8;
enum TurnHow { kTurnTo, kTurnBy, kNoTurn };

QString range(double from, double to) {
  const QLocale c = QLocale::c();
  const QString first = c.toString(from, 'f', 2), last = c.toString(to, 'f', 2);
  return first == last ? first : QStringLiteral("%1 … %2").arg(first, last);
}

/// Completes the last one of several comma-separated tags.
class TagCompleter : public QCompleter {
 public:
  /// Of what is typed into `edit`, which becomes its parent; `editing` must outlive it. The tags are looked
  /// up whenever somebody begins to type there, those that most waypoints have first.
  TagCompleter(WaypointEditing* editing, QLineEdit* edit)
      : QCompleter(edit), editing_(editing), edit_(edit), tags_(new QStringListModel(this)) {
    setModel(tags_);
    setCaseSensitivity(Qt::CaseInsensitive);
    setCompletionMode(QCompleter::PopupCompletion);
    edit_->setCompleter(this);
    edit_->installEventFilter(this);
    // Setting the text does not count as typing; this one was chosen.
    connect(
        this, qOverload<const QString&>(&QCompleter::activated), edit_, [edit] { edit->setModified(true); },
        Qt::QueuedConnection);
  }

  QString pathFromIndex(const QModelIndex& index) const override {
    const QString typed = edit_->text();
    const qsizetype comma = typed.lastIndexOf(QLatin1Char(','));
    const QString before = comma < 0 ? QString() : typed.left(comma + 1) + QLatin1Char(' ');
    return before + QCompleter::pathFromIndex(index);
  }
  QStringList splitPath(const QString& path) const override {
    return {path.mid(path.lastIndexOf(QLatin1Char(',')) + 1).trimmed()};
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == edit_ && event->type() == QEvent::FocusIn) lookUp();
    return QCompleter::eventFilter(watched, event);
  }

 private:
  void lookUp() {
    std::map<std::string, int> counts;
    if (editing_->document()) {
      for (const auto& [key, point] : editing_->document()->items()) {
        for (const std::string& tag : point.tags) ++counts[tag];
      }
    }
    std::vector<std::pair<int, std::string>> order;
    for (const auto& [tag, count] : counts) order.emplace_back(-count, tag);
    std::sort(order.begin(), order.end());
    QStringList tags;
    for (const auto& [count, tag] : order) {
      const QString text = QString::fromStdString(tag);
      if (!text.contains(QLatin1Char(','))) tags << text;  // that one cannot be typed
    }
    tags_->setStringList(tags);
  }

  WaypointEditing* editing_;
  QLineEdit* edit_;
  QStringListModel* tags_;
};

QDoubleSpinBox* metres(QWidget* parent, double most, const QString& name) {
  return numberField(parent, {.least = -most, .most = most, .name = name});
}

QFormLayout* formOf(QWidget* widget) {
  auto* const form = new QFormLayout(widget);
  form->setContentsMargins(8, 6, 8, 6);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  return form;
}

}  // namespace

bool hasFocusInside(const QWidget& form) { return form.isAncestorOf(QApplication::focusWidget()); }

WaypointForm::WaypointForm(WaypointEditing* editing, QWidget* parent)
    : QWidget(parent),
      editing_(editing),
      name_(new QLineEdit(this)),
      tags_(new QLineEdit(this)),
      x_(metres(this, kFarthestFieldM, tr("x of the waypoint"))),
      y_(metres(this, kFarthestFieldM, tr("y of the waypoint"))),
      yaw_(numberField(this, {kNoHeading, 180, 1, 5, QString(QChar(0xb0)), tr("Heading of the waypoint")})),
      doubtful_(wrappedLabel({}, this)) {
  doubtful_->hide();
  setLongest(*name_, kLongestName);
  name_->setAccessibleName(tr("Name of the waypoint"));
  tags_->setAccessibleName(tr("Tags of the waypoint"));
  tags_->setPlaceholderText(tr("separated by commas"));
  new TagCompleter(editing_, tags_);
  yaw_->setSpecialValueText(tr("none"));
  yaw_->setToolTip(tr("Counter-clockwise from the x axis of the map"));
  for (QDoubleSpinBox* box : {x_, y_, yaw_}) box->setKeyboardTracking(false);
  QHBoxLayout* const row = rowOf({x_, y_}, 4);
  for (const int i : {0, 1}) row->setStretch(i, 1);
  QFormLayout* const form = formOf(this);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("x, y"), row);
  form->addRow(tr("Heading"), yaw_);
  form->addRow(tr("Tags"), tags_);
  form->addRow(doubtful_);
  connect(editing_, &WaypointEditing::selectionChanged, this, &WaypointForm::refresh);
  connect(editing_, &WaypointEditing::previewChanged, this, &WaypointForm::refresh);
  connect(editing_, &WaypointEditing::opened, this, [this, form] {
    form->setRowVisible(tags_, editing_->keeps().tags);
    // Not offered if every waypoint must have a heading.
    const bool may_be_none = editing_->keeps().no_heading;
    const QSignalBlocker quiet(yaw_);
    yaw_->setRange(may_be_none ? kNoHeading : -180, 180);
    yaw_->setSpecialValueText(may_be_none ? tr("none") : QString());
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, &WaypointForm::refresh);
    refresh();
  });
  // Typed text is in the list, and so in the draft, at once; continuous typing is one step.
  connect(name_, &QLineEdit::textEdited, this, &WaypointForm::applyName);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    if (refreshing_ || !name_->isModified()) return;
    name_->setModified(false);
    last_field_ = 0;
    refresh();
  });
  connect(tags_, &QLineEdit::editingFinished, this, &WaypointForm::applyTags);
  // Only sets the edited field: the other one keeps its exact value, although it shows a rounded one.
  for (const auto& [box, axis] : {std::pair(x_, 0), std::pair(y_, 1)}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, axis = axis](double metres) {
      apply(tr("move %1"), edit::waypoint_field::kPosition,
            [&](map::Waypoint& to) { to.position_m[axis] = metres; });
    });
  }
  connect(yaw_, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
    apply(tr("turn %1"), edit::waypoint_field::kYaw, [&](map::Waypoint& to) {
      to.yaw_rad =
          degrees <= kNoHeading ? std::nullopt : std::optional(geometry::radiansFromDegrees(degrees));
    });
  });
  refresh();
}

void WaypointForm::setWarnings(const WaypointWarnings* warnings) {
  warnings_ = warnings;
  connect(warnings, &WaypointWarnings::changed, this, &WaypointForm::showWarnings);
  showWarnings();
}

QString WaypointForm::warningsShown() const { return doubtful_->isHidden() ? QString() : doubtful_->text(); }

void WaypointForm::showWarnings() {
  const QString text =
      warnings_ && !shown_.empty() ? sentences::sentencesOf(warnings_->of(shown_)) : QString();
  setTextColor(*doubtful_, appColors().warning_text);
  doubtful_->setText(text);
  doubtful_->setVisible(!text.isEmpty());
}

void WaypointForm::applyName(const QString& text) {
  const map::Waypoint* const now = editing_->find(shown_);
  if (refreshing_ || !now) return;
  if (last_field_ != edit::waypoint_field::kName) {
    gesture_ = editing_->newGesture();
    name_before_ = QString::fromStdString(now->name);
  }
  last_field_ = edit::waypoint_field::kName;
  typing_ = true;
  // An empty name is invalid: the previous one stays.
  editing_->rename(shown_, text.trimmed().isEmpty() ? name_before_ : text, gesture_);
  typing_ = false;
}

void WaypointForm::applyTags() {
  if (refreshing_ || !tags_->isModified()) return;
  tags_->setModified(false);
  apply(tr("tag %1"), edit::waypoint_field::kTags,
        [this](map::Waypoint& to) { to.tags = tagsFrom(tags_->text()); });
}

void WaypointForm::apply(const QString& what, edit::FieldMask field,
                         const std::function<void(map::Waypoint&)>& change) {
  const map::Waypoint* const now = editing_->find(shown_);
  if (refreshing_ || !now) return;
  map::Waypoint to = *now;
  change(to);
  if (last_field_ != field) gesture_ = editing_->newGesture();
  last_field_ = field;
  editing_->set(shown_, to, what.arg(shortWaypointName(*now)), gesture_);
}

void WaypointForm::refresh() {
  const map::Waypoint* const point = editing_->only();
  const edit::Key key = point ? *editing_->selected().begin() : edit::Key();
  if (shown_ != key) {
    applyTags();  // of the one before: what is being typed is not about the next one
    for (QLineEdit* field : {name_, tags_}) field->setModified(false);
    shown_ = key;
    last_field_ = 0;
  }
  refreshing_ = true;
  const std::optional<placing::Spot> spot = point ? editing_->spotOf(key) : std::nullopt;
  // Whoever is typing when the waypoint goes types on, into nothing: letters would be commands elsewhere.
  setEnabled((point && editing_->editable()) || (isEnabled() && hasFocusInside(*this)));
  const auto show = [this](QLineEdit* edit, const QString& text) {
    if (edit->isModified() && (typing_ || edit->hasFocus())) return;  // the user is typing
    if (edit->text() != text) showWhole(*edit, text);
  };
  show(name_, point ? QString::fromStdString(point->name) : QString());
  show(tags_, point ? tagsText(point->tags) : QString());
  const auto number = [](QDoubleSpinBox* box, double value) {
    const QSignalBlocker quiet(box);
    box->setValue(value);
  };
  number(x_, spot ? spot->position_m.x() : 0);
  number(y_, spot ? spot->position_m.y() : 0);
  number(yaw_, spot && spot->yaw_rad ? geometry::degreesFromRadians(geometry::normalizeAngle(*spot->yaw_rad))
                                     : kNoHeading);
  if (!point) {
    for (QDoubleSpinBox* box : {x_, y_, yaw_}) box->clear();  // only the text
  }
  refreshing_ = false;
  showWarnings();
}

GroupSummary summaryOf(const edit::WaypointDocument& document, const std::set<edit::Key>& keys) {
  GroupSummary summary;
  summary.same_yaw = summary.same_type = true;
  for (const edit::Key& key : keys) {
    const map::Waypoint* const point = document.find(key);
    if (!point) continue;
    summary.place.extend(point->position_m);
    for (const std::string& tag : point->tags) ++summary.tags[tag];
    if (summary.count++ == 0) {
      summary.yaw_rad = point->yaw_rad;
      summary.type = point->type;
    }
    summary.same_yaw = summary.same_yaw && map::sameHeading(point->yaw_rad, summary.yaw_rad);
    summary.same_type = summary.same_type && point->type == summary.type;
  }
  return summary;
}

GroupForm::GroupForm(WaypointEditing* editing, QWidget* parent)
    : QWidget(parent),
      editing_(editing),
      place_(wrappedLabel({}, this)),
      tags_(wrappedLabel({}, this)),
      dx_(metres(this, kFarthestShiftM, tr("Shift along x"))),
      dy_(metres(this, kFarthestShiftM, tr("Shift along y"))),
      yaw_(numberField(this, {-360, 360, 1, 5, QString(QChar(0xb0)), tr("Heading of all selected")})),
      turn_how_(new QComboBox(this)),
      rename_(compactButton(tr("Rename…"), this,
                            tr("New names for all of them: counted, or with a part replaced (F2)"))),
      shift_(compactButton(tr("Shift"), this)),
      turn_(compactButton(tr("Turn"), this)),
      add_tags_(new QLineEdit(this)),
      remove_tags_(new QLineEdit(this)),
      type_(new QLineEdit(this)),
      type_label_(new QLabel(tr("Kind"), this)) {
  turn_how_->addItems({tr("to"), tr("by")});
  turn_how_->setAccessibleName(tr("How the heading changes"));
  add_tags_->setPlaceholderText(tr("add, then Enter"));
  add_tags_->setAccessibleName(tr("Tags to add to all selected"));
  remove_tags_->setPlaceholderText(tr("remove, then Enter"));
  remove_tags_->setAccessibleName(tr("Tags to remove from all selected"));
  type_->setAccessibleName(tr("Kind of all selected"));
  new TagCompleter(editing_, add_tags_);
  new TagCompleter(editing_, remove_tags_);

  QHBoxLayout *const shift_row = rowOf({dx_, dy_, shift_}, 4),
                     *const turn_row = rowOf({turn_how_, yaw_, turn_}, 4),
                     *const tags_row = rowOf({add_tags_, remove_tags_}, 4);
  for (const int i : {0, 1}) {
    shift_row->setStretch(i, 1);
    tags_row->setStretch(i, 1);
  }
  turn_row->setStretch(1, 1);
  QFormLayout* const form = formOf(this);
  form->addRow(place_);
  form->addRow(tr("Names"), rowOf({rename_, LayoutItem::rest()}));
  form->addRow(tr("Shift"), shift_row);
  form->addRow(tr("Heading"), turn_row);
  form->addRow(tr("Tags"), tags_row);
  form->addRow(QString(), tags_);
  form->addRow(type_label_, type_);

  connect(editing_, &WaypointEditing::selectionChanged, this, &GroupForm::refresh);
  connect(editing_, &WaypointEditing::opened, this, [this, form, tags_row] {
    // Fields that the store cannot keep are not offered.
    const robot::KeptFields& keeps = editing_->keeps();
    form->setRowVisible(tags_row, keeps.tags);
    form->setRowVisible(tags_, keeps.tags);
    for (QWidget* of_types : std::initializer_list<QWidget*>{type_label_, type_})
      of_types->setVisible(keeps.type);
    turn_how_->removeItem(kNoTurn);
    if (keeps.no_heading) turn_how_->addItem(tr("none"));
    if (editing_->document())
      connect(editing_->document(), &edit::WaypointDocument::changed, this, &GroupForm::refresh);
    refresh();
  });
  connect(rename_, &QPushButton::clicked, editing_, &WaypointEditing::renameSeveralWanted);
  connect(shift_, &QPushButton::clicked, this, &GroupForm::shift);
  connect(turn_, &QPushButton::clicked, this, &GroupForm::turn);
  connect(turn_how_, &QComboBox::currentIndexChanged, this,
          [this](int how) { yaw_->setEnabled(how != kNoTurn); });
  connect(add_tags_, &QLineEdit::returnPressed, this, [this] { tag(add_tags_, true); });
  connect(remove_tags_, &QLineEdit::returnPressed, this, [this] { tag(remove_tags_, false); });
  connect(type_, &QLineEdit::returnPressed, this, [this] {
    if (!type_->isModified()) return;
    const std::string type = type_->text().trimmed().toStdString();
    type_->setModified(false);
    editing_->changeSelected(tr("kind of %1"), [&](map::Waypoint& to) { to.type = type; });
  });
  refresh();
}

void GroupForm::shift() { editing_->moveSelected({dx_->value(), dy_->value()}); }

void GroupForm::turn() {
  const double angle = geometry::radiansFromDegrees(yaw_->value());
  const int how = turn_how_->currentIndex();
  editing_->changeSelected(tr("turn %1"), [&](map::Waypoint& to) {
    if (how == kNoTurn) {
      to.yaw_rad.reset();
    } else {
      to.yaw_rad = geometry::normalizeAngle(how == kTurnTo ? angle : to.yaw_rad.value_or(0) + angle);
    }
  });
}

void GroupForm::tag(QLineEdit* edit, bool add) {
  const std::vector<std::string> tags = tagsFrom(edit->text());
  if (tags.empty()) return;
  editing_->changeSelected(add ? tr("tag %1") : tr("untag %1"), [&](map::Waypoint& to) {
    for (const std::string& tag : tags) {
      const bool has = std::find(to.tags.begin(), to.tags.end(), tag) != to.tags.end();
      if (add && !has) to.tags.push_back(tag);
      if (!add) std::erase(to.tags, tag);
    }
  });
  edit->clear();
}

void GroupForm::refresh() {
  const bool several = editing_->document() && editing_->selected().size() > 1;
  setEnabled((several && editing_->editable()) || (isEnabled() && hasFocusInside(*this)));
  if (!several) return;
  const GroupSummary all = summaryOf(*editing_->document(), editing_->selected());
  QString place =
      tr("%1: x %2 m, y %3 m")
          .arg(waypointsText(qsizetype(all.count)), range(all.place.min().x(), all.place.max().x()),
               range(all.place.min().y(), all.place.max().y()));
  place += !all.same_yaw ? tr(", different headings")
           : all.yaw_rad ? tr(", heading %1").arg(yawText(all.yaw_rad))
                         : tr(", no heading");
  place_->setText(place);
  QStringList tags;
  for (const auto& [tag, count] : all.tags) {
    if (tags.size() == kMostTagsShown) {
      tags << QStringLiteral("…");
      break;
    }
    const QString name = words::plainName(tag);
    tags << (count == all.count
                 ? name
                 : tr("%1 (%2 of %3)").arg(name, QString::number(count), QString::number(all.count)));
  }
  tags_->setText(tags.isEmpty() ? tr("No tags") : words::listed(tags));
  if (!type_->isModified() || !type_->hasFocus())
    type_->setText(all.same_type ? QString::fromStdString(all.type) : QString());
  type_->setPlaceholderText(all.same_type ? tr("none") : tr("different"));
}

}  // namespace mapwright::ui

#include "moc_waypoint_forms.cpp"
