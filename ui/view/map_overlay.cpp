#include "ui/view/map_overlay.h"

#include <algorithm>
#include <initializer_list>

#include <QEvent>
#include <QHBoxLayout>

#include "ui/kit/plain_label.h"
#include "ui/view/compare_bar.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_furniture.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/toast_stack.h"
#include "words/qt_plain.h"

namespace mapwright::window {

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
  auto* row = new QHBoxLayout(hint_frame_);
  row->setContentsMargins(12, 4, 12, 4);
  row->addWidget(hint_);
  hint_->setAlignment(Qt::AlignCenter);
  hint_frame_->hide();
  // The map stays usable under the hint.
  hint_frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
  for (QWidget* widget : std::initializer_list<QWidget*>{view_, card_, safety_notice_, notice_, place_notice_,
                                                         edit_notice_, compare_bar_}) {
    widget->installEventFilter(this);
  }
  connect(toasts_, &ToastStack::changed, this, &MapOverlay::place);
  place();
}

void MapOverlay::setHint(const QString& text) {
  hint_->setText(words::plainText(text));
  hint_frame_->setVisible(!text.isEmpty());
  place();
}

QString MapOverlay::hint() const { return hint_->text(); }

void MapOverlay::setFurnitureVisible(bool visible) {
  furniture_visible_ = visible;
  furniture_->setVisible(visible);
}

bool MapOverlay::eventFilter(QObject* watched, QEvent* event) {
  // A strip's own resize is no reason: it comes from here, or, the first time, while the strip is about to be
  // shown. A geometry that is set then is never told to its layout, and its text has no room.
  const bool resized = event->type() == QEvent::Resize && watched == view_;
  if (resized || event->type() == QEvent::Show || event->type() == QEvent::Hide ||
      event->type() == QEvent::LayoutRequest) {
    place();
  }
  return QObject::eventFilter(watched, event);
}

void MapOverlay::place() {
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
                             hint_frame_->sizeHint().height());
  }
  const QSize toasts = toasts_->sizeHint();
  toasts_->setGeometry(area.width() - toasts.width() - kMargin, area.height() - toasts.height() - kMargin,
                       toasts.width(), toasts.height());
}

}  // namespace mapwright::window

#include "moc_map_overlay.cpp"
