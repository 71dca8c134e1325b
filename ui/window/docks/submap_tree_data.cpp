// SubmapTreeModel: what a row shows, and its check box.
#include "window/docks/submap_tree_model.h"
#include "window/look/plain_label.h"
#include "window/status/status_text.h"

namespace mapwright::window {

QVariant SubmapTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (const auto leaf = facts(index)) return leafData(*leaf, index.column(), role);
  if (const auto number = trajectory(index)) {
    const Branch& branch = branches_[std::size_t(index.row())];
    return groupData(QStringLiteral("Trajectory %1").arg(*number), branch.visible, branch.shown,
                     int(branch.leaves.size()), index.column(), role);
  }
  return groupData(QStringLiteral("All"), visible_, shown_, total_, index.column(), role);
}

QVariant SubmapTreeModel::groupData(const QString& name, int visible, int shown, int total, int column,
                                    int role) const {
  if (column == NameColumn && role == Qt::DisplayRole) return name;
  if (column == NameColumn && role == Qt::CheckStateRole) {
    return int(visible == 0 ? Qt::Unchecked : visible == total ? Qt::Checked : Qt::PartiallyChecked);
  }
  if (column == StatusColumn && role == Qt::DisplayRole && total > 0) {
    return QStringLiteral("%1 of %2").arg(countText(shown), countText(total));
  }
  if (role == Qt::ToolTipRole) {
    return plainToolTip(QStringLiteral("%1: %2, %3 loaded, %4 hidden")
                            .arg(name, plural(total, QStringLiteral("submap")), countText(shown),
                                 countText(total - visible)));
  }
  if (role == HiddenRole) return total > 0 && visible == 0;
  return {};
}

QVariant SubmapTreeModel::leafData(const SubmapFacts& leaf, int column, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      if (column == NameColumn) return QStringLiteral("#%1 v%2").arg(leaf.id.index).arg(leaf.version);
      if (column == StatusColumn) return statusWord(leaf.status);
      return {};
    case Qt::CheckStateRole:
      if (column == NameColumn) return int(leaf.visible ? Qt::Checked : Qt::Unchecked);
      return {};
    case Qt::ToolTipRole: {
      if (column == LocateColumn) return QStringLiteral("Show this submap in the middle of the map");
      QStringList lines{QStringLiteral("Submap %1, version %2")
                            .arg(QString::fromStdString(map::toText(leaf.id)))
                            .arg(leaf.version)};
      if (leaf.shown_version >= 0 && leaf.shown_version != leaf.version) {
        lines << QStringLiteral("Version %1 is on screen.").arg(leaf.shown_version);
      }
      const QString reason = session_ ? session_->reason(leaf.id) : QString();
      lines << (reason.isEmpty() ? statusWord(leaf.status)
                                 : QStringLiteral("%1: %2").arg(statusWord(leaf.status), reason));
      return plainToolTip(lines.join(QLatin1Char('\n')));
    }
    case BadgesRole:
      return badges(leaf);
    case StatusRole:
      return int(leaf.status);
    case HiddenRole:
      return !leaf.visible;
    default:
      return {};
  }
}

QVariant SubmapTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case NameColumn:
      return QStringLiteral("Submap");
    case BadgeColumn:
      return QStringLiteral("Flags");
    case StatusColumn:
      return QStringLiteral("Status");
    default:
      return QString();
  }
}

Qt::ItemFlags SubmapTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() == NameColumn) flags |= Qt::ItemIsUserCheckable;
  if (index.internalId() > 1) flags |= Qt::ItemNeverHasChildren;
  return flags;
}

bool SubmapTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != NameColumn || !session_) return false;
  session_->setVisible(submapsBelow(index), value.toInt() == Qt::Checked);
  sync();  // the boxes follow at once, not with the next tick
  return true;
}

}  // namespace mapwright::window
