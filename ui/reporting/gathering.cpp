#include "ui/reporting/gathering.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>

#include "robot/sends_map.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui::reporting {
namespace {

using incident::remainingWay;
using incident::utcText;
using shot::Awaited;
using shot::Stage;

class GatheringText {
  Q_DECLARE_TR_FUNCTIONS(Incident)
};

constexpr int kLookEveryMs = 20, kTries = 3;
constexpr double kAroundM = 6, kMostAroundM = 40, kPictureMarginPx = 40;
constexpr double kDotsPerMeter = 96 / 0.0254;  // whatever screen there is
constexpr std::size_t kLongestMessage = 4096;

session::Session::Options optionsOf(std::shared_ptr<work::Workers> workers) {
  session::Session::Options options;
  options.workers = std::move(workers);
  // What is opened depends on the bag alone, not on how fast something comes.
  options.overview = options.maps = false;
  return options;
}

std::unique_ptr<replay::ReplayRobot> replayOf(std::unique_ptr<robot::Robot> origin, const Wanted& wanted) {
  return wanted.any_kind ? std::make_unique<replay::ReplayRobot>(std::move(origin), wanted.bag.name)
                         : std::make_unique<replay::ReplayRobot>(std::move(origin), wanted.bag);
}

/// Topics that tell of bumpers and stops, in whatever form.
bool isAboutSafety(const std::string& topic) {
  const QString name = QString::fromStdString(topic).toLower();
  return name.contains(QLatin1String("bumper")) || name.contains(QLatin1String("safety")) ||
         name.contains(QLatin1String("emergency")) || name.contains(QLatin1String("estop")) ||
         name.contains(QLatin1String("e_stop")) || name.contains(QLatin1String("protective"));
}

}  // namespace

Gathering::Gathering(std::unique_ptr<robot::Robot> origin, Wanted wanted,
                     std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      wanted_(std::move(wanted)),
      workers_(std::move(workers)),
      session_(replayOf(std::move(origin), wanted_), optionsOf(workers_)),
      replayed_(qobject_cast<replay::ReplayRobot*>(&session_.robot())),
      recall_(session_, *replayed_) {
  run_.name = wanted_.bag.name;
  map::Streams streams;
  for (const scene::Layer layer : scene::layersIn(scene::LayerSet::Report))
    streams.merge(scene::layerStreams(layer));
  session_.want(QStringLiteral("incident"), streams);
  connect(&poll_, &QTimer::timeout, this, &Gathering::look);
}

Gathering::~Gathering() = default;

void Gathering::start() {
  poll_.start(kLookEveryMs);
  session_.open();
}

void Gathering::fail(const QString& sentence, map::FailureKind kind) {
  error_ = sentence;
  failure_ = kind;
  end(Stage::Failed);
}

void Gathering::end(Stage stage) {
  if (shot_.over()) return;
  shot_.enter(stage);
  poll_.stop();
  Q_EMIT ended();
}

bool Gathering::opened() {
  const robot::ConnectionState link = session_.connection();
  if (link.phase == robot::ConnectionPhase::Refused)
    fail(words::about(words::plainName(wanted_.bag.name), sentences::sentenceOf(link.reason)), link.failure);
  if (shot_.over() || link.phase != robot::ConnectionPhase::Online) return false;
  if (replayed_->at() || minute_) return true;
  const robot::BagInfo& info = *replayed_->reading()->info();
  run_.info = info;
  if (!wanted_.at_s) return true;
  const QString why = incident::notWithinReason(wanted_.bag.name, info, *wanted_.at_s, !replayed_->isLocal());
  if (!why.isEmpty()) fail(why, map::FailureKind::Unsupported);
  return why.isEmpty();
}

bool Gathering::momentChosen() {
  if (minute_) return true;
  replay::Reading& reading = *replayed_->reading();
  if (!wanted_.at_s) {
    reading.setWhole(true);
    if (!reading.chunks().wanted()) reading.want(reading.chunks().end_s());
    const replay::Cell* const obstacle = reading.chunks().obstacleUntil(HUGE_VAL);
    if (obstacle && replay::isFinal(*obstacle))
      fail(QString::fromStdString(sentences::sentenceOf(obstacle->failure)), obstacle->failure.kind);
    if (shot_.over() || !reading.chunks().wholeSettled()) return false;
    double least_m = std::numeric_limits<double>::infinity();
    for (const auto& [from, digest] : reading.index().digests()) {
      for (const replay::Digest::Pose& pose : digest.poses) {
        const double away_m = (replay::placeOf(pose).position_m - *wanted_.near_m).norm();
        if (away_m >= least_m) continue;
        least_m = away_m;
        wanted_.at_s = pose.stamp_s;
      }
    }
    if (!wanted_.at_s) {
      fail(GatheringText::tr("%1 has no position, so the same place cannot be found. Give the time instead.")
               .arg(words::plainName(wanted_.bag.name)),
           map::FailureKind::Unsupported);
      return false;
    }
  }
  run_.at_s = *wanted_.at_s;
  minute_.emplace(run_.at_s);
  shot_.enter(Stage::Reading);
  recall_.goTo(run_.at_s);
  return true;
}

void Gathering::look() {
  if (!shot_.waits() || !opened() || !momentChosen()) return;
  if (const auto failure = recall_.failure())
    return fail(QString::fromStdString(sentences::sentenceOf(*failure)), failure->kind);
  if (!recall_.in()) {
    const auto all = double(std::max<std::int64_t>(run_.info.messages.value_or(1), 1));
    Q_EMIT progressed(std::min(1.0, double(replayed_->reading()->chunks().messagesRead()) / all));
    return;
  }
  if (!shot_.connected()) {
    shot_.enter(Stage::Settling);
    openMap();
    shot_.await(Awaited::Messages, [this] { return minuteRead(); });
    shot_.await(Awaited::WholeMap, [this] { return mapIn(); });
  }
  if (!shot_.missing()) draw();
}

bool Gathering::minuteRead() {
  replay::Reading& reading = *replayed_->reading();
  const double until_s = std::min(minute_->until(), reading.chunks().end_s());
  if (!awaited_) {
    // What is wanted stays the moment: the robot may tell its state again at any time.
    reading.setWhole(true);
    const replay::Cell* const obstacle = reading.chunks().obstacleUntil(until_s);
    if (!reading.chunks().settledUntil(until_s) && !(obstacle && replay::isFinal(*obstacle))) return false;
    reading.setWhole(false);
    std::set<replay::Tick> needed;
    for (const auto& [from, cell] : reading.chunks().cells()) {
      if (cell.state == replay::CellState::Read && replay::secondsOf(cell.until) > minute_->from() &&
          replay::secondsOf(cell.from) <= minute_->until())
        needed.insert(from);
    }
    for (const auto& [topic, stamp_s] : replayed_->topics()) {
      const replay::Cell* const cell = isAboutSafety(topic) ? reading.chunks().cellAt(stamp_s) : nullptr;
      if (cell) needed.insert(cell->from);
    }
    awaited_.emplace();
    std::vector<replay::Tick> again;
    for (const replay::Tick from : needed) {
      awaited_->insert(from);
      if (const replay::ChunkPtr chunk = reading.chunkAt(from)) {
        take(chunk);
      } else {
        again.push_back(from);
      }
    }
    connect(&reading, &replay::Reading::chunkRead, this, &Gathering::take);
    if (!again.empty()) reading.readAgain(again);
  }
  for (auto it = awaited_->begin(); it != awaited_->end();) {
    const replay::Cell* const cell = reading.chunks().find(*it);
    it = !cell || cell->tries >= kTries ? awaited_->erase(it) : std::next(it);
  }
  return awaited_->empty();
}

void Gathering::take(const replay::ChunkPtr& chunk) {
  if (awaited_->erase(replay::tickOf(chunk->from_s)) == 0) return;
  minute_->take(*chunk);
  addMessages(*chunk);
}

void Gathering::addMessages(const replay::Chunk& chunk) {
  const std::size_t end = chunk.countUntil(run_.at_s);
  for (std::size_t place = 0; place < end; ++place) {
    const robot::BagMessage& message = chunk.at(place);
    const std::string& topic = message.message.topic;
    if (message.known || !replay::isRecorded(message) || message.size > kLongestMessage ||
        !isAboutSafety(topic))
      continue;
    const auto last = replayed_->topics().find(topic);
    if (last == replayed_->topics().end() || last->second != message.message.received_s) continue;
    run_.said[topic] = std::string(chunk.source->textOf(message));
  }
}

void Gathering::openMap() {
  const map::World& world = session_.world();
  if (world.submaps) return;
  if (world.live.grids.contains(map::GridKind::WholeMap) || replayed_->picturesUnderWay() > 0) {
    session_.openMap({map::MapKind::Live, {}});
  } else if (session_.robot().mapCatalogue()) {
    session_.catalogue().refresh();
  }
}

bool Gathering::mapIn() {
  if (replayed_->picturesUnderWay() > 0 || session_.layerGrids().busy()) return false;
  if (session_.world().submaps) {
    const geometry::ViewTransform view = chosenView();
    session_.setView(view.visibleWorld(), view.center_m);
    return session_.settled(kTries);
  }
  session::MapSlot& slot = session_.wholeMap();
  if (session_.catalogue().loading()) return false;
  if (session_.catalogue().asked() && slot.phase() == session::MapSlot::Phase::Empty) {
    const auto& entries = session_.catalogue().entries();
    const map::CatalogueEntry* entry = session_.catalogue().current();
    if (!entry && entries.size() == 1) entry = &entries.front();
    if (entry && !(robot::givesByRegion(session_.robot()) && !session_.robot().isLocal()))
      session_.openMap(entry->key);
  }
  return slot.settled() && !slot.waypointsAwaited();
}

void Gathering::onState() {
  replay::Reading& reading = *replayed_->reading();
  run_.live = session_.live();
  run_.topics = replayed_->topics();
  minute_->addPoses(reading.index().digests());
  run_.curves = minute_->curves();
  run_.conditions = incident::conditionsAt(reading.index().digests(), run_.at_s);
  run_.events = replay::eventsOf(reading.index().digests());
  for (const auto& [from, digest] : reading.index().digests()) {
    for (const replay::Digest::Kept& kept : digest.history)
      run_.first_s.try_emplace(kept.message.index(), kept.stamp_s);
  }
  std::erase_if(run_.events, [&](const replay::Event& event) { return event.at_s > minute_->until(); });
  const session::MapSlot& slot = session_.wholeMap();
  if (run_.live.map_info) {
    run_.map_name = run_.live.map_info->name;
    run_.overlays = run_.live.map_info->overlays;
  }
  if (slot.cells()) {
    if (run_.map_name.empty()) run_.map_name = slot.name().toStdString();
    if (run_.overlays.empty()) run_.overlays = slot.shown().overlays;
    run_.map_of_now = slot.shown().key.kind != map::MapKind::Live && !session_.robot().isLocal();
  }
  if (slot.phase() == session::MapSlot::Phase::Failed && slot.remark())
    run_.remarks << GatheringText::tr("The map is not drawn. %1").arg(sentences::sentenceOf(*slot.remark()));
  const session::SubmapCounts counts = session_.counts();
  if (session_.world().submaps && counts.shown < counts.listed)
    run_.remarks << GatheringText::tr("Submaps that could not be drawn: %1 of %2.")
                        .arg(counts.listed - counts.shown)
                        .arg(counts.listed);
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    if (!row.resolved && row.problem.subject.kind == map::SubjectKind::Bag &&
        row.problem.severity >= map::Severity::Warning)
      run_.remarks << sentences::sentenceOf(row.problem);
  }
  // What is lost up to the moment is among them.
  const double later_s = std::nextafter(run_.at_s, HUGE_VAL);
  if (const auto holes = reading.chunks().holes(later_s, minute_->until()); !holes.empty())
    run_.remarks << sentences::sentenceOf(replay::faultOf(holes));
  run_.remarks.removeDuplicates();
}

geometry::ViewTransform Gathering::chosenView() const {
  if (wanted_.view) return *wanted_.view;
  geometry::ViewTransform view;
  view.width_px = wanted_.picture_px.width();
  view.height_px = wanted_.picture_px.height();
  const auto& pose = session_.live().robot_pose;
  geometry::WorldRect bounds;
  if (!pose) {
    bounds.extend(session_.contentBounds());
    if (session_.wholeMap().cells()) bounds.extend(session_.wholeMap().reference().bounds());
    return view.fitted(bounds, kPictureMarginPx);
  }
  const Eigen::Vector2d robot(pose->x_m, pose->y_m);
  bounds.extend(robot);
  bounds = bounds.grown(kAroundM);
  for (const Eigen::Vector2d& point : remainingWay(session_.live()).points) {
    if ((point - robot).norm() < kMostAroundM) bounds.extend(point);
  }
  return view.fitted(bounds, kPictureMarginPx);
}

void Gathering::draw() {
  shot_.enter(Stage::Drawing);
  view_ = chosenView();
  onState();
  // Drawing takes a while. Nothing may change meanwhile.
  session_.standStill();
  session_.close();
  const bool whole = session_.wholeMap().cells() != nullptr;
  if (!whole && !session_.world().submaps && !run_.live.robot_pose) return end(Stage::Done);
  shot::Look look;
  look.view = view_;
  look.layers = scene::layersIn(scene::LayerSet::Report);
  if (whole) look.layers.insert(scene::Layer::WholeMap);
  if (session_.world().submaps) look.layers.insert(scene::Layer::Submaps);
  picture_ = std::make_unique<shot::ScenePicture>(std::move(look), session_, workers_);
  connect(picture_.get(), &shot::Picture::finished, this, &Gathering::onPicture);
  picture_->start();
}

void Gathering::onPicture() {
  if (shot_.over()) return;
  QImage image = picture_->image();
  image.setDotsPerMeterX(int(kDotsPerMeter));
  image.setDotsPerMeterY(int(kDotsPerMeter));
  QBuffer buffer(&run_.picture);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  run_.picture_px = image.size();
  end(Stage::Done);
}

}  // namespace mapwright::ui::reporting

#include "moc_gathering.cpp"
