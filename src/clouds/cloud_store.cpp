#include "clouds/cloud_store.h"

#include <atomic>
#include <utility>

#include <QMetaObject>

#include "clouds/cloud_tree.h"
#include "clouds/draw_cloud.h"
#include "clouds/write_cloud.h"
#include "disk/file_error.h"
#include "disk/written_file.h"

namespace mapwright::clouds {
namespace {

std::shared_ptr<std::atomic<bool>> newFlag() { return std::make_shared<std::atomic<bool>>(false); }

}  // namespace

CloudStore::CloudStore(std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      order_stop_(newFlag()),
      cut_stop_(newFlag()),
      write_stop_(newFlag()),
      share_(work::orOwn(std::move(workers))) {}

CloudStore::~CloudStore() {
  stopAll();
  write_stop_->store(true);
}

void CloudStore::add(CloudPiece piece) {
  waiting_.push_back(std::move(piece));
  proceed();
}

void CloudStore::clear() {
  stopAll();
  ++epoch_;
  waiting_.clear();
  ordering_ = counting_ = count_again_ = false;
  next_cut_.reset();
  cutting_ = false;
  newest_.clear();
  set_.reset();
  sums_ = {};
  heights_ = {};
  range_.reset();
  Q_EMIT changed();
  Q_EMIT summed();
  emitSettled();
}

void CloudStore::setHeightRange(std::optional<HeightRange> range) {
  if (range == range_) return;
  range_ = range;
  if (!set_) return;
  Q_EMIT changed();
  count();
}

void CloudStore::setVoxel(std::optional<double> metres) {
  newest_.setVoxel(metres);
  if (set_) count();
}

geometry::WorldRect CloudStore::bounds() const {
  if (!set_ || set_->bounds.empty()) return {};
  return {set_->bounds.min.x(), set_->bounds.min.y(), set_->bounds.max.x(), set_->bounds.max.y()};
}

std::shared_ptr<const CloudSet> CloudStore::setOrNone() const {
  return set_ ? set_ : std::make_shared<const CloudSet>();
}

void CloudStore::cut(const Cut& cut, SectionReply reply) {
  next_cut_.emplace(cut, std::move(reply));
  cut_stop_->store(true);
  proceedCutting();
}

void CloudStore::write(const QString& path, std::function<void(tl::expected<std::uint64_t, Fault>)> reply) {
  const auto format = formatOf(path.toStdString());
  // Shared only with the job: writing continues when the map is left.
  share_.startLong([this, set = setOrNone(), heights = chosenHeights(), format, path,
                    existing = disk::existingNow(path.toStdString()), stop = write_stop_,
                    reply = std::move(reply)] {
    disk::WrittenFile file(path.toStdString(), existing);
    const auto written = writeClouds(
        *set, heights, format.value_or(CloudFormat::PcdBinary),
        [&file](std::string_view bytes) {
          file.write(bytes);
          return file.good();
        },
        stop.get());
    if (*stop) return;
    const auto problem = file.place();
    tl::expected<std::uint64_t, Fault> outcome = written ? written->points : 0;
    if (problem) outcome = tl::make_unexpected(disk::notWritten(*problem));
    QMetaObject::invokeMethod(
        this, [reply, outcome] { reply(outcome); }, Qt::QueuedConnection);
  });
}

void CloudStore::stopAll() {
  for (const Flag& flag : {order_stop_, cut_stop_}) flag->store(true);
  order_stop_ = newFlag();
  cut_stop_ = newFlag();
}

/// Passes `made` to the GUI thread, unless everything was cleared meanwhile.
void CloudStore::later(std::uint64_t epoch, std::function<void()> made) {
  QMetaObject::invokeMethod(
      this,
      [this, epoch, made = std::move(made)] {
        if (epoch == epoch_) made();
      },
      Qt::QueuedConnection);
}

// One after the other: the newest is the last one received, however large it is.
void CloudStore::proceed() {
  emitSettled();
  if (ordering_ || waiting_.empty()) return;
  ordering_ = true;
  CloudPiece piece = std::move(waiting_.front());
  waiting_.pop_front();
  share_.startLong([this, piece = std::move(piece), stop = order_stop_, epoch = epoch_] {
    NewestClouds::Came came;
    came.kind = piece.voxels ? PointKind::Voxel : PointKind::Point;
    came.region = piece.region;
    came.points = piece.cloud->points.size();
    came.left_out = piece.cloud->left_out;
    came.one_of = NewestClouds::oneOf(came.points);
    came.tree = CloudTree::make(*piece.cloud, came.one_of, stop.get());
    if (!came.tree) return;
    if (piece.voxels) came.voxel_m = voxelSize(*came.tree);
    later(epoch, [this, came] {
      newest_.add(came);
      ordering_ = false;
      count();
      proceed();
    });
  });
  emitSettled();
}

/// New data is shown when its heights are known, since the colours depend on them.
void CloudStore::count() {
  if (counting_) {
    count_again_ = true;
    return;
  }
  counting_ = true;
  auto set = std::make_shared<const CloudSet>(newest_.set());
  share_.startLong([this, set, chosen = chosenHeights(), epoch = epoch_] {
    const Heights found = heightsOf(*set);
    const std::uint64_t shown = countShown(*set, chosen);
    later(epoch, [this, set, found, shown] {
      counting_ = false;
      publish(set, found, shown);
      if (std::exchange(count_again_, false)) count();
      emitSettled();
    });
  });
  emitSettled();
}

void CloudStore::publish(const std::shared_ptr<const CloudSet>& set, const Heights& found,
                         std::uint64_t shown) {
  set_ = set;
  heights_ = found;
  sums_ = {newest_.totals(), shown};
  Q_EMIT changed();
  Q_EMIT summed();
}

void CloudStore::proceedCutting() {
  if (cutting_ || !next_cut_) return;
  cutting_ = true;
  cut_stop_ = newFlag();
  auto [wanted, reply] = std::move(*next_cut_);
  next_cut_.reset();
  share_.startLong([this, set = setOrNone(), wanted = wanted, reply = std::move(reply),
                    chosen = chosenHeights(), stop = cut_stop_, epoch = epoch_] {
    auto made = std::make_shared<const Section>(cutThrough(*set, wanted, chosen, stop.get()));
    later(epoch, [this, made, reply, stopped = stop->load()] {
      cutting_ = false;
      if (!stopped) reply(made);
      proceedCutting();
    });
  });
}

void CloudStore::emitSettled() {
  const bool now = settled();
  if (std::exchange(was_settled_, now) != now) Q_EMIT settledChanged();
}

}  // namespace mapwright::clouds

#include "moc_cloud_store.cpp"
