#include "ui/shell/map_drafts.h"

#include <memory>
#include <utility>

#include <QPointer>

#include "sentences/fault_sentence.h"
#include "ui/kit/panels.h"
#include "ui/shell/unsaved_question.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {

MapDrafts::MapDrafts(WindowContext& context, QDockWidget* dock, Kind kind)
    : context_(context),
      dock_(dock),
      kind_(std::move(kind)),
      keeper_(context.edit.drafts_folder, kind_.of, kind_.content, context.edit.later, context.workers),
      share_(context.workers) {
  connect(&keeper_, &edit::DraftKeeper::troubleChanged, this, &MapDrafts::tell);
  share_.startLong([this, folder = context.edit.drafts_folder, kind = kind_] {
    const auto found = std::make_shared<Found>(look(folder, kind));
    QMetaObject::invokeMethod(
        this,
        [this, found] {
          left_ = std::move(found->drafts);
          for (const QString& sentence : std::as_const(found->remarks)) remark(sentence);
          if (offered()) tell();
        },
        Qt::QueuedConnection);
  });
}

MapDrafts::Found MapDrafts::look(const QString& folder, const Kind& kind) {
  Found found;
  edit::LeftDrafts left = edit::leftDrafts(folder, kind.of);
  for (const Fault& note : left.notes) found.remarks << sentences::wordsOf(note);
  for (edit::LeftDraft& file : left.drafts) {
    auto draft = kind.read(file.bytes);
    if (!draft) {
      found.remarks << sentences::wordsOf(edit::setAside(std::move(file)));
    } else if (draft->needless) {
      edit::removeDraft(std::move(file));
    } else {
      file.bytes.clear();
      found.drafts.push_back({std::move(file), std::move(*draft)});
    }
  }
  return found;
}

void MapDrafts::tell() {
  const QPointer<MapDrafts> here(this);
  Q_EMIT changed();
  if (here && offered())
    context_.overlay.toasts()->add(Mark::Neutral, offer(),
                                   {tr("Show"), [this] { context_.panels.open(dock_); }});
}

void MapDrafts::remark(const QString& sentence) { context_.overlay.toasts()->add(Mark::Warning, sentence); }

void MapDrafts::keepOrTell() {
  const bool any = kind_.unsaved();
  if (const auto trouble = keep(); trouble && any)
    context_.overlay.toasts()->add(Mark::Bad, kind_.lost.arg(sentences::wordsOf(*trouble)));
}

QString MapDrafts::trouble() const {
  // What is saved needs no draft.
  if (!keeper_.trouble().any() || !kind_.unsaved()) return {};
  return kind_.not_backed.arg(sentences::wordsOf(keeper_.trouble()));
}

QString MapDrafts::offer() const {
  if (!offered()) return {};
  const Draft& first = left_.front().draft;
  return kind_.offer.arg(draftTimeText(first.made, context_.edit.now()), first.amount);
}

MapDrafts::Left MapDrafts::take() {
  Left left = std::move(left_.front());
  left_.erase(left_.begin());
  tell();
  return left;
}

void MapDrafts::replace(edit::LeftDraft file) {
  keeper_.replace(std::move(file));
  keeper_.touch();
}

void MapDrafts::turnDown() {
  if (!offered()) return;
  if (const auto trouble = edit::removeDraft(take().file)) remark(sentences::wordsOf(*trouble));
}

}  // namespace mapwright::window

#include "moc_map_drafts.cpp"
