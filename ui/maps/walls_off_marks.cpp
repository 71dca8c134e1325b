#include "ui/maps/walls_off_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QGraphicsItem>
#include <QPainter>

namespace mapwright::ui {
namespace {

constexpr double kAboveLayers = 1e6;

std::size_t stepOf(double off_m) {
  std::size_t step = 0;
  while (step + 1 < kOffSteps_m.size() && off_m > kOffSteps_m[step + 1]) ++step;
  return step;
}

}  // namespace

QColor offColor(std::size_t step) {
  // The ground is light in the dark theme, too.
  constexpr std::array<QRgb, 3> kColors{0xffe09a1f, 0xffd2431c, 0xff7a0f3c};
  return QColor(kColors[step]);
}

class WallsOffMarks::Item : public QGraphicsItem {
 public:
  explicit Item(const scene::MapScene* scene) : scene_(scene) {
    setZValue(kAboveLayers);
    setAcceptedMouseButtons(Qt::NoButton);
    hide();
  }
  void setWalls(std::vector<align::OffWall> walls, double cell_m) {
    walls_ = std::move(walls);
    cell_m_ = cell_m;
    setVisible(!walls_.empty());
    follow();
  }
  void follow() {
    if (!isVisible()) return;
    prepareGeometryChange();
    update();
  }
  const std::vector<align::OffWall>& walls() const { return walls_; }

  /// The scene's coordinates are viewport pixels.
  QRectF boundingRect() const override {
    return {0, 0, double(scene_->view().width_px), double(scene_->view().height_px)};
  }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    // Zoomed out, many walls share a place on screen: the worst of them is drawn.
    constexpr int kPlacePx = 2;
    const geometry::ViewTransform& view = scene_->view();
    const int columns = view.width_px / kPlacePx + 1, rows = view.height_px / kPlacePx + 1;
    std::vector<std::uint8_t> places(std::size_t(columns) * std::size_t(rows));
    for (const align::OffWall& wall : walls_) {
      const Eigen::Vector2d at = view.pixelFromWorld(wall.at_m) / kPlacePx;
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns && at.y() < rows)) continue;
      std::uint8_t& place = places[std::size_t(at.y()) * std::size_t(columns) + std::size_t(at.x())];
      place = std::max(place, std::uint8_t(stepOf(wall.off_m) + 1));
    }
    const double cell_px = cell_m_ / view.scale_m_per_px;
    std::array<std::vector<QRectF>, kOffSteps_m.size()> marks;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const int place = places[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
        if (place == 0) continue;
        const double edge = std::max(kOffMarks_px[std::size_t(place - 1)], cell_px);
        const QPointF middle = QPointF(column + 0.5, row + 0.5) * kPlacePx;
        marks[std::size_t(place - 1)].emplace_back(middle - QPointF(edge / 2, edge / 2), QSizeF(edge, edge));
      }
    }
    painter->setPen(Qt::NoPen);
    for (std::size_t step = 0; step < marks.size(); ++step) {
      painter->setBrush(offColor(step));
      painter->drawRects(marks[step].data(), int(marks[step].size()));
    }
  }

 private:
  const scene::MapScene* scene_;
  std::vector<align::OffWall> walls_;
  double cell_m_ = 0;
};

WallsOffMarks::WallsOffMarks(scene::MapScene* scene, std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), scene_(scene), item_(std::make_unique<Item>(scene)), share_(std::move(workers)) {
  scene_->addItem(item_.get());
  connect(scene_, &scene::MapScene::viewChanged, this, [this] { item_->follow(); });
}

WallsOffMarks::~WallsOffMarks() { over_ = true; }

const std::vector<align::OffWall>& WallsOffMarks::shown() const { return item_->walls(); }

void WallsOffMarks::show(const std::optional<Subject>& subject) {
  if (std::exchange(wanted_, subject) == subject) return;
  if (!subject || !made_ || !made_->sameMaps(*subject)) {
    made_.reset();
    walls_.reset();
    item_->setWalls({}, 0);
  }
  if (subject && !running_) start();
}

void WallsOffMarks::start() {
  running_ = true;
  share_.startLong([this, subject = *wanted_, walls = walls_]() mutable {
    if (!walls) walls = align::WallsOff::between(subject.reference, subject.map, over_);
    if (!walls) return;
    auto off = walls->at(subject.pose, kOffSteps_m.front());
    QMetaObject::invokeMethod(
        this,
        [this, subject, walls, off = std::move(off)]() mutable {
          running_ = false;
          if (!wanted_) return;  // nobody wants it any more
          if (subject.sameMaps(*wanted_)) {
            made_ = subject;
            walls_ = walls;
            item_->setWalls(std::move(off), walls->cell_m());
          }
          if (made_ != wanted_) return start();
          Q_EMIT found();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::ui

#include "moc_walls_off_marks.cpp"
