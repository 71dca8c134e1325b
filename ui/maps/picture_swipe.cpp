#include "ui/maps/picture_swipe.h"

#include <cmath>
#include <utility>

#include <QPainter>

#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr QSize kPreferred(900, 480), kLeast(320, 200);
constexpr int kNamePadPx = 6, kNameAwayPx = 8;

}  // namespace

PictureSwipe::PictureSwipe(QImage left, QImage right, const QString& left_name, const QString& right_name,
                           QWidget* parent)
    : QWidget(parent),
      left_(std::move(left)),
      right_(std::move(right)),
      left_name_(left_name),
      right_name_(right_name),
      sheet_(this),
      handle_(&sheet_) {
  setMinimumSize(kLeast);
  handle_.setToolTip(tr("Drag it, or press Left and Right, to reveal one picture or the other"));
  handle_.setAccessibleName(tr("Divider between %1 and %2").arg(left_name_, right_name_));
  connect(&handle_, &SwipeHandle::moved, this, [this] { update(); });
  handle_.show();
}

QSize PictureSwipe::sizeHint() const {
  return canvas().boundedTo(canvas().scaled(kPreferred, Qt::KeepAspectRatio)).expandedTo(kLeast);
}

void PictureSwipe::resizeEvent(QResizeEvent*) {
  const QSize shown = canvas().boundedTo(canvas().scaled(size(), Qt::KeepAspectRatio));
  sheet_.setGeometry(QRect(QPoint((width() - shown.width()) / 2, (height() - shown.height()) / 2), shown));
  handle_.setAt(handle_.at());
  const double scale = double(shown.width()) / std::max(1, canvas().width()) * devicePixelRatioF();
  const auto scaled = [&](const QImage& picture) {
    QPixmap made = QPixmap::fromImage(picture.scaled((QSizeF(picture.size()) * scale).toSize(),
                                                     Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    made.setDevicePixelRatio(devicePixelRatioF());
    return made;
  };
  left_shown_ = scaled(left_);
  right_shown_ = scaled(right_);
}

void PictureSwipe::paintHalf(QPainter& painter, const QRect& half, const QPixmap& picture,
                             const QString& name, Qt::Alignment side) const {
  const UiColors colors = appColors();
  painter.setClipRect(half);
  painter.drawPixmap(sheet_.pos(), picture);
  QRect label(QPoint(), painter.fontMetrics().size(0, name) + QSize(2 * kNamePadPx, kNamePadPx));
  label.moveTop(half.top() + kNameAwayPx);
  if (side == Qt::AlignLeft)
    label.moveLeft(half.left() + kNameAwayPx);
  else
    label.moveRight(half.right() - kNameAwayPx);
  painter.fillRect(label, colors.window);
  painter.setPen(colors.text);
  painter.drawText(label, Qt::AlignCenter, name);
}

void PictureSwipe::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect whole = sheet_.geometry();
  const int divider = whole.left() + int(handle_.at() * whole.width());
  QRect left = whole, right = whole;
  left.setRight(divider - 1);
  right.setLeft(divider);
  paintHalf(painter, left, left_shown_, left_name_, Qt::AlignLeft);
  paintHalf(painter, right, right_shown_, right_name_, Qt::AlignRight);
  painter.setClipping(false);
  painter.fillRect(QRect(divider - 1, whole.top(), 2, whole.height()), appColors().accent);
}

}  // namespace mapwright::ui

#include "moc_picture_swipe.cpp"
