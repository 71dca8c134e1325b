#include "ui/maps/expected_controller.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTimer>

#include "compare/comparison_sentence.h"
#include "compare/difference_picture.h"
#include "compare/picture_reading.h"
#include "compare/picture_view.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"

namespace mapwright::window {
namespace {

constexpr auto kExpectedFolderKey = "expectedPictures/folder";
constexpr std::int64_t kMostDrawnPixels = 40'000'000;
constexpr QSize kLargestShown(1'000, 700);

render::TileRenderer::Options exactTiles(const std::shared_ptr<work::Workers>& workers) {
  render::TileRenderer::Options options;
  options.workers = workers;
  options.previews = false;
  return options;
}

}  // namespace

/// The map drawn once more, aside.
struct ExpectedController::Drawing {
  Drawing(QString picture, const WindowContext& context)
      : expected(std::move(picture)), scene(exactTiles(context.workers)) {
    const scene::MapScene& shown = context.scene;
    scene.setTheme(shown.theme());
    scene.setColorMode(shown.colorMode());
    scene.setLayerOrder(shown.layerOrder());
    for (const scene::Layer layer : scene::allLayers()) {
      scene.setLayerVisible(layer, shown.layerVisible(layer));
      scene.setLayerOpacity(layer, shown.layerOpacity(layer));
      scene.setLayerStyle(layer, shown.layerStyle(layer));
    }
    const QJsonObject drawn = compare::drawnBeside(expected);
    if (drawn.isEmpty()) return;
    scene.setTheme(drawn[QLatin1String("theme")] == QLatin1String("dark") ? scene::darkMapTheme()
                                                                          : scene::lightMapTheme());
    const QJsonArray layers = drawn[QLatin1String("layers")].toArray();
    for (const scene::Layer layer : scene::allLayers())
      scene.setLayerVisible(layer, layers.contains(scene::layerName(layer)));
  }

  QString expected;
  geometry::ViewTransform view;
  scene::MapScene scene;
};

ExpectedController::ExpectedController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context) {
  context_.actions.add({.id = "compareExpected",
                        .text = tr("Compare &with expected…"),
                        .tip = tr("Compare the map with an expected picture of the same place"),
                        .needs_session = true,
                        .menu = {MenuGroup::Exports, 20}},
                       this, &ExpectedController::askAndCompare);
}

ExpectedController::~ExpectedController() = default;

void ExpectedController::setSession(session::Session*) { drawing_.reset(); }

void ExpectedController::tell(const QString& problem) { context_.overlay.toasts()->add(Mark::Bad, problem); }

void ExpectedController::askAndCompare() {
  const QString path = QFileDialog::getOpenFileName(&context_.window, tr("Compare with an expected picture"),
                                                    context_.settings.value(kExpectedFolderKey).toString(),
                                                    tr("PNG pictures (*.png)"));
  if (path.isEmpty()) return;
  context_.settings.setValue(kExpectedFolderKey, QFileInfo(path).absolutePath());
  compareWith(path);
}

void ExpectedController::compareWith(const QString& picture) {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const QString name = QFileInfo(picture).fileName();
  const auto read = compare::PictureReading::open(picture.toStdString());
  if (!read) return tell(sentences::sentenceOf(read.error()));
  const auto view = compare::viewBeside(picture, read->size());
  if (!view)
    return tell(
        tr("No report beside %1 says which part of the map it shows. snapshot --report and suite accept "
           "write one.")
            .arg(name));
  if (read->size().pixels() > kMostDrawnPixels)
    return tell(tr("%1 is too large to be compared here. The command suite has no such limit.").arg(name));
  drawing_ = std::make_unique<Drawing>(picture, context_);
  drawing_->view = *view;
  drawing_->scene.setView(*view);
  drawing_->scene.setSession(session);
  connect(&drawing_->scene, &scene::MapScene::tilesSettled, this, &ExpectedController::take,
          Qt::QueuedConnection);
  QTimer::singleShot(0, &drawing_->scene, [this] { take(); });
}

void ExpectedController::take() {
  if (!drawing_ || !drawing_->scene.picturesSettled()) return;
  const std::unique_ptr<Drawing> drawn = std::move(drawing_);
  const QSize size(drawn->view.width_px, drawn->view.height_px);
  QImage image(size, QImage::Format_RGB32);
  QTemporaryDir folder;
  const QString actual = folder.filePath(QStringLiteral("actual.png")),
                difference = folder.filePath(QStringLiteral("difference.png"));
  if (image.isNull() || !folder.isValid()) return tell(tr("There is not enough room to draw the map again."));
  QPainter painter(&image);
  const QRectF whole(QPointF(0, 0), QSizeF(size));
  drawn->scene.render(&painter, whole, whole);
  painter.end();
  if (!image.save(actual)) return tell(tr("There is not enough room to draw the map again."));
  const auto made = compare::comparePictures(drawn->expected.toStdString(), actual.toStdString(), {});
  if (!made) return tell(sentences::sentenceOf(made.error()));
  if (const auto fault = compare::writeDifference(*made, drawn->expected.toStdString(), actual.toStdString(),
                                                  difference.toStdString()))
    return tell(sentences::sentenceOf(*fault));
  show(compare::comparisonText(*made, drawn->view), difference);
}

void ExpectedController::show(const QString& sentence, const QString& difference) {
  delete dialog_;
  dialog_ = new QDialog(&context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  dialog_->setWindowTitle(tr("Compared with the expected picture"));
  auto* const picture = new QLabel(dialog_);
  QPixmap pixels(difference);
  if (pixels.width() > kLargestShown.width() || pixels.height() > kLargestShown.height())
    pixels = pixels.scaled(kLargestShown, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  picture->setPixmap(pixels);
  picture->setAccessibleName(tr("What differs"));
  auto* const area = new QScrollArea(dialog_);
  area->setWidget(picture);
  area->setAccessibleName(tr("What differs"));
  area->setMinimumSize(pixels.size().boundedTo(QSize(640, 480)) + QSize(4, 4));
  auto* const close = new QPushButton(tr("Close"), dialog_);
  giveRoles(*close, {});
  connect(close, &QPushButton::clicked, dialog_, &QDialog::reject);
  dialog_->setLayout(columnOf({textLabel(sentence, dialog_), {area, 1}, rowOf({LayoutItem::rest(), close})}));
  dialog_->open();
}

}  // namespace mapwright::window

#include "moc_expected_controller.cpp"
