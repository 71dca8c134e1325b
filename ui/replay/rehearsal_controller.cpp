#include "ui/replay/rehearsal_controller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
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
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr double kAroundPlace_m = 3;
constexpr std::size_t kMostTrackBytes = 256 << 20;

/// Where lines of one kind have been drawn on screen. A way that comes by again would fill the gaps between
/// the dashes of the first: it is left out there.
class DrawnPlaces {
 public:
  /// The parts of a line where nothing was drawn yet.
  std::vector<QPolygonF> newOf(const QPolygonF& line) {
    ++pass_;
    std::vector<QPolygonF> parts;
    bool open = false;
    double along_px = 0;
    for (qsizetype i = 1; i < line.size(); ++i) {
      const QPointF from = line[i - 1], way = line[i] - from;
      const double length_px = std::hypot(way.x(), way.y());
      const int steps = std::max(1, int(std::ceil(length_px / kStep_px)));
      for (int step = 0; step <= steps; ++step) {
        const QPointF at = from + way * (double(step) / steps);
        if (isTaken(at, along_px + length_px * step / steps)) {
          open = false;
          continue;
        }
        if (!std::exchange(open, true)) parts.emplace_back();
        parts.back() << at;
      }
      along_px += length_px;
    }
    return parts;
  }

 private:
  static constexpr double kStep_px = 2, kPlace_px = 5, kSameLine_px = 40;
  struct First {
    int pass;
    double along_px;
  };
  bool isTaken(const QPointF& at, double along_px) {
    const auto column = std::int64_t(std::floor(at.x() / kPlace_px)),
               row = std::int64_t(std::floor(at.y() / kPlace_px));
    for (std::int64_t x = column - 1; x <= column + 1; ++x) {
      for (std::int64_t y = row - 1; y <= row + 1; ++y) {
        const auto known = first_.find({x, y});
        if (known == first_.end()) continue;
        if (known->second.pass != pass_ || along_px - known->second.along_px > kSameLine_px) return true;
      }
    }
    first_.try_emplace({column, row}, First{pass_, along_px});
    return false;
  }

  int pass_ = 0;
  std::map<std::pair<std::int64_t, std::int64_t>, First> first_;
};

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
    std::array<DrawnPlaces, carry::kCrossings> drawn;
    const auto draw = [&](const carry::Stretch& stretch, const QPen& pen) {
      painter->setPen(pen);
      if (stretch.line.size() == 1) {
        painter->drawPoint(scene::toPoint(scene_.view().pixelFromWorld(stretch.line[0])));
        return;
      }
      for (const QPolygonF& line : scene::visibleLines(scene_.view(), stretch.line, 8)) {
        if (pen.style() == Qt::SolidLine) {
          painter->drawPolyline(line);
          continue;
        }
        for (const QPolygonF& part : drawn[std::size_t(stretch.what)].newOf(line))
          painter->drawPolyline(part);
      }
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
  connect(dock_, &RehearsalDock::cancelWanted, this,
          [this] { fail(tr("Cancelled."), tr("Cancelled. Press Again.")); });
  connect(dock_, &RehearsalDock::removeWanted, this, [this] {
    path_.clear();
    bag_.reset();
    good_.reset();
    forget({});
  });
  connect(dock_, &RehearsalDock::radiusChanged, this, [this] {
    if (!track_file_.isEmpty()) run(QString(track_file_));
  });
  connect(dock_, &RehearsalDock::placeWanted, this, &RehearsalController::goTo);
  connect(&context_.scene, &scene::MapScene::viewChanged, this, [this] { line_->follow(); });
  connect(&context_.scene, &scene::MapScene::contentChanged, this, [this] {
    if (good_ && !sameCells(good_->ground)) good_.reset();
    if (ground_ && !sameCells(*ground_))
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

bool RehearsalController::sameCells(const Ground& ground) const {
  const session::Session* const session = context_.current.session();
  if (!session) return false;
  const session::MapSlot& whole = session->wholeMap();
  return whole.cells() && whole.reference() == ground.map.reference &&
         (whole.cells() == ground.map.cells ||
          (!ground.content.empty() && whole.shown().fingerprint == ground.content));
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
  if (!session || !session->wholeMap().cells()) return fail(tr("There is no whole map on screen."));
  const session::MapSlot& whole = session->wholeMap();
  if (!whole.settled()) return fail(tr("The map on screen is still being read."));
  if (!whole.isWhole()) return fail(tr("Parts of the map on screen could not be read."));
  wait(tr("Reading %1…").arg(called()));
  ground_ = Ground{{whole.cells(), whole.reference()}, whole.shown().fingerprint};
  if (!bag_) return readFile();
  robot::BagLibrary* const library = this->library();
  if (!library) return fail(tr("The robot does not offer its recordings any more."));
  readRecording(*library, *bag_);
}

void RehearsalController::readFile() {
  if (replay::isTrackName(path_.toStdString())) return run(path_);
  auto robot = make_robot_(QStringLiteral("file:") + QFileInfo(path_).absoluteFilePath());
  if (!robot) return fail(robot.error());
  origin_ = std::move(*robot);
  robot::BagLibrary* const library = origin_->bagLibrary();
  if (!library) return fail(tr("This is no recording."));
  library->list([this, library, over = over_](const robot::Outcome<std::vector<robot::BagEntry>>& rows) {
    if (*over) return;
    if (!rows) return fail(QString::fromStdString(sentences::sentenceOf(rows.error())));
    if (rows->empty()) return fail(tr("This is no recording."));
    readRecording(*library, rows->front().key);
  });
}

QString RehearsalController::newTrackFile() const {
  const QString one = folder_.filePath(QStringLiteral("way.geojson"));
  return good_ && good_->track_file == one ? folder_.filePath(QStringLiteral("other.geojson")) : one;
}

void RehearsalController::readRecording(robot::BagLibrary& library, const robot::BagKey& key) {
  excerpt::Order order;
  order.kind = excerpt::Kind::TrackGeoJson;  // has the uids of the maps
  const QString path = newTrackFile();
  order.path = path.toStdString();
  job_ = std::make_unique<excerpt::ExcerptJob>(excerpt::ExcerptJob::Source{&library, key, {}}, order,
                                               context_.workers);
  const auto onEnded = [this, path, over = over_](const excerpt::Ended& ended) {
    if (*over) return;
    if (ended.not_read) return fail(QString::fromStdString(sentences::sentenceOf(*ended.not_read)));
    if (ended.not_written) return fail(sentences::sentenceOf(*ended.not_written));
    if (lost_.isEmpty() && !ended.holes.empty()) lost_ = tr("Parts of the recording cannot be read.");
    if (ended.written) run(path);
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
  options.driven_on = drivenOn();
  // As it is painted at present.
  if (const auto drawn = context_.scene.wholeMap(); drawn && drawn->reference == map.reference) map = *drawn;
  run_.start([this, file = track_file.toStdString(), map, options](const auto&) -> BackgroundRun::Then {
    const auto bytes = disk::readFile(file, kMostTrackBytes);
    if (!bytes) return [this, why = bytes.error()] { fail(sentences::wordsOf(why.cause)); };
    std::vector<map::MapIdentity> maps;
    const auto track = replay::trackFrom(*bytes, &maps);
    if (!track)
      return [this] { fail(tr("This is no track. Choose a recording, or a track that was exported.")); };
    std::vector<carry::WayPoint> way;
    for (const replay::TrackPoint& point : *track)
      way.push_back({{point.pose.x_m, point.pose.y_m}, point.stamp_s, point.piece, point.map});
    return [this, found = carry::Rehearsal(map, options).of(way, maps)] { onRehearsed(found); };
  });
}

map::MapIdentity RehearsalController::drivenOn() const {
  const session::Session* const session = context_.current.session();
  if (!session) return {};
  const session::MapSlot& whole = session->wholeMap();
  const map::MapKey key = laid_ ? laid_->key : whole.key();
  if (laid_ && laid_->reader != &session->robot()) return {{}, laid_->name};
  const session::Catalogue& catalogue = session->catalogue();
  const auto* const entry = key.kind == map::MapKind::Live ? catalogue.current() : catalogue.find(key);
  if (entry) return {entry->uid, entry->name};
  return {{}, laid_ ? laid_->name : whole.shown().name};
}

void RehearsalController::onRehearsed(const carry::Rehearsed& way) {
  const QString lies =
      laid_ ? tr("It was moved as the reference map lies.") : tr("It lies as it was recorded.");
  const QString said = words::about(called(), words::paragraph({carry::rehearsedText(way), lies, lost_}));
  if (way.points == 0) return fail(said, said);
  const bool edited = std::exchange(edited_, false);
  good_ = Good{path_, bag_, track_file_, lost_, said, *ground_, way.stretches, way.crossed()};
  show(said);
  if (edited) onEdited();
  geometry::WorldRect all;
  for (const carry::Stretch& stretch : way.stretches) {
    for (const Eigen::Vector2d& at : stretch.line) all.extend(at);
  }
  if (!all.empty()) context_.viewpoint.lookAt(all);
}

void RehearsalController::show(const QString& said) {
  crossed_ = good_->crossed;
  line_->show(good_->stretches);
  dock_->setStretches(crossed_);
  dock_->setBusy(false);
  dock_->setSaid(said);
}

void RehearsalController::fail(const QString& why, const QString& why_nothing) {
  if (!good_ || !sameCells(good_->ground)) {
    good_.reset();
    return forget(why_nothing.isEmpty() ? why : why_nothing);
  }
  const QString of = called(), start = why.startsWith(of) ? why : words::about(of, why);
  path_ = good_->path;
  bag_ = good_->bag;
  forget({});
  track_file_ = good_->track_file;
  lost_ = good_->lost;
  ground_ = good_->ground;
  edited_ = good_->edited;
  const QString still = tr("Still shown: %1").arg(good_->said);
  show(QStringLiteral("%1\n%2").arg(
      start,
      edited_ ? tr("The map on screen has changed since then. As it was: %1").arg(good_->said) : still));
}

void RehearsalController::onEdited() {
  if (good_) good_->edited = true;
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
  dock_->setStretches({});
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
  good_.reset();
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
  good_.reset();
  dock_->setRadius(0);  // it was that of the robot before
  forget({});
  if (!session) return;
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    if (what == map::topicIndex<map::RobotModel>()) syncRobot();
  });
}

}  // namespace mapwright::ui

#include "moc_rehearsal_controller.cpp"
