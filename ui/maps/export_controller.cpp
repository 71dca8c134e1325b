#include "ui/maps/export_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QClipboard>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPainter>
#include <QRadioButton>
#include <QStandardPaths>

#include "jobs/export_map.h"
#include "jobs/write_picture.h"
#include "robot/address.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/folders.h"
#include "ui/maps/export_dialog.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {

namespace {

const QString kExportFolderKey = QStringLiteral("export/folder");
const QString kPictureFolderKey = QStringLiteral("screenshot/folder");

/// The position of the view's pixels in the world.
map::GridReference referenceOf(const geometry::ViewTransform& view, const QSize& pixels) {
  map::GridReference reference;
  reference.width = pixels.width();
  reference.height = pixels.height();
  reference.resolution_m = view.scale_m_per_px * view.width_px / std::max(1, pixels.width());
  const Eigen::Vector2d corner = view.worldFromPixel({0, double(view.height_px)});
  reference.origin = {corner.x(), corner.y(), -view.rotation_rad};
  return reference;
}

}  // namespace

ExportController::ExportController(WindowContext& context,
                                   std::function<QStringList(const QString& picture)> yamls_naming,
                                   QObject* parent)
    : Controller(parent), context_(context), yamls_naming_(std::move(yamls_naming)) {
  context_.actions.add({.id = "export",
                        .text = tr("E&xport…"),
                        .icon = "export",
                        .keys = {"Ctrl+E"},
                        .tip = tr("Write the map on screen to a file"),
                        .needs_session = true,
                        .menu = {MenuGroup::WholeMap, 20},
                        .map_menu = {MapMenuGroup::Copies, 30}},
                       this, &ExportController::exportMap);
  context_.actions.add({.id = "screenshotCopy",
                        .text = tr("Copy pict&ure"),
                        .icon = "copy",
                        .keys = {"Ctrl+Shift+C"},
                        .tip = tr("Copy the map as a picture"),
                        .needs_session = true,
                        .menu = {MenuGroup::Copies, 20},
                        .map_menu = {MapMenuGroup::Copies, 10}},
                       this, &ExportController::copyPicture);
  context_.actions.add({.id = "screenshotSave",
                        .text = tr("&Save picture…"),
                        .icon = "screenshot",
                        .keys = {"Ctrl+Shift+S"},
                        .tip = tr("Save the map as a PNG picture"),
                        .needs_session = true,
                        .menu = {MenuGroup::Copies, 30},
                        .bar = {BarGroup::Places, 20},
                        .map_menu = {MapMenuGroup::Copies, 20}},
                       this, &ExportController::askAndSavePicture);
}

ExportDialog* ExportController::dialog() const { return dialog_; }

QImage ExportController::mapPicture() const {
  const double ratio = context_.view.devicePixelRatioF();
  const QSize size = context_.view.viewport()->size();
  QImage image(size * ratio, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(context_.scene.theme().map.unknown);
  QPainter painter(&image);
  painter.setRenderHints(context_.view.renderHints());
  context_.scene.render(&painter, QRectF(QPointF(0, 0), QSizeF(size)), QRectF(QPointF(0, 0), QSizeF(size)),
                        Qt::IgnoreAspectRatio);
  return image;
}

std::optional<QString> ExportController::saveMapPicture(const QString& path) {
  if (!jobs::firstOwnSource({path}, sourceFiles()).isEmpty()) {
    return tr("The map was read from %1. Choose another name.").arg(QDir::toNativeSeparators(path));
  }
  const auto problem = jobs::writePicture(mapPicture(), path);
  return problem ? std::optional(sentences::wordsOf(*problem)) : std::nullopt;
}

void ExportController::copyPicture() {
  QGuiApplication::clipboard()->setImage(mapPicture());
  context_.overlay.toasts()->add(Mark::Good, tr("Picture copied"));
}

void ExportController::askAndSavePicture() {
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QDir folder(folderToWriteInto({context_.settings.value(kPictureFolderKey).toString(), pictures}));
  const QString proposed =
      folder.filePath(QStringLiteral("mapwright-%1.png")
                          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
  QString path = QFileDialog::getSaveFileName(&context_.window, tr("Save the map as a picture"), proposed,
                                              tr("PNG pictures (*.png)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) path += QLatin1String(".png");
  context_.settings.setValue(kPictureFolderKey, QFileInfo(path).absolutePath());
  if (const auto error = saveMapPicture(path)) {
    context_.overlay.toasts()->add(Mark::Bad, *error);
  } else {
    context_.overlay.toasts()->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(path)));
  }
}

std::vector<std::string> ExportController::sourceFiles() const {
  const session::Session* const session = context_.current.session();
  if (!session) return {};
  const session::MapSlot& slot = session->wholeMap();
  const auto address = context_.addresses.parse(session->robot().address());
  std::vector<std::string> files;
  if (address) files = robot::localFiles(*address, slot.key().id, slot.shown().path);
  if (files.empty() || slot.shown().path.empty() || !yamls_naming_) return files;
  for (const QString& yaml : yamls_naming_(QString::fromStdString(slot.shown().path)))
    files.push_back(yaml.toStdString());
  return files;
}

void ExportController::exportMap() {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const session::MapSlot& slot = session->wholeMap();
  ExportOffer offer;
  offer.submaps = context_.scene.placedTextures();
  const auto& rows = session->submaps().rows();
  for (const auto& placed : offer.submaps) {
    if (!rows.at(placed.id).visible) offer.hidden.insert(placed.id);
  }
  offer.without_picture = int(rows.size()) - int(offer.submaps.size());
  double finest = std::numeric_limits<double>::infinity();
  for (const render::PlacedTexture& placed : offer.submaps) {
    if (placed.texture->resolutionM() > 0) finest = std::min(finest, placed.texture->resolutionM());
  }
  if (std::isfinite(finest)) offer.submap_resolution_m = finest;
  if (slot.cells() && slot.cells()->complete() && slot.settled()) {
    offer.whole = jobs::WholeMapExport{slot.cells(), slot.reference()};
    const auto on_screen = context_.scene.wholeMap();
    offer.unsaved = on_screen && on_screen->cells != slot.cells();
  } else {
    offer.why_not_whole = slot.cells() ? tr("The map is still loading.")
                                       : tr("There is no open map, and there are no submaps.");
  }
  offer.prefers_submaps = !offer.whole || !context_.scene.layerVisible(scene::Layer::WholeMap);
  offer.name = slot.cells() && !offer.prefers_submaps ? mapCalled(slot.name(), slot.key())
                                                      : session->robot().identity().name;
  if (offer.name.trimmed().isEmpty()) offer.name = QStringLiteral("map");
  offer.view = [this] {
    const QImage picture = mapPicture();
    return jobs::ViewExport{picture, referenceOf(context_.scene.view(), picture.size())};
  };
  offer.sources = sourceFiles();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  offer.folder = folderToWriteInto({context_.settings.value(kExportFolderKey).toString(), documents});
  delete dialog_;
  dialog_ = new ExportDialog(std::move(offer), context_.workers, &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &ExportDialog::exported, this, [this](const QString& path) {
    context_.settings.setValue(kExportFolderKey, QFileInfo(path).absolutePath());
    context_.overlay.toasts()->add(Mark::Good, tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
    const bool view = dialog_->formatButton(jobs::ExportFormat::ViewPicture)->isChecked();
    const bool submaps = dialog_->sourceBox()->currentData().toBool();
    if (!view && !submaps) Q_EMIT wholeExported();
  });
  dialog_->open();
}

}  // namespace mapwright::window

#include "moc_export_controller.cpp"
