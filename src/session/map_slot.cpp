#include "session/map_slot.h"

#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>

#include "grids/grid_pyramid.h"
#include "session/faults.h"

namespace mapwright::session {
namespace {

constexpr std::chrono::milliseconds kStillWithin{200};

/// Names the picture, where the map is another file: a map.yaml.
Fault ofPicture(const map::WholeMap& map, Fault why) {
  const std::string file = map.path.substr(map.path.rfind('/') + 1);
  if (map.key.kind != map::MapKind::File || file.empty() || file == map.name) return why;
  return {FaultCode{"session", QT_TRANSLATE_NOOP("session", "Picture %1"), FaultCode::Causes::Capital},
          {file},
          {std::move(why)}};
}

}  // namespace

struct MapSlot::Opened {
  map::WholeMap source;  // as it came
  map::WholeMap map;     // grid has the picture's own size, without the bytes
  std::unique_ptr<grids::GridReading> reading;
  std::shared_ptr<const grids::GridPyramid> cells;
  std::optional<Fault> error;  // instead of all the above
  std::vector<Fault> notes;
  quint64 generation = 0;
};

/// Where pyramids say that their file is damaged, from any thread.
struct MapSlot::Listener {
  std::mutex mutex;
  MapSlot* slot = nullptr;  // null: gone
};

MapSlot::MapSlot(QString sidecar_folder, const grids::Resources& resources, QObject* parent)
    : QObject(parent),
      sidecar_folder_(std::move(sidecar_folder)),
      listener_(std::make_shared<Listener>()),
      resources_(std::make_unique<grids::Resources>(work::orOwn(resources.workers), resources.unpacked)),
      tasks_(resources_->workers) {
  listener_->slot = this;
}

MapSlot::~MapSlot() {
  {
    const std::lock_guard lock(listener_->mutex);
    listener_->slot = nullptr;
  }
  cancel();
  tasks_.waitForDone();
}

bool MapSlot::broken() const { return broken_ || (shown_cells_ && shown_cells_->trouble().any()); }

bool MapSlot::isWhole() const { return shown_cells_ && shown_whole_ && !shown_cells_->trouble().any(); }

map::Subject MapSlot::subject() const { return map::subjectOf(key_, name_.toStdString()); }

void MapSlot::cancel() {
  ++generation_;
  if (cancelled_) cancelled_->store(true);
  cancelled_.reset();
  reading_.reset();
  next_.reset();
}

void MapSlot::expect(const map::MapKey& key, const QString& name) {
  cancel();
  key_ = key;
  name_ = name;
  coming_waypoints_.reset();
  waypoints_awaited_ = false;
  remark_.reset();
  phase_ = Phase::Fetching;
  Q_EMIT changed();
}

void MapSlot::show(map::WholeMap map) {
  if (phase_ == Phase::Reading && source_ && source_->key == map.key) {
    // A map that changes faster than it can be read would never be seen: this one is read to its end first.
    next_ = std::move(map);
    return;
  }
  cancel();
  key_ = map.key;
  name_ = QString::fromStdString(map.name);
  source_ = std::move(map);
  start();
}

void MapSlot::setAveraged(bool averaged) {
  if (averaged == averaged_) return;
  averaged_ = averaged;
  if (!source_ || phase_ == Phase::Fetching) return;
  cancel();
  start();
}

/// On the thread that reads.
std::shared_ptr<MapSlot::Opened> MapSlot::open(const map::WholeMap& map, const grids::GridOptions& options,
                                               quint64 generation) {
  auto opened = std::make_shared<Opened>();
  opened->source = map;
  opened->map = map;
  opened->generation = generation;
  auto reading = map.cells   ? grids::openGrid(map.cells, map.grid.width, map.grid.height, options)
                 : map.bytes ? grids::openGrid(map.bytes, options)
                             : grids::openGridFile(map.path, options);
  opened->map.bytes.reset();
  opened->map.cells.reset();
  if (!reading) {
    opened->error = ofPicture(map, reading.error());
    return opened;
  }
  opened->reading = std::move(*reading);
  opened->cells = opened->reading->pyramid();
  map::GridReference& grid = opened->map.grid;
  const int width = opened->cells->width(), height = opened->cells->height();
  if ((grid.width > 0 && grid.width != width) || (grid.height > 0 && grid.height != height)) {
    opened->notes.push_back({faultText("session",
                                       "Its metadata says %1 x %2 cells, but its picture has %3 x %4. The "
                                       "size of the picture is used."),
                             {grid.width, grid.height, width, height}});
  }
  grid.width = width;
  grid.height = height;
  if (!std::isfinite(grid.origin.yaw_rad)) {
    grid.origin.yaw_rad = 0;
    opened->notes.push_back(
        faultText("session", "The rotation of its origin is not a number. It is shown without rotation."));
  }
  return opened;
}

void MapSlot::start() {
  remark_.reset();
  broken_ = false;
  phase_ = Phase::Reading;
  if (const auto why = map::unusableReason(source_->grid)) {
    fail({map::Severity::Error, subject(), *why, map::ProblemCode::Unreadable});
    return;
  }
  for (map::Problem note : source_->notes) {
    note.subject = subject();
    note.code = map::ProblemCode::Odd;
    Q_EMIT problemFound(note);
    if (note.severity != map::Severity::Info && !remark_) remark_ = note;
  }
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  grids::GridOptions options;
  options.reading = source_->reading;
  options.reduction = averaged_ ? grids::Reduction::Average : grids::Reduction::OccupiedWins;
  options.resources = *resources_;
  if (source_->key.kind != map::MapKind::Live) {
    options.sidecar_folder = sidecar_folder_.toStdString();
    options.fingerprint = source_->fingerprint;
    options.sidecar_from_cells = kLargeCells;
    options.damaged = [listener = listener_, generation = generation_](grids::GridDamage damage) {
      const std::lock_guard lock(listener->mutex);
      MapSlot* const slot = listener->slot;
      if (!slot) return;
      QMetaObject::invokeMethod(
          slot,
          [slot, generation, damage] { slot->onDamage(generation, damage == grids::GridDamage::Mended); },
          Qt::QueuedConnection);
    };
  }
  tasks_.startLong([this, generation = generation_, cancelled = cancelled_, map = *source_,
                    options]() mutable {
    const auto call = [&](auto what) { QMetaObject::invokeMethod(this, what, Qt::QueuedConnection); };
    for (;;) {
      const auto opened = open(map, options, generation);
      call([this, generation, opened] { onOpened(generation, opened); });
      if (!opened->reading) return;
      std::optional<Fault> error;
      if (!opened->reading->complete()) {
        error = opened->reading->read(*cancelled, [&] { call([this, generation] { onRows(generation); }); });
      }
      options.code = opened->reading->otherCode();
      if (options.code) continue;  // then nothing more has to be judged
      call([this, generation, error] { onEnd(generation, error); });
      return;
    }
  });
  Q_EMIT changed();
}

void MapSlot::onOpened(quint64 generation, const std::shared_ptr<Opened>& opened) {
  if (generation != generation_) return;
  if (opened->error) {
    auto next = std::exchange(next_, std::nullopt);
    if (!opened->map.fingerprint.empty()) Q_EMIT unreadable(opened->map.fingerprint);
    fail({map::Severity::Error, subject(), *opened->error, map::ProblemCode::Unreadable});
    if (next) show(std::move(*next));
    return;
  }
  const bool said = reading_ && reading_->generation == generation;  // it is being read once more
  for (const Fault& note : said ? std::vector<Fault>() : opened->notes) {
    const map::Problem problem{map::Severity::Warning, subject(), note, map::ProblemCode::Odd};
    if (!remark_) remark_ = problem;
    Q_EMIT problemFound(problem);
  }
  reading_ = opened;
  const bool whole_shown = shown_cells_ && shown_.key == opened->map.key && shown_cells_->complete();
  const bool update = whole_shown && !opened->cells->complete();
  if (!update) put(opened, false);
}

void MapSlot::put(const std::shared_ptr<Opened>& opened, bool whole) {
  if (!(shown_.key == opened->map.key)) waypoints_ = {};
  if (coming_waypoints_) waypoints_ = *std::exchange(coming_waypoints_, std::nullopt);
  shown_ = opened->map;
  shown_source_ = opened->source;
  shown_cells_ = opened->cells;
  shown_generation_ = opened->generation;
  shown_whole_ = whole;
  Q_EMIT changed();
}

void MapSlot::onDamage(quint64 generation, bool mended) {
  if (mended) {
    Q_EMIT problemFound(
        {map::Severity::Info, subject(),
         faultText("session", "The cached copy was damaged. The map was read again from its picture."),
         map::ProblemCode::Odd});
    return;
  }
  if (generation != shown_generation_ || !shown_cells_) return;
  broken_ = true;
  remark_ = {map::Severity::Error, subject(), ofPicture(shown_, shown_cells_->trouble()),
             map::ProblemCode::Unreadable};
  Q_EMIT problemFound(*remark_);
  Q_EMIT changed();
}

void MapSlot::onRows(quint64 generation) {
  if (generation != generation_ || !reading_) return;
  if (reading_->cells == shown_cells_) Q_EMIT rowsArrived();
}

void MapSlot::onEnd(quint64 generation, const std::optional<Fault>& error) {
  if (generation != generation_ || !reading_) return;
  const auto opened = std::exchange(reading_, nullptr);
  if (const Fault trouble = opened->reading->notKept(); trouble.any() && !cache_told_) {
    cache_told_ = true;
    Q_EMIT problemFound({map::Severity::Warning, map::SubjectKind::DiskCache, trouble});
  }
  phase_ = Phase::Ready;
  broken_ = error.has_value();
  if (error) {
    remark_ = {map::Severity::Error, subject(), ofPicture(opened->map, *error), map::ProblemCode::Unreadable};
    if (!opened->map.fingerprint.empty()) Q_EMIT unreadable(opened->map.fingerprint);
    Q_EMIT problemFound(*remark_);
  } else if (!remark_) {
    Q_EMIT recovered({subject()});
  } else {
    Q_EMIT recovered({subject(), map::ProblemCode::Unavailable});
    Q_EMIT recovered({subject(), map::ProblemCode::Unreadable});
  }
  if (opened->cells == shown_cells_) {
    shown_whole_ = !error;
    Q_EMIT rowsArrived();
    Q_EMIT changed();
  } else {
    put(opened, !error);
  }
  if (next_) show(*std::exchange(next_, std::nullopt));
}

void MapSlot::fail(map::Problem problem) {
  // The finder may use another name for the map; recoveries refer to this slot's map.
  problem.subject = subject();
  if (problem.code == map::ProblemCode::Unspecified) problem.code = map::ProblemCode::Unavailable;
  // A robot that does not send this map works as it should.
  if (problem.failure == map::FailureKind::Unsupported && key_.kind == map::MapKind::Stored)
    problem.severity = map::Severity::Info;
  cancel();
  phase_ = Phase::Failed;
  failure_ = problem.failure;
  remark_ = problem;
  if (!(shown_.key == key_)) {
    shown_ = {};
    shown_source_.reset();
    shown_cells_.reset();
    waypoints_ = {};
  }
  Q_EMIT problemFound(problem);
  Q_EMIT changed();
}

void MapSlot::clear() {
  cancel();
  phase_ = Phase::Empty;
  key_ = {};
  name_.clear();
  remark_.reset();
  source_.reset();
  shown_ = {};
  shown_source_.reset();
  shown_cells_.reset();
  waypoints_ = {};
  coming_waypoints_.reset();
  Q_EMIT changed();
}

void MapSlot::standStill() {
  cancel();
  waypoints_awaited_ = false;
  tasks_.waitForDone(kStillWithin);  // a row or two may be on their way into the picture
}

double MapSlot::progress() const {
  if (phase_ != Phase::Reading || !reading_ || !reading_->cells) return phase_ == Phase::Ready ? 1 : 0;
  return double(reading_->cells->rowsReady()) / reading_->cells->height();
}

void MapSlot::setWaypoints(map::WaypointList waypoints) {
  const map::Subject places = map::placesOf(key_, name_.toStdString());
  Q_EMIT recovered({places});
  for (const Fault& note : waypoints.notes) {
    Q_EMIT problemFound({map::Severity::Warning, places, note, map::ProblemCode::Odd});
  }
  if (shown_cells_ && shown_.key == key_) {
    waypoints_ = std::move(waypoints);
    Q_EMIT changed();
  } else {
    coming_waypoints_ = std::move(waypoints);
  }
}

}  // namespace mapwright::session

#include "moc_map_slot.cpp"
