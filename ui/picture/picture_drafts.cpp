#include "ui/picture/picture_drafts.h"

#include <utility>

#include "sentences/fault_sentence.h"
#include "ui/picture/picture_text.h"

namespace mapwright::window {

PictureDrafts::PictureDrafts(PictureEditing* editing, edit::DraftIdentity of, edit::EditOptions options,
                             const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent),
      editing_(editing),
      of_(std::move(of)),
      options_(std::move(options)),
      keeper_(
          options_.drafts_folder, of_,
          [this]() -> edit::DraftKeeper::Job {
            if (!editing_->isOpen() || !editing_->unsaved()) return {};
            return [of = of_, made = options_.now(), now = editing_->snapshot(), saved = editing_->saved()] {
              return pictureDraftBytes(of, made, *now, *saved);
            };
          },
          options_.later, workers),
      share_(workers) {
  connect(&keeper_, &edit::DraftKeeper::troubleChanged, this, &PictureDrafts::changed);
  connect(&keeper_, &edit::DraftKeeper::written, this, &PictureDrafts::forgetTakenUp);
  share_.startLong([this, folder = options_.drafts_folder, identity = of_, grid = editing_->snapshot()] {
    const auto found = std::make_shared<Found>(look(folder, identity, *grid));
    QMetaObject::invokeMethod(
        this,
        [this, found] {
          left_ = std::move(found->drafts);
          for (const QString& remark : std::as_const(found->remarks)) Q_EMIT remarked(remark);
          if (offered()) Q_EMIT changed();
        },
        Qt::QueuedConnection);
  });
}

PictureDrafts::~PictureDrafts() = default;

PictureDrafts::Found PictureDrafts::look(const QString& folder, const edit::DraftIdentity& of,
                                         const picture::EditedGrid& grid) {
  Found found;
  edit::LeftDrafts left = edit::leftDrafts(folder, of);
  for (const Fault& note : left.notes) found.remarks << sentences::wordsOf(note);
  for (edit::LeftDraft& file : left.drafts) {
    auto draft = pictureDraftFrom(file.bytes);
    const auto taken = draft ? takeDraft(*draft, grid) : std::nullopt;
    if (!taken) {
      found.remarks << sentences::wordsOf(edit::setAside(std::move(file)));
    } else if (taken->cells == 0) {
      edit::removeDraft(std::move(file));  // it has been saved after all
    } else {
      file.bytes.clear();
      found.drafts.push_back({std::move(file), std::move(*draft), taken->cells});
    }
  }
  return found;
}

QString PictureDrafts::offer() const {
  return offered() ? draftText(left_.front().draft.made, options_.now(), left_.front().cells) : QString();
}

QString PictureDrafts::trouble() const {
  if (!keeper_.trouble().any()) return {};
  return tr("Changes to the map are not backed up: save them soon. %1")
      .arg(sentences::wordsOf(keeper_.trouble()));
}

std::optional<Fault> PictureDrafts::keep() {
  const auto trouble = keeper_.flush();
  forgetTakenUp();
  return trouble;
}

void PictureDrafts::forgetTakenUp() {
  // Only when it is saved elsewhere.
  if (keeper_.trouble().any()) return;
  for (edit::LeftDraft& file : std::exchange(taken_up_, {})) edit::removeDraft(std::move(file));
}

void PictureDrafts::takeUp() {
  if (!offered() || !editing_->isOpen()) return;
  Left left = std::move(left_.front());
  left_.erase(left_.begin());
  if (auto taken = takeDraft(left.draft, *editing_->grid())) {
    taken_up_.push_back(std::move(left.file));
    editing_->takeUp(std::move(taken->patch), tr("restore the draft"));
    if (taken->elsewhere > 0)
      Q_EMIT remarked(tr("Since this draft was made, someone else has also changed these parts of the map: "
                         "%1. Your changes are shown; use undo to see the others.")
                          .arg(cellsText(taken->elsewhere)));
  }
  Q_EMIT changed();
}

void PictureDrafts::turnDown() {
  if (!offered()) return;
  if (const auto trouble = edit::removeDraft(std::move(left_.front().file)))
    Q_EMIT remarked(sentences::wordsOf(*trouble));
  left_.erase(left_.begin());
  Q_EMIT changed();
}

}  // namespace mapwright::window

#include "moc_picture_drafts.cpp"
