#include "ui/maps/map_files.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "map/grid_reference.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {

bool endsWithAny(const QString& path, std::initializer_list<const char*> suffixes) {
  return std::any_of(suffixes.begin(), suffixes.end(), [&](const char* suffix) {
    return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
  });
}

QString exact(double value) { return QString::number(value, 'g', 15); }

}  // namespace

bool isMapYaml(const QString& path) { return endsWithAny(path, {".yaml", ".yml"}); }
bool isBarePicture(const QString& path) { return endsWithAny(path, {".png", ".pgm", ".bmp"}); }
bool isRecordingFile(const QString& path) {
  return endsWithAny(path, {".mcap", ".bag", ".db3", ".mcap.zstd", ".bag.zstd", ".db3.zstd", ".mcap.zst",
                            ".bag.zst", ".db3.zst"});
}
bool isOverlayFile(const QString& path) { return endsWithAny(path, {".geojson"}); }
bool isStateFile(const QString& path) { return endsWithAny(path, {".pbstream"}); }

QString fileAddress(const QString& path, const std::optional<PicturePlacement>& placement) {
  const QString address = QStringLiteral("file:") + QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  if (!placement) return address;
  return address + QStringLiteral("?resolution=") + exact(placement->resolution_m) +
         QStringLiteral("&origin=") + exact(placement->origin.x_m) + QLatin1Char(',') +
         exact(placement->origin.y_m) + QLatin1Char(',') + exact(placement->origin.yaw_rad);
}

QString droppedMap(const QList<QUrl>& urls) {
  QString picture;
  for (const QUrl& url : urls) {
    if (!url.isLocalFile()) continue;
    const QString path = url.toLocalFile();
    // Dropping a map.yaml together with its picture means the map.
    if (isMapYaml(path) || isRecordingFile(path) || isStateFile(path) || QFileInfo(path).isDir()) return path;
    if (picture.isEmpty() && (isBarePicture(path) || isOverlayFile(path))) picture = path;
  }
  return picture;
}

QString mapFileFilter() {
  return QCoreApplication::translate(
      "window",
      "Maps and recordings (*.yaml *.yml *.png *.pgm *.bmp *.geojson *.pbstream *.mcap *.bag *.db3 *.zstd "
      "*.YAML *.PNG *.PGM *.BMP);;"
      "ROS maps (*.yaml *.yml);;Pictures (*.png *.pgm *.bmp);;Overlays (*.geojson);;SLAM states of "
      "Cartographer (*.pbstream);;Recordings (*.mcap *.bag *.db3 *.zstd metadata.yaml);;"
      "All files (*)");
}

namespace {

std::optional<double> numberIn(const QString& text) {
  bool fine = false;
  QString plain = text.trimmed();
  if (!plain.contains(QLatin1Char('.'))) plain.replace(QLatin1Char(','), QLatin1Char('.'));
  const double value = plain.toDouble(&fine);
  return fine && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<PicturePlacement> placementFrom(const QString& resolution, const QString& x, const QString& y,
                                              const QString& yaw_deg) {
  const auto cell = numberIn(resolution), east = numberIn(x), north = numberIn(y), yaw = numberIn(yaw_deg);
  if (!cell || !east || !north || !yaw) return std::nullopt;
  return PicturePlacement{*cell, {*east, *north, geometry::radiansFromDegrees(*yaw)}};
}

}  // namespace

QString noPlacementReason(const QString& resolution, const QString& x, const QString& y,
                          const QString& yaw_deg) {
  const auto cell = numberIn(resolution);
  if (!cell) return PictureDialog::tr("The resolution must be a number in metres, for example 0.05.");
  if (*cell <= 0)
    return PictureDialog::tr(
        "The resolution must be greater than 0: it is the edge length of a cell in metres.");
  const auto placement = placementFrom(resolution, x, y, yaw_deg);
  if (!placement)
    return PictureDialog::tr("The origin needs three numbers: x and y in metres, yaw in degrees.");
  map::GridReference grid;
  grid.resolution_m = placement->resolution_m;
  grid.origin = placement->origin;
  const auto problem = map::unusableReason(grid);
  return problem ? sentences::sentenceOf(*problem) : QString();
}

namespace {

QString intro(const QString& picture, const QStringList& named_by) {
  const QString question =
      PictureDialog::tr("How large is a cell, and where is the lower-left corner of the picture?");
  if (named_by.isEmpty())
    return PictureDialog::tr("%1 is a picture without a map.yaml. %2").arg(picture, question);
  constexpr qsizetype kMostNames = 4;
  QStringList names;
  for (const QString& path : named_by.mid(0, kMostNames)) names << plainWords(QFileInfo(path).fileName(), 60);
  if (named_by.size() > kMostNames) names << QStringLiteral("…");
  return PictureDialog::tr(
             "Several map.yaml files name %1: %2. Open the right one instead, or enter the values here. %3")
      .arg(picture, words::listed(names), question);
}

}  // namespace

PictureDialog::PictureDialog(const QString& path, const QStringList& named_by, const QString& accept_text,
                             QWidget* parent)
    : QDialog(parent),
      resolution_(new QLineEdit(QStringLiteral("0.05"), this)),
      x_(new QLineEdit(QStringLiteral("0"), this)),
      y_(new QLineEdit(QStringLiteral("0"), this)),
      yaw_(new QLineEdit(QStringLiteral("0"), this)),
      intro_(new QLabel(this)),
      error_(new QLabel(this)),
      open_(new QPushButton(accept_text, this)) {
  setWindowTitle(tr("Position of the picture"));
  setMinimumWidth(440);
  intro_->setTextFormat(Qt::PlainText);
  intro_->setWordWrap(true);
  intro_->setText(intro(plainWords(QFileInfo(path).fileName(), 120), named_by));
  resolution_->setObjectName(QStringLiteral("resolution"));
  x_->setObjectName(QStringLiteral("originX"));
  y_->setObjectName(QStringLiteral("originY"));
  yaw_->setObjectName(QStringLiteral("originYaw"));
  error_->setTextFormat(Qt::PlainText);
  error_->setWordWrap(true);
  error_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  error_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  setTextColor(*error_, appColors().error_text);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->addRow(tr("&Resolution, metres per cell"), resolution_);
  form->addRow(tr("Origin &x, metres"), x_);
  form->addRow(tr("Origin &y, metres"), y_);
  form->addRow(tr("Origin ya&w, degrees"), yaw_);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*open_, {cancel});
  setLayout(columnOf({intro_, form, error_, rowOf({LayoutItem::rest(), cancel, open_}, 8)}, 10,
                     QMargins(16, 16, 16, 16)));
  for (QLineEdit* field : {resolution_, x_, y_, yaw_})
    connect(field, &QLineEdit::textChanged, this, &PictureDialog::check);
  connect(open_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  resolution_->selectAll();
  check();
}

std::optional<PicturePlacement> PictureDialog::placement() const {
  if (!errorText().isEmpty()) return std::nullopt;
  return placementFrom(resolution_->text(), x_->text(), y_->text(), yaw_->text());
}

QString PictureDialog::introText() const { return intro_->text(); }

QString PictureDialog::errorText() const {
  return noPlacementReason(resolution_->text(), x_->text(), y_->text(), yaw_->text());
}

void PictureDialog::check() {
  const QString error = errorText();
  error_->setText(error);
  open_->setEnabled(error.isEmpty());
}

PicturePlacing::PicturePlacing(QWidget* window,
                               std::function<QStringList(const QString& picture)> yamls_naming,
                               std::shared_ptr<work::Workers> workers)
    : QObject(window), window_(window), yamls_naming_(std::move(yamls_naming)), share_(std::move(workers)) {}

void PicturePlacing::place(const QString& path, const QString& accept_text, const Then& then) {
  const quint64 asked = ++asked_;
  const auto know = [this, asked, path, accept_text, then](const QStringList& yamls) {
    if (asked != asked_) return;
    yamls.size() == 1 ? then(fileAddress(yamls.front())) : ask(path, yamls, accept_text, then);
  };
  if (!yamls_naming_) return know({});
  // A folder on a slow network drive must not block the window.
  share_.startLong([this, know, path] {
    QMetaObject::invokeMethod(
        this, [know, yamls = yamls_naming_(path)] { know(yamls); }, Qt::QueuedConnection);
  });
}

PictureDialog* PicturePlacing::dialog() const { return dialog_; }

void PicturePlacing::ask(const QString& path, const QStringList& named_by, const QString& accept_text,
                         const Then& then) {
  delete dialog_;
  dialog_ = new PictureDialog(path, named_by, accept_text, window_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &QDialog::accepted, this, [this, path, then] {
    if (const auto placement = dialog_->placement()) then(fileAddress(path, placement));
  });
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_map_files.cpp"
