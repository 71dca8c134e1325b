#include "scene/map_clouds.h"

#include <atomic>
#include <cmath>
#include <deque>
#include <utility>

#include <QFile>
#include <QMetaObject>

#include "clouds/cloud_tree.h"
#include "clouds/draw_cloud.h"
#include "clouds/heights.h"
#include "clouds/section.h"
#include "clouds/write_cloud.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "sentences/fault_sentence.h"
#include "words/qt_plain.h"
#include "work/workers.h"

namespace mapwright::scene {
namespace {

using Flag = std::shared_ptr<std::atomic<bool>>;
Flag newFlag() { return std::make_shared<std::atomic<bool>>(false); }

clouds::CloudColor colorOf(int choice) {
  switch (DispatchedCloudChoice(choice)) {
    case DispatchedCloudChoice::Intensity:
      return clouds::CloudColor::Intensity;
    case DispatchedCloudChoice::Rgb:
      return clouds::CloudColor::Rgb;
    case DispatchedCloudChoice::OneColor:
      return clouds::CloudColor::OneColor;
    case DispatchedCloudChoice::Height:
      break;
  }
  return clouds::CloudColor::Height;
}

render::TilePainter painterOf(std::shared_ptr<const clouds::CloudSet> set, const clouds::CloudLook& look) {
  return [set = std::move(set), look](const render::PixelGrid& grid, const std::atomic<bool>& cancelled) {
    const clouds::Raster raster{grid.origin_m,  grid.scale_m_per_px, grid.rotation_rad, grid.width_px,
                                grid.height_px, grid.first_column,   grid.first_row};
    const clouds::CloudPixels pixels = clouds::drawClouds(raster, *set, look, &cancelled);
    if (pixels.argb.empty()) return QImage();
    QImage image(pixels.width_px, pixels.height_px, QImage::Format_ARGB32_Premultiplied);
    for (int row = 0; row < pixels.height_px; ++row) {
      std::copy_n(pixels.argb.data() + std::size_t(row) * std::size_t(pixels.width_px), pixels.width_px,
                  reinterpret_cast<std::uint32_t*>(image.scanLine(row)));
    }
    return image;
  };
}

}  // namespace

struct CloudSection::Inside {
  clouds::Section section;
  std::shared_ptr<const clouds::CloudSet> set;
};

std::optional<Eigen::Vector2d> CloudSection::nearest(const Eigen::Vector2d& at, double reach_m) const {
  return inside_ ? clouds::nearestIn(inside_->section, at, reach_m) : std::nullopt;
}

class MapClouds::Impl {
 public:
  Impl(MapClouds& owner, MapScene& scene, std::shared_ptr<work::Workers> workers)
      : owner_(owner), scene_(scene), share_(work::orOwn(std::move(workers))) {}
  ~Impl() {
    stopAll();
    write_stop_->store(true);
  }

  void add(CloudPiece piece) {
    waiting_.push_back(std::move(piece));
    proceed();
  }

  void clear() {
    stopAll();
    ++epoch_;
    waiting_.clear();
    ordering_ = counting_ = count_again_ = false;
    next_cut_.reset();
    cutting_ = false;
    book_.clear();
    set_.reset();
    sums = {};
    heights = {};
    range.reset();
    Q_EMIT owner_.changed();
    Q_EMIT owner_.summed();
    noteSettled();
  }

  bool empty() const { return !set_ && waiting_.empty() && !ordering_; }
  bool settled() const { return waiting_.empty() && !ordering_ && !counting_; }

  void setRange(std::optional<CloudRange> wanted) {
    if (wanted == range) return;
    range = wanted;
    if (!set_) return;
    Q_EMIT owner_.changed();
    count();
  }

  void setVoxel(std::optional<double> metres) {
    book_.setVoxel(metres);
    if (set_) count();
  }

  geometry::WorldRect bounds() const {
    if (!set_ || set_->bounds.empty()) return {};
    return {set_->bounds.min.x(), set_->bounds.min.y(), set_->bounds.max.x(), set_->bounds.max.y()};
  }

  render::TilePainter painter(double ratio) const {
    return set_ ? painterOf(set_, look(ratio, chosenHeights())) : render::TilePainter();
  }

  render::TilePainter sectionPainter(const CloudSection::Inside& inside, double ratio) const {
    // The cut has already selected the heights.
    return painterOf(inside.set, look(ratio, {}));
  }

  void cut(const CloudCut& cut, SectionReply reply) {
    next_cut_.emplace(cut, std::move(reply));
    cut_stop_->store(true);
    proceedCutting();
  }

  void write(const QString& path, std::function<void(tl::expected<std::uint64_t, QString>)> reply) {
    const auto format = clouds::formatOf(path.toStdString());
    const auto set = set_ ? set_ : std::make_shared<const clouds::CloudSet>();
    // Shared only with the job: writing continues when the map is left.
    share_.startLong(
        [this, set, heights = chosenHeights(), format, path, stop = write_stop_, reply = std::move(reply)] {
          disk::WrittenFile file(path.toStdString());
          const auto written = clouds::writeClouds(
              *set, heights, format.value_or(clouds::CloudFormat::PcdBinary),
              [&file](std::string_view bytes) {
                file.write(bytes);
                return file.good();
              },
              stop.get());
          if (*stop) return;
          const auto fault = file.place();
          tl::expected<std::uint64_t, QString> outcome = written ? written->points : 0;
          if (fault) outcome = tl::make_unexpected(sentences::sentenceOf(disk::notWritten(*fault)));
          QMetaObject::invokeMethod(
              &owner_, [reply, outcome] { reply(outcome); }, Qt::QueuedConnection);
        });
  }

  std::optional<CloudScale> scaleNow() const {
    if (!set_ || heights.points == 0) return std::nullopt;
    const clouds::CloudLook now = look(1, {});
    const clouds::Shades& all = clouds::shades();
    CloudScale made{CloudScale::Of::Height, now.low_z_m, now.high_z_m, {all.begin(), all.end()}};
    if (now.color == clouds::CloudColor::Height) return made;
    if (now.color != clouds::CloudColor::Intensity || !set_->has_intensity) return std::nullopt;
    made.of = CloudScale::Of::Intensity;
    made.low = now.low_intensity;
    made.high = now.high_intensity;
    return made;
  }

  CloudSums sums;
  CloudHeights heights;
  std::optional<CloudRange> range;

 private:
  clouds::HeightRange chosenHeights() const {
    return range ? clouds::HeightRange{range->low_m, range->high_m} : clouds::HeightRange{};
  }

  clouds::CloudLook look(double ratio, const clouds::HeightRange& shown) const {
    const LayerStyle& style = scene_.layerStyle(Layer::DispatchedCloud);
    const QColor one = style.color.isValid() ? style.color : scene_.theme().cloud;
    clouds::CloudLook look;
    look.color = colorOf(style.choice);
    look.one = one.rgb() & 0xffffff;
    const double size_px = style.size > 0 ? style.size : layerTraits(Layer::DispatchedCloud).default_size_px;
    look.size_px = int(std::lround(std::clamp(size_px * ratio, 1.0, double(clouds::kLargestPoint))));
    look.heights = shown;
    look.low_z_m = range ? range->low_m : heights.usual_low_m;
    look.high_z_m = range ? range->high_m : heights.usual_high_m;
    if (set_) {
      look.low_intensity = double(set_->usual_intensity[0]);
      look.high_intensity = double(set_->usual_intensity[1]);
    }
    return look;
  }

  void stopAll() {
    for (const Flag& flag : {order_stop_, cut_stop_}) flag->store(true);
    order_stop_ = newFlag();
    cut_stop_ = newFlag();
  }

  /// Passes `made` to the GUI thread, unless everything was cleared meanwhile.
  template <class Made>
  void later(std::uint64_t epoch, Made made) {
    QMetaObject::invokeMethod(
        &owner_,
        [this, epoch, made = std::move(made)]() mutable {
          if (epoch == epoch_) made();
        },
        Qt::QueuedConnection);
  }

  // One after the other: the newest is the last one received, however large it is.
  void proceed() {
    noteSettled();
    if (ordering_ || waiting_.empty()) return;
    ordering_ = true;
    CloudPiece piece = std::move(waiting_.front());
    waiting_.pop_front();
    share_.startLong([this, piece = std::move(piece), stop = order_stop_, epoch = epoch_] {
      clouds::CloudStore::Came came;
      came.kind = piece.voxels ? clouds::PointKind::Voxel : clouds::PointKind::Point;
      came.region = piece.region;
      came.points = piece.cloud->points.size();
      came.left_out = piece.cloud->left_out;
      came.one_of = clouds::CloudStore::oneOf(came.points);
      came.tree = clouds::CloudTree::make(*piece.cloud, came.one_of, stop.get());
      if (!came.tree) return;
      if (piece.voxels) came.voxel_m = clouds::voxelSize(*came.tree);
      later(epoch, [this, came = std::move(came)]() mutable {
        book_.add(std::move(came));
        ordering_ = false;
        count();
        proceed();
      });
    });
    noteSettled();
  }

  /// New data is shown when its heights are known, since the colours depend on them.
  void count() {
    if (counting_) {
      count_again_ = true;
      return;
    }
    counting_ = true;
    auto set = std::make_shared<const clouds::CloudSet>(book_.set());
    share_.startLong([this, set, chosen = chosenHeights(), epoch = epoch_] {
      const clouds::Heights found = clouds::heightsOf(*set);
      const std::uint64_t shown = clouds::countShown(*set, chosen);
      later(epoch, [this, set, found, shown] {
        counting_ = false;
        take(set, found, shown);
        if (std::exchange(count_again_, false)) count();
        noteSettled();
      });
    });
    noteSettled();
  }

  void take(const std::shared_ptr<const clouds::CloudSet>& set, const clouds::Heights& found,
            std::uint64_t shown) {
    set_ = set;
    heights = {found.low_m, found.high_m, found.usual_low_m, found.usual_high_m, found.bins, found.points};
    const clouds::CloudStore::Totals totals = book_.totals();
    sums = {};
    sums.clouds = totals.clouds;
    sums.came = totals.came;
    sums.shown = shown;
    sums.left_out = totals.left_out;
    sums.thinned = totals.thinned;
    sums.forgotten = totals.forgotten;
    sums.bytes = totals.bytes;
    sums.voxels = totals.voxels;
    sums.voxel_m = totals.voxel_m;
    sums.has_intensity = set->has_intensity;
    sums.has_rgb = set->has_rgb;
    sums.without_z = totals.without_z;
    for (const std::string& frame : totals.frames) sums.frames << words::plainName(frame);
    Q_EMIT owner_.changed();
    Q_EMIT owner_.summed();
  }

  void proceedCutting() {
    if (cutting_ || !next_cut_) return;
    cutting_ = true;
    cut_stop_ = newFlag();
    auto [wanted, reply] = std::move(*next_cut_);
    next_cut_.reset();
    const auto set = set_ ? set_ : std::make_shared<const clouds::CloudSet>();
    share_.startLong([this, set, wanted = wanted, reply = std::move(reply), chosen = chosenHeights(),
                      stop = cut_stop_, epoch = epoch_] {
      auto inside = std::make_shared<CloudSection::Inside>();
      inside->section =
          clouds::cutThrough(*set, {wanted.from_m, wanted.to_m, wanted.width_m}, chosen, stop.get());
      inside->set = std::make_shared<const clouds::CloudSet>(inside->section.set);
      auto made = std::make_shared<CloudSection>();
      made->cut = wanted;
      made->points = inside->section.points;
      made->one_of = inside->section.one_of;
      made->low_m = inside->section.low_m;
      made->high_m = inside->section.high_m;
      made->inside_ = std::move(inside);
      later(epoch, [this, made, reply, stopped = stop->load()] {
        cutting_ = false;
        if (!stopped) reply(made);
        proceedCutting();
      });
    });
  }

  void noteSettled() {
    const bool now = settled();
    if (std::exchange(was_settled_, now) != now) Q_EMIT owner_.settledChanged();
  }

  MapClouds& owner_;
  MapScene& scene_;
  clouds::CloudStore book_;
  std::shared_ptr<const clouds::CloudSet> set_;  // null: not ready yet
  std::deque<CloudPiece> waiting_;
  bool ordering_ = false, counting_ = false, count_again_ = false, cutting_ = false, was_settled_ = true;
  std::optional<std::pair<CloudCut, SectionReply>> next_cut_;
  std::uint64_t epoch_ = 0;  // results of an older one are ignored
  Flag order_stop_ = newFlag(), cut_stop_ = newFlag(), write_stop_ = newFlag();
  work::Tasks share_;  // last member: its jobs use all of the above
};

MapClouds::MapClouds(MapScene* scene, std::shared_ptr<work::Workers> workers)
    : QObject(scene), impl_(std::make_unique<Impl>(*this, *scene, std::move(workers))) {}

MapClouds::~MapClouds() = default;

MapClouds& MapClouds::of(const MapScene& scene) {
  return *scene.findChild<MapClouds*>(QString(), Qt::FindDirectChildrenOnly);
}

void MapClouds::add(CloudPiece piece) { impl_->add(std::move(piece)); }
void MapClouds::clear() { impl_->clear(); }
bool MapClouds::empty() const { return impl_->empty(); }
bool MapClouds::settled() const { return impl_->settled(); }
void MapClouds::setHeightRange(std::optional<CloudRange> range) { impl_->setRange(range); }
const std::optional<CloudRange>& MapClouds::heightRange() const { return impl_->range; }
void MapClouds::setVoxel(std::optional<double> metres) { impl_->setVoxel(metres); }
const CloudSums& MapClouds::sums() const { return impl_->sums; }
const CloudHeights& MapClouds::heights() const { return impl_->heights; }
std::optional<CloudScale> MapClouds::scale() const { return impl_->scaleNow(); }
geometry::WorldRect MapClouds::bounds() const { return impl_->bounds(); }
render::TilePainter MapClouds::painter(double ratio) const { return impl_->painter(ratio); }
void MapClouds::cut(const CloudCut& cut, SectionReply reply) { impl_->cut(cut, std::move(reply)); }
render::TilePainter MapClouds::sectionPainter(const std::shared_ptr<const CloudSection>& section,
                                              double ratio) const {
  return section && section->inside_ ? impl_->sectionPainter(*section->inside_, ratio)
                                     : render::TilePainter();
}
void MapClouds::write(const QString& path, std::function<void(tl::expected<std::uint64_t, QString>)> reply) {
  impl_->write(path, std::move(reply));
}

}  // namespace mapwright::scene

#include "moc_map_clouds.cpp"
