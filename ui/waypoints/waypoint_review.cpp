#include "ui/waypoints/waypoint_review.h"

#include <algorithm>
#include <array>

#include <QCheckBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "exchange/waypoint_plan.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::ui {
namespace {

constexpr qsizetype kLongestTip = 2'000;

constexpr int kReviewRowPx = 24;
constexpr qsizetype kNamed = 3;  // of those that differ

bool areCalls(const edit::OpenWaypoints& list, const std::vector<edit::PlannedRequest>& planned,
              const std::vector<robot::WaypointRequest>& shown) {
  return std::equal(planned.begin(), planned.end(), shown.begin(), shown.end(),
                    [&](const edit::PlannedRequest& one, const robot::WaypointRequest& other) {
                      const robot::WaypointCall call = list.callOf(other);
                      return one.call.service == call.service && one.call.arguments == call.arguments;
                    });
}

}  // namespace

void ReviewModel::showPlan(edit::OpenWaypoints* list, std::vector<edit::PlannedRequest> plan) {
  list_ = list;
  plan_ = std::move(plan);
  follows_ = false;
  onRefused();
  updateRows();
}

void ReviewModel::showSubmission(edit::OpenWaypoints* list) {
  if (!std::exchange(follows_, true) || list_ != list) {
    list_ = list;
    connect(list, &edit::OpenWaypoints::changed, this, &ReviewModel::follow, Qt::UniqueConnection);
  }
  follow();
}

void ReviewModel::clear() {
  if (list_) list_->disconnect(this);
  list_.clear();
  plan_.clear();
  refused_.clear();
  refused_since_.clear();
  follows_ = false;
  updateRows();
}

void ReviewModel::follow() {
  if (!follows_ || !list_) return;
  if (!list_->saving()) onRefused();
  updateRows();
}

void ReviewModel::onRefused() {
  refused_.clear();
  refused_since_.clear();
  const std::set<edit::Key> refused = list_->refused();
  std::set<edit::Key> shown;
  for (int row = 0; row < requests(); ++row) {
    if (changes(row).size() == 1) shown.insert(list_->document().ourName(changes(row).front().id));
  }
  for (const edit::Change& change :
       refused.empty() ? std::vector<edit::Change>() : list_->document().changes()) {
    if (!refused.contains(change.key)) continue;
    const QString why = tr("not sent: another waypoint is called %1").arg(shortWaypointName(*change.after));
    if (shown.contains(change.key)) {
      refused_since_.emplace(change.key, why);
    } else {
      refused_.push_back({{{change.key, change.before, change.after}}, why});
    }
  }
}

const QString* ReviewModel::refusedReason(int row) const {
  if (row >= requests()) return &refused_[std::size_t(row - requests())].why;
  if (changes(row).size() != 1) return nullptr;
  const auto found = refused_since_.find(list_->document().ourName(changes(row).front().id));
  return found == refused_since_.end() ? nullptr : &found->second;
}

/// As many as there are now. They come and go at the end, so that what is current or selected stays so.
void ReviewModel::updateRows() {
  const int rows = requests() + int(refused_.size());
  const int before = shown_rows_;
  if (rows > before) {
    beginInsertRows({}, before, rows - 1);
    shown_rows_ = rows;
    endInsertRows();
  } else if (rows < before) {
    beginRemoveRows({}, rows, before - 1);
    shown_rows_ = rows;
    endRemoveRows();
  }
  if (const int same = std::min(rows, before); same > 0)
    Q_EMIT dataChanged(index(0, 0), index(same - 1, kColumns - 1));
}

int ReviewModel::requests() const {
  if (!list_) return 0;
  return follows_ ? int(list_->submission().rows().size()) : int(plan_.size());
}

const robot::WaypointRequest& ReviewModel::request(int row) const {
  return follows_ ? list_->submission().rows()[std::size_t(row)].request : plan_[std::size_t(row)].request;
}

robot::WaypointCall ReviewModel::call(int row) const {
  return follows_ ? list_->callOf(request(row)) : plan_[std::size_t(row)].call;
}

const std::vector<robot::WaypointChange>& ReviewModel::changes(int row) const {
  return row < requests() ? request(row).changes : refused_[std::size_t(row - requests())].changes;
}

/// What is to be feared of it before it is sent.
ReviewModel::Outcome ReviewModel::plannedOutcome(int row) const {
  for (const robot::WaypointChange& one : changes(row)) {
    const QString why = one.after ? exchange::notKeptReason(one.before, *one.after)
                                  : exchange::notRemovedReason(list_->keeps());
    if (!one.after && !why.isEmpty()) return {Mark::Bad, tr("will be refused. %1").arg(why)};
    if (!why.isEmpty()) return {Mark::Warning, tr("may be refused. %1").arg(why)};
    if (!one.before && !list_->keeps().removal)
      return {Mark::Warning, tr("cannot be deleted later"), exchange::notRemovedReason(list_->keeps())};
  }
  return {};
}

ReviewModel::Outcome ReviewModel::outcome(int row) const {
  if (row >= requests()) return {Mark::Bad, *refusedReason(row)};
  if (!follows_) return plannedOutcome(row);
  const auto& sent = list_->submission().rows()[std::size_t(row)];
  if (sent.state == State::Waiting) return {Mark::Neutral, tr("waiting")};
  if (sent.state == State::InProgress) return {Mark::Busy, tr("in progress…")};
  const exchange::SentOutcome outcome = outcomeOf(*list_, sent);
  switch (outcome.state) {
    case exchange::SentState::Applied:
      return {Mark::Good, sent.state == State::Done ? tr("done") : tr("done, answer lost")};
    case exchange::SentState::NotSent:
      if (const QString* const why = refusedReason(row)) return {Mark::Bad, *why};
      if (!outcome.failure) return {Mark::Neutral, tr("not sent")};
      break;
    case exchange::SentState::Unknown:
    case exchange::SentState::Failed:
      break;
  }
  // The state first: the column is narrow, and its tooltip has the whole sentence.
  const QString sentence = words::plainLine(exchange::sentenceOf(outcome));
  const QString why = outcome.failure ? reasonText(*outcome.failure) : sentence;
  if (outcome.state == exchange::SentState::Failed) return {Mark::Bad, tr("failed. %1").arg(why), sentence};
  const bool unknown = outcome.state == exchange::SentState::Unknown;
  return {Mark::Warning, (unknown ? tr("unknown. %1") : tr("not sent. %1")).arg(why), sentence};
}

exchange::SentCounts ReviewModel::counts() const {
  return follows_ && list_ ? countsOf(*list_) : exchange::SentCounts{.not_sent = std::size_t(requests())};
}

std::vector<robot::WaypointRequest> ReviewModel::rest() const {
  std::vector<robot::WaypointRequest> rest;
  if (!follows_ || !list_) return rest;
  for (const auto& sent : list_->submission().rows()) {
    if (outcomeOf(*list_, sent).state != exchange::SentState::Applied) rest.push_back(sent.request);
  }
  return rest;
}

int ReviewModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : shown_rows_; }
int ReviewModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant ReviewModel::data(const QModelIndex& index, int role) const {
  // When a submission starts, its rows change before it emits the signal.
  const int row = index.row(), column = index.column();
  if (!index.isValid() || row >= std::min(shown_rows_, requests() + int(refused_.size()))) return {};
  if (role == Qt::TextAlignmentRole)
    return int((column == NumberColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ForegroundRole && row >= requests() && column != OutcomeColumn)
    return appColors().secondary_text;
  if (role == Qt::DecorationRole && column == OutcomeColumn) {
    const Mark mark = outcome(row).mark;
    return mark == Mark::None ? QVariant() : markPixmap(mark);
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const bool tip = role == Qt::ToolTipRole;
  const std::vector<robot::WaypointChange>& changes = this->changes(row);
  QString text;
  switch (column) {
    case NumberColumn:
      if (row < requests()) text = QLocale::c().toString(row + 1);
      break;
    case DeedColumn:
      text = changes.size() == 1 ? deedText(changes.front().before, changes.front().after)
                                 : tr("Save %1").arg(waypointsText(qsizetype(changes.size())));
      break;
    case CallColumn: {
      if (row >= requests()) break;
      const robot::WaypointCall call = this->call(row);
      text = words::plainName(call.service);
      if (text.isEmpty()) text = tr("save the list");
      if (tip)
        text += QLatin1Char('\n') +
                words::shortened(words::plainText(QString::fromStdString(call.arguments)), kLongestTip);
      break;
    }
    case ChangeColumn:
      if (changes.size() == 1) text = changeText(changes.front().before, changes.front().after);
      break;
    default: {
      const Outcome outcome = this->outcome(row);
      text = tip && !outcome.sentence.isEmpty() ? outcome.sentence : outcome.text;
    }
  }
  return tip ? plainToolTip(text) : text;
}

QVariant ReviewModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const std::array<QString, kColumns> names{QStringLiteral("#"), tr("What"), tr("Call"), tr("Values"),
                                            tr("Outcome")};
  return section < kColumns ? names[std::size_t(section)] : QVariant();
}

WaypointReview::WaypointReview(QWidget* parent)
    : QDialog(parent),
      model_(new ReviewModel(this)),
      heading_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      compared_(wrappedLabel({}, this)),
      table_(new QuietTableView(this)),
      go_on_(new QCheckBox(tr("Continue if one fails"), this)),
      progress_(new QProgressBar(this)),
      send_(new QPushButton(tr("&Send"), this)),
      cancel_(new QPushButton(tr("&Cancel"), this)),
      close_(new QPushButton(tr("C&lose"), this)) {
  setObjectName(QStringLiteral("waypointReview"));
  setWindowTitle(tr("Review and send"));
  resize(960, 420);
  showRows(*table_, model_, tr("The requests in their order"), kReviewRowPx);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  // In average letter widths: room for the longest of our own texts and usual names.
  const auto wide = [&](int letters) { return letters * fontMetrics().averageCharWidth() + 20; };
  header->resizeSection(ReviewModel::NumberColumn, wide(4));
  header->resizeSection(ReviewModel::CallColumn, wide(20));
  header->resizeSection(ReviewModel::OutcomeColumn, wide(30));
  header->resizeSection(ReviewModel::ChangeColumn, wide(36));
  new NameColumn(table_, header, ReviewModel::DeedColumn,
                 {{ReviewModel::NumberColumn},
                  {ReviewModel::OutcomeColumn, wide(6)},
                  {ReviewModel::CallColumn, wide(8)},
                  {ReviewModel::ChangeColumn, wide(12)}});
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  // Enter sends, wherever the focus is, and does nothing else.
  send_->setDefault(true);
  for (QPushButton* button : {cancel_, close_}) button->setAutoDefault(false);

  setLayout(columnOf({heading_,
                      {table_, 1},
                      progress_,
                      status_,
                      compared_,
                      rowOf({go_on_, LayoutItem::rest(), cancel_, close_, send_})}));

  connect(send_, &QPushButton::clicked, this, &WaypointReview::send);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (list_) list_->cancelSaving();
  });
  connect(close_, &QPushButton::clicked, this, &WaypointReview::close);
}

bool WaypointReview::isWorthIt(const edit::OpenWaypoints& list) {
  // The first one is representative: either all of them are calls, or none.
  const auto changes = list.document().changes();
  if (changes.empty()) return false;
  const auto& one = changes.front();
  robot::WaypointRequest request;
  request.changes.push_back({list.document().theirName(one.key), one.before, one.after});
  return !list.callOf(request).service.empty();
}

void WaypointReview::review(edit::OpenWaypoints* list, const QString& map) {
  if (list_ != list) {
    forget();
    list_ = list;
    connect(list, &edit::OpenWaypoints::changed, this, &WaypointReview::refresh);
    // Further edits update the plan; at most once per turn of the event loop.
    connect(&list->document(), &edit::WaypointDocument::changed, this, [this] {
      if (isHidden() || !list_ || list_->saving() || !model_->showsPlan() || std::exchange(waiting_, true))
        return;
      QTimer::singleShot(0, this, [this] {
        waiting_ = false;
        if (list_ && !list_->saving() && model_->showsPlan()) onPlan();
      });
    });
  }
  map_ = map;
  if (!list_->saving()) {
    sent_ = overtaken_ = unreached_ = false;
    wanted_.clear();
    onPlan();
  }
  show();
  raise();
  activateWindow();
  (send_->isVisible() && send_->isEnabled() ? static_cast<QWidget*>(send_) : table_)->setFocus();
}

void WaypointReview::forget() {
  if (list_) {
    list_->disconnect(this);
    list_->document().disconnect(this);
  }
  list_.clear();
  model_->clear();
  wanted_.clear();
  sent_ = overtaken_ = unreached_ = false;
  hide();
}

void WaypointReview::setLinkTrouble(const QString& why) {
  if (std::exchange(link_trouble_, why) != why) refresh();
}

void WaypointReview::onPlan() {
  sent_ = false;  // none of this has been sent
  model_->showPlan(list_, list_->planned());
  refresh();
}

void WaypointReview::send() {
  if (!list_ || list_->saving() || !link_trouble_.isEmpty()) return;
  std::vector<edit::PlannedRequest> planned = list_->planned();
  // Sends exactly what is shown, nothing else.
  if (!model_->showsPlan() && !areCalls(*list_, planned, model_->rest())) {
    overtaken_ = true;
    return onPlan();
  }
  overtaken_ = unreached_ = false;
  const std::set<edit::Key> refused = list_->refused();
  for (const edit::Change& change : list_->document().changes()) {
    if (!refused.contains(change.key)) wanted_.insert_or_assign(change.key, change);
  }
  sent_ = true;
  list_->send(model_->showsPlan() ? model_->plan() : planned,
              go_on_->isChecked() ? edit::AtFailure::GoOn : edit::AtFailure::Stop);
}

void WaypointReview::refresh() {
  if (!list_) return;
  using edit::SubmissionPhase;
  const SubmissionPhase phase = list_->submission().phase();
  if (sent_ && phase == SubmissionPhase::Undecided) {
    // Nothing was sent: others have changed something.
    overtaken_ = true;
    return onPlan();
  }
  const bool before_the_first = phase != SubmissionPhase::Looking && phase != SubmissionPhase::Done &&
                                list_->submission().rows().empty();
  if (sent_ && !list_->saving() && before_the_first) {
    // The stored state could not be read: the shown plan is still valid.
    unreached_ = true;
    return onPlan();
  }
  if (sent_ && phase != SubmissionPhase::Looking) model_->showSubmission(list_);
  const bool saving = list_->saving();
  const int rows = model_->requests();
  heading_->setText(
      tr("Waypoints of %1: %2 in this order.")
          .arg(map_, sentences::counted(tr("%1 requests", nullptr, sentences::formOf(rows)), rows)));
  QStringList lines{statusText(), list_->saving() ? QString() : refusedText(),
                    list_->saving() || !list_->unsaved() ? QString() : link_trouble_};
  if (model_->showsPlan()) lines << madeUpText();
  lines.removeAll(QString());
  status_->setText(lines.join(QLatin1Char('\n')));
  status_->setVisible(!status_->text().isEmpty());
  compared_->setText(comparedText());
  compared_->setVisible(!compared_->text().isEmpty());
  progress_->setVisible(saving);
  progress_->setRange(0, saving && phase == SubmissionPhase::Sending ? rows : 0);
  progress_->setValue(int(list_->submission().done()));
  const bool all_done = sent_ && phase == SubmissionPhase::Done;
  send_->setText(saving ? tr("Sending…") : sent_ && !all_done ? tr("&Send the rest") : tr("&Send"));
  // It stays where it is while it works, and presses nothing then.
  const bool may_send =
      saving || (list_->maySave() && link_trouble_.isEmpty() && (model_->showsPlan() ? rows > 0 : !all_done));
  // Hiding or disabling a button would move the focus to the next one, and Space would press that.
  if ((saving ? close_ : cancel_)->hasFocus() || (!may_send && send_->hasFocus())) table_->setFocus();
  send_->setEnabled(may_send);
  send_->setToolTip(plainToolTip(saving ? QString() : link_trouble_));
  cancel_->setVisible(saving);
  close_->setVisible(!saving);
  go_on_->setEnabled(!saving);
}

QString WaypointReview::statusText() const {
  using edit::SubmissionPhase;
  const auto figure = [](std::size_t count) { return countText(qint64(count)); };
  if (!list_->document().conflicts().empty() && !list_->saving())
    return tr("%1 changed here and elsewhere. Choose which version to keep in the Waypoints panel: nothing "
              "is sent before that.")
        .arg(waypointsText(qsizetype(list_->document().conflicts().size())));
  if (!sent_) {
    if (const auto why = list_->stoppedBy(); unreached_ && why)
      return reasonText(*why) + QLatin1Char(' ') + tr("Nothing was sent.");
    if (overtaken_)
      return tr(
          "Nothing was sent: the list has changed in the meantime. These are the requests that are needed "
          "now. Review them and send them.");
    if (model_->requests() > 0) return tr("Nothing has been sent yet.");
    return list_->unsaved() ? QString() : tr("There is nothing to send.");
  }
  const exchange::SentCounts counts = model_->counts();
  const auto& submission = list_->submission();
  switch (submission.phase()) {
    case SubmissionPhase::Looking:
      return tr("Checking the waypoints on the robot…");
    case SubmissionPhase::Sending:
      return tr("Sending: %1 of %2 done.")
          .arg(figure(counts.applied), figure(std::size_t(model_->requests())));
    case SubmissionPhase::LookingAgain:
      return tr("Everything was sent. Checking the result…");
    case SubmissionPhase::Done:
      return tr("All requests that were sent succeeded.");
    default:
      break;
  }
  QString text = tr("Of %1 requests: %2 succeeded, %3 failed, %4 with unknown result, %5 not sent.")
                     .arg(figure(std::size_t(model_->requests())), figure(counts.applied),
                          figure(counts.failed), figure(counts.unknown), figure(counts.not_sent));
  // Only the reason: the result of each is shown in its row.
  const auto why = list_->stoppedBy();
  return why ? words::paragraph({reasonText(*why), text}) : text;
}

QString WaypointReview::refusedText() const {
  return exchange::refusedText(list_->refused(), list_->document().changes());
}

QString WaypointReview::madeUpText() const {
  if (list_->keeps().no_heading) return {};
  const auto& plan = model_->plan();
  const bool any = std::any_of(plan.begin(), plan.end(), [](const edit::PlannedRequest& one) {
    return std::any_of(one.request.changes.begin(), one.request.changes.end(), [](const auto& change) {
      return !change.before && change.after && change.after->yaw_rad == 0.0;
    });
  });
  return any ? tr("Every waypoint has a heading on this robot: new ones get 0° until you turn them.")
             : QString();
}

void WaypointReview::keyPressEvent(QKeyEvent* event) {
  // Holding the key down only sends once.
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enter || !event->isAutoRepeat()) QDialog::keyPressEvent(event);
}

QString WaypointReview::comparedText() const {
  if (!sent_ || list_->saving() || wanted_.empty()) return {};
  if (!list_->looked())
    return tr(
        "Not compared with the robot's waypoints yet: they could not be read. This happens as soon as "
        "the connection is back.");
  QStringList names;
  std::size_t differ = 0;
  const edit::WaypointDocument& document = list_->document();
  for (const auto& [key, change] : wanted_) {
    const auto steps = exchange::stepsOf({change});
    const bool as_wanted = std::all_of(steps.begin(), steps.end(), [&](const auto& step) {
      return exchange::isDone(step, document.findKept(key), list_->keeps().pixel_m);
    });
    if (as_wanted) continue;
    ++differ;
    if (names.size() < kNamed) names << shortWaypointName(change.before ? *change.before : *change.after);
  }
  const QLocale c = QLocale::c();
  const QString as_wanted = c.toString(qulonglong(wanted_.size() - differ));
  if (differ == 0) return tr("Compared with the robot's waypoints: all %1 as intended.").arg(as_wanted);
  if (qsizetype(differ) > names.size()) names << QStringLiteral("…");
  return tr("Compared with the robot's waypoints: %1 as intended, %2 differ: %3.")
      .arg(as_wanted, c.toString(qulonglong(differ)), words::listed(names));
}

void WaypointReview::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  if (!event->spontaneous() && list_ && !list_->saving() && list_->unsaved()) Q_EMIT givenUp();
}

QString WaypointReview::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString WaypointReview::comparedShown() const {
  return compared_->isHidden() ? QString() : compared_->text();
}

}  // namespace mapwright::ui

#include "moc_waypoint_review.cpp"
