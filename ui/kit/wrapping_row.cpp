#include "ui/kit/wrapping_row.h"

#include <algorithm>

#include <QStyle>
#include <QWidget>

namespace mapwright::ui {

WrappingRow::WrappingRow(const QMargins& margins, int spacing) {
  setContentsMargins(margins);
  setSpacing(spacing);
}

WrappingRow::~WrappingRow() {
  for (const Item& each : items_) delete each.item;
}

void WrappingRow::add(QWidget* widget, int stretch, int wanted_px) {
  addChildWidget(widget);
  items_.push_back({new QWidgetItem(widget), stretch, wanted_px});
}

void WrappingRow::addItem(QLayoutItem* item) { items_.push_back({item, 0, -1}); }

QLayoutItem* WrappingRow::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[std::size_t(index)].item : nullptr;
}

QLayoutItem* WrappingRow::takeAt(int index) {
  QLayoutItem* const item = itemAt(index);
  if (item) items_.erase(items_.begin() + index);
  return item;
}

int WrappingRow::Item::width() const {
  return std::max(wanted_px < 0 ? item->sizeHint().width() : wanted_px, item->minimumSize().width());
}

QSize WrappingRow::sizeHint() const {
  int width = 0;
  for (const Item& each : items_)
    if (!each.item->isEmpty()) width += (width > 0 ? spacing() : 0) + each.width();
  const QMargins around = contentsMargins();
  width += around.left() + around.right();
  return {width, heightForWidth(width)};
}

QSize WrappingRow::minimumSize() const {
  QSize least;
  for (const Item& each : items_)
    if (!each.item->isEmpty()) least = least.expandedTo(each.item->minimumSize());
  return least.grownBy(contentsMargins());
}

void WrappingRow::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int WrappingRow::arrange(const QRect& rect, bool apply) const {
  const QRect area = rect.marginsRemoved(contentsMargins());
  int top = area.top();
  for (auto first = items_.begin(); first != items_.end();) {
    // As many as fit; one always does.
    int used = 0, stretches = 0, height = 0, shown = 0;
    auto last = first;
    for (; last != items_.end(); ++last) {
      if (last->item->isEmpty()) continue;
      const int more = (shown > 0 ? spacing() : 0) + last->width();
      if (shown > 0 && used + more > area.width()) break;
      used += more;
      stretches += last->stretch;
      height = std::max(height, last->item->sizeHint().height());
      ++shown;
    }
    if (shown == 0) break;
    int left = area.left(), spare = std::max(0, area.width() - used);
    for (; first != last; ++first) {
      if (!apply || first->item->isEmpty()) continue;
      int width = std::min(first->width(), area.width());
      if (first->stretch > 0) {
        const int more = spare * first->stretch / stretches;
        width = std::min(width + more, first->item->maximumSize().width());
        spare -= more;
        stretches -= first->stretch;
      }
      const int item_height = std::min(first->item->sizeHint().height(), height);
      const QRect at(left, top + (height - item_height) / 2, width, item_height);
      first->item->setGeometry(QStyle::visualRect(parentWidget()->layoutDirection(), area, at));
      left += width + spacing();
    }
    top += height + spacing();
  }
  if (top > area.top()) top -= spacing();
  return top - rect.top() + contentsMargins().bottom();
}

}  // namespace mapwright::ui
