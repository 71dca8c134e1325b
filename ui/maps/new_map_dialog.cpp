#include "ui/maps/new_map_dialog.h"

#include <algorithm>

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>

#include "jobs/change_map.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

PlacePreview::PlacePreview(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 200);
  setAccessibleName(tr("Where the picture lies"));
}

void PlacePreview::setPresent(const geometry::WorldRect& map, const std::optional<geometry::Pose2>& robot) {
  present_ = map;
  robot_ = robot;
  update();
}

void PlacePreview::setPlace(const geometry::WorldRect& place) {
  place_ = place;
  update();
}

void PlacePreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), appColors().border);  // most pictures are white
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  if (place_.empty()) return;
  double left = std::min(place_.min_x, 0.0), right = std::max(place_.max_x, 0.0);
  double low = std::min(place_.min_y, 0.0), high = std::max(place_.max_y, 0.0);
  if (!present_.empty()) {
    // Of a small picture in the whole of a large map nothing would be seen.
    const double around_m = std::max(right - left, high - low);
    left = std::min(left, std::max(present_.min_x, left - around_m));
    right = std::max(right, std::min(present_.max_x, right + around_m));
    low = std::min(low, std::max(present_.min_y, low - around_m));
    high = std::max(high, std::min(present_.max_y, high + around_m));
  }
  constexpr double kRimPx = 14;
  const double scale = std::min((width() - 2 * kRimPx) / std::max(right - left, 1e-6),
                                (height() - 2 * kRimPx) / std::max(high - low, 1e-6));
  const QPointF middle(width() / 2.0, height() / 2.0);
  const auto px = [&](double x, double y) {
    return middle + QPointF((x - (left + right) / 2) * scale, -(y - (low + high) / 2) * scale);
  };
  const QRectF there(px(place_.min_x, place_.max_y), px(place_.max_x, place_.min_y));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!picture_.isNull()) painter.drawImage(there, picture_);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(appColors().accent_text, 1.5));
  painter.drawRect(there);
  if (!present_.empty()) {
    painter.setPen(QPen(appColors().secondary_text, 1, Qt::DashLine));
    painter.drawRect(QRectF(px(present_.min_x, present_.max_y), px(present_.max_x, present_.min_y)));
  }
  painter.setPen(QPen(appColors().secondary_text, 1));
  const QPointF origin = px(0, 0);
  painter.drawLine(origin - QPointF(6, 0), origin + QPointF(6, 0));
  painter.drawLine(origin - QPointF(0, 6), origin + QPointF(0, 6));
  if (robot_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(appColors().accent_text);
    painter.drawEllipse(px(robot_->x_m, robot_->y_m), 4, 4);
  }
}

NewMapDialog::NewMapDialog(const QString& path, const QSize& size, const QImage& shown, QWidget* parent)
    : QDialog(parent),
      path_(path),
      size_px_(size),
      name_(new QLineEdit(QFileInfo(path).completeBaseName().left(80), this)),
      size_(wrappedLabel({}, this)),
      error_(wrappedLabel({}, this)),
      preview_(new PlacePreview(this)),
      accept_(new QPushButton(tr("Add to the robot"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(tr("A map from a picture"));
  setMinimumWidth(460);
  name_->setObjectName(QStringLiteral("name"));
  name_->selectAll();
  resolution_ = numberField(this, {0, 10, 4, 0.01, tr(" m per pixel"), tr("Resolution"), 130});
  resolution_->setValue(0.05);
  constexpr double kFarthestM = 1e7;
  x_ = numberField(
      this, {-kFarthestM, kFarthestM, 3, 1, QStringLiteral(" m"), tr("x of the lower left corner"), 130});
  y_ = numberField(
      this, {-kFarthestM, kFarthestM, 3, 1, QStringLiteral(" m"), tr("y of the lower left corner"), 130});
  error_->setMinimumHeight(fontMetrics().lineSpacing());
  auto* const about = wrappedLabel(tr("Black pixels are occupied, white ones free, gray and transparent ones "
                                      "unknown (sent as gray). A map made from a picture has no positioning "
                                      "data: the robot may not find its position on it."),
                                   this);
  auto* const legend =
      wrappedLabel(tr("Dashed: what is on screen now. Cross: the origin. Dot: the robot."), this);
  setTextColor(*legend, appColors().secondary_text);
  auto* const form = new QFormLayout;
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Resolution"), resolution_);
  form->addRow(tr("Lower left corner, &x"), x_);
  form->addRow(tr("Lower left corner, &y"), y_);
  form->addRow(tr("Size"), size_);
  giveRoles(*accept_, {cancel_});
  setLayout(
      columnOf({about, form, {preview_, 1}, legend, error_, rowOf({LayoutItem::rest(), cancel_, accept_}, 8)},
               10, QMargins(16, 16, 16, 16)));
  preview_->setPicture(shown);
  connect(name_, &QLineEdit::textChanged, this, &NewMapDialog::check);
  for (QDoubleSpinBox* const box : {resolution_, x_, y_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &NewMapDialog::check);
  connect(accept_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  name_->setFocus();
  check();
}

void NewMapDialog::setPresent(const geometry::WorldRect& map, const std::optional<geometry::Pose2>& robot) {
  preview_->setPresent(map, robot);
}

jobs::PictureMap NewMapDialog::picture() const {
  return {path_, name_->text(), resolution_->value(), x_->value(), y_->value()};
}

void NewMapDialog::setRemark(std::function<QString(const QString& name)> remark) {
  remark_ = std::move(remark);
  check();
}

QString NewMapDialog::sizeShown() const { return size_->text(); }
QString NewMapDialog::errorShown() const { return error_->text(); }

void NewMapDialog::check() {
  const jobs::PictureMap now = picture();
  QString why = jobs::noMapNameReason(now.name);
  if (why.isEmpty()) why = jobs::noPlaceOfMapReason(now.resolution_m, now.x_m, now.y_m);
  setTextColor(*error_, why.isEmpty() ? appColors().secondary_text : appColors().error_text);
  error_->setText(!why.isEmpty() || !remark_ ? why : remark_(now.name));
  accept_->setEnabled(why.isEmpty());
  const double width = size_px_.width() * now.resolution_m, height = size_px_.height() * now.resolution_m;
  size_->setText(tr("%1 x %2 pixels, %3 x %4 m")
                     .arg(size_px_.width())
                     .arg(size_px_.height())
                     .arg(width, 0, 'f', 1)
                     .arg(height, 0, 'f', 1));
  preview_->setPlace(now.resolution_m > 0
                         ? geometry::WorldRect{now.x_m, now.y_m, now.x_m + width, now.y_m + height}
                         : geometry::WorldRect());
}

}  // namespace mapwright::ui

#include "moc_new_map_dialog.cpp"
