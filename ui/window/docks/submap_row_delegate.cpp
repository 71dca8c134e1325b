#include "window/docks/submap_row_delegate.h"

#include <QApplication>
#include <QPainter>

#include "window/docks/submap_tree_model.h"
#include "window/look/icons.h"
#include "window/look/ui_colors.h"
#include "window/status/state_mark.h"

namespace mapwright::window {

namespace {

QColor badgeColor(const QString& name, const UiColors& colors) {
  if (name == QLatin1String("ACTIVE")) return colors.ok_text;
  if (name == QLatin1String("INC")) return colors.accent_text;
  if (name == QLatin1String("NEARBY")) return colors.warning_text;
  return colors.secondary_text;
}

}  // namespace

QSize SubmapRowDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRowPx};
}

void SubmapRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  const UiColors colors = uiColors(option.palette);
  const bool selected = option.state & QStyle::State_Selected;
  if (index.column() == SubmapTreeModel::NameColumn) {
    if (index.data(SubmapTreeModel::HiddenRole).toBool() && !selected) {
      row.palette.setColor(QPalette::Text, colors.secondary_text);
      row.font.setStrikeOut(true);
    }
    const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
    return;
  }
  row.text.clear();
  const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  switch (index.column()) {
    case SubmapTreeModel::BadgeColumn:
      paintBadges(painter, option, index.data(SubmapTreeModel::BadgesRole).toStringList());
      break;
    case SubmapTreeModel::StatusColumn:
      paintStatus(painter, option, index);
      break;
    case SubmapTreeModel::LocateColumn:
      if (index.data(SubmapTreeModel::StatusRole).isValid() &&
          (selected || option.state & QStyle::State_MouseOver)) {
        paintIcon(painter, QRectF(option.rect).adjusted(2, 4, -2, -4), QStringLiteral("locate"),
                  selected ? option.palette.color(QPalette::HighlightedText) : colors.accent_text);
      }
      break;
    default:
      break;
  }
  painter->restore();
}

void SubmapRowDelegate::paintBadges(QPainter* painter, const QStyleOptionViewItem& option,
                                    const QStringList& names) const {
  const UiColors colors = uiColors(option.palette);
  const bool selected = option.state & QStyle::State_Selected;
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.74);
  font.setWeight(QFont::DemiBold);
  painter->setFont(font);
  const QFontMetricsF metrics(font);
  double x = option.rect.left() + 2;
  const double right = option.rect.right() - 2;
  const auto width = [&metrics](const QString& name) { return metrics.horizontalAdvance(name) + 8; };
  for (qsizetype i = 0; i < names.size(); ++i) {
    const qsizetype left_over = names.size() - i;
    // A badge that has no room becomes a count; the tooltip of the column and the details name them all.
    QString name = names[i];
    const double reserve = left_over > 1 ? width(QStringLiteral("+9")) + 3 : 0;
    const bool last = x + width(name) + (left_over > 1 ? reserve : 0) > right &&
                      !(left_over == 1 && x + width(name) <= right);
    if (last) name = QStringLiteral("+%1").arg(left_over);
    const QRectF box(x, option.rect.center().y() - 7 + 0.5, width(name), 15);
    const QColor color = selected ? option.palette.color(QPalette::HighlightedText)
                         : last   ? colors.secondary_text
                                  : badgeColor(name, colors);
    QColor fill = color;
    fill.setAlpha(selected ? 50 : 26);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(box, 4, 4);
    painter->setPen(color);
    painter->drawText(box, Qt::AlignCenter, name);
    if (last) break;
    x += box.width() + 3;
  }
}

void SubmapRowDelegate::paintStatus(QPainter* painter, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  const UiColors colors = uiColors(option.palette);
  const bool selected = option.state & QStyle::State_Selected;
  const QVariant value = index.data(SubmapTreeModel::StatusRole);
  QRect text = option.rect.adjusted(2, 0, -4, 0);
  QColor color = selected ? option.palette.color(QPalette::HighlightedText) : colors.secondary_text;
  if (value.isValid()) {
    const auto status = session::SubmapStatus(value.toInt());
    const QColor mark = selected ? color : markTextColor(statusMark(status), colors);
    paintIcon(painter, QRectF(text.left(), text.center().y() - 6.5, 14, 14), statusIcon(status), mark);
    text.setLeft(text.left() + 18);
    // A healthy row stays quiet; the word takes a colour only where it asks for attention.
    const Mark kind = statusMark(status);
    if (!selected && (kind == Mark::Warning || kind == Mark::Bad)) color = mark;
  }
  painter->setPen(color);
  const QFontMetrics metrics(option.font);
  painter->setFont(option.font);
  painter->drawText(text, int((value.isValid() ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter),
                    metrics.elidedText(index.data().toString(), Qt::ElideRight, text.width()));
}

}  // namespace mapwright::window
