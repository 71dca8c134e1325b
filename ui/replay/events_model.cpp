#include "ui/replay/events_model.h"

#include <algorithm>
#include <utility>

#include <QFont>
#include <QGuiApplication>

#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/event_painting.h"
#include "ui/replay/timeline_axis.h"

namespace mapwright::window {

using replay::Event;

namespace {

// As with steps from event to event: the one just reached counts as past.
constexpr double kHairS = 1e-6;
constexpr int kMarkPx = 14;

std::string quotedField(const QString& text) {
  QString quoted = text;
  quoted.replace(QLatin1Char('"'), QStringLiteral("\"\""));
  return '"' + quoted.toStdString() + '"';
}

}  // namespace

bool EventsModel::passes(const Event& event) const {
  if (filter_.group && replay::groupOf(event.kind) != *filter_.group) return false;
  return filter_.text.isEmpty() || eventText(event).contains(filter_.text, Qt::CaseInsensitive) ||
         kindName(event.kind).contains(filter_.text, Qt::CaseInsensitive);
}

std::vector<std::uint32_t> EventsModel::passing(const std::vector<Event>& events) const {
  std::vector<std::uint32_t> rows;
  rows.reserve(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (passes(events[i])) rows.push_back(std::uint32_t(i));
  }
  return rows;
}

void EventsModel::setEvents(std::vector<Event> events, double start_s) {
  const bool moved = std::exchange(start_s_, start_s) != start_s;
  if (events != events_) take(std::move(events));
  if (moved && !rows_.empty())
    Q_EMIT dataChanged(index(0, SinceColumn), index(int(rows_.size()) - 1, SinceColumn));
  takePresent();
}

void EventsModel::setFilter(const EventFilter& filter) {
  if (filter == filter_) return;
  filter_ = filter;
  take(events_);
  takePresent();
}

void EventsModel::take(std::vector<Event> events) {
  std::vector<std::uint32_t> rows = passing(events);
  const std::size_t least = std::min(rows.size(), rows_.size());
  std::size_t same = 0, same_after = 0;
  while (same < least && events[rows[same]] == events_[rows_[same]]) ++same;
  while (same_after < least - same &&
         events[rows[rows.size() - 1 - same_after]] == events_[rows_[rows_.size() - 1 - same_after]])
    ++same_after;
  present_ = -1;  // takePresent() tells anew
  if (const std::size_t gone = rows_.size() - same - same_after; gone > 0) {
    beginRemoveRows({}, int(same), int(same + gone) - 1);
    rows_.erase(rows_.begin() + std::ptrdiff_t(same), rows_.begin() + std::ptrdiff_t(same + gone));
    endRemoveRows();
  }
  const std::size_t come = rows.size() - same - same_after;
  if (come > 0) beginInsertRows({}, int(same), int(same + come) - 1);
  events_ = std::move(events);
  rows_ = std::move(rows);
  if (come > 0) endInsertRows();
}

void EventsModel::setAt(std::optional<double> at_s) {
  at_s_ = at_s;
  takePresent();
}

void EventsModel::takePresent() {
  int now = -1;
  if (at_s_) {
    const auto after = std::partition_point(rows_.begin(), rows_.end(), [&](std::uint32_t place) {
      return events_[place].at_s <= *at_s_ + kHairS;
    });
    now = int(after - rows_.begin()) - 1;
  }
  const int before = std::exchange(present_, now);
  if (before == now) return;
  for (const int row : {before, now}) {
    if (row >= 0 && row < int(rows_.size())) Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
  }
}

const Event* EventsModel::event(int row) const {
  return row >= 0 && row < int(rows_.size()) ? &events_[at(row)] : nullptr;
}

int EventsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}

QString EventsModel::text(const Event& event, int column) const {
  switch (column) {
    case TimeColumn:
      return clockText(event.at_s);
    case SinceColumn:
      return elapsedText(event.at_s - start_s_);
    case KindColumn:
      return kindName(event.kind);
    default:
      return eventText(event);
  }
}

QVariant EventsModel::data(const QModelIndex& index, int role) const {
  const Event* const event = index.isValid() ? this->event(index.row()) : nullptr;
  if (!event) return {};
  const bool present = index.row() == present_;
  switch (role) {
    case Qt::DisplayRole:
      return text(*event, index.column());
    case Qt::ToolTipRole:
      return plainToolTip(
          QStringLiteral("%1 %2\n%3").arg(dayText(event->at_s), clockText(event->at_s), eventText(*event)));
    case Qt::TextAlignmentRole:
      return int((index.column() == SinceColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::DecorationRole:
      if (index.column() != KindColumn) return {};
      return eventMarkPixmap(markOf(*event), kMarkPx, qApp->devicePixelRatio());
    case Qt::FontRole: {
      if (!present) return {};
      QFont font = QGuiApplication::font();
      font.setBold(true);
      return font;
    }
    case Qt::BackgroundRole: {
      if (!present) return {};
      QColor color = appColors().accent;
      color.setAlpha(48);
      return color;
    }
    default:
      return {};
  }
}

QVariant EventsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == SinceColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case TimeColumn:
      return tr("Time (UTC)");
    case SinceColumn:
      return tr("Since start");
    case KindColumn:
      return tr("Kind");
    default:
      return tr("Event");
  }
}

QString EventsModel::copied(const QModelIndexList& rows) const {
  std::vector<int> places;
  for (const QModelIndex& index : rows) places.push_back(index.row());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  QString lines;
  for (const int row : places) {
    const Event* const event = this->event(row);
    if (!event) continue;
    lines += QStringLiteral("%1 %2").arg(dayText(event->at_s), text(*event, TimeColumn));
    for (const int column : {SinceColumn, KindColumn, TextColumn})
      lines += QLatin1Char('\t') + text(*event, column);
    lines += QLatin1Char('\n');
  }
  return lines;
}

std::string EventsModel::csv() const {
  std::string csv = "stamp_s,time_utc,since_start_s,kind,event\r\n";
  for (const std::uint32_t place : rows_) {
    const Event& event = events_[place];
    csv += QByteArray::number(event.at_s, 'f', 6).toStdString() + ',' + dayText(event.at_s).toStdString() +
           'T' + clockText(event.at_s).toStdString() + "Z," +
           QByteArray::number(event.at_s - start_s_, 'f', 3).toStdString() + ',' +
           quotedField(kindName(event.kind)) + ',' + quotedField(eventText(event)) + "\r\n";
  }
  return csv;
}

}  // namespace mapwright::window

#include "moc_events_model.cpp"
