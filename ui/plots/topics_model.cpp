#include "ui/plots/topics_model.h"

#include <algorithm>
#include <cmath>

#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {
constexpr qint64 kShortestSpanMs = 1'000;  // a single message just now does not mean a thousand per second
}  // namespace

void TopicLog::record(const robot::RawMessage& message, qint64 now_ms, Telling telling) {
  auto found = topics_.find(message.topic);
  if (found == topics_.end()) {
    if (topics_.size() >= std::size_t(kMaxTopics)) {
      ++dropped_;
      return;
    }
    found = topics_.emplace(message.topic, TopicTally{}).first;
    found->second.topic = message.topic;
  }
  TopicTally& tally = found->second;
  Arrivals& arrivals = arrivals_[message.topic];
  const bool counted = telling == Telling::Again && tally.count > 0 && tally.last == message.received;
  tally.binary = message.binary;
  if (!counted) ++tally.count;
  tally.last_bytes = message.bytes;
  tally.last = message.received;
  tally.cut = message.text.size() > kMaxText || message.text.size() >= robot::kMaxRawText;
  tally.text = tally.cut ? message.text.left(kMaxText) : message.text;
  if (tally.count == 1) arrivals.first_ms = now_ms;
  while (!arrivals.recent.empty() &&
         (arrivals.recent.size() >= kMaxRecent || arrivals.recent.front().first <= now_ms - kRateSpanMs)) {
    arrivals.recent.pop_front();
  }
  if (!counted) arrivals.recent.emplace_back(now_ms, message.bytes);
}

void TopicLog::setAskedFor(const QStringList& topics) {
  for (auto it = topics_.begin(); it != topics_.end();) {
    it->second.asked_for = topics.contains(it->first);
    // A row without any messages is removed.
    it = !it->second.asked_for && it->second.count == 0 ? topics_.erase(it) : std::next(it);
  }
  for (const QString& topic : topics) {
    TopicTally& tally = topics_[topic];
    tally.topic = topic;
    tally.asked_for = true;
  }
}

void TopicLog::clear() {
  QStringList asked;
  for (const auto& [topic, tally] : topics_) {
    if (tally.asked_for) asked << topic;
  }
  topics_.clear();
  arrivals_.clear();
  dropped_ = 0;
  setAskedFor(asked);
}

const TopicTally* TopicLog::find(const QString& topic) const {
  const auto found = topics_.find(topic);
  return found == topics_.end() ? nullptr : &found->second;
}

template <typename Sum>
double TopicLog::perSecond(const QString& topic, qint64 now_ms, Sum sum) const {
  const auto found = arrivals_.find(topic);
  if (found == arrivals_.end()) return 0;
  double total = 0;
  qint64 since = recorded_ ? rates_from_ms_ : found->second.first_ms;
  for (const auto& [when, bytes] : found->second.recent) {
    const bool within = when > now_ms - kRateSpanMs && (!recorded_ || (when > since && when <= now_ms));
    if (within) total += sum(bytes);
  }
  // There were so many that the oldest ones are no longer stored.
  if (found->second.recent.size() >= kMaxRecent) since = found->second.recent.front().first;
  const qint64 span = std::clamp(now_ms - since, kShortestSpanMs, kRateSpanMs);
  return total * 1000.0 / double(span);
}

bool TopicLog::ratesKnown(const QString& topic, qint64 now_ms) const {
  const auto found = arrivals_.find(topic);
  if (found == arrivals_.end() || found->second.recent.empty()) return false;
  return !recorded_ || now_ms - rates_from_ms_ >= kShortestSpanMs;
}

double TopicLog::messagesPerSecond(const QString& topic, qint64 now_ms) const {
  return perSecond(topic, now_ms, [](qint64) { return 1.0; });
}

double TopicLog::bytesPerSecond(const QString& topic, qint64 now_ms) const {
  return perSecond(topic, now_ms, [](qint64 bytes) { return double(bytes); });
}

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
      return row.topic.isEmpty() ? tr("(without a topic)") : plainWords(row.topic, 200);
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
  const QStringList names{tr("Topic"),   tr("Type"), tr("Count"), tr("Hz"),
                          tr("Bytes/s"), tr("Size"), tr("Last")};
  return role == Qt::DisplayRole ? names.value(section) : QVariant();
}

}  // namespace mapwright::ui

#include "moc_topics_model.cpp"
