#include "ui/view/map_overlay.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

#include "geometry/pose.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/view/compare_bar.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {
constexpr int kMargin = 12;
}

MapOverlay::MapOverlay(MapView* view, MapFurniture* furniture)
    : QObject(view),
      view_(view),
      furniture_(furniture),
      card_(new EmptyStateCard(view)),
      safety_notice_(new NoticeBar(view)),
      notice_(new NoticeBar(view)),
      place_notice_(new NoticeBar(view)),
      edit_notice_(new NoticeBar(view)),
      compare_bar_(new CompareBar(view)),
      toasts_(new ToastStack(view)),
      hint_frame_(new QFrame(view)),
      hint_(new PlainLabel(hint_frame_)) {
  furniture_->setParent(view);
  hint_frame_->setObjectName(QStringLiteral("furniture"));
  hint_frame_->setLayout(rowOf({hint_}, -1, QMargins(12, 4, 12, 4)));
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  hint_->setMostLines(3);
  hint_frame_->hide();
  // The map stays usable under the hint.
  hint_frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
  for (QWidget* widget : std::initializer_list<QWidget*>{view_, card_, safety_notice_, notice_, place_notice_,
                                                         edit_notice_, compare_bar_}) {
    widget->installEventFilter(this);
  }
  connect(toasts_, &ToastStack::changed, this, &MapOverlay::layOut);
  layOut();
}

void MapOverlay::setHint(const QString& text) {
  const QString plain = words::plainText(text);
  if (plain == hint_->text() && text.isEmpty() == hint_frame_->isHidden()) return;
  hint_->setText(plain);
  hint_frame_->setVisible(!text.isEmpty());
  layOut();
}

QString MapOverlay::hint() const { return hint_->text(); }

void MapOverlay::setFurnitureVisible(bool visible) {
  furniture_visible_ = visible;
  furniture_->setVisible(visible);
  layOut();
}

bool MapOverlay::eventFilter(QObject* watched, QEvent* event) {
  // A strip's own resize is no reason: it comes from here, or, the first time, while the strip is about to be
  // shown. A geometry that is set then is never told to its layout, and its text has no room.
  const bool resized = event->type() == QEvent::Resize && watched == view_;
  if (resized || event->type() == QEvent::Show || event->type() == QEvent::Hide ||
      event->type() == QEvent::LayoutRequest) {
    layOut();
  }
  return QObject::eventFilter(watched, event);
}

void MapOverlay::layOut() {
  const QSize area = view_->size();
  int top = 0;
  for (QWidget* strip :
       std::initializer_list<QWidget*>{safety_notice_, notice_, place_notice_, edit_notice_, compare_bar_}) {
    if (strip->isHidden()) continue;
    const int height =
        strip->hasHeightForWidth() ? strip->heightForWidth(area.width()) : strip->sizeHint().height();
    strip->setGeometry(0, top, area.width(), height);
    top += strip->height();
  }
  view_->setCoveredTop(top);
  const QSize furniture = furniture_->sizeHint();
  furniture_->setGeometry(area.width() - furniture.width() - kMargin, top + kMargin, furniture.width(),
                          furniture.height());
  if (!card_->isHidden()) {
    const int width = std::min(card_->maximumWidth(), std::max(280, area.width() - 2 * kMargin));
    const int height = card_->hasHeightForWidth() ? card_->heightForWidth(width) : card_->sizeHint().height();
    card_->setGeometry((area.width() - width) / 2,
                       std::max(top + kMargin, top + (area.height() - top - height) / 2 - 16), width, height);
  }
  if (!hint_frame_->isHidden()) {
    const int room = area.width() - 2 * (furniture.width() + 2 * kMargin);
    const int width = std::clamp(hint_frame_->sizeHint().width() + 4, 0, std::max(0, room));
    hint_frame_->setGeometry((area.width() - width) / 2, top + kMargin, width,
                             hint_frame_->heightForWidth(width));
  }
  std::vector<QRectF> covered;
  if (furniture_visible_) covered.emplace_back(furniture_->geometry());
  if (!hint_frame_->isHidden()) covered.emplace_back(hint_frame_->geometry());
  view_->setCovered(std::move(covered));
  const QSize toasts = toasts_->sizeHint();
  toasts_->setGeometry(area.width() - toasts.width() - kMargin, area.height() - toasts.height() - kMargin,
                       toasts.width(), toasts.height());
}

void copyText(MapOverlay& overlay, const QString& text, const QString& said) {
  QGuiApplication::clipboard()->setText(words::plainText(text));
  overlay.toasts()->add(Mark::Good, said);
}

NorthArrow::NorthArrow(QWidget* parent) : QAbstractButton(parent) {
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::NoFocus);
  setFixedSize(32, 32);
  setAccessibleName(tr("North up"));
}

void NorthArrow::setRotation(double rad) {
  if (rad == rotation_) return;
  rotation_ = rad;
  update();
}

void NorthArrow::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.hover);
    painter.drawRoundedRect(rect(), 4, 4);
  }
  painter.translate(width() / 2.0, height() / 2.0);
  // Rotating the picture counter-clockwise rotates the painter (y down) by the negative angle.
  painter.rotate(-geometry::degreesFromRadians(rotation_));
  QPainterPath north, south;
  north.moveTo(0, -12);
  north.lineTo(4.5, 1);
  north.lineTo(-4.5, 1);
  north.closeSubpath();
  south.moveTo(0, 12);
  south.lineTo(4.5, 1);
  south.lineTo(-4.5, 1);
  south.closeSubpath();
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.error);
  painter.drawPath(north);
  painter.setBrush(colors.neutral);
  painter.drawPath(south);
}

MapFurniture::MapFurniture(const Actions& actions, QWidget* parent)
    : QFrame(parent), north_(new NorthArrow(this)) {
  setObjectName(QStringLiteral("furniture"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(2);
  QAction* const fit = actions.find(QStringLiteral("fit"));
  QAction* const north_up = actions.find(QStringLiteral("northUp"));
  for (QAction* action :
       {actions.find(QStringLiteral("zoomIn")), actions.find(QStringLiteral("zoomOut")), fit}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setIconSize({20, 20});
    button->setFixedSize(32, 32);
    button->setFocusPolicy(Qt::NoFocus);
    button->setAutoRepeat(action != fit);
    column->addWidget(button);
  }
  column->addWidget(north_);
  north_->setToolTip(north_up->toolTip());
  connect(north_, &QAbstractButton::clicked, north_up, &QAction::trigger);
  connect(north_up, &QAction::enabledChanged, north_, &QWidget::setEnabled);
}

}  // namespace mapwright::ui

#include "moc_map_overlay.cpp"
