#include "edit/open_waypoints.h"

#include <algorithm>

#include "edit/faults.h"

namespace mapwright::edit {
namespace {

constexpr int kMostOvertaken = 3;

}  // namespace

OpenWaypoints::OpenWaypoints(robot::WaypointStore& store, map::MapKey map, const QString& address,
                             const EditOptions& options, QObject* parent)
    : EditSession(parent),
      store_(&store),
      map_(std::move(map)),
      keeps_(store.keeps()),
      submission_(store, map_, listener()) {
  document_.setRemoval(keeps_.removal);
  document_.setFit([this](map::Waypoint& point, const map::Waypoint* kept) { fit(point, keeps_, kept); });
  openDrafts(address, options);
  connect(&submission_, &WaypointSubmission::changed, this, &OpenWaypoints::onSubmissionChanged);
  connect(&store, &robot::WaypointStore::changed, this, &OpenWaypoints::read);
  connect(&store, &robot::WaypointStore::named, this, &OpenWaypoints::onNamed);
  read();
}

OpenWaypoints::~OpenWaypoints() {
  submission_.disconnect(this);
  submission_.abandon();
  closeDrafts();
}

void OpenWaypoints::onSubmissionChanged() {
  const auto& failure = submission_.failure();
  if (submission_.phase() == SubmissionPhase::Stopped) read_since_ = false;
  const bool overtaken = submission_.phase() == SubmissionPhase::Stopped && failure &&
                         failure->kind == map::FailureKind::Conflict;
  if (overtaken && ++conflicts_met_ <= kMostOvertaken) {
    // Someone else was faster, and nothing was applied: check again, the changes may still be compatible.
    QMetaObject::invokeMethod(this, &OpenWaypoints::startSaving, Qt::QueuedConnection);
  } else if (!saving()) {
    conflicts_met_ = 0;
  }
  Q_EMIT changed();
  if (submission_.phase() == SubmissionPhase::Done && refused().empty()) Q_EMIT saved();
  // Cancelled between two requests: the results of the earlier ones are still unknown.
  if (submission_.phase() == SubmissionPhase::Stopped && failure &&
      failure->kind == map::FailureKind::Cancelled && options_.look_after_failure && !looked_)
    read();
  if (!saving() && std::exchange(read_again_, false)) read();
}

void OpenWaypoints::read() {
  if (!store_) return;
  // Data read while changes are in progress may be older or newer than them.
  if (saving() || reading_) {
    read_again_ = true;
    return;
  }
  reading_ = true;
  store_->read(map_, [self = QPointer<OpenWaypoints>(this)](robot::Outcome<robot::StoredWaypoints> stored) {
    if (!self) return;
    self->reading_ = false;
    if (std::exchange(self->read_overtaken_, false)) {
      self->read_again_ = true;
    } else if (stored && !self->saving()) {
      self->read_since_ = true;
      self->onStored(*stored);
    } else if (!stored) {
      self->failure_ = stored.error();
      if (!self->has_read_) self->phase_ = Phase::Failed;
    }
    Q_EMIT self->changed();
    if (!self->saving() && std::exchange(self->read_again_, false)) self->read();
  });
}

void OpenWaypoints::onNamed(const QString& ours, const QString& theirs) {
  document_.nameTheirs(document_.ourName(ours.toStdString()), theirs.toStdString());
}

void OpenWaypoints::onStored(const robot::StoredWaypoints& stored) {
  failure_.reset();
  phase_ = Phase::Ready;
  notes_ = stored.notes;
  zero_turns_ = stored.zero_turns;
  revision_ = stored.revision;
  if (store_) keeps_.pixel_m = store_->keeps().pixel_m;
  looked_ = true;
  if (std::exchange(has_read_, true)) {
    const bool gone = !stored.there && !document_.kept().empty();
    if (!gone) return document_.mergeStored(itemsOf(stored.points));
    document_.onGone();
    Q_EMIT remarked(faultText("edit",
                              "The saved waypoint draft has disappeared. The waypoints are still open here: "
                              "saving writes them again."));
  } else {
    document_.reset(itemsOf(stored.points));
    if (drafts()) drafts()->look();
  }
}

std::set<Key> OpenWaypoints::zeroTurns() const {
  std::set<Key> keys;
  for (const std::string& id : zero_turns_) keys.insert(document_.ourName(id));
  return keys;
}

void OpenWaypoints::save(AtFailure at_failure) {
  if (saving()) return;
  reviewed_.reset();
  options_ = {at_failure, false};
  startSaving();
}

void OpenWaypoints::send(const std::vector<PlannedRequest>& reviewed, AtFailure at_failure) {
  if (saving()) return;
  reviewed_.emplace();
  for (const PlannedRequest& one : reviewed) reviewed_->push_back(one.call);
  options_ = {at_failure, true};
  startSaving();
}

void OpenWaypoints::startSaving() {
  if (!store_ || phase_ != Phase::Ready) return;
  read_overtaken_ = reading_;
  submission_.start(options_);
}

std::vector<PlannedRequest> OpenWaypoints::planned() const {
  std::vector<PlannedRequest> planned;
  if (!store_ || phase_ != Phase::Ready) return planned;
  robot::StoredWaypoints now;
  now.revision = revision_;
  for (auto& [key, point] : document_.kept()) {
    now.points.push_back(point);
    now.points.back().id = document_.theirName(key);
  }
  for (robot::WaypointRequest& request : store_->plan(now, wireChanges())) {
    robot::WaypointCall call = store_->callOf(map_, request);
    planned.push_back({std::move(request), std::move(call)});
  }
  return planned;
}

robot::WaypointCall OpenWaypoints::callOf(const robot::WaypointRequest& request) const {
  return store_ ? store_->callOf(map_, request) : robot::WaypointCall{};
}

bool OpenWaypoints::areReviewed(const std::vector<robot::WaypointRequest>& requests) const {
  if (!reviewed_) return true;
  return std::equal(requests.begin(), requests.end(), reviewed_->begin(), reviewed_->end(),
                    [this](const robot::WaypointRequest& request, const robot::WaypointCall& reviewed) {
                      const robot::WaypointCall call = callOf(request);
                      return call.service == reviewed.service && call.arguments == reviewed.arguments;
                    });
}

std::optional<map::Failure> OpenWaypoints::stoppedBy() const {
  const auto& failure = submission_.failure();
  const bool overcome =
      failure && read_since_ && isOfTheLink(*failure) && failure->kind != map::FailureKind::Cancelled;
  const bool stands = submission_.phase() == SubmissionPhase::Stopped && failure && !overcome;
  return stands ? failure : std::nullopt;
}

void OpenWaypoints::robotGone() {
  submission_.abandon();
  if (store_) store_->disconnect(this);
  store_.clear();
}

WaypointSubmission::Listener OpenWaypoints::listener() {
  WaypointSubmission::Listener hears;
  hears.plan =
      [this](const robot::StoredWaypoints& stored) -> std::optional<std::vector<robot::WaypointRequest>> {
    onStored(stored);
    if (!document_.conflicts().empty()) return std::nullopt;
    auto requests = store_->plan(stored, wireChanges());
    return areReviewed(requests) ? std::optional(std::move(requests)) : std::nullopt;
  };
  hears.sending = [this](const robot::WaypointRequest& request) {
    looked_ = false;
    document_.markSent(ownChanges(request.changes));
  };
  hears.done = [this](const robot::WaypointRequest& request, const robot::WaypointReceipt& receipt) {
    for (const auto& [ours, theirs] : receipt.ids) document_.nameTheirs(document_.ourName(ours), theirs);
    document_.confirm(ownChanges(request.changes));
  };
  hears.failed = [this](const robot::WaypointRequest& request, const map::Failure& failure) {
    if (failure.applied == map::Applied::Yes) {
      document_.confirm(ownChanges(request.changes));
    } else {
      document_.endSending();
    }
  };
  hears.looked = [this](const robot::StoredWaypoints& stored) {
    onStored(stored);
    return !unsaved();
  };
  return hears;
}

std::set<Key> OpenWaypoints::refused() const {
  return keeps_.name_twice ? std::set<Key>() : refusedNames(document_.kept(), document_.changes(), keeps_);
}

std::vector<robot::WaypointChange> OpenWaypoints::wireChanges() const {
  const std::set<Key> refused = this->refused();
  std::vector<robot::WaypointChange> wire;
  for (const Change& change : document_.changes()) {
    if (!refused.contains(change.key))
      wire.push_back({document_.theirName(change.key), change.before, change.after});
  }
  return wire;
}

std::vector<Change> OpenWaypoints::ownChanges(const std::vector<robot::WaypointChange>& changes) const {
  std::vector<Change> own;
  for (const robot::WaypointChange& change : changes)
    own.push_back({document_.ourName(change.id), change.before, change.after});
  return own;
}

void OpenWaypoints::openDrafts(const QString& address, const EditOptions& options) {
  DocumentDrafts::Kind kind;
  kind.of = {address, QString::fromStdString(map::toText(map_)), QStringLiteral("waypoints")};
  kind.unsaved = [this] { return unsaved(); };
  kind.content = [this, of = kind.of, now = options.now]() -> DraftKeeper::Job {
    return [draft = WaypointDraft{of, now(), document_.allChanges()}] { return toBytes(draft); };
  };
  kind.read = [of = kind.of](const QByteArray& bytes) -> std::optional<Draft> {
    auto draft = waypointDraftFrom(bytes);
    if (!draft || !(draft->of == of)) return std::nullopt;
    return Draft{draft->made, qint64(draft->changes.size()), std::move(draft->changes)};
  };
  kind.removeSaved = [this](Draft& draft) {
    auto& changes = *std::any_cast<std::vector<Change>>(&draft.content);
    std::erase_if(changes, [&](const Change& change) {
      const map::Waypoint* const now = document_.find(change.key);
      return same(now ? std::optional(*now) : std::nullopt, change.after);
    });
    draft.changes = qint64(changes.size());
  };
  keepDrafts(options, std::move(kind));
  if (drafts()) connect(&document_, &WaypointDocument::changed, drafts(), &DocumentDrafts::touch);
}

void OpenWaypoints::restoreDraft(const QString& text) {
  if (!drafts()) return;
  drafts()->restore([&](const Draft& draft) {
    document_.rebase(std::any_cast<const std::vector<Change>&>(draft.content), text);
    return true;
  });
}

void OpenWaypoints::discard() {
  document_.reset(document_.kept());
  if (drafts()) drafts()->keep();
  read();
}

}  // namespace mapwright::edit

#include "moc_open_waypoints.cpp"
