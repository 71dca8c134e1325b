#include "ui/waypoints/review_model.h"

#include <algorithm>

#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr int kReviewMarkPx = 14;
constexpr qsizetype kLongestTip = 2'000;

QPixmap pixmapOf(Mark mark) {
  QPixmap pixmap(kReviewMarkPx, kReviewMarkPx);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintMark(&painter, QRectF(2, 2, kReviewMarkPx - 4, kReviewMarkPx - 4), mark, appColors());
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

ReviewModel::Outcome ReviewModel::outcome(int row) const {
  if (!follows_) return {};
  const auto& sent = list_->submission().rows()[std::size_t(row)];
  if (sent.state == State::Waiting) return {Mark::Neutral, tr("waiting")};
  if (sent.state == State::UnderWay) return {Mark::Busy, tr("in progress…")};
  const exchange::SentOutcome outcome = outcomeOf(*list_, sent);
  switch (outcome.state) {
    case exchange::SentState::Applied:
      return {Mark::Good, sent.state == State::Done ? tr("done") : tr("done, answer lost")};
    case exchange::SentState::NotSent:
      return {Mark::Neutral, tr("not sent")};
    case exchange::SentState::Unknown:
    case exchange::SentState::Failed:
      break;
  }
  // The state first: the column is narrow, and its tooltip has the whole sentence.
  const bool failed = outcome.state == exchange::SentState::Failed;
  const QString sentence = words::plainLine(exchange::sentenceOf(outcome));
  const QString why = outcome.failure ? whyText(*outcome.failure) : sentence;
  return {failed ? Mark::Bad : Mark::Warning, failed ? tr("failed. %1").arg(why) : tr("unknown. %1").arg(why),
          sentence};
}

exchange::SentCounts ReviewModel::counts() const {
  return follows_ && list_ ? countsOf(*list_) : exchange::SentCounts{.not_sent = std::size_t(rowCount())};
}

std::vector<robot::WaypointRequest> ReviewModel::rest() const {
  std::vector<robot::WaypointRequest> rest;
  if (!follows_ || !list_) return rest;
  for (const auto& sent : list_->submission().rows()) {
    if (outcomeOf(*list_, sent).state != exchange::SentState::Applied) rest.push_back(sent.request);
  }
  return rest;
}

int ReviewModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() || !list_) return 0;
  // When a submission starts, its rows change before it emits the signal.
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
      if (text.isEmpty()) text = tr("save the list");
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
    default: {
      const Outcome outcome = this->outcome(index.row());
      text = tip && !outcome.sentence.isEmpty() ? outcome.sentence : outcome.text;
    }
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

#include "moc_review_model.cpp"
