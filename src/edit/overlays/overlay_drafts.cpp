#include "edit/overlays/overlay_drafts.h"

#include <utility>

#include <QJsonObject>

namespace mapwright::edit {
namespace {

constexpr auto kBase = QLatin1String("base"), kMine = QLatin1String("mine");

}  // namespace

QByteArray overlayDraftBytes(const DraftIdentity& of, const OverlayDraft& draft) {
  const QJsonObject texts{{kBase, QString::fromStdString(draft.base.text())},
                          {kMine, QString::fromStdString(draft.mine.text())}};
  return toBytes(DraftFrame{of, draft.made, {texts}});
}

std::optional<OverlayDraft> overlayDraftFrom(const QByteArray& bytes) {
  const auto frame = draftFrame(bytes);
  if (!frame || frame->changes.size() != 1) return std::nullopt;
  const QJsonObject texts = frame->changes.first().toObject();
  if (!texts.value(kBase).isString() || !texts.value(kMine).isString()) return std::nullopt;
  auto base = overlays::OverlayDocument::read(texts.value(kBase).toString().toStdString());
  auto mine = overlays::OverlayDocument::read(texts.value(kMine).toString().toStdString());
  if (!base || !mine) return std::nullopt;
  return OverlayDraft{frame->made, std::move(*base), std::move(*mine)};
}

}  // namespace mapwright::edit
