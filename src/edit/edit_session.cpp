#include "edit/edit_session.h"

#include <utility>

namespace mapwright::edit {

void EditSession::keepDrafts(const EditOptions& options, DocumentDrafts::Kind kind) {
  if (options.drafts_folder.isEmpty()) return;
  drafts_ = std::make_unique<DocumentDrafts>(options, std::move(kind));
  connect(drafts_.get(), &DocumentDrafts::changed, this, &EditSession::changed);
  connect(drafts_.get(), &DocumentDrafts::remarked, this, &EditSession::remarked);
}

std::optional<Fault> EditSession::closeDrafts() {
  const auto drafts = std::exchange(drafts_, nullptr);
  return drafts ? drafts->keep() : std::nullopt;
}

}  // namespace mapwright::edit

#include "moc_edit_session.cpp"
