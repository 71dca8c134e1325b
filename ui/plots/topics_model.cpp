#include "ui/plots/topics_model.h"

#include <algorithm>
#include <cmath>

#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::window {

void TopicsModel::sync(const TopicLog& log, qint64 now_ms) {
  std::vector<Row> fresh;
  fresh.reserve(log.topics().size());
  for (const auto& [topic, tally] : log.topics()) {
    fresh.push_back({topic, tally.binary, tally.asked_for, tally.count, log.ratesKnown(topic, now_ms),
                     log.messagesPerSecond(topic, now_ms), log.bytesPerSecond(topic, now_ms),
                     tally.last_bytes, tally.last});
  }
  const bool same = fresh.size() == rows_.size() &&
                    std::equal(fresh.begin(), fresh.end(), rows_.begin(),
                               [](const Row& a, const Row& b) { return a.topic == b.topic; });
  if (same) {
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      if (fresh[i] == rows_[i]) continue;
      rows_[i] = std::move(fresh[i]);
      Q_EMIT dataChanged(index(int(i), 0), index(int(i), Columns - 1));
    }
    return;
  }
  // Both are sorted by name: one walk, so that selection and scroll position are stable.
  std::size_t at = 0;
  for (Row& row : fresh) {
    while (at < rows_.size() && rows_[at].topic < row.topic) {
      beginRemoveRows({}, int(at), int(at));
      rows_.erase(rows_.begin() + std::ptrdiff_t(at));
      endRemoveRows();
    }
    if (at < rows_.size() && rows_[at].topic == row.topic) {
      rows_[at] = std::move(row);
      Q_EMIT dataChanged(index(int(at), 0), index(int(at), Columns - 1));
    } else {
      beginInsertRows({}, int(at), int(at));
      rows_.insert(rows_.begin() + std::ptrdiff_t(at), std::move(row));
      endInsertRows();
    }
    ++at;
  }
  if (at < rows_.size()) {
    beginRemoveRows({}, int(at), int(rows_.size()) - 1);
    rows_.resize(at);
    endRemoveRows();
  }
}

QString TopicsModel::topicAt(int row) const {
  return row >= 0 && row < int(rows_.size()) ? rows_[std::size_t(row)].topic : QString();
}

int TopicsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}
int TopicsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QString TopicsModel::text(const Row& row, int column) const {
  const bool any = row.count > 0;
  switch (column) {
    case TopicColumn:
      return row.topic.isEmpty() ? tr("(without a topic)") : words::plainName(row.topic.left(200));
    case TypeColumn:
      return !any ? tr("waiting") : row.binary ? tr("binary") : tr("text");
    case CountColumn:
      return countText(qint64(row.count));
    case RateColumn:
      return row.rate_known ? QString::number(row.rate, 'f', row.rate < 9.95 ? 1 : 0) : QString();
    case BytesRateColumn:
      return row.rate_known ? bytesText(qint64(std::lround(row.bytes_rate))) : QString();
    case SizeColumn:
      return any ? bytesText(row.size) : QString();
    case TimeColumn:
      return row.last.isValid() ? row.last.toString(QStringLiteral("HH:mm:ss")) : QString();
    default:
      return {};
  }
}

QVariant TopicsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= int(rows_.size())) return {};
  const Row& row = rows_[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case Qt::ToolTipRole:
      return index.column() == TopicColumn ? QVariant(plainToolTip(row.topic)) : QVariant();
    case Qt::ForegroundRole:
      return row.count == 0 ? QVariant(appColors().secondary_text) : QVariant();
    case Qt::TextAlignmentRole:
      return int((index.column() >= CountColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case kSortRole:
      switch (index.column()) {
        case CountColumn:
          return row.count;
        case RateColumn:
          return row.rate;
        case BytesRateColumn:
          return row.bytes_rate;
        case SizeColumn:
          return row.size;
        case TimeColumn:
          return row.last;
        default:
          return text(row, index.column());
      }
    default:
      return {};
  }
}

QVariant TopicsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section >= CountColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && (section == RateColumn || section == BytesRateColumn))
    return tr("Over the last 5 seconds");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case TopicColumn:
      return tr("Topic");
    case TypeColumn:
      return tr("Type");
    case CountColumn:
      return tr("Count");
    case RateColumn:
      return tr("Hz");
    case BytesRateColumn:
      return tr("Bytes/s");
    case SizeColumn:
      return tr("Size");
    case TimeColumn:
      return tr("Last");
    default:
      return {};
  }
}

}  // namespace mapwright::window

#include "moc_topics_model.cpp"
