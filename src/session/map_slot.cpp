#include "session/map_slot.h"

#include <cmath>
#include <mutex>
#include <utility>

#include "raster/stand_back.h"

namespace mapwright::session {
namespace {

constexpr int kStillWithinMs = 200;

}  // namespace

struct MapSlot::Opened {
  map::WholeMap source;  // as it came
  map::WholeMap map;     // grid has the picture's own size, without the bytes
  std::unique_ptr<raster::GridReading> reading;
  std::shared_ptr<const raster::GridPyramid> cells;
  std::optional<raster::GridError> error;  // instead of all the above
  std::vector<std::string> notes;
  quint64 generation = 0;
};

/// Where pyramids say that their file is damaged, from any thread.
struct MapSlot::Ear {
  std::mutex mutex;
  MapSlot* slot = nullptr;  // null: gone
};

MapSlot::MapSlot(QString sidecar_folder, QObject* parent)
    : QObject(parent), sidecar_folder_(std::move(sidecar_folder)), ear_(std::make_shared<Ear>()) {
  ear_->slot = this;
  // Two: a map that nobody wants any more may take a moment to notice.
  pool_.setMaxThreadCount(2);
}

MapSlot::~MapSlot() {
  {
    const std::lock_guard lock(ear_->mutex);
    ear_->slot = nullptr;
  }
  cancel();
  pool_.waitForDone();
}

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
  remark_.clear();
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
  if (!map.name.empty() || key_.kind != map::MapKind::Live) name_ = QString::fromStdString(map.name);
  source_ = std::move(map);
  start();
}

void MapSlot::setReduction(raster::Reduction reduction) {
  if (reduction == reduction_) return;
  reduction_ = reduction;
  if (!source_ || phase_ == Phase::Fetching) return;
  cancel();
  start();
}

void MapSlot::start() {
  remark_.clear();
  broken_ = false;
  phase_ = Phase::Reading;
  if (const auto why = map::whyUnusable(source_->grid)) {
    fail({map::Severity::Error, subject(), *why, map::ProblemCode::Unreadable});
    return;
  }
  for (map::Problem note : source_->notes) {
    note.subject = subject();
    note.code = map::ProblemCode::Odd;
    Q_EMIT problemFound(note);
    if (note.severity != map::Severity::Info)
      remark_ = remark_.isEmpty() ? QString::fromStdString(note.sentence) : remark_;
  }
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  raster::GridOptions options;
  options.reading = source_->reading;
  options.reduction = reduction_;
  if (source_->key.kind != map::MapKind::Live) {
    options.sidecar_folder = sidecar_folder_.toStdString();
    options.fingerprint = source_->fingerprint;
    options.sidecar_from_cells = kLargeCells;
    options.damaged = [ear = ear_, generation = generation_](raster::GridDamage damage) {
      const std::lock_guard lock(ear->mutex);
      MapSlot* const slot = ear->slot;
      if (!slot) return;
      QMetaObject::invokeMethod(
          slot, [slot, generation, damage] { slot->takeDamage(generation, damage); }, Qt::QueuedConnection);
    };
  }
  pool_.start([this, generation = generation_, cancelled = cancelled_, map = *source_, options] {
    raster::standBack();
    auto opened = std::make_shared<Opened>();
    opened->source = map;
    opened->map = map;
    opened->generation = generation;
    auto reading = map.bytes ? raster::openGrid(map.bytes, options) : raster::openGridFile(map.path, options);
    opened->map.bytes.reset();
    if (!reading) {
      opened->error = reading.error();
    } else {
      opened->reading = std::move(*reading);
      opened->cells = opened->reading->pyramid();
      map::GridReference& grid = opened->map.grid;
      const int width = opened->cells->width(), height = opened->cells->height();
      if ((grid.width > 0 && grid.width != width) || (grid.height > 0 && grid.height != height)) {
        opened->notes.push_back("It is said to have " + std::to_string(grid.width) + " x " +
                                std::to_string(grid.height) + " cells, but its picture has " +
                                std::to_string(width) + " x " + std::to_string(height) +
                                ". It is shown as the picture has it.");
      }
      grid.width = width;
      grid.height = height;
      if (!std::isfinite(grid.origin.yaw_rad)) {
        grid.origin.yaw_rad = 0;
        opened->notes.push_back("The turn of its origin is not a number. It is shown unturned.");
      }
    }
    const auto call = [&](auto what) { QMetaObject::invokeMethod(this, what, Qt::QueuedConnection); };
    call([this, generation, opened] { takeOpened(generation, opened); });
    if (!opened->reading) return;
    std::optional<raster::GridError> error;
    if (!opened->reading->complete()) {
      error = opened->reading->read(*cancelled, [&] { call([this, generation] { takeRows(generation); }); });
    }
    call([this, generation, error] { takeEnd(generation, error); });
  });
  Q_EMIT changed();
}

void MapSlot::takeOpened(quint64 generation, const std::shared_ptr<Opened>& opened) {
  if (generation != generation_) return;
  if (opened->error) {
    auto next = std::exchange(next_, std::nullopt);
    if (!opened->map.fingerprint.empty()) Q_EMIT unreadable(opened->map.fingerprint);
    fail({map::Severity::Error, subject(), opened->error->sentence, map::ProblemCode::Unreadable});
    if (next) show(std::move(*next));
    return;
  }
  for (const std::string& note : opened->notes) {
    Q_EMIT problemFound({map::Severity::Warning, subject(), note, map::ProblemCode::Odd});
    if (remark_.isEmpty()) remark_ = QString::fromStdString(note);
  }
  reading_ = opened;
  const bool update = shown_cells_ && shown_.key == opened->map.key && !opened->cells->complete();
  if (!update) put(opened);
}

void MapSlot::put(const std::shared_ptr<Opened>& opened) {
  if (!(shown_.key == opened->map.key)) waypoints_ = {};
  if (coming_waypoints_) waypoints_ = *std::exchange(coming_waypoints_, std::nullopt);
  shown_ = opened->map;
  shown_source_ = opened->source;
  shown_cells_ = opened->cells;
  shown_generation_ = opened->generation;
  Q_EMIT changed();
}

void MapSlot::takeDamage(quint64 generation, raster::GridDamage damage) {
  if (damage == raster::GridDamage::Mended) {
    Q_EMIT problemFound({map::Severity::Info, subject(),
                         "Its copy in the cache was damaged. The map was read again from its picture.",
                         map::ProblemCode::Odd});
    return;
  }
  if (generation != shown_generation_ || !shown_cells_) return;
  const std::string trouble = shown_cells_->trouble();
  broken_ = true;
  remark_ = QString::fromStdString(trouble);
  Q_EMIT problemFound({map::Severity::Error, subject(), trouble, map::ProblemCode::Unreadable});
  Q_EMIT changed();
}

void MapSlot::takeRows(quint64 generation) {
  if (generation != generation_ || !reading_) return;
  if (reading_->cells == shown_cells_) Q_EMIT rowsArrived();
}

void MapSlot::takeEnd(quint64 generation, const std::optional<raster::GridError>& error) {
  if (generation != generation_ || !reading_) return;
  const auto opened = std::exchange(reading_, nullptr);
  if (const std::string trouble = opened->reading->notKept(); !trouble.empty() && !cache_told_) {
    cache_told_ = true;
    Q_EMIT problemFound({map::Severity::Warning, "Disk cache", trouble});
  }
  phase_ = Phase::Ready;
  broken_ = error.has_value();
  if (error) {
    remark_ = QString::fromStdString(error->sentence);
    if (!opened->map.fingerprint.empty()) Q_EMIT unreadable(opened->map.fingerprint);
    Q_EMIT problemFound({map::Severity::Error, subject(), error->sentence, map::ProblemCode::Unreadable});
  } else if (remark_.isEmpty()) {
    Q_EMIT recovered({subject()});
  } else {
    Q_EMIT recovered({subject(), map::ProblemCode::Unavailable});
    Q_EMIT recovered({subject(), map::ProblemCode::Unreadable});
  }
  if (opened->cells == shown_cells_) {
    Q_EMIT rowsArrived();
    Q_EMIT changed();
  } else {
    put(opened);
  }
  if (next_) show(*std::exchange(next_, std::nullopt));
}

void MapSlot::fail(map::Problem problem) {
  // Whoever found it may call the map otherwise; what recovers later is this slot's map.
  problem.subject = subject();
  if (problem.code == map::ProblemCode::Unspecified) problem.code = map::ProblemCode::Unavailable;
  cancel();
  phase_ = Phase::Failed;
  failure_ = problem.failure;
  remark_ = QString::fromStdString(problem.sentence);
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
  remark_.clear();
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
  pool_.waitForDone(kStillWithinMs);  // a row or two may be on their way into the picture
}

double MapSlot::progress() const {
  if (phase_ != Phase::Reading || !reading_ || !reading_->cells) return phase_ == Phase::Ready ? 1 : 0;
  return double(reading_->cells->rowsReady()) / reading_->cells->height();
}

void MapSlot::setWaypoints(map::WaypointList waypoints) {
  const map::Subject places = map::placesOf(key_, name_.toStdString());
  Q_EMIT recovered({places});
  for (const std::string& note : waypoints.notes) {
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
