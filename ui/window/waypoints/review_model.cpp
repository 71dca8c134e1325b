#include "window/waypoints/review_model.h"

#include <algorithm>

#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include "exchange/waypoint_steps.h"
#include "window/look/plain_label.h"
#include "window/look/ui_colors.h"
#include "window/status/state_mark.h"
#include "window/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr int kMarkPx = 14;
constexpr qsizetype kLongestTip = 2'000;

QPixmap pixmapOf(Mark mark) {
  QPixmap pixmap(kMarkPx, kMarkPx);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintMark(&painter, QRectF(2, 2, kMarkPx - 4, kMarkPx - 4), mark, appColors());
  return pixmap;
}

}  // namespace

void ReviewModel::showPlan(edit::OpenWaypoints* list, std::vector<edit::PlannedRequest> plan) {
  beginResetModel();
  list_ = list;
  plan_ = std::move(plan);
  follows_ = false;
  told_rows_ = int(plan_.size());
  endResetModel();
}

void ReviewModel::showSubmission(edit::OpenWaypoints* list) {
  if (!follows_ || list_ != list) {
    beginResetModel();
    list_ = list;
    follows_ = true;
    told_rows_ = int(list->submission().rows().size());
    endResetModel();
    connect(list, &edit::OpenWaypoints::changed, this, &ReviewModel::follow, Qt::UniqueConnection);
  }
  follow();
}

void ReviewModel::clear() {
  beginResetModel();
  if (list_) list_->disconnect(this);
  list_.clear();
  plan_.clear();
  follows_ = false;
  told_rows_ = 0;
  endResetModel();
}

void ReviewModel::follow() {
  if (!follows_ || !list_) return;
  const int rows = int(list_->submission().rows().size());
  if (rows != told_rows_) {
    beginResetModel();
    told_rows_ = rows;
    endResetModel();
  } else if (rows > 0) {
    Q_EMIT dataChanged(index(0, 0), index(rows - 1, kColumns - 1));
  }
}

const robot::WaypointRequest& ReviewModel::request(int row) const {
  return follows_ ? list_->submission().rows()[std::size_t(row)].request : plan_[std::size_t(row)].request;
}

robot::WaypointCall ReviewModel::call(int row) const {
  return follows_ ? list_->callOf(request(row)) : plan_[std::size_t(row)].call;
}

std::optional<bool> ReviewModel::arrived(const robot::WaypointRequest& request) const {
  if (!list_->looked()) return std::nullopt;
  const edit::WaypointDocument& document = list_->document();
  return std::all_of(request.changes.begin(), request.changes.end(), [&](const robot::WaypointChange& one) {
    const edit::Key key = document.ourName(one.id);
    const auto steps = exchange::stepsOf({{key, one.before, one.after}});
    return std::all_of(steps.begin(), steps.end(),
                       [&](const auto& step) { return exchange::isDone(step, document.findKept(key)); });
  });
}

ReviewModel::Outcome ReviewModel::outcome(int row) const {
  if (!follows_) return {};
  const auto& sent = list_->submission().rows()[std::size_t(row)];
  switch (sent.state) {
    case State::Waiting:
      return {Mark::Neutral, tr("waiting")};
    case State::UnderWay:
      return {Mark::Busy, tr("under way…")};
    case State::Done:
      return {Mark::Good, tr("done")};
    case State::NotSent:
      return {Mark::Neutral, tr("not sent")};
    case State::Failed:
      break;
  }
  const map::Failure& failure = *sent.failure;
  if (failure.applied == map::Applied::No) return {Mark::Bad, failureText(failure)};
  map::Failure plain = failure;  // whether it was applied is said here
  plain.applied = map::Applied::No;
  const QString why = failureText(plain);
  const auto there = failure.applied == map::Applied::Yes ? std::optional(true) : arrived(sent.request);
  if (!there) return {Mark::Warning, tr("%1 Whether it has arrived is not known yet.").arg(why)};
  return *there ? Outcome{Mark::Good, tr("%1 It has arrived all the same.").arg(why)}
                : Outcome{Mark::Bad, tr("%1 It has not arrived.").arg(why)};
}

ReviewModel::Counts ReviewModel::counts() const {
  Counts counts;
  for (int row = 0; row < rowCount(); ++row) {
    if (!follows_) {
      ++counts.not_sent;
      continue;
    }
    const auto& sent = list_->submission().rows()[std::size_t(row)];
    const bool maybe = sent.state == State::Failed && sent.failure->applied != map::Applied::No;
    if (sent.state == State::Done) {
      ++counts.done;
    } else if (maybe) {
      const auto there =
          sent.failure->applied == map::Applied::Yes ? std::optional(true) : arrived(sent.request);
      ++(there ? *there ? counts.done : counts.failed : counts.unknown);
    } else {
      ++(sent.state == State::Failed ? counts.failed : counts.not_sent);
    }
  }
  return counts;
}

std::vector<robot::WaypointRequest> ReviewModel::rest() const {
  std::vector<robot::WaypointRequest> rest;
  if (!follows_) return rest;
  for (const auto& sent : list_->submission().rows()) {
    if (sent.state == State::Done) continue;
    const bool maybe = sent.state == State::Failed && sent.failure->applied != map::Applied::No;
    if (maybe && arrived(sent.request).value_or(false)) continue;
    rest.push_back(sent.request);
  }
  return rest;
}

int ReviewModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() || !list_) return 0;
  // While a submission begins its rows change before it tells so.
  return follows_ ? std::min(told_rows_, int(list_->submission().rows().size())) : int(plan_.size());
}
int ReviewModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant ReviewModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const robot::WaypointRequest& asked = request(index.row());
  const int column = index.column();
  if (role == Qt::TextAlignmentRole)
    return int((column == NumberColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::DecorationRole && column == OutcomeColumn) {
    const Mark mark = outcome(index.row()).mark;
    return mark == Mark::None ? QVariant() : pixmapOf(mark);
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const bool tip = role == Qt::ToolTipRole;
  QString text;
  switch (column) {
    case NumberColumn:
      text = QLocale::c().toString(index.row() + 1);
      break;
    case CallColumn: {
      const robot::WaypointCall call = this->call(index.row());
      text = words::plainName(call.service);
      if (text.isEmpty()) text = tr("write the list");
      if (tip)
        text +=
            QLatin1Char('\n') + words::plainText(QString::fromStdString(call.arguments)).left(kLongestTip);
      break;
    }
    case WaypointColumn:
      if (asked.changes.size() == 1) {
        const auto& one = asked.changes.front();
        if (one.before || one.after) text = shortWaypointName(one.before ? *one.before : *one.after);
      } else {
        text = waypointsText(qsizetype(asked.changes.size()));
      }
      break;
    case ChangeColumn:
      if (asked.changes.size() == 1)
        text = changeText(asked.changes.front().before, asked.changes.front().after);
      break;
    default:
      text = outcome(index.row()).text;
  }
  return tip ? plainToolTip(text) : text;
}

QVariant ReviewModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case CallColumn:
      return tr("Call");
    case WaypointColumn:
      return tr("Waypoint");
    case ChangeColumn:
      return tr("What changes");
    case OutcomeColumn:
      return tr("Outcome");
    default:
      return QStringLiteral("#");
  }
}

}  // namespace mapwright::window
