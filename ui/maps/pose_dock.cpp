#include "ui/maps/pose_dock.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>

#include "jobs/set_pose.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/kit/wrapping_row.h"

namespace mapwright::ui {

PoseDock::PoseDock(QWidget* parent)
    : QDockWidget(tr("Robot's pose"), parent),
      warning_(wrappedLabel(jobs::poseWarning(), this)),
      outcome_(textLabel({}, this)),
      present_(new PlainLabel(this)),
      adjust_(new QCheckBox(tr("The robot may &adjust it"), this)),
      place_(compactButton(tr("&Place on the map"), this,
                           tr("Click where the robot is; drag towards where it looks"))),
      set_(compactButton(tr("&Set pose"), this, tr("Tell the robot that it is there"))),
      find_(compactButton(tr("&Find itself"), this,
                          tr("Make the robot search its whole map for its position"))),
      confirm_(compactButton(tr("It &is there"), this, tr("Set the pose that the robot proposes"))),
      reject_(compactButton(tr("&No"), this, tr("Leave the robot's pose as it is"))),
      cancel_(compactButton(tr("&Cancel"), this)) {
  setObjectName(QStringLiteral("pose"));
  const auto field = [this](const QString& name, double most, int decimals, double step,
                            const QString& unit) {
    QDoubleSpinBox* const box = numberField(this, {-most, most, decimals, step, unit, name, 90});
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &PoseDock::applyTyped);
    return box;
  };
  constexpr double kFarthestM = 1e7;
  x_ = field(tr("x of the pose"), kFarthestM, 3, 0.05, QStringLiteral(" m"));
  y_ = field(tr("y of the pose"), kFarthestM, 3, 0.05, QStringLiteral(" m"));
  yaw_ = field(tr("Heading of the pose"), 360, 1, 5, QStringLiteral("°"));
  adjust_->setToolTip(
      tr("The robot may correct the pose with its sensors. Otherwise it uses exactly this pose."));
  adjust_->setChecked(true);
  place_->setCheckable(true);
  outcome_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  outcome_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* const body = new QWidget(this);
  auto* const form = new QFormLayout;
  auto* const buttons = new WrappingRow(QMargins());
  for (QPushButton* const button : {place_, set_, find_}) buttons->add(button);
  form->addRow(tr("Now"), present_);
  form->addRow(tr("&x"), x_);
  form->addRow(tr("&y"), y_);
  form->addRow(tr("&Heading"), yaw_);
  body->setLayout(columnOf({warning_, form, adjust_, buttons, outcome_,
                            rowOf({confirm_, reject_, cancel_, LayoutItem::rest()}, 8), LayoutItem::rest()},
                           8, QMargins(8, 6, 8, 6)));
  setScrolledWidget(*this, body);
  connect(place_, &QPushButton::clicked, this, &PoseDock::placeWanted);
  connect(set_, &QPushButton::clicked, this, &PoseDock::setWanted);
  connect(find_, &QPushButton::clicked, this, &PoseDock::findWanted);
  connect(confirm_, &QPushButton::clicked, this, &PoseDock::confirmWanted);
  connect(reject_, &QPushButton::clicked, this, &PoseDock::forgetOutcome);
  connect(cancel_, &QPushButton::clicked, this, &PoseDock::cancelWanted);
  setPresent(std::nullopt);
  setPose(std::nullopt);
  forgetOutcome();
}

void PoseDock::show(const geometry::Pose2& pose) {
  const QScopedValueRollback quiet(setting_, true);
  x_->setValue(pose.x_m);
  y_->setValue(pose.y_m);
  yaw_->setValue(geometry::degreesFromRadians(pose.yaw_rad));
}

void PoseDock::setPresent(const std::optional<geometry::Pose2>& pose) {
  present_->setText(pose ? jobs::poseWords(*pose) : tr("unknown"));
  present_pose_ = pose.value_or(geometry::Pose2());
  // Not under the fingers of somebody who types.
  if (!has_pose_ && !x_->hasFocus() && !y_->hasFocus() && !yaw_->hasFocus()) show(present_pose_);
}

void PoseDock::setPose(const std::optional<geometry::Pose2>& pose) {
  has_pose_ = pose.has_value();
  show(pose.value_or(present_pose_));
  allowAll();
}

void PoseDock::setObstacle(const QString& why) {
  if (why == obstacle_) return;
  obstacle_ = why;
  for (QWidget* const one : std::initializer_list<QWidget*>{place_, set_, find_})
    one->setProperty("why", why);
  allowAll();
}

void PoseDock::setPlacing(bool on) { place_->setChecked(on); }

void PoseDock::setWaiting(bool waiting, const QString& said) {
  waiting_ = waiting;
  confirmable_ = false;
  if (waiting) {
    setTextColor(*outcome_, appColors().secondary_text);
    outcome_->setText(said);
  }
  allowAll();
}

void PoseDock::setOutcome(const QString& said, Outcome outcome, bool confirmable) {
  waiting_ = false;
  confirmable_ = confirmable;
  setTextColor(*outcome_, outcome == Outcome::Well  ? palette().color(QPalette::WindowText)
                          : outcome == Outcome::Odd ? appColors().warning_text
                                                    : appColors().error_text);
  outcome_->setText(said);
  allowAll();
}

void PoseDock::forgetOutcome() { setOutcome({}, Outcome::Well); }

void PoseDock::allowAll() {
  const bool may = obstacle_.isEmpty() && !waiting_;
  for (QWidget* const one : std::initializer_list<QWidget*>{x_, y_, yaw_, adjust_, place_, find_})
    one->setEnabled(may);
  set_->setEnabled(may && has_pose_);
  confirm_->setVisible(confirmable_);
  reject_->setVisible(confirmable_);
  confirm_->setEnabled(may);
  cancel_->setVisible(waiting_);
  warning_->setText(obstacle_.isEmpty() ? jobs::poseWarning() : obstacle_);
}

bool PoseDock::adjusts() const { return adjust_->isChecked(); }
QString PoseDock::outcomeShown() const { return outcome_->text(); }
QString PoseDock::warningShown() const { return warning_->text(); }
QString PoseDock::presentShown() const { return present_->text(); }

void PoseDock::applyTyped() {
  if (setting_) return;
  has_pose_ = true;
  allowAll();
  Q_EMIT typed(
      {x_->value(), y_->value(), geometry::normalizeAngle(geometry::radiansFromDegrees(yaw_->value()))});
}

}  // namespace mapwright::ui

#include "moc_pose_dock.cpp"
