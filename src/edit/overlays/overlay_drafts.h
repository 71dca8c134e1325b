// Drafts of the unsaved changes of a map's overlays, as bytes.
#pragma once

#include <optional>

#include <QByteArray>
#include <QDateTime>

#include "edit/drafts.h"
#include "overlays/overlay_document.h"

namespace mapwright::edit {

/// What the robot held, and what was made of it.
struct OverlayDraft {
  QDateTime made;
  overlays::OverlayDocument base, mine;
};
QByteArray overlayDraftBytes(const DraftIdentity& of, const OverlayDraft& draft);
/// nullopt: not such a draft, or damaged.
std::optional<OverlayDraft> overlayDraftFrom(const QByteArray& bytes);

}  // namespace mapwright::edit
