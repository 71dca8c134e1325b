#include "ui/maps/map_row_delegate.h"

#include <QApplication>
#include <QPainter>

#include "ui/kit/icons.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/maps_model.h"

namespace mapwright::window {

namespace {

constexpr int kMapRowPx = 56, kMapSectionPx = 24, kMapPad = 4;
// Names from robots are left-aligned in any script, so that all rows begin at the same edge.
constexpr int kLeft = int(Qt::AlignLeft) | int(Qt::AlignAbsolute) | int(Qt::AlignVCenter);

MapsModel::RowKind kindOf(const QModelIndex& index) {
  return MapsModel::RowKind(index.data(MapsModel::KindRole).toInt());
}

}  // namespace

QSize MapRowDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
  switch (kindOf(index)) {
    case MapsModel::RowKind::Section:
      return {100, kMapSectionPx};
    case MapsModel::RowKind::Live:
    case MapsModel::RowKind::Fetched:
      return {100, 40};
    case MapsModel::RowKind::Map:
      break;
  }
  return {100, kMapRowPx};
}

void MapRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  if (kindOf(index) == MapsModel::RowKind::Section) {
    paintSection(painter, option, index);
    return;
  }
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  row.text.clear();
  const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
  paintRowState(painter, option.rect, option.state.testFlag(QStyle::State_Selected),
                option.state.testFlag(QStyle::State_HasFocus));
  const UiColors colors = appColors();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const int edge = MapsModel::kThumbnailPx;
  const QRect box(option.rect.left() + kMapPad, option.rect.top() + (option.rect.height() - edge) / 2, edge,
                  edge);
  paintThumbnail(painter, box, index);
  QRect text = option.rect.adjusted(2 * kMapPad + edge + 2, 4, -kMapPad, -4);
  const QFontMetrics metrics(option.font);

  // The badges are at the right end of the first line; the name takes the rest.
  const QStringList badges = index.data(MapsModel::BadgesRole).toStringList();
  QFont small = option.font;
  small.setPointSizeF(small.pointSizeF() * 0.8);
  small.setWeight(QFont::DemiBold);
  const QFontMetrics small_metrics(small);
  const int line = text.height() / 2;
  QRect first(text.left(), text.top(), text.width(), line);
  for (auto it = badges.rbegin(); it != badges.rend(); ++it) {
    const bool current = std::next(it) == badges.rend() && index.data(MapsModel::CurrentRole).toBool();
    const QColor color = current ? colors.ok_text : colors.accent_text;
    const int width = small_metrics.horizontalAdvance(*it) + 8;
    const QRectF badge(first.right() - width + 1, first.center().y() - 7, width, 16);
    QColor fill = color;
    fill.setAlpha(26);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(badge, 4, 4);
    painter->setPen(color);
    painter->setFont(small);
    painter->drawText(badge, Qt::AlignCenter, *it);
    first.setRight(int(badge.left()) - 4);
  }
  const bool nameless =
      index.data(MapsModel::NamelessRole).toBool() && kindOf(index) == MapsModel::RowKind::Map;
  painter->setFont(option.font);
  painter->setPen(nameless ? colors.secondary_text : colors.text);
  painter->drawText(first, kLeft | Qt::TextSingleLine,
                    metrics.elidedText(index.data().toString(), Qt::ElideMiddle, first.width()));
  QFont second = option.font;
  second.setPointSizeF(second.pointSizeF() * 0.88);
  painter->setFont(second);
  painter->setPen(colors.secondary_text);
  const QRect below(text.left(), text.top() + line, text.width(), text.height() - line);
  painter->drawText(below, kLeft | Qt::TextSingleLine,
                    QFontMetrics(second).elidedText(index.data(MapsModel::DetailRole).toString(),
                                                    Qt::ElideRight, below.width()));
  painter->restore();
}

void MapRowDelegate::paintSection(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  const UiColors colors = appColors();
  painter->save();
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.88);
  font.setWeight(QFont::DemiBold);
  painter->setFont(font);
  painter->setPen(colors.secondary_text);
  painter->drawText(option.rect.adjusted(8, 4, -8, 0), kLeft, index.data().toString());
  painter->restore();
}

void MapRowDelegate::paintThumbnail(QPainter* painter, const QRect& box, const QModelIndex& index) const {
  const UiColors colors = appColors();
  if (kindOf(index) == MapsModel::RowKind::Live) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("robot"),
              colors.secondary_text);
    return;
  }
  if (kindOf(index) == MapsModel::RowKind::Fetched) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("rectangle"),
              colors.secondary_text);
    return;
  }
  painter->setPen(colors.border);
  painter->setBrush(colors.window);
  painter->drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  const QPixmap picture = index.data(MapsModel::ThumbnailRole).value<QPixmap>();
  if (picture.isNull()) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("map"), colors.neutral);
    return;
  }
  const QSizeF size = QSizeF(picture.size()) / picture.devicePixelRatio();
  painter->drawPixmap(
      QPointF(box.center().x() + 0.5 - size.width() / 2, box.center().y() + 0.5 - size.height() / 2),
      picture);
}

}  // namespace mapwright::window

#include "moc_map_row_delegate.cpp"
