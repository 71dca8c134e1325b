#include "app/snapshot_run.h"

#include <algorithm>
#include <cmath>

#include <QFile>
#include <QImage>
#include <QImageWriter>
#include <QJsonArray>
#include <QPainter>
#include <QSaveFile>

#include "app/exit_code.h"
#include "app/raw_picture.h"
#include "app/robot_factory.h"

namespace mapwright::app {
namespace {

constexpr double kFitMarginPx = 16;
constexpr int kTries = 3;  // of a failing submap, before it counts as failed
constexpr int kConnectAttempts = 3;
constexpr double kConnectWithinS = 10;
constexpr int kLookEveryMs = 20;
constexpr double kTopicsWithinS = 3;   // live layers, after connecting
constexpr double kLiveMapWithinS = 8;  // a robot that sends no map of its own is asked for its current one

/// The most memory this program has held. getrusage() would answer with that of whoever started it, were that
/// more.
qint64 peakMemoryBytes() {
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return 0;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith("VmHWM:")) return line.mid(6).trimmed().split(' ').first().toLongLong() * 1024;
  }
  return 0;
}

session::Session::Options sessionOptions() {
  session::Session::Options options;
  options.sidecar_folder = gridCacheFolder();
  options.overview = false;  // a picture shows what is exact, or nothing
  return options;
}

}  // namespace

SnapshotRun::SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot)
    : options_(std::move(options)), session_(std::move(robot), sessionOptions()) {
  session_.setSlice(options_.slice);
  timeout_.setSingleShot(true);
  settle_.setSingleShot(true);
  connect(&timeout_, &QTimer::timeout, this, &SnapshotRun::timeOut);
  connect(&settle_, &QTimer::timeout, this, [this] { paint(session_.settled(kTries)); });
  connect(&poll_, &QTimer::timeout, this, &SnapshotRun::look);
  connect(&session_, &session::Session::connectionChanged, this, &SnapshotRun::look);
  connect(&session_, &session::Session::listChanged, this, [this] {
    if (!options_.center_m) session_.setView(session_.contentBounds(), session_.contentBounds().center());
  });
  if (options_.mode == SnapshotMode::Automatic) {
    options_.mode = session_.robot().submapSource() ? SnapshotMode::Submaps : SnapshotMode::Whole;
  }
  if (options_.average) session_.wholeMap().setReduction(raster::Reduction::Average);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, &SnapshotRun::look, Qt::QueuedConnection);
  connect(&session_.wholeMap(), &session::MapSlot::changed, this, [this] {
    const auto cells = session_.wholeMap().cells();
    if (first_paint_s_ < 0 && wantsWhole() && cells && cells->rowsReady() > 0) first_paint_s_ = seconds();
  });
  connect(&session_, &session::Session::submapsPlaced, this, [this] {
    if (first_paint_s_ < 0) first_paint_s_ = seconds();
  });
}

SnapshotRun::~SnapshotRun() = default;

void SnapshotRun::start() {
  clock_.start();
  timeout_.start(int(std::min(options_.timeout_s * 1000, 2e9)));
  poll_.start(kLookEveryMs);
  view_ = chooseView();
  if (options_.center_m) session_.setView(view_.visibleWorld(), view_.center_m);
  session_.open();
}

geometry::ViewTransform SnapshotRun::chooseView() const {
  geometry::ViewTransform view;
  view.width_px = options_.size_px.width();
  view.height_px = options_.size_px.height();
  view.rotation_rad = options_.rotation_rad;
  if (!options_.center_m) {
    geometry::WorldRect bounds;
    if (wantsSubmaps()) bounds.extend(session_.contentBounds());
    if (wantsWhole() && session_.wholeMap().cells()) bounds.extend(session_.wholeMap().reference().bounds());
    return view.fitted(bounds, kFitMarginPx);
  }
  view.center_m = *options_.center_m;
  view.scale_m_per_px = options_.scale_m_per_px;
  return view;
}

void SnapshotRun::look() {
  if (done_ || painting_) return;
  const robot::ConnectionState link = session_.connection();
  if (connected_s_ < 0) {
    if (link.phase == robot::ConnectionPhase::Refused) {
      // A file that cannot be read is no robot that cannot be reached.
      fail(session_.robot().liveTopics() || session_.robot().submapSource() || !isLocal() ? kUnreachable
                                                                                          : kUsage,
           QStringLiteral("%1: %2").arg(options_.robot, link.reason));
      return;
    }
    if (link.phase != robot::ConnectionPhase::Online) {
      const bool gave_up = link.phase == robot::ConnectionPhase::Interrupted &&
                           (link.attempt >= kConnectAttempts || seconds() > kConnectWithinS);
      if (gave_up) fail(kUnreachable, QStringLiteral("%1: %2").arg(options_.robot, link.reason));
      return;
    }
    connected_s_ = seconds();
    askForTopics();
    if (options_.settle_s) settle_.start(int(*options_.settle_s * 1000));
  }
  if (wantsWhole()) {
    askForWhole();
    const session::MapSlot& slot = session_.wholeMap();
    if (slot.phase() == session::MapSlot::Phase::Failed && !slot.cells()) {
      fail(isLocal() ? kUsage : kRobotError,
           QStringLiteral("%1: %2").arg(slot.name().isEmpty() ? options_.robot : slot.name(), slot.remark()));
      return;
    }
    if (whole_asked_ && !session_.catalogue().error().isEmpty() &&
        slot.phase() == session::MapSlot::Phase::Empty) {
      fail(kRobotError, QStringLiteral("%1: %2").arg(options_.robot, session_.catalogue().error()));
      return;
    }
    Q_EMIT progressed(QStringLiteral("Map %1: %2 % read").arg(slot.name()).arg(int(slot.progress() * 100)));
  }
  if (wantsSubmaps()) {
    const session::SubmapCounts counts = session_.counts();
    Q_EMIT progressed(QStringLiteral("%1 of %2 submaps, %3 missing, %4 failed")
                          .arg(counts.shown)
                          .arg(counts.listed)
                          .arg(counts.missing)
                          .arg(counts.failed + counts.corrupt));
  }
  if (!options_.settle_s && everythingIn() && topicsIn()) paint(true);
}

bool SnapshotRun::isLocal() const { return session_.robot().address().startsWith(QLatin1String("file:")); }

bool SnapshotRun::wantsSubmaps() const {
  return options_.mode == SnapshotMode::Submaps || options_.layers.contains(scene::Layer::Submaps);
}

bool SnapshotRun::wantsWhole() const {
  return options_.mode == SnapshotMode::Whole || options_.layers.contains(scene::Layer::WholeMap);
}

void SnapshotRun::askForWhole() {
  const bool sends_maps = session_.robot().liveTopics() != nullptr;
  if (!whole_asked_) {
    // The names of a folder's maps are known when its list is in.
    if (options_.map && session_.catalogue().offered() && !session_.catalogue().asOf() &&
        session_.catalogue().error().isEmpty()) {
      return;
    }
    whole_asked_ = true;
    if (options_.map) {
      const map::CatalogueEntry* const entry = session_.catalogue().called(map::toText(*options_.map));
      session_.openMap(entry ? entry->key : *options_.map);
    } else if (sends_maps) {
      session_.openMap({map::MapKind::Live, {}});
    }
    // Else the session opens the current map by itself when the catalogue is in.
    return;
  }
  const session::Catalogue& catalogue = session_.catalogue();
  const session::MapSlot& slot = session_.wholeMap();
  const bool nothing_sent = !options_.map && sends_maps && slot.key().kind == map::MapKind::Live &&
                            slot.phase() == session::MapSlot::Phase::Fetching &&
                            seconds() - connected_s_ > kLiveMapWithinS;
  if (nothing_sent && catalogue.current()) {
    for (const session::LoggedProblem& row : session_.problems().rows()) {
      live_map_broken_ |= !row.resolved && row.problem.subject.kind == map::SubjectKind::Topic &&
                          row.problem.subject.id.starts_with("/map");
    }
    notes_ << (live_map_broken_
                   ? QStringLiteral(
                         "The map that the robot sends cannot be had. Its current stored map is shown.")
                   : QStringLiteral("The robot sends no map now. Its current stored map is shown."));
    session_.openMap(catalogue.current()->key);
  } else if (nothing_sent && !catalogue.loading()) {
    fail(kRobotError,
         QStringLiteral("%1: it sends no map now, and none of its stored maps is the current one.")
             .arg(options_.robot));
  }
  if (!sends_maps && !options_.map && slot.phase() == session::MapSlot::Phase::Empty &&
      !catalogue.loading() && catalogue.asOf() && catalogue.error().isEmpty()) {
    fail(kRobotError,
         catalogue.entries().empty()
             ? QStringLiteral("%1: there is no map.").arg(options_.robot)
             : QStringLiteral(
                   "%1: none of its %2 maps is the current one. Give --map ID (mapwright maps list).")
                   .arg(options_.robot)
                   .arg(catalogue.entries().size()));
  }
}

void SnapshotRun::askForTopics() {
  robot::LiveTopics* const live = session_.robot().liveTopics();
  if (!live) return;
  QStringList topics;
  for (const scene::Layer layer : options_.layers) topics += scene::layerTopics(layer);
  for (const QString& topic : topics) topics_awaited_.insert(topic);
  if (options_.mode == SnapshotMode::Whole) topics += scene::layerTopics(scene::Layer::WholeMap);
  session_.want(QStringLiteral("snapshot"), topics);
  if (topics_awaited_.empty()) return;
  live->setWatching(true);
  connect(&session_.robot(), &robot::Robot::rawReceived, this, [this](const robot::RawMessage& message) {
    topics_awaited_.erase(message.topic);
    // Old firmware sends it under its older name.
    if (message.topic == QLatin1String("/trajectory"))
      topics_awaited_.erase(QStringLiteral("/trajectory_node_list"));
  });
}

bool SnapshotRun::topicsIn() const {
  return topics_awaited_.empty() || seconds() - connected_s_ > kTopicsWithinS;
}

bool SnapshotRun::everythingIn() const {
  if (wantsSubmaps() && !session_.settled(kTries)) return false;
  if (!wantsWhole()) return true;
  const session::MapSlot& slot = session_.wholeMap();
  return slot.settled() && slot.phase() != session::MapSlot::Phase::Empty;
}

bool SnapshotRun::mapComplete() const {
  const session::MapSlot& slot = session_.wholeMap();
  return slot.cells() && slot.phase() == session::MapSlot::Phase::Ready && slot.cells()->complete() &&
         !slot.broken() && !live_map_broken_;
}

void SnapshotRun::timeOut() {
  if (done_) return;
  timed_out_ = true;
  if (connected_s_ < 0) {
    fail(kUnreachable, QStringLiteral("%1: no connection within %2 s. %3")
                           .arg(options_.robot)
                           .arg(options_.timeout_s)
                           .arg(session_.connection().reason));
    return;
  }
  if (painting_) {
    fail(kIncomplete, QStringLiteral("The picture was not finished within %1 s. Give a longer --timeout.")
                          .arg(options_.timeout_s));
    return;
  }
  const bool no_list = wantsSubmaps() && !session_.book().listReceived();
  notes_
      << (!no_list
              ? QStringLiteral("Not everything had arrived within %1 s (--timeout).").arg(options_.timeout_s)
              : QStringLiteral("The robot sent no submap list within %1 s (--timeout).")
                    .arg(options_.timeout_s));
  paint(false);
}

void SnapshotRun::paint(bool settled) {
  if (done_ || painting_) return;
  painting_ = true;
  poll_.stop();
  settle_.stop();
  if (timed_out_)
    timeout_.start(int(std::min(options_.timeout_s * 1000, 2e9)));  // the picture itself takes time, too
  const session::SubmapCounts counts = session_.counts();
  complete_ = settled;
  if (wantsSubmaps()) {
    complete_ = complete_ && counts.list_received && counts.shown + counts.without_slice == counts.listed &&
                counts.updating == 0;
  }
  if (wantsWhole()) complete_ = complete_ && mapComplete();
  for (const QString& topic : topics_awaited_) {
    notes_ << QStringLiteral("Topic %1 gave nothing within %2 s.").arg(topic).arg(kTopicsWithinS);
  }
  if (counts.without_slice > 0 && counts.without_slice == counts.listed) {
    notes_ << QStringLiteral("No submap has a slice %1 (--slice): the picture is empty.").arg(options_.slice);
  }
  view_ = chooseView();
  if (options_.raw) {
    if (writeRaw()) finish(complete_ ? kDone : kIncomplete);
    return;
  }
  render::TileRenderer::Options renderer;
  renderer.previews = false;
  scene_ = std::make_unique<scene::MapScene>(renderer);
  scene_->setTheme(options_.dark ? scene::darkMapTheme() : scene::lightMapTheme());
  scene_->setColorMode(options_.colors);
  for (const scene::Layer layer : scene::allLayers()) {
    scene_->setLayerVisible(layer, options_.layers.contains(layer));
  }
  scene_->setLayerVisible(scene::Layer::Submaps, wantsSubmaps() && !options_.without_submaps);
  scene_->setLayerVisible(scene::Layer::WholeMap, wantsWhole());
  scene_->setView(view_);
  scene_->setSession(&session_);
  const auto whenSettled = [this] {
    if (done_ || !scene_->picturesSettled()) return;
    if (writeScene()) finish(complete_ ? kDone : kIncomplete);
  };
  connect(scene_.get(), &scene::MapScene::tilesSettled, this, whenSettled);
  QTimer::singleShot(0, this, whenSettled);
}

bool SnapshotRun::writeScene() {
  QImage image(options_.size_px, QImage::Format_RGB32);
  if (image.isNull()) {
    fail(kUsage, QStringLiteral("There is not enough memory for a picture of %1 x %2.")
                     .arg(options_.size_px.width())
                     .arg(options_.size_px.height()));
    return false;
  }
  QPainter painter(&image);
  const QRectF whole(QPointF(0, 0), QSizeF(options_.size_px));
  scene_->render(&painter, whole, whole);
  painter.end();
  QSaveFile file(options_.output);
  const bool opened = file.open(QIODevice::WriteOnly);
  QImageWriter writer(&file, "png");
  if (!opened || !writer.write(image) || !file.commit()) {
    fail(kUsage, QStringLiteral("%1 cannot be written: %2.").arg(options_.output, file.errorString()));
    return false;
  }
  return true;
}

bool SnapshotRun::writeRaw() {
  std::optional<QString> error;
  if (options_.mode == SnapshotMode::Whole) {
    const session::MapSlot& slot = session_.wholeMap();
    error = writeRawPicture(view_, render::PlacedGrid{slot.cells(), slot.reference()}, options_.output);
  } else {
    std::vector<render::PlacedTexture> textures;
    for (const auto& [id, row] : session_.book().rows()) {
      if (const auto placement = session_.book().placement(id, options_.slice)) {
        textures.push_back({id, placement->texture, placement->world_from_texture, 0});
      }
    }
    error = writeRawPicture(view_, textures, options_.output);
  }
  if (error) fail(kUsage, *error);
  return !error;
}

void SnapshotRun::fail(int exit_code, const QString& sentence) {
  error_ = sentence;
  complete_ = false;
  finish(exit_code);
}

void SnapshotRun::finish(int exit_code) {
  if (done_) return;
  done_ = true;
  poll_.stop();
  timeout_.stop();
  settle_.stop();
  complete_s_ = seconds();
  Q_EMIT finished(exit_code);
}

QStringList SnapshotRun::warnings() const {
  QStringList all;
  if (!error_.isEmpty()) all << error_;
  // The gravest first: a terminal shows no more than one.
  for (const map::Severity severity : {map::Severity::Error, map::Severity::Warning, map::Severity::Info}) {
    for (const session::LoggedProblem& row : session_.problems().rows()) {
      if (row.resolved || row.problem.severity != severity) continue;
      all << QStringLiteral("%1: %2").arg(QString::fromStdString(map::toText(row.problem.subject)),
                                          QString::fromStdString(row.problem.sentence));
    }
  }
  return all + notes_;
}

QJsonObject SnapshotRun::report() const {
  const session::SubmapCounts counts = session_.counts();
  const auto secondsOrNull = [](double value) {
    return value < 0 ? QJsonValue() : QJsonValue(std::round(value * 1000) / 1000);
  };
  QJsonObject report{
      {QStringLiteral("complete"), complete_},
      {QStringLiteral("mode"),
       options_.mode == SnapshotMode::Whole ? QStringLiteral("whole") : QStringLiteral("submaps")},
      {QStringLiteral("uuid"), QString::fromStdString(session_.book().uuid())},
      {QStringLiteral("submaps"), QJsonObject{{QStringLiteral("listed"), counts.listed},
                                              {QStringLiteral("drawn"), counts.shown},
                                              {QStringLiteral("missing"), counts.missing},
                                              {QStringLiteral("failed"), counts.failed + counts.pending},
                                              {QStringLiteral("corrupt"), counts.corrupt},
                                              {QStringLiteral("without_slice"), counts.without_slice}}},
      {QStringLiteral("bytes_fetched"), qint64(counts.bytes_fetched)},
      {QStringLiteral("fetches"), qint64(counts.fetches)},
      {QStringLiteral("cache_hits"), qint64(counts.cache_hits)},
      {QStringLiteral("seconds"), QJsonObject{{QStringLiteral("connect"), secondsOrNull(connected_s_)},
                                              {QStringLiteral("first_paint"), secondsOrNull(first_paint_s_)},
                                              {QStringLiteral("complete"), secondsOrNull(complete_s_)}}},
      {QStringLiteral("view"),
       QJsonObject{{QStringLiteral("center"), QJsonArray{view_.center_m.x(), view_.center_m.y()}},
                   {QStringLiteral("scale"), view_.scale_m_per_px},
                   {QStringLiteral("size"), QJsonArray{view_.width_px, view_.height_px}},
                   {QStringLiteral("rotation_deg"), geometry::degreesFromRadians(view_.rotation_rad)}}},
      {QStringLiteral("peak_rss_bytes"), peakMemoryBytes()},
      {QStringLiteral("warnings"), QJsonArray::fromStringList(warnings())},
  };
  const session::MapSlot& slot = session_.wholeMap();
  if (wantsWhole() && slot.cells()) {
    const map::GridReference& grid = slot.reference();
    report[QStringLiteral("map")] = QJsonObject{
        {QStringLiteral("id"), QString::fromStdString(map::toText(slot.shown().key))},
        {QStringLiteral("name"), slot.name()},
        {QStringLiteral("size"), QJsonArray{grid.width, grid.height}},
        {QStringLiteral("resolution"), grid.resolution_m},
        {QStringLiteral("origin"), QJsonArray{grid.origin.x_m, grid.origin.y_m, grid.origin.yaw_rad}}};
  }
  return report;
}

}  // namespace mapwright::app
