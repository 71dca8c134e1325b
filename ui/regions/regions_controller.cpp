#include "ui/regions/regions_controller.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QActionGroup>
#include <QFormLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolTip>
#include <QVBoxLayout>

#include "jobs/change_map.h"
#include "map/live_state.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/regions/map_fetch.h"
#include "ui/regions/rectangle_tool.h"
#include "ui/regions/regions_text.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/viewpoint.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/on_screen.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kLongestFilename = 200, kWidthPx = 420;

}  // namespace

SaveMapDialog::SaveMapDialog(robot::MapDispatch* dispatch, std::function<void(Mark, const QString&)> toast,
                             QWidget* parent)
    : QDialog(parent),
      dispatch_(dispatch),
      toast_(std::move(toast)),
      name_(new QLineEdit(this)),
      state_(new QLabel(this)) {
  setWindowTitle(tr("Save the map on the robot"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(kWidthPx);
  name_->setObjectName(QStringLiteral("saveMapName"));
  setLongest(*name_, kLongestFilename);
  name_->setText(QStringLiteral("map.png"));
  name_->setSelection(0, 3);
  auto* const about = new QLabel(tr("The robot writes its map to a file on its own disk. The extension of "
                                    "the name selects the format: most know .png, .pgm or .yaml for grids "
                                    "and .pcd, .ply or .vtk for clouds. An existing file may be replaced."),
                                 this);
  about->setTextFormat(Qt::PlainText);
  about->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setObjectName(QStringLiteral("saveMapState"));
  state_->setWordWrap(true);
  state_->hide();
  auto* const form = new QFormLayout;
  form->addRow(tr("&Name on the robot"), name_);
  save_ = new QPushButton(tr("Save"), this);
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*save_, {cancel});
  auto* const column = new QVBoxLayout(this);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(about);
  column->addWidget(state_);
  column->addStretch();
  column->addLayout(rowOf({LayoutItem::rest(), cancel, save_}, 8));
  // Wrapped text needs less height than requested before the width is known.
  resize(kWidthPx, column->totalHeightForWidth(kWidthPx));
  connect(name_, &QLineEdit::textChanged, this, &SaveMapDialog::look);
  connect(save_, &QPushButton::clicked, this, &SaveMapDialog::ask);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  look();
}

QString SaveMapDialog::filename() const { return name_->text().trimmed(); }

void SaveMapDialog::look() { save_->setEnabled(!waits_ && !filename().isEmpty()); }

void SaveMapDialog::ask() {
  if (!dispatch_) return refuse(tr("The robot is no longer connected."));
  if (const QString why = jobs::noFilenameReason(filename()); !why.isEmpty()) return refuse(why);
  wait();
  saving_ = dispatch_->save(
      filename().toStdString(), [self = QPointer(this)](const robot::Outcome<std::string>& outcome) {
        if (!self || !self->isVisible()) return;  // it was closed meanwhile
        if (!outcome) return self->refuse(QString::fromStdString(sentences::sentenceOf(outcome.error())));
        self->toast_(Mark::Good, tr("The robot saved its map as %1.").arg(words::plainName(*outcome)));
        self->accept();
      });
}

void SaveMapDialog::done(int result) {
  saving_.cancel();
  QDialog::done(result);
}

void SaveMapDialog::wait() {
  waits_ = true;
  name_->setEnabled(false);
  state_->setText(tr("Waiting for the robot…"));
  state_->show();
  look();
}

void SaveMapDialog::refuse(const QString& why) {
  waits_ = false;
  name_->setEnabled(true);
  state_->setText(why);
  state_->show();
  look();
}

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

/// A tooltip saying why a place on the map is blank or old.
class RegionTip : public QObject {
 public:
  /// `words`: plain text about a position in the world; empty = no tooltip.
  RegionTip(MapView& view, std::function<QString(const Eigen::Vector2d& world_m)> words, QObject* parent)
      : QObject(parent), view_(view), words_(std::move(words)) {
    view_.viewport()->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::ToolTip) return QObject::eventFilter(watched, event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    const QString words = words_(view_.worldAt(help->pos()));
    if (words.isEmpty()) {
      QToolTip::hideText();
      return QObject::eventFilter(watched, event);
    }
    // It depends on the position: nearby the reason may differ.
    constexpr int kAroundPx = 24;
    const QRect around(help->pos() - QPoint(kAroundPx, kAroundPx), QSize(2 * kAroundPx, 2 * kAroundPx));
    QToolTip::showText(help->globalPos(), plainToolTip(words), view_.viewport(), around);
    return true;
  }

 private:
  MapView& view_;
  std::function<QString(const Eigen::Vector2d&)> words_;
};

}  // namespace

RegionsController::RegionsController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      tool_(new RectangleTool(
          &context.scene,
          [this](const geometry::WorldRect& rect) {
            return map_ ? rectangleText(map_->regions(), wholeCells(map_->regions(), rect)) : areaText(rect);
          },
          this)),
      every_(new QActionGroup(this)),
      status_(new PlainLabel(&context.bar)),
      map_fetch_(std::make_unique<MapFetch>(context)) {
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
  connect(tool_, &RectangleTool::drawn, map_fetch_.get(), &MapFetch::onRectangle);
  connect(map_fetch_.get(), &MapFetch::changed, this, &RegionsController::updateState);
  connect(map_fetch_.get(), &MapFetch::regionWanted, this, &RegionsController::drawRectangle);
  updateState();
}

RegionsController::~RegionsController() {
  context_.scene.setRegions(nullptr);
  if (status_) delete status_;
  delete save_dialog_;
}

void RegionsController::addActions() {
  refresh_ = context_.actions.add({.id = "refreshRegions",
                                   .text = tr("Re&fetch the regions"),
                                   .icon = "retry",
                                   .tip = tr("Fetch all visible regions again"),
                                   .menu = {MenuGroup::Regions, 30}},
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
  context_.actions.addToMenu({MenuGroup::Regions, 40}, menu->menuAction());
  fetch_whole_ = context_.actions.add({.id = "fetchWholeMap",
                                       .text = tr("Fetch the &whole map…"),
                                       .icon = "download",
                                       .tip = tr("Fetch the robot's whole map at once"),
                                       .menu = {MenuGroup::Regions, 50}},
                                      map_fetch_.get(), &MapFetch::fetchWhole);
  save_map_ = context_.actions.add({.id = "saveMapOnRobot",
                                    .text = tr("&Save the map on the robot…"),
                                    .icon = "download",
                                    .tip = tr("The robot writes its map to a file on its own disk"),
                                    .menu = {MenuGroup::Regions, 60}},
                                   this, &RegionsController::saveOnRobot);
  fetch_region_ =
      context_.actions.add({.id = "fetchRegion",
                            .text = tr("Fetch a regi&on…"),
                            .icon = "rectangle",
                            .tip = tr("Draw a rectangle to fetch it, then save it or keep it on screen"),
                            .toggle = true,
                            .menu = {MenuGroup::Regions, 10}});
  context_.tools.add(tool_, fetch_region_);
  setRefreshEvery(0);
}

void RegionsController::setSession(session::Session* session) {
  map_fetch_->stop();
  map_fetch_->closeQuestion();
  if (save_dialog_) save_dialog_->close();
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
  map_fetch_->setDispatch(nullptr, nullptr);
  if (dispatch_) dispatch_->disconnect(this);
  dispatch_ = dispatch;
  context_.scene.setRegions(nullptr);
  map_.reset();
  if (dispatch_) {
    map_ = std::make_unique<regions::RegionMap>(*dispatch_, mapOptions(context_.budgets));
    connect(map_.get(), &regions::RegionMap::changed, this, &RegionsController::updateState);
    connect(dispatch_, &robot::MapDispatch::offersChanged, this, [this] {
      updateState();
      Q_EMIT context_.current.stateChanged();
    });
    connect(dispatch_, &robot::MapDispatch::extentChanged, this, &RegionsController::updateState);
  }
  map_fetch_->setDispatch(dispatch, map_.get());
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

void RegionsController::saveOnRobot() {
  if (!dispatch_ || save_dialog_) return;
  save_dialog_ = new SaveMapDialog(
      dispatch_, [this](Mark mark, const QString& text) { context_.overlay.toasts()->add(mark, text); },
      &context_.window);
  connect(save_dialog_, &QDialog::finished, this, [this] {
    save_dialog_.clear();  // it goes by itself
    updateState();
  });
  save_dialog_->open();
  updateState();
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
  updateState();
}

QMessageBox* RegionsController::question() const { return map_fetch_->question(); }

QString RegionsController::statusShown() const { return status_ && map_ ? status_->text() : QString(); }

void RegionsController::updateState() {
  const bool by_region = map_ && map_->offered();
  const bool left = map_ && !by_region && online() && map_->regions().bytes() > 0;
  // If the robot never sent a region nothing is missing on the map.
  const bool on_map = map_ && (map_->offered() || map_->regions().bytes() > 0);
  context_.scene.setRegions(on_map ? map_.get() : nullptr);
  const bool whole = dispatch_ && dispatch_->offered(DispatchService::Grid);
  const bool busy = map_fetch_->busy();
  const session::Session* const session = context_.current.session();
  const QString why =
      session && !dispatch_
          ? sentences::absenceReason(robot::Capability::Dispatch,
                                     session->robot().unavailableReason(robot::Capability::Dispatch))
          : QString();
  allow(refresh_, by_region, why);
  allow(fetch_whole_, whole && online() && !busy, why);
  allow(save_map_, dispatch_ && dispatch_->offered(DispatchService::Save) && online() && !save_dialog_, why);
  allow(fetch_region_, by_region && online() && !busy, why);
  if (!fetch_region_->isEnabled() && context_.tools.chosen() == tool_) context_.tools.putAway();
  if (status_) {
    status_->setVisible(by_region || left);
    if (by_region || left) status_->setText(regionsStatus(map_->regions()));
  }
  const auto extent = dispatch_ ? dispatch_->extent() : std::nullopt;
  context_.scene.setRegionsExtent(extent ? std::optional(extent->grid) : std::nullopt);
  if (busy) return context_.notices.set(NoticeRank::Regions, map_fetch_->notice());
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
    said.accept = [this] { map_fetch_->fetchWhole(); };
  } else if (notice.offer == Offer::Region) {
    said.offer = tr("Fetch a region…");
    said.accept = [this] { drawRectangle(); };
  } else if (notice.offer == Offer::Retry) {
    said.offer = tr("Retry");
    said.accept = [this] {
      if (map_) map_->retryNow();
    };
  }
  context_.notices.set(NoticeRank::Regions, std::move(said));
}

std::vector<Fetched> RegionsController::fetched() { return map_fetch_->fetched(); }

void RegionsController::onExported() { map_fetch_->markSaved(); }

QString RegionsController::reasonAt(const Eigen::Vector2d& world_m) const {
  const bool seen = map_ && context_.scene.regions() == map_.get() &&
                    context_.scene.layerVisible(Layer::Regions) && !comparing(context_.scene);
  return seen ? regionReason(map_->regions(), world_m, map_->offered(), online()) : QString();
}

void RegionsController::drawRectangle() {
  if (fetch_region_->isEnabled()) context_.tools.choose(tool_);
}

}  // namespace mapwright::ui

#include "moc_regions_controller.cpp"
