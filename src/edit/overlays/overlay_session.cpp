#include "edit/overlays/overlay_session.h"

#include <utility>

#include <QPointer>

#include "edit/overlays/overlay_drafts.h"

namespace mapwright::edit {

using overlays::OverlayDocument;

OverlaySession::OverlaySession(StoreNow store, Target target, const QString& address, OverlayEditing& editing,
                               const EditOptions& options)
    : store_(std::move(store)),
      target_(std::move(target)),
      editing_(editing),
      share_(work::orOwn(options.workers)) {
  DocumentDrafts::Kind kind;
  kind.of = {address, QString::fromStdString(map::toText(target_.map) + target_.uid),
             QStringLiteral("overlays")};
  kind.unsaved = [this] { return unsaved(); };
  kind.content = [this, of = kind.of, now = options.now]() -> DraftKeeper::Job {
    return [of, draft = OverlayDraft{now(), editing_.document().draftBase(), editing_.document().mine()}] {
      return overlayDraftBytes(of, draft);
    };
  };
  kind.read = [](const QByteArray& bytes) -> std::optional<Draft> {
    auto draft = overlayDraftFrom(bytes);
    if (!draft) return std::nullopt;
    const auto changes = qint64(overlays::changesBetween(draft->base, draft->mine).size());
    return Draft{draft->made, changes, std::move(*draft)};
  };
  keepDrafts(options, std::move(kind));
  if (!drafts()) return;
  connect(&editing_, &OverlayEditing::changed, drafts(), &DocumentDrafts::touch);
  drafts()->look();
}

OverlaySession::~OverlaySession() {
  call_.cancel();
  editing_.disconnect(this);
  closeDrafts();
  editing_.close();
}

void OverlaySession::read() {
  robot::OverlayStore* const store = store_();
  if (!store || saving_) return;
  if (reading_) {
    read_again_ = true;
    return;
  }
  reading_ = true;
  failure_.reset();
  call_ = store->read(target_.map, [self = QPointer<OverlaySession>(this),
                                    saves = saves_](const robot::Outcome<robot::OverlayText>& now) {
    if (!self) return;
    self->reading_ = false;
    // What was asked before something was saved may be older than that, however late it is answered.
    const bool counts = self->saves_ == saves;
    if (now && counts) self->merge(*now, false);
    if (!self) return;
    if (!now && counts) self->failure_ = now.error();
    if (!now && !self->editing_.isOpen()) self->phase_ = Phase::Failed;
    Q_EMIT self->changed();
    if (self && std::exchange(self->read_again_, false)) self->read();
  });
  Q_EMIT changed();
}

void OverlaySession::merge(const robot::OverlayText& text, bool sent, const jobs::OverlaysHeld* read) {
  const QPointer<OverlaySession> here(this);
  held_ = text;
  Q_EMIT seen(text, sent);
  using Read = tl::expected<OverlayDocument, Fault>;
  const auto& base = editing_.document().base();
  auto held = editing_.isOpen() && base.text() == text.text ? Read(base)
              : read                                        ? Read(read->document)
                                                            : OverlayDocument::read(text.text);
  unreadable_ = held ? Fault() : held.error();
  failure_.reset();
  if (!held) {
    failure_ =
        map::Failure{.kind = map::FailureKind::MalformedAnswer, .subject = map::subjectOf(target_.map)};
    if (!editing_.isOpen()) phase_ = Phase::Failed;
    return;
  }
  phase_ = Phase::Ready;
  if (editing_.isOpen()) {
    rebase(*held, read);
  } else {
    editing_.open(std::move(*held));
    Q_EMIT opened();
  }
  Q_EMIT merged();
  if (here && std::exchange(doubt_, false)) Q_EMIT doubtSettled(!unsaved());
}

void OverlaySession::rebase(const OverlayDocument& held, const jobs::OverlaysHeld* read) {
  const auto& document = editing_.document();
  if (held.isSameText(document.base())) return;
  const std::size_t before = document.changedThere().size();
  // What was sent is there, or what was not known to be saved turns out to be.
  bool saved = false;
  if (document.unsaved()) {
    const OverlayDocument mine = document.mine();
    const bool compared = read && read->sent.isSameText(mine);
    saved = compared ? read->as_sent : jobs::otherwiseHeld(mine, held).empty();
  }
  editing_.rebase(held, saved);
  const std::size_t now = document.changedThere().size();
  if (now > before) Q_EMIT changedThere(qsizetype(now - before));
}

void OverlaySession::change(bool send, bool still_held) {
  robot::OverlayStore* const store = store_();
  if (!store || saving_) return;
  saving_ = true;
  ++saves_;
  editing_.setLocked(true);
  const QPointer<OverlaySession> self(this);
  Q_EMIT changed();
  if (!self) return;
  jobs::OverlayOrder order{target_.map, editing_.document().mine(), editing_.document().base(), send};
  if (still_held) order.held = held_;
  order.elsewhere = onAnotherThread();
  order.seen = [self](const robot::OverlayText& text, bool was_sent, const jobs::OverlaysHeld* read) {
    if (self) self->merge(text, was_sent, read);
  };
  call_ = jobs::changeOverlays(*store, std::move(order),
                               [self, send](const robot::Outcome<jobs::OverlayOutcome>& outcome) {
                                 if (!self) return;
                                 self->saving_ = false;
                                 // What was read again may hold it all, beside what others changed since.
                                 if (!outcome && outcome.error().applied != map::Applied::No)
                                   self->doubt_ = self->unsaved();
                                 self->editing_.setLocked(false);
                                 outcome ? self->ended(*outcome, send) : self->failed(outcome.error());
                                 if (self) Q_EMIT self->changed();
                               });
}

jobs::OverlayOrder::Elsewhere OverlaySession::onAnotherThread() {
  return [this](std::function<std::function<void()>()> work) {
    share_.startLong(
        [this, work = std::move(work)] { QMetaObject::invokeMethod(this, work(), Qt::QueuedConnection); });
  };
}

void OverlaySession::restoreDraft(const QString& text) {
  if (!drafts() || !editing_.editable()) return;
  drafts()->restore([&](const Draft& draft) {
    const auto& content = std::any_cast<const OverlayDraft&>(draft.content);
    editing_.restoreDraft(content.base, content.mine, text);
    return true;
  });
}

}  // namespace mapwright::edit

#include "moc_overlay_session.cpp"
