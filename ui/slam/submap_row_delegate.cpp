#include "ui/slam/submap_row_delegate.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QHeaderView>
#include <QPainter>
#include <QTreeView>

#include "ui/kit/icons.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/slam/submap_tree_model.h"

namespace mapwright::ui {

namespace {

QColor badgeColor(const QString& name, const UiColors& colors) {
  if (name == QLatin1String("ACTIVE")) return colors.ok_text;
  if (name == QLatin1String("INC")) return colors.accent_text;
  if (name == QLatin1String("NEARBY")) return colors.warning_text;
  return colors.secondary_text;
}

constexpr int kSubmapPad = 2;      // left of what the delegate paints itself
constexpr int kStatusIconPx = 18;  // the mark of a status with its gap
constexpr double kBadgeGap = 3;    // between two
constexpr double kBadgeEdge = 8;   // around its word
constexpr int kLocatePx = 22, kRowPx = 24;

QFont badgeFont(QFont font) {
  font.setPointSizeF(font.pointSizeF() * 0.74);
  font.setWeight(QFont::DemiBold);
  return font;
}

double badgeWidth(const QFontMetricsF& metrics, const QString& name) {
  return metrics.horizontalAdvance(name) + kBadgeEdge;
}

double badgesWidth(const QFont& font, const QStringList& names) {
  const QFontMetricsF metrics(badgeFont(font));
  double width = 0;
  for (const QString& name : names) width += badgeWidth(metrics, name) + kBadgeGap;
  return width;
}

int nameWidth(const QTreeView& tree, const QString& text, int depth) {
  QStyleOptionViewItem option;
  option.initFrom(&tree);
  option.font = tree.font();
  option.fontMetrics = QFontMetrics(tree.font());
  option.features = QStyleOptionViewItem::HasDisplay | QStyleOptionViewItem::HasCheckIndicator;
  option.text = text;
  option.widget = &tree;
  const QSize item = tree.style()->sizeFromContents(QStyle::CT_ItemViewItem, &option, QSize(), &tree);
  return item.width() + tree.indentation() * (depth + (tree.rootIsDecorated() ? 1 : 0)) + 2;
}

}  // namespace

ColumnWidths shareColumns(int available, const ColumnNeeds& needs) {
  const int status_wanted = std::max(needs.status_wanted, needs.status_least);
  const int badges_wanted = std::max(needs.badges_wanted, needs.badges_least);
  const int room = std::max(available - needs.name - needs.locate, needs.total);
  ColumnWidths widths;
  widths.locate = needs.locate;
  widths.badges = std::clamp(room - status_wanted, needs.badges_least, badges_wanted);
  widths.status = std::clamp(room - widths.badges, needs.status_least, status_wanted);
  // A total may be wider than both: rather empty space than a truncated number.
  widths.status = std::max(widths.status, needs.total - widths.badges);
  widths.name = std::max(needs.name, available - widths.badges - widths.status - widths.locate);
  return widths;
}

ColumnNeeds columnNeeds(const QTreeView& tree, const SubmapTreeModel& model) {
  const QFontMetrics metrics(tree.font());
  ColumnNeeds needs;
  needs.name = std::max(nameWidth(tree, model.widestLeaf(), 2), nameWidth(tree, model.widestGroup(), 1));
  needs.total = metrics.horizontalAdvance(model.widestTotal()) + 2 * kSubmapPad + 4;
  needs.locate = kLocatePx;
  const auto heading = [&](SubmapTreeModel::Column column) { return tree.header()->sectionSizeHint(column); };
  SubmapFacts all;
  all.frozen = all.incremental = all.nearby = true;
  needs.badges_least = heading(SubmapTreeModel::BadgeColumn);
  needs.badges_wanted = kSubmapPad + int(std::ceil(badgesWidth(tree.font(), badges(all))));
  needs.status_least = heading(SubmapTreeModel::StatusColumn);
  for (int status = 0; status <= int(session::SubmapStatus::Unplaced); ++status) {
    const int word = metrics.horizontalAdvance(statusWord(session::SubmapStatus(status)));
    needs.status_wanted = std::max(needs.status_wanted, word + kStatusIconPx + 3 * kSubmapPad);
  }
  return needs;
}

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
      if (index.data(SubmapTreeModel::StatusRole).isValid()) paintStatus(painter, option, index);
      break;
    case SubmapTreeModel::LocateColumn:
      if (!index.data(SubmapTreeModel::StatusRole).isValid()) {
        paintTotal(painter, option, index);
      } else if (option.state & (QStyle::State_Selected | QStyle::State_MouseOver)) {
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
  const UiColors colors = appColors();
  const QFont font = badgeFont(option.font);
  painter->setFont(font);
  const QFontMetricsF metrics(font);
  double x = option.rect.left() + kSubmapPad;
  const auto paint_one = [&](const QString& name, const QColor& color) {
    const QRectF box(x, option.rect.center().y() - 6.5, badgeWidth(metrics, name), 15);
    QColor fill = color;
    fill.setAlpha(26);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(box, 4, 4);
    painter->setPen(color);
    painter->drawText(box, Qt::AlignCenter, name);
    x += box.width() + kBadgeGap;
  };
  const double right = option.rect.right() + 1;
  const bool all_fit = x + badgesWidth(option.font, names) - kBadgeGap <= right;
  // Badges without room become a count; the details below the tree list them
  // all.
  const double room = all_fit ? right : right - badgeWidth(metrics, QStringLiteral("+9")) - kBadgeGap;
  for (qsizetype i = 0; i < names.size(); ++i) {
    if (x + badgeWidth(metrics, names[i]) > room) {
      paint_one(QStringLiteral("+%1").arg(names.size() - i), colors.secondary_text);
      return;
    }
    paint_one(names[i], badgeColor(names[i], colors));
  }
}

void SubmapRowDelegate::paintStatus(QPainter* painter, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  const UiColors colors = appColors();
  const auto status = session::SubmapStatus(index.data(SubmapTreeModel::StatusRole).toInt());
  const Mark kind = statusMark(status);
  const QColor mark = markTextColor(kind, colors);
  QRect text = option.rect.adjusted(kSubmapPad, 0, -kSubmapPad, 0);
  paintIcon(painter, QRectF(text.left(), text.center().y() - 6.5, 14, 14), statusIcon(status), mark);
  text.setLeft(text.left() + kStatusIconPx);
  const QString word = index.data().toString();
  // A truncated word says less than the shape next to it; the tooltip has it in
  // full.
  if (QFontMetrics(option.font).horizontalAdvance(word) > text.width()) return;
  painter->setFont(option.font);
  // A normal row is unobtrusive; the status is only coloured if it needs
  // attention.
  painter->setPen(kind == Mark::Warning || kind == Mark::Bad ? mark : colors.secondary_text);
  painter->drawText(text, int(Qt::AlignLeft | Qt::AlignVCenter), word);
}

void SubmapRowDelegate::paintTotal(QPainter* painter, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
  // Across the columns before, which are empty on a group's row: painted with
  // the last one, over all of them.
  const auto* tree = qobject_cast<const QTreeView*>(option.widget);
  if (!tree) return;
  const int left = tree->visualRect(index.siblingAtColumn(SubmapTreeModel::BadgeColumn)).left();
  const QRect text(QPoint(left, option.rect.top()),
                   QPoint(option.rect.left() - kSubmapPad, option.rect.bottom()));
  painter->setFont(option.font);
  painter->setPen(appColors().secondary_text);
  painter->drawText(text, int(Qt::AlignRight | Qt::AlignVCenter),
                    index.data(SubmapTreeModel::TotalRole).toString());
}

}  // namespace mapwright::ui

#include "moc_submap_row_delegate.cpp"
