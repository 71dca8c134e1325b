#include "ui/waypoints/waypoint_form.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "geometry/pose.h"
#include "sentences/placing_sentence.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/tag_completer.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_warnings.h"

namespace mapwright::window {

namespace {

constexpr double kFarthestFieldM = 1e9;
constexpr double kNoHeading = -181;  // the minimum of its field means none
constexpr int kLongestName = 500;

QDoubleSpinBox* metres(const QString& accessible, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setLocale(QLocale::c());
  box->setRange(-kFarthestFieldM, kFarthestFieldM);
  box->setDecimals(3);
  box->setSingleStep(0.05);
  box->setSuffix(QStringLiteral(" m"));
  box->setKeyboardTracking(false);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(60);
  box->setAccessibleName(accessible);
  return box;
}

}  // namespace

WaypointForm::WaypointForm(WaypointEditing* editing, QWidget* parent)
    : QWidget(parent),
      editing_(editing),
      name_(new QLineEdit(this)),
      tags_(new QLineEdit(this)),
      x_(metres(tr("x of the waypoint"), this)),
      y_(metres(tr("y of the waypoint"), this)),
      yaw_(new QDoubleSpinBox(this)),
      doubtful_(new QLabel(this)) {
  doubtful_->setTextFormat(Qt::PlainText);
  doubtful_->setWordWrap(true);
  doubtful_->hide();
  name_->setMaxLength(kLongestName);
  name_->setAccessibleName(tr("Name of the waypoint"));
  tags_->setAccessibleName(tr("Tags of the waypoint"));
  tags_->setPlaceholderText(tr("separated by commas"));
  new TagCompleter(editing_, tags_);
  yaw_->setLocale(QLocale::c());
  yaw_->setRange(kNoHeading, 180);
  yaw_->setSpecialValueText(tr("none"));
  yaw_->setDecimals(1);
  yaw_->setSingleStep(5);
  yaw_->setSuffix(QString(QChar(0xb0)));
  yaw_->setKeyboardTracking(false);
  yaw_->setAlignment(Qt::AlignRight);
  yaw_->setAccessibleName(tr("Heading of the waypoint"));
  yaw_->setToolTip(tr("Counter-clockwise from the x axis of the map"));

  auto* place = new QHBoxLayout;
  place->setSpacing(4);
  place->addWidget(x_, 1);
  place->addWidget(y_, 1);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 6, 8, 6);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("x, y"), place);
  form->addRow(tr("Heading"), yaw_);
  form->addRow(tr("Tags"), tags_);
  form->addRow(doubtful_);

  connect(editing_, &WaypointEditing::selectionChanged, this, &WaypointForm::refresh);
  connect(editing_, &WaypointEditing::previewChanged, this, &WaypointForm::refresh);
  connect(editing_, &WaypointEditing::opened, this, [this] {
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
  connect(name_, &QLineEdit::textEdited, this, &WaypointForm::takeName);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    if (refreshing_ || !name_->isModified()) return;
    name_->setModified(false);
    last_field_ = 0;
    refresh();
  });
  connect(tags_, &QLineEdit::editingFinished, this, [this] {
    if (refreshing_ || !tags_->isModified()) return;
    tags_->setModified(false);
    apply(tr("tag %1"), edit::waypoint_field::kTags,
          [this](map::Waypoint& to) { to.tags = tagsFrom(tags_->text()); });
  });
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
  QPalette palette = doubtful_->palette();
  palette.setColor(QPalette::WindowText, appColors().warning_text);
  doubtful_->setPalette(palette);
  doubtful_->setText(text);
  doubtful_->setVisible(!text.isEmpty());
}

void WaypointForm::takeName(const QString& text) {
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
  refreshing_ = true;
  const map::Waypoint* const point = editing_->only();
  const edit::Key key = point ? *editing_->selected().begin() : edit::Key();
  if (std::exchange(shown_, key) != key) last_field_ = 0;
  const std::optional<placing::Spot> spot = point ? editing_->spotOf(key) : std::nullopt;
  setEnabled(point && editing_->editable());
  const auto show = [this](QLineEdit* edit, const QString& text) {
    if (edit->isModified() && (typing_ || edit->hasFocus())) return;  // the user is typing
    if (edit->text() != text) edit->setText(text);
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

}  // namespace mapwright::window

#include "moc_waypoint_form.cpp"
