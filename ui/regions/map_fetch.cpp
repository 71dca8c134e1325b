#include "ui/regions/map_fetch.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QPushButton>
#include <QStandardPaths>
#include <QTime>

#include "grids/grid_pyramid.h"
#include "jobs/export_map.h"
#include "regions/region_sentence.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/folders.h"
#include "ui/regions/regions_text.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

using scene::Layer;

const QString kRegionsFolderKey = QStringLiteral("regions/folder");

}  // namespace

MapFetch::MapFetch(WindowContext& context, QObject* parent)
    : QObject(parent), context_(context), showing_(context.workers), export_(context.workers) {
  every_second_.setInterval(1000);
  connect(&every_second_, &QTimer::timeout, this, &MapFetch::changed);
}

MapFetch::~MapFetch() = default;

void MapFetch::setDispatch(robot::MapDispatch* dispatch, const regions::RegionMap* map) {
  stop();
  dispatch_ = dispatch;
  map_ = map;
}

void MapFetch::closeQuestion() {
  if (question_) question_->close();
}

Notice MapFetch::notice() {
  if (fetch_) {
    const regions::RegionCounts counts = fetch_->counts();
    return {Mark::Busy,
            tr("Fetching the region: %1 of %2 parts received.")
                .arg(countText(counts.answered), countText(counts.in_view)),
            tr("Cancel"), [this] { stop(); }};
  }
  if (whole_in_progress_) {
    const auto extent = dispatch_ ? dispatch_->extent() : std::nullopt;
    return {Mark::Busy, wholeProgressText(whole_bytes_, whole_began_.elapsed() / 1000, extent), tr("Cancel"),
            [this] { stop(); }};
  }
  return {};
}

void MapFetch::toast(Mark mark, const QString& text) { context_.overlay.toasts()->add(mark, text); }

void MapFetch::stop() {
  ++job_;
  whole_.cancel();
  whole_ = {};
  whole_in_progress_ = false;
  every_second_.stop();
  if (fetch_) fetch_.release()->deleteLater();  // it may be emitting just now
  showing_.forget();
  export_.forget();
  Q_EMIT changed();
}

void MapFetch::fetchWhole() {
  if (!dispatch_ || question_) return;
  const auto extent = dispatch_->extent();
  if (const QString why = notWholeReason(extent); !why.isEmpty()) return refuseWhole(why);
  question_ = new QMessageBox(
      QMessageBox::Question, tr("Fetch the whole map"),
      tr("Fetch the whole map at once? %1").arg(wholeSizeText(map_ ? &map_->regions() : nullptr, extent)),
      QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Cancel);
  sayReplaced();
  QPushButton* const yes = question_->addButton(tr("Fetch"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("fetchWhole"));
  connect(yes, &QPushButton::clicked, this, &MapFetch::startWhole);
  question_->open();
}

void MapFetch::refuseWhole(const QString& why) {
  question_ = new QMessageBox(QMessageBox::Information, tr("Fetch the whole map"), why, QMessageBox::Close,
                              &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  if (dispatch_->offered(robot::DispatchService::GridRegion)) {
    QPushButton* const region = question_->addButton(tr("Fetch a region…"), QMessageBox::AcceptRole);
    region->setObjectName(QStringLiteral("fetchRegionInstead"));
    question_->setDefaultButton(region);
    connect(region, &QPushButton::clicked, this, &MapFetch::regionWanted);
  }
  question_->open();
}

void MapFetch::startWhole() {
  if (!dispatch_) return;
  stop();
  whole_in_progress_ = true;
  whole_bytes_ = 0;
  whole_began_.start();
  every_second_.start();
  whole_ = dispatch_->grid(std::nullopt,
                           [self = QPointer(this), job = job_](const robot::Outcome<map::GridPart>& outcome) {
                             if (self && job == self->job_) self->endWhole(outcome);
                           });
  whole_.onProgress([self = QPointer(this), job = job_](const robot::Progress& progress) {
    if (!self || job != self->job_) return;
    self->whole_bytes_ = std::max(self->whole_bytes_, qint64(progress.bytes));
    Q_EMIT self->changed();
  });
  Q_EMIT changed();
}

void MapFetch::endWhole(const robot::Outcome<map::GridPart>& outcome) {
  whole_in_progress_ = false;
  every_second_.stop();
  whole_ = {};
  if (!outcome) {
    toast(Mark::Bad, tr("The whole map was not fetched: %1")
                         .arg(QString::fromStdString(sentences::sentenceOf(outcome.error()))));
  } else if (const auto flaw = regions::flawOf(*outcome); flaw != regions::Misfit::None) {
    const regions::RegionTrouble trouble{regions::RegionTrouble::Kind::Misplaced, {}, flaw};
    toast(Mark::Bad, tr("The whole map was not fetched: %1").arg(regions::sentenceOf(trouble)));
  } else {
    show([cells = outcome->cells] { return cells; }, outcome->grid, tr("Whole map"));
  }
  Q_EMIT changed();
}

void MapFetch::show(std::function<map::OccupancyCells()> cells, const map::GridReference& grid,
                    const QString& name) {
  // Another one is another map, even if equally large.
  const QString id = tr("fetched %1").arg(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")));
  // Copying hundreds of millions of cells takes a while.
  showing_.start([this, cells = std::move(cells), grid, name, id](const auto&) -> BackgroundRun::Then {
    map::WholeMap map;
    map.key = {map::MapKind::Stored, id.toStdString()};
    // Its dispatcher's map is the map that the robot is in.
    map.state_of = map::MapKey{map::MapKind::Live, {}};
    map.name = name.toStdString();
    map.grid = grid;
    map.reading = {map::CellReading::Mode::Raw};
    map.cells = cells();
    return [this, map = std::move(map)] {
      session::Session* const session = context_.current.session();
      if (!session) return;
      session->wholeMap().show(map);
      kept_ = map.key;
      context_.scene.setLayerVisible(Layer::WholeMap, true);
      context_.scene.setLayerVisible(Layer::Regions, false);
      toast(Mark::Good,
            tr("%1 is shown. The layer \"Map by regions\" is hidden.").arg(QString::fromStdString(map.name)));
    };
  });
}

void MapFetch::sayReplaced() {
  if (const std::vector<Fetched> kept = fetched(); !kept.empty())
    question_->setInformativeText(
        tr("\"Keep on screen\" replaces %1, which is not saved.").arg(kept.front().name));
}

void MapFetch::onRectangle(const geometry::WorldRect& drawn) {
  if (!map_ || question_) return;
  const geometry::WorldRect rect = wholeCells(map_->regions(), drawn);
  question_ = new QMessageBox(QMessageBox::Question, tr("Fetch a region"),
                              rectangleText(map_->regions(), rect), QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  sayReplaced();
  QPushButton* const keep = question_->addButton(tr("Keep on screen"), QMessageBox::AcceptRole);
  keep->setObjectName(QStringLiteral("keepRegion"));
  QPushButton* const save = question_->addButton(tr("Save as PGM and YAML…"), QMessageBox::AcceptRole);
  save->setObjectName(QStringLiteral("saveRegion"));
  connect(keep, &QPushButton::clicked, this, [this, rect] { keepRectangle(rect); });
  connect(save, &QPushButton::clicked, this, [this, rect] {
    const QString path = askWhere();
    if (path.isEmpty()) return;
    saveRectangle(rect, path);
  });
  question_->open();
}

void MapFetch::saveRectangle(const geometry::WorldRect& rect, const QString& path) {
  startRectangle(rect, Then::Save, path);
}

void MapFetch::keepRectangle(const geometry::WorldRect& rect) { startRectangle(rect, Then::Show, {}); }

void MapFetch::startRectangle(const geometry::WorldRect& rect, Then then, const QString& path) {
  if (!dispatch_) return;
  stop();
  then_ = then;
  path_ = path;
  existing_ = disk::existingNow(path.toStdString());
  fetch_ = std::make_unique<regions::RegionFetch>(*dispatch_, rect, regions::RegionFetch::Options{});
  connect(fetch_.get(), &regions::RegionFetch::progressed, this, &MapFetch::changed);
  connect(fetch_.get(), &regions::RegionFetch::finished, this, &MapFetch::endRectangle);
  fetch_->start();
  Q_EMIT changed();
}

void MapFetch::endRectangle() {
  const std::unique_ptr<regions::RegionFetch, void (*)(regions::RegionFetch*)> fetch(
      fetch_.release(), [](regions::RegionFetch* one) { one->deleteLater(); });
  Q_EMIT changed();
  if (fetch->tooLarge()) {
    return toast(Mark::Bad, tr("This region is too large to be fetched at once: %1")
                                .arg(rectangleText(fetch->map().regions(), fetch->rect())));
  }
  const QString why = regions::sentenceOf(fetch->trouble());
  const regions::RegionCounts counts = fetch->counts();
  const regions::FetchedGrid fetched = regions::cutOut(fetch->map().regions().sheets(), fetch->rect());
  if (!fetched.cells) {
    return toast(Mark::Bad, why.isEmpty() ? tr("The map is empty in this region.")
                                          : tr("The region was not fetched: %1").arg(why));
  }
  if (!fetch->complete() && counts.smaller == 0) {
    toast(Mark::Warning, tr("Parts of the region are missing and shown as unknown (%1 of %2 arrived): %3")
                             .arg(countText(counts.answered), countText(counts.in_view), why));
  } else if (counts.smaller > 0) {
    toast(Mark::Warning, tr("The robot's answers are smaller than the requested regions: the missing parts "
                            "are shown as unknown."));
  } else if (fetched.other_lattices > 0) {
    toast(Mark::Warning,
          tr("Some of the answers have cells of another size or orientation and were left out."));
  }
  if (then_ == Then::Save) return write({fetched.cells, fetched.reference}, path_, existing_, {});
  show([cells = fetched.cells] { return regions::cellsOf(*cells); }, fetched.reference,
       tr("Region %1").arg(areaText(fetch->rect())));
}

void MapFetch::write(const jobs::WholeMapExport& map, const QString& path, disk::Existing existing,
                     std::function<void()> then) {
  const jobs::ExportRequest request{map, jobs::ExportFormat::MapServer, path, false, {}, existing};
  export_.start([this, request, then = std::move(then),
                 workers = context_.workers](const BackgroundRun::Running& run) -> BackgroundRun::Then {
    return [this, then, result = jobs::exportMap(request, run.proceed, {workers})] {
      if (!result.error.isEmpty()) return toast(Mark::Bad, result.error);
      toast(Mark::Good, tr("Saved %1")
                            .arg(words::listed(jobs::exportedFiles(QDir::toNativeSeparators(result.path),
                                                                   jobs::ExportFormat::MapServer, false))));
      if (then) then();
    };
  });
}

std::vector<Fetched> MapFetch::fetched() {
  const session::Session* const session = context_.current.session();
  if (!kept_ || !session) return {};
  const session::MapSlot& slot = session->wholeMap();
  if (!slot.cells() || !(slot.shown().key == *kept_)) return {};
  return {
      {mapCalled(slot.name(), slot.key()), [this](const std::function<void()>& saved) { saveKept(saved); }}};
}

void MapFetch::saveKept(const std::function<void()>& then) {
  const session::Session* const session = context_.current.session();
  if (!session || !session->wholeMap().cells()) return;
  const session::MapSlot& slot = session->wholeMap();
  if (!slot.cells()->complete()) return toast(Mark::Warning, tr("The map is still loading."));
  if (const QString path = askWhere(); !path.isEmpty()) {
    write({slot.cells(), slot.reference()}, path, disk::existingNow(path.toStdString()), [this, then] {
      markSaved();
      then();
    });
  }
}

QString MapFetch::askWhere() {
  const QDir folder(folderToWriteInto({context_.settings.value(kRegionsFolderKey).toString(),
                                       QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}));
  const QString path = QFileDialog::getSaveFileName(&context_.window, tr("Save the region"),
                                                    folder.filePath(QStringLiteral("region.yaml")),
                                                    tr("Maps for map_server (*.yaml)"));
  if (!path.isEmpty()) context_.settings.setValue(kRegionsFolderKey, QFileInfo(path).absolutePath());
  return path;
}

}  // namespace mapwright::ui

#include "moc_map_fetch.cpp"
