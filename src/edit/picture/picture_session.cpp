#include "edit/picture/picture_session.h"

#include <utility>

#include <QPointer>

#include "edit/picture/picture_copies.h"
#include "edit/picture/picture_drafts.h"

namespace mapwright::edit {

PictureSession::PictureSession(StoreNow store, map::MapKey map, QString address, Picture picture,
                               PictureEditing& editing, EditOptions options)
    : store_(std::move(store)),
      map_(std::move(map)),
      address_(std::move(address)),
      editing_(editing),
      options_(std::move(options)),
      share_(work::orOwn(options_.workers)) {
  connect(&editing_, &PictureEditing::mergeDone, this, &PictureSession::onMerged);
  open(std::move(picture));
}

PictureSession::~PictureSession() {
  editing_.disconnect(this);
  editing_.endStroke();  // it is kept with the rest
  closeDrafts();
  editing_.close();
}

void PictureSession::open(Picture picture) {
  closeDrafts();
  ++opened_;
  phase_ = Phase::Ready;
  seen_ = picture.cells;
  revision_ = std::move(picture.revision);
  past_revisions_.clear();
  editing_.open(seen_, picture.reference, picture.holds_unknown);
  DocumentDrafts::Kind kind;
  kind.of = {address_, QString::fromStdString(map::toText(map_)), QStringLiteral("picture")};
  kind.unsaved = [this] { return editing_.isOpen() && unsaved(); };
  kind.content = [this, of = kind.of]() -> DraftKeeper::Job {
    return [of, made = options_.now(), now = editing_.snapshot(), saved = editing_.saved()] {
      return pictureDraftBytes(of, made, *now, *saved);
    };
  };
  kind.read = [grid = editing_.snapshot()](const QByteArray& bytes) -> std::optional<Draft> {
    auto draft = pictureDraftFrom(bytes);
    const auto fits = draft ? fitDraft(*draft, *grid) : std::nullopt;
    if (!fits) return std::nullopt;
    const QDateTime made = draft->made;
    return Draft{made, fits->cells, std::move(*draft)};
  };
  keepDrafts(options_, std::move(kind));
  if (!drafts()) return;
  connect(&editing_, &PictureEditing::stateChanged, drafts(), &DocumentDrafts::touch);
  drafts()->look();
}

void PictureSession::restoreDraft(const QString& text) {
  if (!drafts()) return;
  drafts()->restore([&](const Draft& draft) {
    auto fits = fitDraft(std::any_cast<const PictureDraft&>(draft.content), *editing_.grid());
    if (!fits) return false;
    editing_.applyPatch(std::move(fits->patch), text);
    Q_EMIT restored(fits->elsewhere);
    return true;
  });
}

void PictureSession::onRead(Picture picture) {
  if (picture.cells == seen_ || saving_) return;
  seen_ = picture.cells;
  const bool fits = picture::sameShape(*editing_.grid(), *seen_) && picture.reference == editing_.reference();
  if (!fits || !editing_.touched()) {
    editing_.endStroke();
    const std::int64_t lost = editing_.changedCells();
    again_ = false;
    open(std::move(picture));
    settleDoubt();
    Q_EMIT replaced(lost);
    return;
  }
  // A picture saved here comes back, possibly after a later save; and so may the one before it, which was
  // being read meanwhile. What is read comes in order: an older one after the latest is someone's change.
  const bool latest = picture.revision == revision_;
  const bool known = latest || past_revisions_.contains(picture.revision);
  if (latest || !known) past_revisions_.clear();
  if (known && !editing_.merging()) return again_ ? onMerged(0, revision_) : settleDoubt();
  editing_.mergeTheirs(seen_, picture.revision);
}

void PictureSession::onMerged(qint64 cells, const std::string& revision) {
  revision_ = revision;
  const bool again = std::exchange(again_, false);
  settleDoubt();
  const QPointer<PictureSession> self(this);
  Q_EMIT merged(cells, again);
  if (!self || !again || inConflict()) return;
  unsaved() ? send(copy_) : saved();
}

void PictureSession::send(const QString& copy) {
  if (saving_ || !unsaved() || inConflict()) return;
  copy_ = copy;
  if (editing_.merging()) {
    again_ = true;  // it would be refused: the stored picture has already changed
    return;
  }
  if (!store_()) return;
  saving_ = true;
  const QPointer<PictureSession> self(this);
  Q_EMIT changed();
  if (!self) return;
  if (copy_.isEmpty()) return write();
  share_.startLong(
      [this, path = copy_, cells = editing_.saved(), place = editing_.reference(), opened = opened_] {
        const auto trouble = keepCopy(*cells, place, path);
        QMetaObject::invokeMethod(
            this,
            [this, trouble, opened] {
              if (opened != opened_ || !saving_) return;
              if (!trouble) return write();
              // Without a copy nothing is overwritten.
              saving_ = false;
              Q_EMIT notCopied(*trouble);
            },
            Qt::QueuedConnection);
      });
}

void PictureSession::write() {
  robot::PictureStore* const store = store_();
  if (!store) {
    saving_ = false;
    Q_EMIT changed();
    return;
  }
  const auto cells = editing_.snapshot(), before = editing_.saved();
  const QPointer<PictureSession> self(this);
  write_call_ =
      store->write({map_, cells, revision_},
                   [self, cells, before, opened = opened_](const robot::Outcome<robot::PictureReceipt>& end) {
                     if (self && opened == self->opened_) self->onWritten(cells, before, end);
                   });
  write_call_.onProgress([self, opened = opened_](robot::Progress progress) {
    if (!self || opened != self->opened_ || !self->saving_ || progress.of_bytes.value_or(0) <= 0) return;
    Q_EMIT self->progressed(double(progress.bytes) / double(*progress.of_bytes));
  });
  Q_EMIT changed();
}

void PictureSession::onWritten(const std::shared_ptr<const picture::EditedGrid>& cells,
                               const std::shared_ptr<const picture::EditedGrid>& before,
                               const robot::Outcome<robot::PictureReceipt>& outcome) {
  saving_ = false;
  if (outcome) {
    past_revisions_.insert(std::exchange(revision_, outcome->revision));
    editing_.markSaved(cells);
  } else if (outcome.error().kind == map::FailureKind::Conflict) {
    again_ = true;
  }
  doubt_.reset();
  const QPointer<PictureSession> self(this);
  Q_EMIT ended(outcome ? std::nullopt : std::optional(outcome.error()), copy_);
  if (!self) return;
  if (outcome) Q_EMIT saved();
  // What was read meanwhile was ignored; it says nothing about a doubt that begins only now.
  if (self) Q_EMIT changed();
  if (self && !outcome && outcome.error().applied == map::Applied::Maybe) doubt_ = Doubt{cells, before};
}

/// The picture was read again after it was sent with an unknown result.
void PictureSession::settleDoubt() {
  if (!doubt_) return;
  share_.startLong([this, doubt = *doubt_, now = editing_.saved(), opened = opened_] {
    const auto same = [&](const picture::EditedGrid& one) {
      return picture::sameShape(one, *now) && picture::DifferenceCount::between(one, *now).cells == 0;
    };
    const DoubtEnd end = same(*doubt.sent)     ? DoubtEnd::Stored
                         : same(*doubt.before) ? DoubtEnd::AsBefore
                                               : DoubtEnd::Other;
    QMetaObject::invokeMethod(
        this,
        [this, end, sent = doubt.sent, opened] {
          if (opened != opened_ || !doubt_ || doubt_->sent != sent) return;
          if (end == DoubtEnd::Stored) doubt_.reset();
          Q_EMIT doubtSettled(end);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::edit

#include "moc_picture_session.cpp"
