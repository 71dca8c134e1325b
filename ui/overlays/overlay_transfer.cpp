#include "ui/overlays/overlay_transfer.h"

#include <memory>

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>

#include "overlays/overlay_paste.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::ui {
namespace {

const QString kGeoJsonType = QStringLiteral("application/geo+json");

}  // namespace

OverlayTransfer::OverlayTransfer(WindowContext& context, edit::OverlayEditing* editing, QObject* parent)
    : QObject(parent), context_(context), editing_(editing) {
  const QString edit = menuName(Menu::Edit);
  const auto add = [&](const char* id, const QString& text, const char* icon, const QString& tip) {
    return context_.actions.add(edit, QLatin1String(id), text, QLatin1String(icon), {}, Reach::Everywhere,
                                tip);
  };
  copy_ = add("copyOverlays", tr("&Copy overlays"), "copy",
              tr("Copy the selection as GeoJSON, for another map or a text editor (Ctrl+C on the map)"));
  cut_ = add("cutOverlays", tr("C&ut overlays"), "",
             tr("Copy the selection, then delete it (Ctrl+X on the map)"));
  paste_ = add("pasteOverlays", tr("&Paste overlays"), "",
               tr("Paste overlays where they were copied from (Ctrl+V on the map)"));
  paste_here_ = add("pasteOverlaysHere", tr("Paste overlays in the &view"), "",
                    tr("Paste overlays in the middle of the view (Ctrl+Shift+V on the map: at the cursor)"));
  connect(copy_, &QAction::triggered, this, &OverlayTransfer::copy);
  connect(cut_, &QAction::triggered, this, &OverlayTransfer::cut);
  connect(paste_, &QAction::triggered, this, [this] { paste(std::nullopt); });
  connect(paste_here_, &QAction::triggered, this, [this] { paste(context_.scene.view().center_m); });
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::editableChanged})
    connect(editing_, signal, this, &OverlayTransfer::refresh);
  connect(editing_, &edit::OverlayEditing::selectionChanged, this, &OverlayTransfer::refresh);
  refresh();
}

void OverlayTransfer::addTo(QMenu& menu) {
  for (QAction* action : {copy_, cut_, paste_, paste_here_}) menu.addAction(action);
}

void OverlayTransfer::refresh() {
  const bool any = !editing_->selected().empty(), editable = editing_->editable();
  const QString closed = tr("Open the overlays of a map first."), none = tr("Nothing is selected.");
  allow(copy_, any, editing_->isOpen() ? none : closed);
  allow(cut_, any && editable, editing_->isOpen() ? none : closed);
  allow(paste_, editable, closed);
  allow(paste_here_, editable, closed);
}

void OverlayTransfer::copy() {
  const std::string copied = editing_->copied();
  if (copied.empty()) return;
  auto data = std::make_unique<QMimeData>();
  data->setData(kGeoJsonType, QByteArray::fromStdString(copied));
  data->setText(QString::fromStdString(copied));
  QGuiApplication::clipboard()->setMimeData(data.release());
  context_.overlay.toasts()->add(Mark::Good,
                                 tr("Copied: %1").arg(featuresText(qsizetype(editing_->selected().size()))));
}

void OverlayTransfer::cut() {
  if (!editing_->editable() || editing_->selected().empty()) return;
  copy();
  editing_->removeSelected();
}

void OverlayTransfer::paste(std::optional<Eigen::Vector2d> at_m) {
  if (!editing_->editable()) return;
  const QMimeData* const data = QGuiApplication::clipboard()->mimeData();
  const QByteArray own = data ? data->data(kGeoJsonType) : QByteArray();
  const std::string text = !own.isEmpty() ? own.toStdString()
                           : data         ? data->text().toStdString()
                                          : std::string();
  const auto features = overlays::pastedFeatures(text);
  if (!features) {
    context_.overlay.toasts()->add(
        Mark::Warning,
        tr("Nothing was pasted from the clipboard. %1").arg(sentences::sentenceOf(features.error())));
    return;
  }
  editing_->paste(*features, at_m);
  context_.overlay.toasts()->add(Mark::Good, tr("Pasted: %1").arg(featuresText(qsizetype(features->size()))));
  // Of what lies elsewhere nothing would be seen.
  const geometry::WorldRect around = editing_->bounds();
  constexpr double kAroundPastedM = 2;
  if (!around.empty() && !context_.scene.view().visibleWorld().intersects(around))
    context_.view.fit(around.grown(kAroundPastedM), true);
}

}  // namespace mapwright::ui

#include "moc_overlay_transfer.cpp"
