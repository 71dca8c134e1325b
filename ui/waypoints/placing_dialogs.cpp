#include "ui/waypoints/placing_dialogs.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

#include "geometry/pose.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {
namespace {

constexpr double kFarthestPlaceM = 1e6;
constexpr double kNoPlaceHeading = -181;  // the minimum of its field means none
constexpr int kLongestPlaceName = 500;

QDoubleSpinBox* number(double least, double most, int decimals, double step, const QString& suffix,
                       QWidget* parent) {
  auto* const box = new QDoubleSpinBox(parent);
  box->setLocale(QLocale::c());
  box->setRange(least, most);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(130);
  return box;
}

QDoubleSpinBox* metres(double least, double most, double value, QWidget* parent) {
  auto* const box = number(least, most, 3, 0.05, QStringLiteral(" m"), parent);
  box->setValue(value);
  return box;
}

QHBoxLayout* buttonsOf(QDialog* dialog, const QString& done) {
  auto* const ok = new QPushButton(done, dialog);
  ok->setObjectName(QStringLiteral("primary"));
  ok->setDefault(true);
  auto* const cancel = new QPushButton(QDialog::tr("Cancel"), dialog);
  cancel->setObjectName(QStringLiteral("secondary"));
  cancel->setAutoDefault(false);
  auto* const row = new QHBoxLayout;
  row->setSpacing(8);
  row->addStretch();
  row->addWidget(cancel);
  row->addWidget(ok);
  QObject::connect(ok, &QPushButton::clicked, dialog, &QDialog::accept);
  QObject::connect(cancel, &QPushButton::clicked, dialog, &QDialog::reject);
  return row;
}

QFormLayout* formOf(QVBoxLayout* column) {
  auto* const form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(8);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  return form;
}

}  // namespace

NewWaypointDialog::NewWaypointDialog(const map::Waypoint& present, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(QString::fromStdString(present.name), this)),
      x_(metres(-kFarthestPlaceM, kFarthestPlaceM, present.position_m.x(), this)),
      y_(metres(-kFarthestPlaceM, kFarthestPlaceM, present.position_m.y(), this)),
      heading_(number(kNoPlaceHeading, 180, 1, 15, QString(QChar(0xb0)), this)) {
  setWindowTitle(tr("New waypoint"));
  setMinimumWidth(340);
  name_->setMaxLength(kLongestPlaceName);
  name_->selectAll();
  heading_->setSpecialValueText(tr("none"));
  heading_->setValue(present.yaw_rad
                         ? geometry::degreesFromRadians(geometry::normalizeAngle(*present.yaw_rad))
                         : kNoPlaceHeading);
  heading_->setToolTip(tr("Counter-clockwise from the x axis of the map"));
  auto* const column = new QVBoxLayout(this);
  QFormLayout* const form = formOf(column);
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&x"), x_);
  form->addRow(tr("&y"), y_);
  form->addRow(tr("&Heading"), heading_);
  column->addLayout(buttonsOf(this, tr("Create")));
}

map::Waypoint NewWaypointDialog::waypoint() const {
  map::Waypoint point;
  point.name = name_->text().trimmed().toStdString();
  point.position_m = {x_->value(), y_->value()};
  if (heading_->value() > kNoPlaceHeading) point.yaw_rad = geometry::radiansFromDegrees(heading_->value());
  return point;
}

PlacingDialog::PlacingDialog(const PlacingNumbers& present, double told_radius_m, QWidget* parent)
    : QDialog(parent),
      present_(present),
      grid_(metres(0.01, 100, present.grid_m, this)),
      wall_(metres(0.01, 100, present.wall_m, this)),
      radius_(metres(0, 10, told_radius_m > 0 ? told_radius_m : present.radius_m, this)) {
  setWindowTitle(tr("Distances"));
  setMinimumWidth(380);
  auto* const column = new QVBoxLayout(this);
  QFormLayout* const form = formOf(column);
  form->addRow(tr("&Grid to snap to"), grid_);
  form->addRow(tr("Distance to &walls"), wall_);
  form->addRow(tr("&Radius of the robot"), radius_);
  radius_->setSpecialValueText(tr("not checked"));
  radius_->setEnabled(told_radius_m <= 0);
  auto* const about =
      new QLabel(told_radius_m > 0 ? tr("The robot reports its own footprint, which is used instead.")
                                   : tr("Waypoints closer to a wall than this get a warning. This robot does "
                                        "not report its footprint."),
                 this);
  about->setTextFormat(Qt::PlainText);
  about->setWordWrap(true);
  QPalette palette = about->palette();
  palette.setColor(QPalette::WindowText, appColors().secondary_text);
  about->setPalette(palette);
  column->addWidget(about);
  column->addLayout(buttonsOf(this, tr("OK")));
}

PlacingNumbers PlacingDialog::numbers() const {
  return {grid_->value(), wall_->value(), radius_->isEnabled() ? radius_->value() : present_.radius_m};
}

}  // namespace mapwright::window

#include "moc_placing_dialogs.cpp"
