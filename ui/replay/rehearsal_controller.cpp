#include "ui/replay/rehearsal_controller.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QGraphicsItem>
#include <QPainter>

#include "carry/rehearsal.h"
#include "carry/rehearsal_sentence.h"
#include "disk/file_error.h"
#include "disk/read_file.h"
#include "excerpt/excerpt_job.h"
#include "map/live_topics.h"
#include "placing/warnings.h"
#include "replay/track_file.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/panels.h"
#include "ui/replay/recordings_dock.h"
#include "ui/replay/rehearsal_dock.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr double kAroundPlace_m = 3;
constexpr std::size_t kMostTrackBytes = 256 << 20;

}  // namespace

class RehearsalController::Line : public QGraphicsItem {
 public:
  explicit Line(scene::MapScene& scene) : scene_(scene) {
    setZValue(std::numeric_limits<int>::max());
    setAcceptedMouseButtons(Qt::NoButton);
    scene.addItem(this);
  }
  void show(std::vector<carry::Stretch> stretches) {
    prepareGeometryChange();
    stretches_ = std::move(stretches);
    update();
  }
  void follow() {
    prepareGeometryChange();
    update();
  }
  const std::vector<carry::Stretch>& stretches() const { return stretches_; }

  QRectF boundingRect() const override {
    const geometry::ViewTransform& view = scene_.view();
    return stretches_.empty() ? QRectF() : QRectF(0, 0, double(view.width_px), double(view.height_px));
  }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    painter->setRenderHint(QPainter::Antialiasing);
    const auto draw = [&](const carry::Stretch& stretch, const QPen& pen) {
      painter->setPen(pen);
      if (stretch.line.size() == 1) {
        painter->drawPoint(scene::toPoint(scene_.view().pixelFromWorld(stretch.line[0])));
        return;
      }
      for (const QPolygonF& line : scene::visibleLines(scene_.view(), stretch.line, 8))
        painter->drawPolyline(line);
    };
    for (const carry::Stretch& stretch : stretches_)
      draw(stretch, QPen(scene_.theme().text_halo, penOf(stretch.what, scene_.theme()).widthF() + 3));
    for (const bool free : {true, false}) {  // what is free never hides what is not
      for (const carry::Stretch& stretch : stretches_) {
        if ((stretch.what == carry::Crossing::Free) == free)
          draw(stretch, penOf(stretch.what, scene_.theme()));
      }
    }
  }

 private:
  scene::MapScene& scene_;
  std::vector<carry::Stretch> stretches_;
};

RehearsalController::RehearsalController(WindowContext& context, MakeRobot make_robot, QObject* parent)
    : Controller(parent),
      context_(context),
      make_robot_(std::move(make_robot)),
      dock_(new RehearsalDock(&context.window)),
      line_(std::make_unique<Line>(context.scene)),
      run_(context.workers) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 72, .menu_rank = 38, .open = false});
  context_.actions.add({.id = "rehearseWay",
                        .text = tr("Rehearse a recorded &way…"),
                        .icon = "layers",
                        .tip = tr("Find out what a recorded way crosses on the map on screen"),
                        .needs_session = true,
                        .menu = {MenuGroup::Link, 36}},
                       this, [this] {
                         context_.panels.open(dock_);
                         if (!library()) choose();
                       });
  connect(dock_, &RehearsalDock::chooseWanted, this, &RehearsalController::choose);
  connect(dock_, &RehearsalDock::recordingsWanted, this, &RehearsalController::recordingsWanted);
  connect(dock_, &RehearsalDock::againWanted, this, &RehearsalController::read);
  connect(dock_, &RehearsalDock::cancelWanted, this, [this] { forget(tr("Cancelled. Press Again.")); });
  connect(dock_, &RehearsalDock::removeWanted, this, [this] {
    path_.clear();
    bag_.reset();
    forget({});
  });
  connect(dock_, &RehearsalDock::radiusChanged, this, [this] {
    if (!track_file_.isEmpty()) run(QString(track_file_));
  });
  connect(dock_, &RehearsalDock::placeWanted, this, &RehearsalController::goTo);
  connect(&context_.scene, &scene::MapScene::viewChanged, this, [this] { line_->follow(); });
  connect(&context_.scene, &scene::MapScene::contentChanged, this, [this] {
    if (ground_ && !sameCells())
      forget(tr("The map on screen has changed, or is another one now. Press Again."));
  });
  connect(&context_.scene, &scene::MapScene::cellsEdited, this, &RehearsalController::onEdited);
  connect(&context_.current, &CurrentSession::stateChanged, this, &RehearsalController::syncRobot);
  syncRobot();
  forget({});
}

RehearsalController::~RehearsalController() {
  *over_ = true;
  delete dock_;
}

const std::vector<carry::Stretch>& RehearsalController::shown() const { return line_->stretches(); }

robot::BagLibrary* RehearsalController::library() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().bagLibrary() : nullptr;
}

QString RehearsalController::called() const {
  return bag_ ? bagCalled(*bag_) : words::plainName(QFileInfo(path_).fileName());
}

bool RehearsalController::sameCells() const {
  const session::Session* const session = context_.current.session();
  if (!session) return false;
  const session::MapSlot& whole = session->wholeMap();
  return whole.cells() && whole.reference() == ground_->map.reference &&
         (whole.cells() == ground_->map.cells ||
          (!ground_->content.empty() && whole.shown().fingerprint == ground_->content));
}

void RehearsalController::choose() {
  const QString path = QFileDialog::getOpenFileName(
      &context_.window, tr("Choose a recorded way"),
      path_.isEmpty() ? lastMapFolder(context_.settings) : QFileInfo(path_).absolutePath(),
      tr("Recordings and tracks (*.mcap *.bag *.db3 *.csv *.geojson *.json *.tum)"));
  if (!path.isEmpty()) rehearse(path);
}

void RehearsalController::rehearse(const QString& path) {
  path_ = path;
  bag_.reset();
  read();
}

void RehearsalController::rehearseBag(const robot::BagKey& key) {
  path_.clear();
  bag_ = key;
  read();
}

void RehearsalController::read() {
  lost_.clear();
  context_.panels.open(dock_);
  const session::Session* const session = context_.current.session();
  if (!session || !session->wholeMap().cells()) return forget(tr("There is no whole map on screen."));
  const session::MapSlot& whole = session->wholeMap();
  if (!whole.settled()) return forget(tr("The map on screen is still being read."));
  wait(tr("Reading %1…").arg(called()));
  ground_ = Ground{{whole.cells(), whole.reference()}, whole.shown().fingerprint};
  if (!bag_) return readFile();
  robot::BagLibrary* const library = this->library();
  if (!library) return forget(tr("The robot does not offer its recordings any more."));
  readRecording(*library, *bag_);
}

void RehearsalController::readFile() {
  if (replay::isTrackName(path_.toStdString())) return run(path_);
  auto robot = make_robot_(QStringLiteral("file:") + QFileInfo(path_).absoluteFilePath());
  if (!robot) return forget(robot.error());
  origin_ = std::move(*robot);
  robot::BagLibrary* const library = origin_->bagLibrary();
  if (!library) return forget(tr("This is no recording."));
  library->list([this, library, over = over_](const robot::Outcome<std::vector<robot::BagEntry>>& rows) {
    if (*over) return;
    if (!rows) return forget(QString::fromStdString(sentences::sentenceOf(rows.error())));
    if (rows->empty()) return forget(tr("This is no recording."));
    readRecording(*library, rows->front().key);
  });
}

void RehearsalController::readRecording(robot::BagLibrary& library, const robot::BagKey& key) {
  excerpt::Order order;
  order.kind = excerpt::Kind::TrackCsv;
  order.path = folder_.filePath(QStringLiteral("way.csv")).toStdString();
  job_ = std::make_unique<excerpt::ExcerptJob>(excerpt::ExcerptJob::Source{&library, key, {}}, order,
                                               context_.workers);
  const auto onEnded = [this, over = over_](const excerpt::Ended& ended) {
    if (*over) return;
    if (ended.not_read) return forget(QString::fromStdString(sentences::sentenceOf(*ended.not_read)));
    if (ended.not_written) return forget(sentences::sentenceOf(*ended.not_written));
    if (lost_.isEmpty() && !ended.holes.empty()) lost_ = tr("Parts of the recording cannot be read.");
    if (ended.written) run(folder_.filePath(QStringLiteral("way.csv")));
  };
  // Queued: it may be deleted then.
  connect(job_.get(), &excerpt::ExcerptJob::ended, this, onEnded, Qt::QueuedConnection);
  connect(job_.get(), &excerpt::ExcerptJob::progressed, this, [this](double share) {
    dock_->setSaid(tr("Reading %1: %2 %").arg(called()).arg(int(100 * std::clamp(share, 0.0, 1.0))));
  });
  library.info(key, [this, over = over_](const robot::Outcome<robot::BagInfo>& info) {
    if (*over) return;
    if (info && info->interrupted)
      lost_ = tr("Its end is missing: the recording was interrupted, or is still going on.");
    job_->start();
  });
}

void RehearsalController::run(const QString& track_file) {
  const std::optional<Ground> ground = ground_;
  wait(tr("Looking at what %1 crosses…").arg(called()));
  ground_ = ground;
  track_file_ = track_file;
  carry::RehearsalOptions options{.radius_m = dock_->radius().value_or(told_m_)};
  if (laid_) options.transform = laid_->pose, options.old_map = laid_->map;
  render::PlacedGrid map = ground->map;
  // As it is painted at present.
  if (const auto drawn = context_.scene.wholeMap(); drawn && drawn->reference == map.reference) map = *drawn;
  run_.start([this, file = track_file.toStdString(), map, options](const auto&) -> BackgroundRun::Then {
    const auto bytes = disk::readFile(file, kMostTrackBytes);
    if (!bytes) return [this, why = bytes.error()] { forget(sentences::wordsOf(why.cause)); };
    const auto track = replay::trackFrom(*bytes);
    if (!track)
      return [this] { forget(tr("This is no track. Choose a recording, or a track that was exported.")); };
    std::vector<carry::WayPoint> way;
    for (const replay::TrackPoint& point : *track)
      way.push_back({{point.pose.x_m, point.pose.y_m}, point.stamp_s, point.piece, point.map});
    return [this, found = carry::Rehearsal(map, options).of(way)] { onRehearsed(found); };
  });
}

void RehearsalController::onRehearsed(const carry::Rehearsed& way) {
  crossed_ = way.crossed();
  line_->show(way.stretches);
  dock_->setStretches(crossed_, context_.scene.theme());
  dock_->setBusy(false);
  const QString lies =
      laid_ ? tr("It was moved as the reference map lies.") : tr("It lies as it was recorded.");
  QString said = QStringLiteral("%1: %2 %3").arg(called(), carry::rehearsedText(way), lies);
  if (!lost_.isEmpty()) said += QLatin1Char(' ') + lost_;
  dock_->setSaid(said);
  if (std::exchange(edited_, false)) onEdited();
  geometry::WorldRect all;
  for (const carry::Stretch& stretch : way.stretches) {
    for (const Eigen::Vector2d& at : stretch.line) all.extend(at);
  }
  if (!all.empty()) context_.viewpoint.lookAt(all);
}

void RehearsalController::onEdited() {
  if (track_file_.isEmpty() || std::exchange(edited_, true) || shown().empty()) return;
  dock_->setSaid(tr("The map on screen has changed since then. As it was: %1").arg(dock_->said()));
}

void RehearsalController::forget(const QString& said) {
  *over_ = true;
  over_ = std::make_shared<bool>(false);
  run_.forget();
  job_.reset();
  track_file_.clear();
  ground_.reset();
  edited_ = false;
  crossed_.clear();
  line_->show({});
  dock_->setStretches({}, context_.scene.theme());
  dock_->setChosen(isChosen());
  dock_->setBusy(false);
  dock_->setSaid(!said.isEmpty() ? said
                                 : tr("Choose a recorded way to see what it crosses on this map. If it was "
                                      "driven on an old map, lay and align that as a reference map first."));
}

void RehearsalController::wait(const QString& said) {
  forget(said);
  dock_->setBusy(true);
}

void RehearsalController::goTo(int row) {
  if (row < 0 || std::size_t(row) >= crossed_.size()) return;
  const Eigen::Vector2d at = crossed_[std::size_t(row)].middle_m;
  context_.scene.setMarker(at);
  context_.viewpoint.lookAt(
      {at.x() - kAroundPlace_m, at.y() - kAroundPlace_m, at.x() + kAroundPlace_m, at.y() + kAroundPlace_m});
}

void RehearsalController::setLaid(const std::optional<LaidMap>& laid) {
  if (laid == laid_) return;
  laid_ = laid;
  if (isChosen()) forget(tr("The reference map was moved, or is another one now. Press Again."));
}

void RehearsalController::syncRobot() {
  const session::Session* const session = context_.current.session();
  const double reported_m = session ? placing::radiusOf(session->live().model) : 0;
  const double told_m = reported_m > 0 ? reported_m : placing::kUsualRadiusM;
  dock_->setToldRadius(told_m);
  if (std::exchange(told_m_, told_m) != told_m && !dock_->radius() && !track_file_.isEmpty())
    run(QString(track_file_));
  dock_->setWhyNoRecordings(
      !session     ? tr("Connect to a robot to see its recordings.")
      : !library() ? sentences::absenceReason(robot::Capability::Bags,
                                              session->robot().unavailableReason(robot::Capability::Bags))
                   : QString());
}

void RehearsalController::setSession(session::Session* session) {
  path_.clear();
  bag_.reset();
  dock_->setRadius(0);  // it was that of the robot before
  forget({});
  if (!session) return;
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    if (what == map::topicIndex<map::RobotModel>()) syncRobot();
  });
}

}  // namespace mapwright::ui

#include "moc_rehearsal_controller.cpp"
