#include "ui/clouds/clouds_controller.h"

#include <algorithm>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QTimer>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "session/session.h"
#include "ui/clouds/cloud_text.h"
#include "ui/clouds/clouds_dock.h"
#include "ui/clouds/region_tool.h"
#include "ui/clouds/section_dock.h"
#include "ui/clouds/section_tool.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/panels.h"
#include "ui/scene/clouds_layer.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"

namespace mapwright::ui {
namespace {

constexpr int kSectionPx = 280;  // enough for a storey and its ceiling

const QString kWidthKey = QStringLiteral("clouds/section_width_m");
const QString kSaving = QStringLiteral("clouds");
const QString kCloudsFolderKey = QStringLiteral("clouds/folder");
const QString kLowKey = QStringLiteral("clouds/asked_low_m");
const QString kHighKey = QStringLiteral("clouds/asked_high_m");

}  // namespace

CloudsController::CloudsController(WindowContext& context, clouds::CloudStore& clouds, QObject* parent)
    : Controller(parent),
      context_(context),
      clouds_(clouds),
      dock_(new CloudsDock(&context.window)),
      section_dock_(new SectionDock(context.workers, &context.window)),
      section_tool_(new SectionTool(&context.scene, this)),
      region_tool_(new RegionTool(&context.scene, this)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 55, .menu_rank = 43, .open = false});
  context_.panels.add(section_dock_,
                      {.side = PanelPosition::Side::Bottom, .tab = 50, .menu_rank = 44, .open = false});
  context_.tools.add(region_tool_, context_.actions.add({.id = "cloudRegion",
                                                         .text = tr("Fetch clou&d of region"),
                                                         .icon = "rectangle",
                                                         .tip = tr("Draw a region and fetch its cloud"),
                                                         .toggle = true,
                                                         .needs_of_robot = robot::Capability::Dispatch,
                                                         .menu = {MenuGroup::Tools, 60}}));
  context_.tools.add(section_tool_,
                     context_.actions.add({.id = "cloudSection",
                                           .text = tr("S&ection"),
                                           .icon = "line",
                                           .tip = tr("Drag a line to see a cross-section of a cloud"),
                                           .toggle = true,
                                           .needs_of_robot = robot::Capability::Dispatch,
                                           .menu = {MenuGroup::Tools, 70}}));
  connect(region_tool_, &RegionTool::boxDrawn, this, &CloudsController::fetchBox);
  connect(region_tool_, &RegionTool::sphereDrawn, this, [this](const Eigen::Vector2d& centre, double radius) {
    const clouds::HeightRange heights = dock_->askedHeights();
    map::CloudRegion region;
    region.centre_m = {centre.x(), centre.y(), (heights.low_m + heights.high_m) / 2};
    region.radius_m = radius;
    fetch(region);
  });
  connect(dock_->kindBox(), &QComboBox::activated, this, &CloudsController::refreshOffer);
  connect(dock_->shapeBox(), &QComboBox::activated, this, [this] { region_tool_->setShape(dock_->shape()); });
  connect(dock_->viewButton(), &QPushButton::clicked, this,
          [this] { fetchBox(context_.view.destination().visibleWorld()); });
  connect(dock_->regionButton(), &QPushButton::clicked, this, [this] {
    region_tool_->setShape(dock_->shape());
    context_.tools.choose(region_tool_);
  });
  connect(dock_, &CloudsDock::wholeWanted, this, [this] { fetch(std::nullopt); });
  connect(dock_->cancelButton(), &QPushButton::clicked, this, [this] { call_.cancel(); });
  connect(dock_->clearButton(), &QPushButton::clicked, this, [this] {
    clouds_.clear();
    unsaved_ = false;
    dock_->setOutcome({}, false);
  });
  connect(dock_->saveButton(), &QPushButton::clicked, this, [this] { askAndSave(); });
  connect(dock_, &CloudsDock::rangeChosen, this, [this](std::optional<clouds::HeightRange> range) {
    clouds_.setHeightRange(range);
    refreshClouds();
  });
  connect(dock_->voxelBox(), &QDoubleSpinBox::valueChanged, this,
          [this](double metres) { clouds_.setVoxel(metres > 0 ? std::optional(metres) : std::nullopt); });
  const auto restyle = [this](auto change) {
    scene::LayerStyle changed = style();
    change(changed);
    context_.scene.setLayerStyle(scene::Layer::DispatchedCloud, changed);
  };
  connect(dock_->colorBox(), &QComboBox::activated, this,
          [restyle](int choice) { restyle([choice](scene::LayerStyle& style) { style.choice = choice; }); });
  connect(dock_->sizeBox(), &QDoubleSpinBox::valueChanged, this,
          [restyle](double px) { restyle([px](scene::LayerStyle& style) { style.size = px; }); });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, [this] {
    dock_->setStyle(style());
    dock_->setScale(scene::cloudScale(clouds_, style(), context_.scene.theme()));
    showSection();
  });
  connect(&clouds_, &clouds::CloudStore::summed, this, &CloudsController::refreshClouds);
  connect(&clouds_, &clouds::CloudStore::changed, this, &CloudsController::cut);
  connect(&clouds_, &clouds::CloudStore::summed, &context_.current, &CurrentSession::stateChanged);
  connect(context_.overlay.card(), &EmptyStateCard::wanted, this, [this](CardOffer offer) {
    if (offer == CardOffer::Clouds) context_.panels.open(dock_);
  });
  connect(section_tool_, &SectionTool::lineDrawn, this,
          [this](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
            cut_ = clouds::Cut{from, to, section_dock_->widthBox()->value()};
            openSection();
            cut();
          });
  connect(section_tool_, &SectionTool::lineGone, this, [this] {
    cut_.reset();
    section_.reset();
    showSection();
  });
  connect(section_dock_, &SectionDock::widthChosen, this, [this](double metres) {
    section_tool_->setWidth(metres);
    if (!cut_) return;
    cut_->width_m = metres;
    cut();
  });
  connect(section_dock_, &SectionDock::looksAt, section_tool_, &SectionTool::setMark);
  connect(&context_.current, &CurrentSession::stateChanged, this, &CloudsController::refreshOffer);
  dock_->setStyle(style());
}

const scene::LayerStyle& CloudsController::style() const {
  return context_.scene.layerStyle(scene::Layer::DispatchedCloud);
}

robot::MapDispatch* CloudsController::dispatch() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().mapDispatch() : nullptr;
}

void CloudsController::setSession(session::Session* session) {
  if (!session) {
    clouds_.clear();
    // The next robot may have none.
    const MapTool* const tool = context_.tools.chosen();
    if (tool == region_tool_ || tool == section_tool_) context_.tools.putAway();
  }
  // Pending requests are void.
  ++asked_;
  call_ = {};
  unsaved_ = false;
  dock_->setProgress({});
  dock_->setOutcome({}, false);
  section_tool_->forget();
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &CloudsController::refreshOffer);
  }
  refreshOffer();
}

void CloudsController::refreshOffer() {
  session::Session* const session = context_.current.session();
  const robot::MapDispatch* const offered = dispatch();
  QString absence;
  if (!session) {
    absence = tr("Connect to a robot with a map dispatcher to see its 3D map.");
  } else if (!offered) {
    absence = sentences::absenceReason(robot::Capability::Dispatch,
                                       session->robot().unavailableReason(robot::Capability::Dispatch));
  }
  dock_->setAbsence(absence);
  using robot::DispatchService;
  CloudOffer offer;
  offer.unavailable_reason = dock_->voxels() ? tr("This robot does not offer a cloud of its occupied cells.")
                                             : tr("This robot does not offer a cloud of its points.");
  if (offered) {
    // It may have appeared only now.
    connect(offered, &robot::MapDispatch::offersChanged, this, &CloudsController::refreshOffer,
            Qt::UniqueConnection);
    offer.whole = offered->offered(dock_->voxels() ? DispatchService::Occupancy : DispatchService::Cloud);
    offer.region =
        offered->offered(dock_->voxels() ? DispatchService::OccupancyRegion : DispatchService::CloudRegion);
  }
  dock_->setOffer(offer);
}

void CloudsController::fetchBox(const geometry::WorldRect& box) {
  const clouds::HeightRange heights = dock_->askedHeights();
  map::CloudRegion region;
  region.centre_m = {box.center().x(), box.center().y(), (heights.low_m + heights.high_m) / 2};
  region.size_m = {box.width(), box.height(), heights.high_m - heights.low_m};
  if (!(region.size_m.z() > 0)) {
    dock_->setOutcome(tr("The lowest and the highest height to fetch are the same."), true);
    context_.panels.open(dock_);
    return;
  }
  fetch(region);
}

void CloudsController::fetch(const std::optional<map::CloudRegion>& region) {
  context_.panels.open(dock_);
  robot::MapDispatch* const offered = dispatch();
  if (!offered) return refreshOffer();
  if (!call_.over()) {
    dock_->setOutcome(tr("A cloud is already being fetched."), true);
    return;
  }
  const auto kind = dock_->voxels() ? robot::CloudKind::Occupancy : robot::CloudKind::Points;
  dock_->setOutcome({}, false);
  dock_->setProgress(tr("Fetching…"));
  call_ = jobs::fetchCloud(*offered, kind, region, context_.workers,
                           [this, kind, region, asked = ++asked_](const auto& outcome) {
                             if (asked == asked_) onAnswer(kind, region, outcome);
                           });
  call_.onProgress([this, asked = asked_](const robot::Progress& progress) {
    if (asked == asked_) dock_->setProgress(tr("Fetching… %1").arg(megabytesText(progress.bytes)));
  });
}

void CloudsController::onAnswer(robot::CloudKind kind, const std::optional<map::CloudRegion>& region,
                                const robot::Outcome<jobs::FetchedCloud>& outcome) {
  call_ = {};
  dock_->setProgress({});
  if (!outcome) {
    const map::Failure& failure = outcome.error();
    if (failure.kind == map::FailureKind::Cancelled) {
      dock_->setOutcome(tr("Cancelled."), false);
    } else {
      dock_->setOutcome(QString::fromStdString(sentences::sentenceOf(failure)), true);
    }
    return;
  }
  const map::SpatialCloud& cloud = *outcome->cloud;
  QStringList said;
  if (outcome->elsewhere()) {
    said << tr("The robot answered with another region.");
  } else if (cloud.points.empty()) {
    said << tr("The robot has no points in this region.");
  } else {
    const auto points = qint64(cloud.points.size());
    said << sentences::counted(tr("%1 points were received.", nullptr, sentences::formOf(points)), points);
  }
  said << outcome->notes();
  dock_->setOutcome(said.join(QLatin1Char('\n')), outcome->elsewhere() || !outcome->complete());
  const bool first = clouds_.empty() && !cloud.points.empty();
  if (!cloud.points.empty() && !outcome->elsewhere()) unsaved_ = true;
  if (!outcome->elsewhere()) clouds_.add({outcome->cloud, kind == robot::CloudKind::Occupancy, region});
  if (!clouds_.settled()) dock_->setSorting();
  if (!context_.scene.layerVisible(scene::Layer::DispatchedCloud)) {
    context_.scene.setLayerVisible(scene::Layer::DispatchedCloud, true);
  }
  if (!first || region) return;
  // The whole map, and nothing was on screen before: show all of it.
  connect(
      &clouds_, &clouds::CloudStore::summed, this,
      [this] {
        if (!context_.viewpoint.chosen()) context_.viewpoint.fit(clouds_.bounds());
      },
      Qt::SingleShotConnection);
}

void CloudsController::refreshClouds() {
  dock_->setClouds(clouds_.sums(), clouds_.heights(), clouds_.heightRange());
  dock_->setScale(scene::cloudScale(clouds_, style(), context_.scene.theme()));
}

void CloudsController::cut() {
  if (!cut_) return;
  clouds_.cut(*cut_, [this](std::shared_ptr<const clouds::Section> section) {
    if (!cut_) return;
    section_ = std::move(section);
    showSection();
  });
}

/// Its dock replaces others below the map, which may be low; once it is open the user controls its height.
void CloudsController::openSection() {
  const bool was_open = section_dock_->isVisible() && !section_dock_->visibleRegion().isEmpty();
  context_.panels.open(section_dock_);
  if (was_open || section_dock_->isFloating()) return;
  // Its height is known once it has been laid out.
  QTimer::singleShot(0, section_dock_, [this] {
    const int wanted = std::max(kSectionPx, context_.window.height() / 4);
    if (section_dock_->height() < wanted)
      context_.window.resizeDocks({section_dock_}, {wanted}, Qt::Vertical);
  });
}

void CloudsController::showSection() {
  if (!section_ && !section_dock_->view()->section()) return;
  section_dock_->showSection(section_,
                             scene::sectionPainter(section_, clouds_, style(), context_.scene.theme(),
                                                   section_dock_->devicePixelRatioF()));
}

std::vector<Fetched> CloudsController::fetched() {
  if (!unsaved_ || clouds_.empty()) return {};
  const auto points = qint64(clouds_.sums().came);
  return {{sentences::counted(tr("clouds of %1 points", nullptr, sentences::formOf(points)), points),
           [this](std::function<void()> saved) { askAndSave(std::move(saved)); }}};
}

void CloudsController::askAndSave(std::function<void()> then) {
  const QString folder = folderToWriteInto({context_.settings.value(kCloudsFolderKey).toString()});
  const QString proposed = QDir(folder).filePath(QStringLiteral("cloud.pcd"));
  QString path = QFileDialog::getSaveFileName(&context_.window, tr("Save the displayed cloud"), proposed,
                                              tr("Clouds (*.pcd *.ply *.csv)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1String(".pcd");
  context_.settings.setValue(kCloudsFolderKey, QFileInfo(path).absolutePath());
  saveTo(path, std::move(then));
}

void CloudsController::saveTo(const QString& path, std::function<void()> then) {
  const QString end = QFileInfo(path).suffix().toLower();
  if (end != QLatin1String("pcd") && end != QLatin1String("ply") && end != QLatin1String("csv")) {
    context_.overlay.toasts()->add(
        Mark::Bad, tr("A cloud can be saved as .pcd, .ply or .csv. Choose one of these."), {}, kSaving);
    return;
  }
  clouds_.write(path, [this, path, asked = asked_,
                       then = std::move(then)](const tl::expected<std::uint64_t, Fault>& outcome) {
    if (!outcome) {
      context_.overlay.toasts()->add(Mark::Bad, sentences::sentenceOf(outcome.error()), {}, kSaving);
      return;
    }
    context_.overlay.toasts()->add(Mark::Good, tr("Saved %1").arg(QDir::toNativeSeparators(path)), {},
                                   kSaving);
    if (asked == asked_) unsaved_ = false;  // nothing has been requested since
    if (then) then();
  });
}

void CloudsController::recall(const QSettings& settings) {
  section_dock_->widthBox()->setValue(settings.value(kWidthKey, 0.5).toDouble());
  section_tool_->setWidth(section_dock_->widthBox()->value());
  dock_->askLowBox()->setValue(settings.value(kLowKey, -50).toDouble());
  dock_->askHighBox()->setValue(settings.value(kHighKey, 50).toDouble());
}

void CloudsController::remember(QSettings& settings) {
  settings.setValue(kWidthKey, section_dock_->widthBox()->value());
  settings.setValue(kLowKey, dock_->askLowBox()->value());
  settings.setValue(kHighKey, dock_->askHighBox()->value());
}

void CloudsController::reset() { section_dock_->widthBox()->setValue(0.5); }

}  // namespace mapwright::ui

#include "moc_clouds_controller.cpp"
