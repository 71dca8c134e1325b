#include "ui/overlays/overlay_drafts.h"

#include <utility>

#include <QJsonObject>

#include "overlays/overlay_merge.h"
#include "sentences/fault_sentence.h"
#include "ui/overlays/overlay_text.h"
#include "ui/shell/unsaved_question.h"

namespace mapwright::window {
namespace {

constexpr auto kBase = QLatin1String("base"), kMine = QLatin1String("mine");

}  // namespace

QByteArray overlayDraftBytes(const edit::DraftIdentity& of, const OverlayDraft& draft) {
  const QJsonObject texts{{kBase, QString::fromStdString(draft.base.text())},
                          {kMine, QString::fromStdString(draft.mine.text())}};
  return edit::toBytes(edit::DraftFrame{of, draft.made, {texts}});
}

std::optional<OverlayDraft> overlayDraftFrom(const QByteArray& bytes) {
  const auto frame = edit::draftFrame(bytes);
  if (!frame || frame->changes.size() != 1) return std::nullopt;
  const QJsonObject texts = frame->changes.first().toObject();
  if (!texts.value(kBase).isString() || !texts.value(kMine).isString()) return std::nullopt;
  auto base = overlays::OverlayDocument::read(texts.value(kBase).toString().toStdString());
  auto mine = overlays::OverlayDocument::read(texts.value(kMine).toString().toStdString());
  if (!base || !mine) return std::nullopt;
  return OverlayDraft{frame->made, std::move(*base), std::move(*mine)};
}

OverlayDrafts::OverlayDrafts(edit::DraftIdentity of, edit::EditOptions options, Content content,
                             const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent),
      of_(std::move(of)),
      options_(std::move(options)),
      keeper_(
          options_.drafts_folder, of_,
          [this, content = std::move(content)]() -> edit::DraftKeeper::Job {
            auto draft = content();
            if (!draft) return {};
            draft->made = options_.now();
            return [of = of_, draft = std::move(*draft)] { return overlayDraftBytes(of, draft); };
          },
          options_.later, workers),
      share_(workers) {
  connect(&keeper_, &edit::DraftKeeper::troubleChanged, this, &OverlayDrafts::changed);
  share_.startLong([this, folder = options_.drafts_folder, identity = of_] {
    const auto found = std::make_shared<Found>(look(folder, identity));
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

OverlayDrafts::Found OverlayDrafts::look(const QString& folder, const edit::DraftIdentity& of) {
  Found found;
  edit::LeftDrafts left = edit::leftDrafts(folder, of);
  for (const Fault& note : left.notes) found.remarks << sentences::wordsOf(note);
  for (edit::LeftDraft& file : left.drafts) {
    auto draft = overlayDraftFrom(file.bytes);
    if (!draft) {
      found.remarks << sentences::wordsOf(edit::setAside(std::move(file)));
      continue;
    }
    const auto changes = qsizetype(overlays::changesBetween(draft->base, draft->mine).size());
    file.bytes.clear();
    found.drafts.push_back({std::move(file), std::move(*draft), changes});
  }
  return found;
}

QString OverlayDrafts::offer() const {
  if (!offered()) return {};
  return tr("There is an unsaved draft of the overlays of this map from %1: %2.")
      .arg(draftTimeText(left_.front().draft.made, options_.now()),
           overlayChangesText(left_.front().changes));
}

QString OverlayDrafts::trouble() const {
  if (!keeper_.trouble().any()) return {};
  return tr("Changes to the overlays are not backed up: save them soon. %1")
      .arg(sentences::wordsOf(keeper_.trouble()));
}

OverlayDraft OverlayDrafts::take() {
  Left left = std::move(left_.front());
  left_.erase(left_.begin());
  keeper_.replace(std::move(left.file));
  keeper_.touch();
  Q_EMIT changed();
  return std::move(left.draft);
}

void OverlayDrafts::turnDown() {
  if (!offered()) return;
  if (const auto trouble = edit::removeDraft(std::move(left_.front().file)))
    Q_EMIT remarked(sentences::wordsOf(*trouble));
  left_.erase(left_.begin());
  Q_EMIT changed();
}

}  // namespace mapwright::window

#include "moc_overlay_drafts.cpp"
