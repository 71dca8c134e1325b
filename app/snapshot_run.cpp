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

namespace mapwright::app {
namespace {

constexpr double kFitMarginPx = 16;
constexpr int kTries = 3;  // of a failing submap, before it counts as failed
constexpr int kConnectAttempts = 3;
constexpr double kConnectWithinS = 10;
constexpr int kLookEveryMs = 20;

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

}  // namespace

SnapshotRun::SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot)
    : options_(std::move(options)), session_(std::move(robot), session::Session::Options{}) {
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
  if (!options_.center_m) return view.fitted(session_.contentBounds(), kFitMarginPx);
  view.center_m = *options_.center_m;
  view.scale_m_per_px = options_.scale_m_per_px;
  return view;
}

void SnapshotRun::look() {
  if (done_ || painting_) return;
  const robot::ConnectionState link = session_.connection();
  if (connected_s_ < 0) {
    if (link.phase == robot::ConnectionPhase::Refused) {
      fail(kUnreachable, QStringLiteral("%1: %2").arg(options_.robot, link.reason));
      return;
    }
    if (link.phase != robot::ConnectionPhase::Online) {
      const bool gave_up = link.phase == robot::ConnectionPhase::Interrupted &&
                           (link.attempt >= kConnectAttempts || seconds() > kConnectWithinS);
      if (gave_up) fail(kUnreachable, QStringLiteral("%1: %2").arg(options_.robot, link.reason));
      return;
    }
    connected_s_ = seconds();
    if (options_.settle_s) settle_.start(int(*options_.settle_s * 1000));
  }
  const session::SubmapCounts counts = session_.counts();
  Q_EMIT progressed(QStringLiteral("%1 of %2 submaps, %3 missing, %4 failed")
                        .arg(counts.shown)
                        .arg(counts.listed)
                        .arg(counts.missing)
                        .arg(counts.failed + counts.corrupt));
  if (!options_.settle_s && session_.settled(kTries)) paint(true);
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
  notes_
      << (session_.book().listReceived()
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
  complete_ = settled && counts.list_received && counts.shown + counts.without_slice == counts.listed &&
              counts.updating == 0;
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
  for (const scene::Layer layer : scene::allLayers())
    scene_->setLayerVisible(layer, options_.layers.contains(layer));
  scene_->setView(view_);
  scene_->setSession(&session_);
  const auto whenSettled = [this] {
    if (done_ || !scene_->renderer().settled()) return;
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
  std::vector<render::PlacedTexture> textures;
  for (const auto& [id, row] : session_.book().rows()) {
    if (const auto placement = session_.book().placement(id, options_.slice)) {
      textures.push_back({id, placement->texture, placement->world_from_texture, 0});
    }
  }
  const auto error = writeRawPicture(view_, textures, options_.output);
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
  for (const session::LoggedProblem& row : session_.problems().rows()) {
    if (row.resolved) continue;
    all << QStringLiteral("%1: %2").arg(QString::fromStdString(row.problem.subject),
                                        QString::fromStdString(row.problem.sentence));
  }
  return all + notes_;
}

QJsonObject SnapshotRun::report() const {
  const session::SubmapCounts counts = session_.counts();
  const auto secondsOrNull = [](double value) {
    return value < 0 ? QJsonValue() : QJsonValue(std::round(value * 1000) / 1000);
  };
  return {
      {QStringLiteral("complete"), complete_},
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
}

}  // namespace mapwright::app
