#include "ui/waypoints/group_form.h"

#include <algorithm>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

#include "geometry/pose.h"
#include "map/waypoint.h"
#include "ui/waypoints/tag_completer.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr double kFarthestShiftM = 1e6;
constexpr int kMostTagsShown = 8;
enum TurnHow { kTurnTo, kTurnBy, kNoTurn };

QDoubleSpinBox* number(double most, int decimals, double step, const QString& suffix,
                       const QString& accessible, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setLocale(QLocale::c());
  box->setRange(-most, most);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(60);
  box->setAccessibleName(accessible);
  return box;
}

QString range(double from, double to) {
  const QLocale c = QLocale::c();
  const QString first = c.toString(from, 'f', 2), last = c.toString(to, 'f', 2);
  return first == last ? first : QStringLiteral("%1 … %2").arg(first, last);
}

}  // namespace

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
      place_(new QLabel(this)),
      tags_(new QLabel(this)),
      dx_(number(kFarthestShiftM, 3, 0.05, QStringLiteral(" m"), tr("Shift along x"), this)),
      dy_(number(kFarthestShiftM, 3, 0.05, QStringLiteral(" m"), tr("Shift along y"), this)),
      yaw_(number(360, 1, 5, QString(QChar(0xb0)), tr("Heading of all selected"), this)),
      turn_how_(new QComboBox(this)),
      shift_(new QPushButton(tr("Shift"), this)),
      turn_(new QPushButton(tr("Turn"), this)),
      add_tags_(new QLineEdit(this)),
      remove_tags_(new QLineEdit(this)),
      type_(new QLineEdit(this)),
      type_label_(new QLabel(tr("Kind"), this)) {
  for (QLabel* label : {place_, tags_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
  }
  turn_how_->addItems({tr("to"), tr("by")});
  turn_how_->setAccessibleName(tr("How the heading changes"));
  add_tags_->setPlaceholderText(tr("add, then Enter"));
  add_tags_->setAccessibleName(tr("Tags to add to all selected"));
  remove_tags_->setPlaceholderText(tr("remove, then Enter"));
  remove_tags_->setAccessibleName(tr("Tags to remove from all selected"));
  type_->setAccessibleName(tr("Kind of all selected"));
  for (QPushButton* button : {shift_, turn_}) button->setObjectName(QStringLiteral("compact"));
  new TagCompleter(editing_, add_tags_);
  new TagCompleter(editing_, remove_tags_);

  auto* shift_row = new QHBoxLayout;
  auto* turn_row = new QHBoxLayout;
  auto* tags_row = new QHBoxLayout;
  for (QHBoxLayout* row : {shift_row, turn_row, tags_row}) row->setSpacing(4);
  shift_row->addWidget(dx_, 1);
  shift_row->addWidget(dy_, 1);
  shift_row->addWidget(shift_);
  turn_row->addWidget(turn_how_);
  turn_row->addWidget(yaw_, 1);
  turn_row->addWidget(turn_);
  tags_row->addWidget(add_tags_, 1);
  tags_row->addWidget(remove_tags_, 1);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 6, 8, 6);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  form->addRow(place_);
  form->addRow(tr("Shift"), shift_row);
  form->addRow(tr("Heading"), turn_row);
  form->addRow(tr("Tags"), tags_row);
  form->addRow(QString(), tags_);
  form->addRow(type_label_, type_);

  connect(editing_, &WaypointEditing::selectionChanged, this, &GroupForm::refresh);
  connect(editing_, &WaypointEditing::opened, this, [this] {
    // Fields that the store cannot keep are not offered.
    const robot::KeptFields& keeps = editing_->keeps();
    for (QWidget* of_types : std::initializer_list<QWidget*>{type_label_, type_})
      of_types->setVisible(keeps.type);
    turn_how_->removeItem(kNoTurn);
    if (keeps.no_heading) turn_how_->addItem(tr("none"));
    if (editing_->document())
      connect(editing_->document(), &edit::DocumentEvents::changed, this, &GroupForm::refresh);
    refresh();
  });
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

void GroupForm::shift() {
  const Eigen::Vector2d by(dx_->value(), dy_->value());
  editing_->changeSelected(tr("move %1"), [&](map::Waypoint& to) { to.position_m += by; });
}

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
  setEnabled(several && editing_->editable());
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
  tags_->setText(tags.isEmpty() ? tr("No tags") : tags.join(QStringLiteral(", ")));
  if (!type_->isModified() || !type_->hasFocus())
    type_->setText(all.same_type ? QString::fromStdString(all.type) : QString());
  type_->setPlaceholderText(all.same_type ? tr("none") : tr("different"));
}

}  // namespace mapwright::window

#include "moc_group_form.cpp"
