#include "ui/regions/regions_controller.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QActionGroup>
#include <QMenu>

#include "ui/kit/plain_label.h"
#include "ui/regions/map_errand.h"
#include "ui/regions/map_saving.h"
#include "ui/regions/rectangle_tool.h"
#include "ui/regions/region_tip.h"
#include "ui/regions/regions_text.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/viewpoint.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/on_screen.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"

namespace mapwright::window {
namespace {

using robot::DispatchService;
using scene::Layer;

const QString kEveryKey = QStringLiteral("regions/refresh_s");
constexpr int kCameraLookMs = 120;  // while the camera moves
constexpr std::array kEveryS{0, 10, 60, 600};
constexpr double kBytesOfRegion = 1024 * 1024 * 4 / 3.0;
constexpr double kFirstViewM = 60;
constexpr int kLeastInView = 6, kMostInView = 72;

regions::RegionMap::Options mapOptions(const work::Budgets& budgets) {
  regions::RegionMap::Options options;
  const double bytes = double(budgets.regions);
  options.regions.budget_bytes = std::size_t(bytes);
  // Visible regions are never dropped, so they must fit.
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
      errand_(std::make_unique<MapErrand>(context)),
      saving_(std::make_unique<MapSaving>(context.window, [this](Mark mark, const QString& text) {
        context_.overlay.toasts()->add(mark, text);
      })) {
  addActions();
  status_->setObjectName(QStringLiteral("regionsStatus"));
  status_->setSample(QStringLiteral("0,000 of 0,000 regions, 000.0 MB"));
  status_->setSecondary(true);
  status_->hide();
  context_.bar.addPermanentWidget(status_);
  look_soon_.setSingleShot(true);
  look_soon_.setInterval(kCameraLookMs);
  connect(&look_soon_, &QTimer::timeout, this, &RegionsController::look);
  connect(&refresh_timer_, &QTimer::timeout, this, [this] {
    if (map_ && online()) map_->refresh();
  });
  connect(&context_.scene, &scene::MapScene::viewChanged, this, [this] {
    if (map_ && !look_soon_.isActive()) look_soon_.start();
  });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, &RegionsController::look);
  new RegionTip(
      context_.view, [this](const Eigen::Vector2d& world_m) { return reasonAt(world_m); }, this);
  connect(tool_, &RectangleTool::drawn, errand_.get(), &MapErrand::takeRectangle);
  connect(errand_.get(), &MapErrand::changed, this, &RegionsController::tell);
  connect(errand_.get(), &MapErrand::regionWanted, this, &RegionsController::drawRectangle);
  connect(saving_.get(), &MapSaving::changed, this, &RegionsController::tell);
  tell();
}

RegionsController::~RegionsController() {
  context_.scene.setRegions(nullptr);
  if (status_) delete status_;
}

void RegionsController::addActions() {
  refresh_ = context_.actions.add({.id = "refreshRegions",
                                   .text = tr("Re&fetch the regions"),
                                   .icon = "retry",
                                   .tip = tr("Fetch all visible regions again"),
                                   .menu = {MenuGroup::WholeMap, 30}},
                                  this, [this] {
                                    if (map_) map_->refresh();
                                  });
  auto* const menu = new QMenu(tr("Refetch regions automaticall&y"), &context_.window);
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
                                       .tip = tr("Fetch the robot's whole map at once"),
                                       .menu = {MenuGroup::WholeMap, 50}},
                                      errand_.get(), &MapErrand::fetchWhole);
  save_map_ = context_.actions.add({.id = "saveMapOnRobot",
                                    .text = tr("&Save the map on the robot…"),
                                    .icon = "download",
                                    .tip = tr("The robot writes its map to a file on its own disk"),
                                    .menu = {MenuGroup::WholeMap, 60}},
                                   this, [this] { saving_->ask(dispatch_); });
  fetch_region_ =
      context_.actions.add({.id = "fetchRegion",
                            .text = tr("Fetch a regi&on…"),
                            .icon = "rectangle",
                            .tip = tr("Draw a rectangle to fetch it, then save it or keep it on screen"),
                            .toggle = true,
                            .menu = {MenuGroup::Tools, 30}});
  context_.tools.add(tool_, fetch_region_);
  setRefreshEvery(0);
}

void RegionsController::setSession(session::Session* session) {
  errand_->stop();
  errand_->closeQuestion();
  saving_->close();
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &RegionsController::follow);
    was_online_ = online();
    connect(session, &session::Session::connectionChanged, this, [this] {
      // Answer times are reported all the time; only the connection state matters here.
      if (std::exchange(was_online_, online()) == online()) return;
      if (map_ && online()) map_->retryNow();
      look();
    });
    connect(session, &session::Session::liveHeard, this, &RegionsController::lookAtRobot);
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
  errand_->setDispatch(nullptr, nullptr);
  if (dispatch_) dispatch_->disconnect(this);
  dispatch_ = dispatch;
  context_.scene.setRegions(nullptr);
  map_.reset();
  if (dispatch_) {
    map_ = std::make_unique<regions::RegionMap>(*dispatch_, mapOptions(context_.budgets));
    connect(map_.get(), &regions::RegionMap::changed, this, &RegionsController::tell);
    connect(dispatch_, &robot::MapDispatch::offersChanged, this, [this] {
      tell();
      Q_EMIT context_.current.stateChanged();
    });
    connect(dispatch_, &robot::MapDispatch::extentChanged, this, &RegionsController::tell);
  }
  errand_->setDispatch(dispatch, map_.get());
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

QMessageBox* RegionsController::question() const { return errand_->question(); }

QString RegionsController::statusShown() const { return status_ && map_ ? status_->text() : QString(); }

void RegionsController::tell() {
  const bool by_region = map_ && map_->offered();
  const bool left = map_ && !by_region && online() && map_->regions().bytes() > 0;
  // If the robot never sent a region nothing is missing on the map.
  const bool on_map = map_ && (map_->offered() || map_->regions().bytes() > 0);
  context_.scene.setRegions(on_map ? map_.get() : nullptr);
  const bool whole = dispatch_ && dispatch_->offered(DispatchService::Grid);
  const bool busy = errand_->busy();
  refresh_->setEnabled(by_region);
  fetch_whole_->setEnabled(whole && online() && !busy);
  save_map_->setEnabled(dispatch_ && dispatch_->offered(DispatchService::Save) && online() &&
                        !saving_->asking());
  fetch_region_->setEnabled(by_region && online() && !busy);
  if (!fetch_region_->isEnabled() && context_.tools.chosen() == tool_) context_.tools.putAway();
  if (status_) {
    status_->setVisible(by_region || left);
    if (by_region || left) status_->setText(regionsStatus(map_->regions()));
  }
  const auto extent = dispatch_ ? dispatch_->extent() : std::nullopt;
  context_.scene.setRegionsExtent(extent ? std::optional(extent->grid) : std::nullopt);
  if (busy) return context_.notices.set(NoticeRank::Regions, errand_->notice());
  const RegionsNotice notice =
      by_region ? regionsNotice(map_->regions(), whole, extent)
      : left    ? RegionsNotice{Mark::Warning, tr("The robot no longer sends its map by region. The regions "
                                                     "received so far stay.")}
                : RegionsNotice{};
  using Offer = RegionsNotice::Offer;
  const bool too_far = notice.offer == Offer::Whole || notice.offer == Offer::Region;
  Notice said{notice.mark, notice.sentence, {}, {}, too_far};
  if (notice.offer == Offer::Whole) {
    said.offer = tr("Fetch the whole map…");
    said.take = [this] { errand_->fetchWhole(); };
  } else if (notice.offer == Offer::Region) {
    said.offer = tr("Fetch a region…");
    said.take = [this] { drawRectangle(); };
  } else if (notice.offer == Offer::Retry) {
    said.offer = tr("Retry");
    said.take = [this] {
      if (map_) map_->retryNow();
    };
  }
  context_.notices.set(NoticeRank::Regions, std::move(said));
}

std::vector<Fetched> RegionsController::fetched() { return errand_->fetched(); }

void RegionsController::noteExported() { errand_->noteSaved(); }

QString RegionsController::reasonAt(const Eigen::Vector2d& world_m) const {
  const bool seen = map_ && context_.scene.regions() == map_.get() &&
                    context_.scene.layerVisible(Layer::Regions) && !comparing(context_.scene);
  return seen ? regionReason(map_->regions(), world_m, map_->offered(), online()) : QString();
}

void RegionsController::drawRectangle() {
  if (fetch_region_->isEnabled()) context_.tools.choose(tool_);
}

}  // namespace mapwright::window

#include "moc_regions_controller.cpp"
