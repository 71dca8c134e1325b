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
  const UiColors colors = appColors();
  if (index.column() == SubmapTreeModel::NameColumn) {
    if (index.data(SubmapTreeModel::HiddenRole).toBool()) {
      row.palette.setColor(QPalette::Text, colors.secondary_text);
      row.palette.setColor(QPalette::HighlightedText, colors.secondary_text);
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
          (option.state & (QStyle::State_Selected | QStyle::State_MouseOver))) {
        paintIcon(painter, QRectF(option.rect).adjusted(2, 4, -2, -4), QStringLiteral("locate"),
                  colors.accent_text);
      }
      break;
    default:
      break;
  }
  painter->restore();
}

void SubmapRowDelegate::paintBadges(QPainter* painter, const QStyleOptionViewItem& option,
                                    const QStringList& names) const {
  constexpr double kGap = 3;
  const UiColors colors = appColors();
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.74);
  font.setWeight(QFont::DemiBold);
  painter->setFont(font);
  const QFontMetricsF metrics(font);
  const auto width = [&metrics](const QString& name) { return metrics.horizontalAdvance(name) + 8; };
  double x = option.rect.left() + 2;
  const auto paint_one = [&](const QString& name, const QColor& color) {
    const QRectF box(x, option.rect.center().y() - 6.5, width(name), 15);
    QColor fill = color;
    fill.setAlpha(26);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(box, 4, 4);
    painter->setPen(color);
    painter->drawText(box, Qt::AlignCenter, name);
    x += box.width() + kGap;
  };
  const double right = option.rect.right();
  double needed = x;
  for (const QString& name : names) needed += width(name) + kGap;
  const bool all_fit = needed - kGap <= right;
  // What has no room becomes a count; the details below the tree name them all.
  const double room = all_fit ? right : right - width(QStringLiteral("+9")) - kGap;
  for (qsizetype i = 0; i < names.size(); ++i) {
    if (x + width(names[i]) > room) {
      paint_one(QStringLiteral("+%1").arg(names.size() - i), colors.secondary_text);
      return;
    }
    paint_one(names[i], badgeColor(names[i], colors));
  }
}

void SubmapRowDelegate::paintStatus(QPainter* painter, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  const UiColors colors = appColors();
  const QVariant value = index.data(SubmapTreeModel::StatusRole);
  QRect text = option.rect.adjusted(2, 0, -4, 0);
  QColor color = colors.secondary_text;
  if (value.isValid()) {
    const auto status = session::SubmapStatus(value.toInt());
    const Mark kind = statusMark(status);
    const QColor mark = markTextColor(kind, colors);
    paintIcon(painter, QRectF(text.left(), text.center().y() - 6.5, 14, 14), statusIcon(status), mark);
    text.setLeft(text.left() + 18);
    // A healthy row stays quiet; the word takes a colour only where it asks for attention.
    if (kind == Mark::Warning || kind == Mark::Bad) color = mark;
  }
  painter->setPen(color);
  const QFontMetrics metrics(option.font);
  painter->setFont(option.font);
  painter->drawText(text, int((value.isValid() ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter),
                    metrics.elidedText(index.data().toString(), Qt::ElideRight, text.width()));
}

}  // namespace mapwright::window
