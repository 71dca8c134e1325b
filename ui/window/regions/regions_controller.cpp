#include "window/regions/regions_controller.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QActionGroup>
#include <QDir>
#include <QFileDialog>
#include <QMenu>
#include <QPushButton>
#include <QStandardPaths>

#include "scene/regions_on_map.h"
#include "sentences/failure_sentence.h"
#include "sentences/region_sentence.h"
#include "window/current_session.h"
#include "window/files/export_map.h"
#include "window/files/folders.h"
#include "window/look/plain_label.h"
#include "window/map/map_overlay.h"
#include "window/map/map_view.h"
#include "window/map/toast_stack.h"
#include "window/map/tool_choice.h"
#include "window/notices.h"
#include "window/on_screen.h"
#include "window/regions/rectangle_tool.h"
#include "window/regions/regions_text.h"
#include "window/regions/save_map_dialog.h"
#include "window/status/window_status_bar.h"
#include "window/viewpoint.h"
#include "words/qt_plain.h"

namespace mapwright::window {
namespace {

using robot::DispatchService;
using scene::Layer;

const QString kEveryKey = QStringLiteral("regions/refresh_s");
const QString kFolderKey = QStringLiteral("regions/folder");
constexpr int kLookEveryMs = 120;  // while the camera moves
constexpr std::array kEveryS{0, 10, 60, 600};
constexpr double kBytesOfRegion = 1024 * 1024 * 4 / 3.0;
constexpr double kFirstViewM = 60;
constexpr int kLeastInView = 6, kMostInView = 72;

regions::RegionMap::Options mapOptions(const work::Budgets& budgets) {
  regions::RegionMap::Options options;
  const double bytes = double(budgets.regions);
  options.regions.budget_bytes = std::size_t(bytes);
  // What is in view is never given up, so it must fit.
  options.regions.plan.most_in_view =
      int(std::clamp(bytes / kBytesOfRegion / 2, double(kLeastInView), double(kMostInView)));
  return options;
}

}  // namespace

RegionsController::RegionsController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      tool_(new RectangleTool([this] { return context_.scene.view(); },
                              [this](const geometry::WorldRect& rect) {
                                return map_ ? rectangleText(map_->regions(), rect) : areaText(rect);
                              },
                              this)),
      every_(new QActionGroup(this)),
      status_(new PlainLabel(&context.bar)),
      share_(context.workers) {
  addActions();
  status_->setObjectName(QStringLiteral("regionsStatus"));
  status_->setSample(QStringLiteral("0,000 of 0,000 regions, 000.0 MB"));
  status_->setSecondary(true);
  status_->hide();
  context_.bar.addPermanentWidget(status_);
  look_soon_.setSingleShot(true);
  look_soon_.setInterval(kLookEveryMs);
  connect(&look_soon_, &QTimer::timeout, this, &RegionsController::look);
  connect(&refresh_timer_, &QTimer::timeout, this, [this] {
    if (map_ && online()) map_->refresh();
  });
  connect(&context_.scene, &scene::MapScene::viewChanged, this, [this] {
    if (map_ && !look_soon_.isActive()) look_soon_.start();
  });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &RegionsController::look);
  connect(tool_, &RectangleTool::drawn, this, &RegionsController::takeRectangle);
  tell();
}

RegionsController::~RegionsController() {
  scene::RegionsOnMap::of(context_.scene).show(nullptr);
  if (status_) delete status_;
}

void RegionsController::addActions() {
  refresh_ = context_.actions.add({.id = "refreshRegions",
                                   .text = tr("&Fetch the regions anew"),
                                   .icon = "retry",
                                   .tip = tr("Ask for all regions in view once more"),
                                   .menu = {MenuGroup::WholeMap, 30}},
                                  this, [this] {
                                    if (map_) map_->refresh();
                                  });
  auto* const menu = new QMenu(tr("Fetch regions anew b&y itself"), &context_.window);
  menu->menuAction()->setObjectName(QStringLiteral("refreshRegionsEvery"));
  const std::array titles{tr("Never"), tr("Every 10 seconds"), tr("Every minute"), tr("Every 10 minutes")};
  for (std::size_t at = 0; at < kEveryS.size(); ++at) {
    QAction* const action = every_->addAction(titles[at]);
    action->setCheckable(true);
    action->setData(kEveryS[at]);
    menu->addAction(action);
  }
  connect(every_, &QActionGroup::triggered, this,
          [this](const QAction* action) { setRefreshEvery(action->data().toInt()); });
  context_.actions.place({MenuGroup::WholeMap, 40}, menu->menuAction());
  fetch_whole_ = context_.actions.add({.id = "fetchWholeMap",
                                       .text = tr("Fetch the &whole map…"),
                                       .icon = "download",
                                       .tip = tr("Ask the robot for all of its map at once"),
                                       .menu = {MenuGroup::WholeMap, 50}},
                                      this, &RegionsController::fetchWhole);
  save_map_ = context_.actions.add({.id = "saveMapOnRobot",
                                    .text = tr("&Save the map on the robot…"),
                                    .icon = "download",
                                    .tip = tr("The robot writes its map into a file of its own"),
                                    .menu = {MenuGroup::WholeMap, 60}},
                                   this, &RegionsController::saveOnRobot);
  fetch_region_ = context_.actions.add({.id = "fetchRegion",
                                        .text = tr("Fetch a regi&on…"),
                                        .icon = "rectangle",
                                        .tip = tr("Draw a rectangle, fetch it, save it or keep it on screen"),
                                        .toggle = true,
                                        .menu = {MenuGroup::Tools, 30}});
  context_.tools.add(tool_, fetch_region_);
  setRefreshEvery(0);
}

void RegionsController::setSession(session::Session* session) {
  stopJob();
  if (question_) question_->close();
  if (save_dialog_) save_dialog_->close();
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &RegionsController::follow);
    connect(session, &session::Session::connectionChanged, this, [this] {
      if (map_ && online()) map_->retryNow();
      look();
    });
    connect(session, &session::Session::liveChanged, this, &RegionsController::lookAtRobot);
  }
  looked_at_robot_ = false;
  follow();
}

void RegionsController::recall(const QSettings& settings) {
  setRefreshEvery(settings.value(kEveryKey, 0).toInt());
}

void RegionsController::remember(QSettings& settings) { settings.setValue(kEveryKey, refresh_every_s_); }

void RegionsController::setRefreshEvery(int seconds) {
  refresh_every_s_ = std::find(kEveryS.begin(), kEveryS.end(), seconds) == kEveryS.end() ? 0 : seconds;
  for (QAction* action : every_->actions()) action->setChecked(action->data().toInt() == refresh_every_s_);
  refresh_timer_.stop();
  if (refresh_every_s_ > 0) refresh_timer_.start(refresh_every_s_ * 1000);
}

bool RegionsController::online() const {
  const session::Session* const session = context_.current.session();
  return session && session->connection().phase == robot::ConnectionPhase::Online;
}

void RegionsController::follow() {
  session::Session* const session = context_.current.session();
  robot::MapDispatch* const dispatch = session ? session->robot().mapDispatch() : nullptr;
  if (dispatch == dispatch_ && (map_ != nullptr) == (dispatch != nullptr)) return;
  stopJob();
  if (dispatch_) dispatch_->disconnect(this);
  dispatch_ = dispatch;
  scene::RegionsOnMap::of(context_.scene).show(nullptr);
  map_.reset();
  if (dispatch_) {
    map_ = std::make_unique<regions::RegionMap>(*dispatch_, mapOptions(context_.budgets));
    connect(map_.get(), &regions::RegionMap::changed, this, &RegionsController::tell);
    connect(dispatch_, &robot::MapDispatch::offersChanged, this, &RegionsController::tell);
    scene::RegionsOnMap::of(context_.scene).show(map_.get());
  }
  look();
  Q_EMIT context_.current.stateChanged();
}

void RegionsController::lookAtRobot() {
  const session::Session* const session = context_.current.session();
  if (looked_at_robot_ || !map_ || !map_->offered() || !session || !session->live().robot_pose) return;
  looked_at_robot_ = true;
  if (context_.viewpoint.chosen() || session->wholeMap().cells()) return;
  geometry::WorldRect around;
  around.extend(session->live().robot_pose->apply({0, 0}));
  context_.viewpoint.fit(around.grown(kFirstViewM / 2));
}

void RegionsController::showRegions() {
  session::Session* const session = context_.current.session();
  if (!session) return;
  session->wholeMap().clear();
  context_.scene.setLayerVisible(Layer::Regions, true);
  look();
}

void RegionsController::look() {
  if (map_) {
    const geometry::ViewTransform& view = context_.scene.view();
    const bool wanted = online() && context_.scene.layerVisible(Layer::Regions) && !comparing(context_.scene);
    map_->setView(wanted ? std::optional(view.visibleWorld()) : std::nullopt, view.center_m);
  }
  tell();
}

QString RegionsController::statusShown() const { return status_ && map_ ? status_->text() : QString(); }

void RegionsController::tell() {
  const bool by_region = map_ && map_->offered();
  const bool left = map_ && !by_region && online() && map_->regions().bytes() > 0;
  const bool whole = dispatch_ && dispatch_->offered(DispatchService::Grid);
  const bool busy = fetch_ || whole_under_way_;
  refresh_->setEnabled(by_region);
  fetch_whole_->setEnabled(whole && online() && !busy);
  save_map_->setEnabled(dispatch_ && dispatch_->offered(DispatchService::Save) && online() && !save_dialog_);
  fetch_region_->setEnabled(by_region && online() && !busy);
  if (!fetch_region_->isEnabled() && context_.tools.chosen() == tool_) context_.tools.putAway();
  if (status_) {
    status_->setVisible(by_region || left);
    if (by_region || left) status_->setText(regionsStatus(map_->regions()));
  }
  if (fetch_) {
    const regions::RegionCounts counts = fetch_->counts();
    context_.notices.set(NoticeRank::Regions,
                         {Mark::Busy,
                          tr("The region is being fetched: %1 of %2 parts are there.")
                              .arg(countText(counts.answered), countText(counts.in_view)),
                          tr("Cancel"), [this] { stopJob(); }});
    return;
  }
  if (whole_under_way_) {
    context_.notices.set(NoticeRank::Regions, {Mark::Busy, tr("The whole map is being fetched."),
                                               tr("Cancel"), [this] { stopJob(); }});
    return;
  }
  const RegionsNotice notice =
      by_region ? regionsNotice(map_->regions(), whole)
      : left    ? RegionsNotice{Mark::Warning, tr("The robot gives no regions of its map any more. "
                                                     "What came of it stays.")}
                : RegionsNotice{};
  const bool is_about_whole = notice.offer == RegionsNotice::Offer::Whole;
  context_.notices.set(NoticeRank::Regions, {notice.mark, notice.sentence,
                                             is_about_whole ? tr("Fetch the whole map…")
                                             : notice.offer == RegionsNotice::Offer::Retry ? tr("Retry")
                                                                                           : QString(),
                                             [this, is_about_whole] {
                                               if (is_about_whole) return fetchWhole();
                                               if (map_) map_->retryNow();
                                             },
                                             is_about_whole});
}

void RegionsController::toast(Mark mark, const QString& text) { context_.overlay.toasts()->add(mark, text); }

void RegionsController::saveOnRobot() {
  if (!dispatch_ || save_dialog_) return;
  save_dialog_ = new SaveMapDialog(&context_.window);
  connect(save_dialog_, &QDialog::finished, this, [this] {
    saving_.cancel();
    save_dialog_.clear();  // it goes by itself
    tell();
  });
  connect(save_dialog_, &SaveMapDialog::saveWanted, this, [this](const QString& filename) {
    if (!dispatch_) return save_dialog_->refuse(tr("The robot is not there any more."));
    save_dialog_->wait();
    saving_ = dispatch_->save(filename.toStdString(), [self = QPointer(this),
                                                       filename](const robot::Outcome<std::string>& outcome) {
      if (!self || !self->save_dialog_) return;
      if (!outcome) {
        return self->save_dialog_->refuse(QString::fromStdString(sentences::sentenceOf(outcome.error())));
      }
      self->toast(
          Mark::Good,
          tr("The robot has saved its map as %1.").arg(words::plainName(QString::fromStdString(*outcome))));
      self->save_dialog_->accept();
    });
  });
  save_dialog_->open();
  tell();
}

void RegionsController::stopJob() {
  ++job_;
  whole_.cancel();
  whole_ = {};
  whole_under_way_ = false;
  if (fetch_) fetch_.release()->deleteLater();  // it may be telling just now
  export_.reset();
  tell();
}

void RegionsController::fetchWhole() {
  if (!dispatch_ || question_) return;
  question_ = new QMessageBox(
      QMessageBox::Question, tr("Fetch the whole map"),
      tr("Fetch all of the map at once? %1")
          .arg(map_ ? wholeSizeText(map_->regions()) : tr("How large it is, is not known yet.")),
      QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Cancel);
  QPushButton* const yes = question_->addButton(tr("Fetch"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("fetchWhole"));
  connect(yes, &QPushButton::clicked, this, &RegionsController::startWhole);
  question_->open();
}

void RegionsController::startWhole() {
  if (!dispatch_) return;
  stopJob();
  whole_under_way_ = true;
  whole_ = dispatch_->grid(
      std::nullopt, [self = QPointer(this), job = job_](robot::Outcome<map::GridPart> outcome) {
        if (!self || job != self->job_) return;
        self->whole_under_way_ = false;
        self->whole_ = {};
        if (!outcome) {
          self->toast(Mark::Bad, tr("The whole map was not fetched: %1")
                                     .arg(QString::fromStdString(sentences::sentenceOf(outcome.error()))));
        } else if (const map::GridPart& part = *outcome;
                   part.grid.width <= 0 || part.grid.height <= 0 || map::whyUnusable(part.grid)) {
          self->toast(Mark::Bad,
                      tr("The whole map was not fetched: %1")
                          .arg(sentences::sentenceOf(regions::RegionTrouble{
                              regions::RegionTrouble::Kind::Misplaced, {}, regions::Misfit::Unusable})));
        } else if (!part.cells ||
                   part.cells->size() / std::size_t(part.grid.width) < std::size_t(part.grid.height)) {
          self->toast(Mark::Bad,
                      tr("The whole map was not fetched: %1")
                          .arg(sentences::sentenceOf(regions::RegionTrouble{
                              regions::RegionTrouble::Kind::Misplaced, {}, regions::Misfit::FewerCells})));
        } else {
          self->show([part] { return regions::pgmOf(part); }, part.grid, tr("Whole map"));
        }
        self->tell();
      });
  tell();
}

void RegionsController::show(std::function<std::string()> picture, const map::GridReference& grid,
                             const QString& name) {
  // Laying out hundreds of millions of cells takes a while.
  share_.startLong([this, picture = std::move(picture), grid, name, job = job_] {
    map::WholeMap map;
    map.key = {map::MapKind::Stored, name.toStdString()};
    // What its dispatcher gives is the map that the robot is in.
    map.state_of = map::MapKey{map::MapKind::Live, {}};
    map.name = name.toStdString();
    map.grid = grid;
    map.reading = regions::kPgmReading;
    map.bytes = std::make_shared<const std::string>(picture());
    QMetaObject::invokeMethod(
        this,
        [this, map = std::move(map), job] {
          session::Session* const session = context_.current.session();
          if (!session || job != job_) return;
          session->wholeMap().show(map);
          context_.scene.setLayerVisible(Layer::WholeMap, true);
          context_.scene.setLayerVisible(Layer::Regions, false);
          toast(Mark::Good, tr("%1 is shown. The layer \"Map by regions\" is hidden.")
                                .arg(QString::fromStdString(map.name)));
        },
        Qt::QueuedConnection);
  });
}

void RegionsController::takeRectangle(const geometry::WorldRect& rect) {
  if (!map_ || question_) return;
  question_ = new QMessageBox(QMessageBox::Question, tr("Fetch a region"),
                              rectangleText(map_->regions(), rect), QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* const keep = question_->addButton(tr("Keep on screen"), QMessageBox::AcceptRole);
  keep->setObjectName(QStringLiteral("keepRegion"));
  QPushButton* const save = question_->addButton(tr("Save as PGM and YAML…"), QMessageBox::AcceptRole);
  save->setObjectName(QStringLiteral("saveRegion"));
  connect(keep, &QPushButton::clicked, this, [this, rect] { keepRectangle(rect); });
  connect(save, &QPushButton::clicked, this, [this, rect] {
    const QDir folder(
        folderToWriteInto({context_.settings.value(kFolderKey).toString(),
                           QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}));
    const QString path = QFileDialog::getSaveFileName(&context_.window, tr("Save the region"),
                                                      folder.filePath(QStringLiteral("region.yaml")),
                                                      tr("Maps for map_server (*.yaml)"));
    if (path.isEmpty()) return;
    context_.settings.setValue(kFolderKey, QFileInfo(path).absolutePath());
    saveRectangle(rect, path);
  });
  question_->open();
}

void RegionsController::saveRectangle(const geometry::WorldRect& rect, const QString& path) {
  startRectangle(rect, Then::Save, path);
}

void RegionsController::keepRectangle(const geometry::WorldRect& rect) {
  startRectangle(rect, Then::Show, {});
}

void RegionsController::startRectangle(const geometry::WorldRect& rect, Then then, const QString& path) {
  if (!dispatch_) return;
  stopJob();
  then_ = then;
  path_ = path;
  fetch_ = std::make_unique<regions::RegionFetch>(*dispatch_, rect, regions::RegionFetch::Options{});
  connect(fetch_.get(), &regions::RegionFetch::progressed, this, &RegionsController::tell);
  connect(fetch_.get(), &regions::RegionFetch::finished, this, &RegionsController::endRectangle);
  fetch_->start();
  tell();
}

void RegionsController::endRectangle() {
  const std::unique_ptr<regions::RegionFetch, void (*)(regions::RegionFetch*)> fetch(
      fetch_.release(), [](regions::RegionFetch* one) { one->deleteLater(); });
  tell();
  if (fetch->tooLarge()) {
    return toast(Mark::Bad, tr("This region is too large to be fetched at once: %1")
                                .arg(rectangleText(fetch->map().regions(), fetch->rect())));
  }
  const QString why = sentences::sentenceOf(fetch->trouble());
  const regions::RegionCounts counts = fetch->counts();
  const regions::FetchedGrid fetched = regions::cutOut(fetch->map().regions().sheets(), fetch->rect());
  if (!fetched.cells) {
    return toast(Mark::Bad, why.isEmpty() ? tr("There is nothing in this region.")
                                          : tr("The region was not fetched: %1").arg(why));
  }
  if (!fetch->complete() && counts.smaller == 0) {
    toast(Mark::Warning, tr("Parts of the region are missing and shown as unknown (%1 of %2 came): %3")
                             .arg(countText(counts.answered), countText(counts.in_view), why));
  } else if (counts.smaller > 0) {
    toast(Mark::Warning,
          tr("The robot's answers are smaller than the regions asked for: what is missing is unknown."));
  } else if (fetched.other_lattices > 0) {
    toast(Mark::Warning, tr("Some of it came with cells of another size or direction, and is left out."));
  }
  if (then_ == Then::Save) return save(fetched);
  show([cells = fetched.cells] { return regions::pgmOf(*cells); }, fetched.reference,
       tr("Region %1").arg(areaText(fetch->rect())));
}

void RegionsController::save(const regions::FetchedGrid& fetched) {
  export_ = std::make_unique<ExportJob>(context_.workers);
  connect(export_.get(), &ExportJob::finished, this, [this](const ExportResult& result) {
    export_.release()->deleteLater();
    if (!result.error.isEmpty()) return toast(Mark::Bad, result.error);
    if (result.cancelled) return;
    toast(Mark::Good,
          tr("Saved %1")
              .arg(exportedFiles(QDir::toNativeSeparators(result.path), ExportFormat::MapServer, false)
                       .join(QStringLiteral(", "))));
  });
  export_->start({WholeMapExport{fetched.cells, fetched.reference}, ExportFormat::MapServer, path_, false});
}

}  // namespace mapwright::window
