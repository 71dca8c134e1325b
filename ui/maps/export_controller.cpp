#include "ui/maps/export_controller.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "cells/cell_texture.h"
#include "render/sample_grid.h"
#include "robot/address.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "submap/submap_store.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "words/file_name.h"

namespace mapwright::ui {

namespace {

using MapMode = grids::MapServerForm::Mode;

QDoubleSpinBox* thresholdField(QWidget* parent, double value, const QString& name, const QString& tip) {
  QDoubleSpinBox* const box =
      numberField(parent, {.most = 1, .decimals = 3, .step = 0.01, .unit = {}, .name = name});
  box->setValue(value);
  box->setToolTip(tip);
  return box;
}

}  // namespace

ExportDialog::ExportDialog(ExportOffer offer, const std::shared_ptr<work::Workers>& workers, QWidget* parent)
    : QDialog(parent),
      offer_(std::move(offer)),
      map_picture_(new QRadioButton(tr("&Picture of the map (PNG)"), this)),
      map_server_(new QRadioButton(tr("&ROS map (PGM and YAML, for map_server)"), this)),
      view_picture_(new QRadioButton(tr("Picture of the current &view (PNG)"), this)),
      source_(new QComboBox(this)),
      resolution_(new DecimalBox(this)),
      hidden_(new QCheckBox(this)),
      world_file_(new QCheckBox(tr("W&ith a world file (.pgw) that gives its position"), this)),
      map_mode_(new QComboBox(this)),
      thresholds_(new QCheckBox(tr("&Thresholds"), this)),
      occupied_(thresholdField(this, map::CellReading().occupied_thresh, tr("Occupied above"),
                               tr("Cells of a higher probability are walls"))),
      free_(thresholdField(this, map::CellReading().free_thresh, tr("Free below"),
                           tr("Cells of a lower probability are free"))),
      path_(new QLineEdit(this)),
      browse_(new QPushButton(tr("&Browse…"), this)),
      export_(new QPushButton(tr("Export"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      progress_(new QProgressBar(this)),
      content_(new QLabel(this)),
      error_(new QLabel(this)),
      source_label_(new QLabel(tr("&What"), this)),
      resolution_label_(new QLabel(tr("Metres per &cell"), this)),
      map_mode_label_(new QLabel(tr("Map &mode"), this)),
      workers_(workers),
      run_(workers) {
  setWindowTitle(tr("Export"));
  setMinimumWidth(520);
  source_->setObjectName(QStringLiteral("source"));
  if (offer_.whole) source_->addItem(tr("The whole map"), false);
  if (!offer_.submaps.empty()) source_->addItem(tr("The submaps, composed"), true);
  source_->setCurrentIndex(qMax(0, source_->findData(offer_.prefers_submaps)));
  const int hidden = int(offer_.hidden.size());
  hidden_->setText(tr("&Also what is hidden on the map (%1)").arg(submapsText(hidden)));
  hidden_->setChecked(true);
  hidden_->setVisible(hidden > 0);
  source_label_->setBuddy(source_);
  resolution_label_->setBuddy(resolution_);
  resolution_->setDecimals(4);
  resolution_->setRange(0.001, 10);
  resolution_->setSingleStep(0.01);
  resolution_->setValue(offer_.submap_resolution_m);
  map_mode_->addItem(tr("Trinary: walls, free and unknown as shown"), int(MapMode::Trinary));
  map_mode_->addItem(tr("Scale: percentages, with a PNG"), int(MapMode::Scale));
  map_mode_->addItem(tr("Raw: percentages, with a PGM"), int(MapMode::Raw));
  map_mode_label_->setBuddy(map_mode_);
  thresholds_->setToolTip(tr("Write the probabilities themselves, and let these thresholds decide"));
  path_->setObjectName(QStringLiteral("path"));
  giveRoles(*export_, {browse_, cancel_});
  makeLine(*progress_);
  for (QLabel* label : {content_, error_}) label->setTextFormat(Qt::PlainText);
  setTextColor(*content_, appColors().secondary_text);
  content_->setWordWrap(true);
  error_->setWordWrap(true);
  setTextColor(*error_, appColors().error_text);
  error_->hide();

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->addRow(source_label_, source_);
  form->addRow(QString(), hidden_);
  form->addRow(QString(), content_);
  form->addRow(resolution_label_, resolution_);
  form->addRow(map_mode_label_, map_mode_);
  form->addRow(QString(), rowOf({thresholds_, new QLabel(tr("occupied above"), this), occupied_,
                                 new QLabel(tr("free below"), this), free_, LayoutItem::rest()}));
  auto* path_label = new QLabel(tr("&File"), this);
  path_label->setBuddy(path_);
  form->addRow(path_label, rowOf({{path_, 1}, browse_}));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(8);
  for (QRadioButton* button : {map_picture_, map_server_, view_picture_}) column->addWidget(button);
  column->addSpacing(4);
  column->addLayout(form);
  column->addWidget(world_file_);
  column->addWidget(error_);
  column->addWidget(progress_);
  column->addLayout(rowOf({LayoutItem::rest(), cancel_, export_}, 8));

  // In visual order, not in order of creation.
  QWidget* const order[] = {map_picture_, map_server_, view_picture_, source_,   hidden_,
                            resolution_,  map_mode_,   thresholds_,   occupied_, free_,
                            path_,        browse_,     world_file_,   cancel_,   export_};
  for (std::size_t i = 1; i < std::size(order); ++i) setTabOrder(order[i - 1], order[i]);

  const bool has_map = source_->count() > 0;
  for (QRadioButton* button : {map_picture_, map_server_}) {
    button->setEnabled(has_map);
    button->setToolTip(has_map ? QString() : offer_.why_not_whole);
  }
  (has_map ? map_picture_ : view_picture_)->setChecked(true);
  path_->setText(QDir(offer_.folder).filePath(words::shortFileName(offer_.name, QStringLiteral("map"))));
  for (QRadioButton* button : {map_picture_, map_server_, view_picture_})
    connect(button, &QRadioButton::toggled, this, &ExportDialog::sync);
  connect(source_, &QComboBox::currentIndexChanged, this, &ExportDialog::sync);
  connect(map_mode_, &QComboBox::currentIndexChanged, this, &ExportDialog::sync);
  connect(thresholds_, &QCheckBox::toggled, this, &ExportDialog::sync);
  connect(hidden_, &QCheckBox::toggled, this, &ExportDialog::sync);
  connect(path_, &QLineEdit::textEdited, this, [this] {
    confirmed_ = source_confirmed_ = false;
    letEnterPress(*export_, true);
    error_->hide();
    export_->setEnabled(!path_->text().trimmed().isEmpty());
  });
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::browse);
  connect(export_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(cancel_, &QPushButton::clicked, this, &ExportDialog::reject);
  sync();
}

jobs::ExportFormat ExportDialog::format() const {
  if (map_server_->isChecked()) return jobs::ExportFormat::MapServer;
  return view_picture_->isChecked() ? jobs::ExportFormat::ViewPicture : jobs::ExportFormat::MapPicture;
}

QRadioButton* ExportDialog::formatButton(jobs::ExportFormat format) const {
  return format == jobs::ExportFormat::MapServer     ? map_server_
         : format == jobs::ExportFormat::ViewPicture ? view_picture_
                                                     : map_picture_;
}

grids::MapServerForm ExportDialog::form() const {
  grids::MapServerForm form;
  if (format() != jobs::ExportFormat::MapServer) return form;
  form.mode = MapMode(map_mode_->currentData().toInt());
  if (thresholds_->isChecked() && form.mode != MapMode::Raw) {
    form.occupied_thresh = occupied_->value();
    form.free_thresh = free_->value();
  }
  return form;
}

bool ExportDialog::fromSubmaps() const {
  return format() != jobs::ExportFormat::ViewPicture && source_->currentData().toBool();
}

bool ExportDialog::withHidden() const { return offer_.hidden.empty() || hidden_->isChecked(); }

std::vector<render::PlacedTexture> ExportDialog::chosenSubmaps() const {
  if (withHidden()) return offer_.submaps;
  std::vector<render::PlacedTexture> chosen;
  std::copy_if(offer_.submaps.begin(), offer_.submaps.end(), std::back_inserter(chosen),
               [this](const render::PlacedTexture& placed) { return !offer_.hidden.contains(placed.id); });
  return chosen;
}

QString ExportDialog::describeContent() const {
  if (format() == jobs::ExportFormat::ViewPicture) return tr("What is hidden on the map is left out.");
  if (!fromSubmaps()) return offer_.unsaved ? tr("Unsaved changes are left out.") : QString();
  const int all = int(offer_.submaps.size()) + offer_.without_picture;
  const int chosen = int(offer_.submaps.size()) - (withHidden() ? 0 : int(offer_.hidden.size()));
  const QString kept = tr("%1 of %2 are included.").arg(countText(chosen), submapsText(all));
  if (offer_.without_picture == 0) return kept;
  return kept + QLatin1Char(' ') + tr("Missing or damaged: %1.").arg(countText(offer_.without_picture));
}

void ExportDialog::sync() {
  const bool view = format() == jobs::ExportFormat::ViewPicture;
  source_->setEnabled(!view && source_->count() > 1);
  resolution_->setEnabled(!view && fromSubmaps());
  resolution_label_->setEnabled(resolution_->isEnabled());
  source_label_->setEnabled(!view);
  hidden_->setEnabled(fromSubmaps());
  content_->setText(describeContent());
  content_->setVisible(!content_->text().isEmpty());
  export_->setEnabled(!fromSubmaps() || !chosenSubmaps().empty());
  const bool map_server = format() == jobs::ExportFormat::MapServer;
  world_file_->setEnabled(!map_server);
  map_mode_->setEnabled(map_server);
  map_mode_label_->setEnabled(map_server);
  thresholds_->setEnabled(map_server && MapMode(map_mode_->currentData().toInt()) != MapMode::Raw);
  for (QDoubleSpinBox* const box : {occupied_, free_})
    box->setEnabled(thresholds_->isEnabled() && thresholds_->isChecked());
  // The name stays, the extension follows the format.
  QString path = path_->text();
  for (const char* suffix : {".png", ".yaml", ".pgm"}) {
    if (path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive)) {
      path.chop(qstrlen(suffix));
      break;
    }
  }
  path_->setText(path + QLatin1Char('.') + jobs::exportSuffix(format()));
  confirmed_ = source_confirmed_ = false;
  letEnterPress(*export_, true);
  error_->hide();
}

void ExportDialog::browse() {
  const QString filter =
      format() == jobs::ExportFormat::MapServer ? tr("ROS maps (*.yaml)") : tr("PNG pictures (*.png)");
  const QString path = QFileDialog::getSaveFileName(this, tr("Export to"), path_->text(), filter);
  if (path.isEmpty()) return;
  path_->setText(path);
  sync();
  confirmed_ = true;  // the file dialog has asked
}

void ExportDialog::start() {
  if (run_.running()) return;
  const QString path = QFileInfo(path_->text().trimmed()).absoluteFilePath();
  const bool with_world_file = world_file_->isChecked() && world_file_->isEnabled();
  const QStringList files = jobs::exportedFiles(path, format(), with_world_file, form().mode);
  const auto askAgain = [this](const QString& sentence) {
    letEnterPress(*export_, false);
    error_->setText(sentence);
    error_->show();
  };
  if (const auto flaw = grids::flawOf(form())) return askAgain(sentences::wordsOf(*flaw));
  const bool whole = format() != jobs::ExportFormat::ViewPicture && !fromSubmaps() && offer_.whole;
  QString missing = whole ? jobs::mostlyMissingReason(*offer_.whole->cells) : QString();
  if (whole && offer_.broken && missing.isEmpty())
    missing = tr("Parts of this map could not be read. They would be unknown cells.");
  if (!missing.isEmpty() && !missing_confirmed_) {
    missing_confirmed_ = true;
    return askAgain(tr("%1 Press Export again to write them anyway.").arg(missing));
  }
  if (const QString own = jobs::firstOwnSource(files, offer_.sources); !own.isEmpty() && !source_confirmed_) {
    confirmed_ = source_confirmed_ = true;
    askAgain(tr("The map was read from %1. Press Export again to replace the file, or choose another name.")
                 .arg(QDir::toNativeSeparators(own)));
    return;
  }
  const auto present =
      std::find_if(files.begin(), files.end(), [](const QString& file) { return QFileInfo::exists(file); });
  if (present != files.end() && !confirmed_) {
    confirmed_ = true;
    askAgain(
        tr("%1 already exists. Press Export again to replace it.").arg(QDir::toNativeSeparators(*present)));
    return;
  }
  jobs::ExportRequest request;
  request.path = path;
  request.format = format();
  request.world_file = with_world_file;
  request.form = form();
  if (present == files.end()) request.existing = disk::Existing::Refuse;  // nobody was asked
  if (request.format == jobs::ExportFormat::ViewPicture) {
    request.source = offer_.view();
  } else if (fromSubmaps()) {
    request.source = jobs::SubmapsExport{chosenSubmaps(), resolution_->value()};
  } else if (offer_.whole) {
    request.source = *offer_.whole;
  } else {
    return;
  }
  error_->hide();
  setRunning(true);
  run_.start(
      [this, request, workers = workers_](const BackgroundRun::Running& run) -> BackgroundRun::Then {
        return [this, result = jobs::exportMap(request, run.proceed, {workers})] { onFinished(result); };
      },
      [this](double done) { progress_->setValue(int(done * 1000)); });
}

void ExportDialog::setRunning(bool running) {
  for (QWidget* widget : std::initializer_list<QWidget*>{
           map_picture_, map_server_, view_picture_, source_, hidden_, resolution_, world_file_, map_mode_,
           thresholds_, occupied_, free_, path_, browse_, export_})
    widget->setEnabled(!running);
  progress_->setValue(0);
  progress_->setVisible(running);
  if (running) return;
  const bool has_map = source_->count() > 0;
  map_picture_->setEnabled(has_map);
  map_server_->setEnabled(has_map);
  cancel_->setEnabled(true);
  const QString path = path_->text();
  sync();
  path_->setText(path);
}

void ExportDialog::onFinished(const jobs::ExportResult& result) {
  setRunning(false);
  if (result.cancelled) {
    error_->setText(tr("Cancelled. Nothing was written."));
    error_->show();
  } else if (!result.error.isEmpty()) {
    error_->setText(result.error);
    error_->show();
  } else {
    Q_EMIT exported(result.path, result.remark);
    accept();
  }
}

void ExportDialog::reject() {
  if (run_.running()) {
    run_.cancel();
    cancel_->setEnabled(false);
    return;
  }
  QDialog::reject();
}

QString ExportDialog::contentText() const { return content_->isHidden() ? QString() : content_->text(); }

QString ExportDialog::errorText() const { return error_->isHidden() ? QString() : error_->text(); }

namespace {

const QString kExportFolderKey = QStringLiteral("export/folder");
const QString kSavingPicture = QStringLiteral("view");
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

ExportController::ExportController(WindowContext& context, jobs::YamlsNaming yamls_naming, QObject* parent)
    : Controller(parent), context_(context), yamls_naming_(std::move(yamls_naming)) {
  context_.actions.add({.id = "export",
                        .text = tr("E&xport…"),
                        .name = tr("Export the map…"),
                        .icon = "export",
                        .keys = {"Ctrl+E"},
                        .tip = tr("Write the map on screen to a file"),
                        .needs_session = true,
                        .menu = {MenuGroup::Exports, 10},
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
    context_.overlay.toasts()->add(Mark::Bad, *error, {}, kSavingPicture);
  } else {
    context_.overlay.toasts()->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(path)), {},
                                   kSavingPicture);
  }
}

std::vector<std::string> ExportController::sourceFiles() const {
  const session::Session* const session = context_.current.session();
  if (!session) return {};
  const session::MapSlot& slot = session->wholeMap();
  return jobs::sourceFiles(context_.addresses, session->robot().address(), slot.key().id, slot.shown().path,
                           yamls_naming_);
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
    offer.broken = !slot.isWhole();
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
  connect(dialog_, &ExportDialog::exported, this, [this](const QString& path, const QString& remark) {
    context_.settings.setValue(kExportFolderKey, QFileInfo(path).absolutePath());
    const QString done = tr("Exported to %1").arg(QDir::toNativeSeparators(path));
    context_.overlay.toasts()->add(remark.isEmpty() ? Mark::Good : Mark::Warning,
                                   remark.isEmpty() ? done : QStringLiteral("%1. %2").arg(done, remark));
    const bool view = dialog_->formatButton(jobs::ExportFormat::ViewPicture)->isChecked();
    const bool submaps = dialog_->sourceBox()->currentData().toBool();
    if (!view && !submaps) Q_EMIT wholeExported();
  });
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_export_controller.cpp"
#include "ui/kit/forms.h"
