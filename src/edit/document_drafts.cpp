#include "edit/document_drafts.h"

#include <utility>

#include <QPointer>

namespace mapwright::edit {

DocumentDrafts::DocumentDrafts(const EditOptions& options, Kind kind)
    : folder_(options.drafts_folder),
      workers_(work::orOwn(options.workers)),
      kind_(std::move(kind)),
      keeper_(
          folder_, kind_.of, [this] { return kind_.unsaved() ? kind_.content() : DraftKeeper::Job(); },
          options.later, workers_),
      looking_(workers_) {
  connect(&keeper_, &DraftKeeper::troubleChanged, this, &DocumentDrafts::changed);
}

DocumentDrafts::~DocumentDrafts() = default;

void DocumentDrafts::look() {
  looking_.startLong([this, folder = folder_, kind = kind_] {
    const auto found = std::make_shared<Found>(find(folder, kind));
    QMetaObject::invokeMethod(
        this, [this, found] { offer(std::move(*found)); }, Qt::QueuedConnection);
  });
}

DocumentDrafts::Found DocumentDrafts::find(const QString& folder, const Kind& kind) {
  Found found;
  LeftDrafts left = leftDrafts(folder, kind.of);
  found.remarks = std::move(left.notes);
  for (LeftDraft& file : left.drafts) {
    auto draft = kind.read(file.bytes);
    if (!draft) {
      found.remarks.push_back(setAside(std::move(file)));
      continue;
    }
    file.bytes.clear();
    found.drafts.push_back({std::move(file), std::move(*draft)});
  }
  return found;
}

void DocumentDrafts::offer(Found found) {
  for (Left& left : found.drafts) {
    if (kind_.removeSaved) kind_.removeSaved(left.draft);
    if (left.draft.changes > 0) {
      left_.push_back(std::move(left));
    } else if (const auto trouble = removeDraft(std::move(left.file))) {
      found.remarks.push_back(*trouble);
    }
  }
  const QPointer<DocumentDrafts> here(this);
  for (const Fault& remark : found.remarks) {
    if (here) Q_EMIT remarked(remark);
  }
  if (here && offered()) Q_EMIT changed();
}

DocumentDrafts::Left DocumentDrafts::removeFirst() {
  Left left = std::move(left_.front());
  left_.erase(left_.begin());
  return left;
}

void DocumentDrafts::restore(const std::function<bool(const Draft&)>& apply) {
  if (!offered()) return;
  Left left = removeFirst();
  if (apply(left.draft)) {
    keeper_.replace(std::move(left.file));
    keeper_.touch();
  }
  Q_EMIT changed();
}

void DocumentDrafts::turnDown() {
  if (!offered()) return;
  const auto trouble = removeDraft(removeFirst().file);
  Q_EMIT changed();
  if (trouble) Q_EMIT remarked(*trouble);
}

}  // namespace mapwright::edit

#include "moc_document_drafts.cpp"
