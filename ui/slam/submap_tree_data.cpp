// SubmapTreeModel: the content of a row, and its check box.
#include "sentences/fault_sentence.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/slam/submap_tree_model.h"

namespace mapwright::window {

QString SubmapTreeModel::leafName(map::SubmapId id, std::int32_t version) {
  return QStringLiteral("#%1 v%2").arg(id.index).arg(version);
}
QString SubmapTreeModel::groupName(std::int32_t trajectory) { return tr("Trajectory %1").arg(trajectory); }
QString SubmapTreeModel::totalText(int shown, int total) {
  return total > 0 ? tr("%1 of %2").arg(countText(shown), countText(total)) : QString();
}

QString SubmapTreeModel::widestGroup() const {
  QString widest = groupName(0);
  for (const Branch& branch : branches_) {
    if (const QString name = groupName(branch.trajectory); name.size() > widest.size()) widest = name;
  }
  return widest;
}

QString SubmapTreeModel::widestTotal() const {
  // A group never shows more than it has, nor has more than all.
  return totalText(total_, total_);
}

QVariant SubmapTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (const auto leaf = facts(index)) return leafData(*leaf, index.column(), role);
  if (const auto number = trajectory(index)) {
    const Branch& branch = branches_[std::size_t(index.row())];
    return groupData(groupName(*number), branch.visible, branch.shown, int(branch.leaves.size()),
                     index.column(), role);
  }
  return groupData(tr("All"), visible_, shown_, total_, index.column(), role);
}

QVariant SubmapTreeModel::groupData(const QString& name, int visible, int shown, int total, int column,
                                    int role) const {
  switch (role) {
    case Qt::DisplayRole:
      if (column == NameColumn) return name;
      return column == StatusColumn && total > 0 ? QVariant(totalText(shown, total)) : QVariant();
    case Qt::CheckStateRole:
      if (column != NameColumn) return {};
      return int(visible == 0 ? Qt::Unchecked : visible == total ? Qt::Checked : Qt::PartiallyChecked);
    case Qt::ToolTipRole:
      return plainToolTip(tr("%1: %2, %3 shown, %4 hidden")
                              .arg(name, submapsText(total), countText(shown), countText(total - visible)));
    case TotalRole:
      return totalText(shown, total);
    case HiddenRole:
      return total > 0 && visible == 0;
    default:
      return {};
  }
}

QVariant SubmapTreeModel::leafData(const SubmapFacts& leaf, int column, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      if (column == NameColumn) return leafName(leaf.id, leaf.version);
      if (column == StatusColumn) return statusWord(leaf.status);
      return {};
    case Qt::CheckStateRole:
      if (column == NameColumn) return int(leaf.visible ? Qt::Checked : Qt::Unchecked);
      return {};
    case Qt::ToolTipRole: {
      if (column == LocateColumn) return tr("Centre the map on this submap");
      QStringList lines{
          tr("Submap %1, version %2").arg(QString::fromStdString(map::toText(leaf.id))).arg(leaf.version)};
      if (leaf.visible && leaf.shown_version >= 0 && leaf.shown_version != leaf.version) {
        lines << tr("Version %1 is on screen.").arg(leaf.shown_version);
      }
      const QString reason = session_ ? sentences::sentenceOf(session_->reason(leaf.id)) : QString();
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
      return tr("Submap");
    case BadgeColumn:
      return tr("Flags");
    case StatusColumn:
      return tr("Status");
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
  syncVisibility();  // the boxes follow at once, not with the next update
  return true;
}

}  // namespace mapwright::window
