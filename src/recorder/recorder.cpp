#include "recorder/recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <QLoggingCategory>

#include "recorder/layout.h"
#include "robot/delivery.h"

namespace mapwright::recorder {
namespace {

Q_LOGGING_CATEGORY(lcRecorder, "mapwright.recorder", QtWarningMsg)

constexpr std::chrono::milliseconds kTick{200};
constexpr int kTellEveryMs = 250;
constexpr double kLatest_s = 9e9;  // limit for nanoseconds in 64 bits

std::int64_t systemNs() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::optional<std::int64_t> nsOf(double seconds) {
  if (!(seconds > 0 && seconds < kLatest_s)) return std::nullopt;
  return std::int64_t(std::llround(seconds * 1e6)) * 1'000;  // a double only has microseconds
}

Entry entryOf(const robot::Delivery& delivery, std::int64_t started_ns) {
  Entry entry;
  entry.before = delivery.before;
  const std::int64_t came_ns = nsOf(delivery.received_s).value_or(started_ns);
  entry.log_ns = delivery.before ? started_ns : std::max(started_ns, came_ns);
  const std::int64_t unsaid_ns = delivery.before ? came_ns : entry.log_ns;
  entry.publish_ns = delivery.said_s ? nsOf(*delivery.said_s).value_or(unsaid_ns) : unsaid_ns;
  entry.encoding = delivery.encoding;
  if (delivery.kind == robot::Delivery::Kind::Definition) {
    entry.kind = Entry::Kind::Definition;
    entry.name = delivery.name;
    return entry;
  }
  if (delivery.kind != robot::Delivery::Kind::Message) {
    entry.kind = Entry::Kind::File;
    entry.publish_ns = 0;  // its creation time is unknown
    entry.before = false;
    entry.name = delivery.kind == robot::Delivery::Kind::Submap ? submapName(delivery.submap)
                                                                : pictureName(delivery.name);
    return entry;
  }
  const bool binary = delivery.encoding == "protobuf" || delivery.encoding == "axbot";
  entry.name = !delivery.name.empty() ? std::string(delivery.name) : binary ? kAxbotBinary : kAxbotAnswer;
  entry.schema = delivery.schema;
  return entry;
}

}  // namespace

map::Streams everyStream() {
  map::Streams all;
  for (int stream = 0; stream <= int(map::Stream::GlobalPositioning); ++stream)
    all.insert(map::Stream(stream));
  return all;
}

tl::expected<std::unique_ptr<Recorder>, disk::FileError> Recorder::start(
    robot::Robot& robot, std::unique_ptr<recording::AppendTarget> target, Options options) {
  if (!options.now_ns) options.now_ns = systemNs;
  auto writer = recording::McapWriter::create(std::move(target), options.writer);
  if (!writer) return tl::unexpected(std::move(writer.error()));
  std::unique_ptr<Recorder> recorder(new Recorder(robot, std::move(*writer), std::move(options)));
  recorder->begin();
  return recorder;
}

Recorder::Recorder(robot::Robot& robot, std::unique_ptr<recording::McapWriter> writer, Options options)
    : robot_(&robot),
      options_(std::move(options)),
      started_ns_(options_.now_ns()),
      queue_(std::make_shared<EntryQueue>(options_.most_waiting_bytes)),
      tape_(std::move(writer)) {}

Recorder::~Recorder() { finish(); }

void Recorder::begin() {
  qCInfo(lcRecorder, "recording of %s begins", qUtf8Printable(robot_->address()));
  thread_ = std::thread([this] { run(); });
  recordIdentity();
  connect(robot_.data(), &robot::Robot::identityChanged, this, &Recorder::recordIdentity);
  onLink();
  connect(robot_.data(), &robot::Robot::connectionChanged, this, &Recorder::onLink);
  if (robot::Delivers* const delivers = robot::deliversOf(*robot_)) {
    delivers->setDeliveryTap([queue = queue_, started_ns = started_ns_](const robot::Delivery& delivery) {
      queue->put(entryOf(delivery, started_ns), delivery.bytes);
    });
  }
  fetches_ = std::make_unique<Fetches>(
      *robot_, options_.submaps,
      [this](std::string name, std::string media_type, std::string_view bytes) {
        Entry entry;
        entry.kind = Entry::Kind::File;
        entry.name = std::move(name);
        entry.encoding = std::move(media_type);
        entry.log_ns = std::max(started_ns_, options_.now_ns());
        queue_->put(std::move(entry), bytes);
      },
      options_.now_ns);
  connect(fetches_.get(), &Fetches::notHad, this, &Recorder::notHad);
  connect(&timer_, &QTimer::timeout, this, &Recorder::progressed);
  timer_.start(kTellEveryMs);
}

void Recorder::recordIdentity() {
  if (!robot_) return;
  const robot::RobotIdentity identity = robot_->identity();
  putMetadata(kAbout, {{"version", std::to_string(kVersion)},
                       {"address", robot_->address().toStdString()},
                       {"kind", options_.kind},
                       {"model", identity.model.toStdString()},
                       {"serial", identity.serial.toStdString()},
                       {"name", identity.name.toStdString()},
                       {"firmware", identity.version.toStdString()},
                       {"recorded_by", options_.recorded_by},
                       {"started_ns", std::to_string(started_ns_)}});
}

void Recorder::putMetadata(const char* name, recording::Values values) {
  Entry entry;
  entry.kind = Entry::Kind::Metadata;
  entry.name = name;
  entry.values = std::move(values);
  queue_->put(std::move(entry), {});
}

void Recorder::onLink() {
  if (!robot_) return;
  const bool online = robot_->connection().phase == robot::ConnectionPhase::Online;
  was_online_ |= online;
  if (!was_online_ || online == !lost_ns_) return;
  const std::int64_t now_ns = options_.now_ns();
  recording::Values values{{"lost_ns", std::to_string(lost_ns_.value_or(now_ns))}};
  if (online) values["back_ns"] = std::to_string(now_ns);
  lost_ns_ = online ? std::nullopt : std::optional(now_ns);
  putMetadata(kLink, std::move(values));
}

void Recorder::run() {
  while (!queue_->over()) {
    for (Entry& entry : queue_->take(kTick)) tape_.write(std::move(entry));
    tape_.tick(options_.now_ns());
    publish();
  }
  auto fault = tape_.finish(options_.now_ns(), queue_->lost());
  publish();
  const std::lock_guard lock(mutex_);
  const Written& written = progress_.written;
  qCInfo(lcRecorder, "recording ends: %lld messages, %lld files, %lld bytes; %lld lost%s%s",
         (long long)(written.messages), (long long)(written.files), (long long)(written.bytes),
         (long long)(written.lost), fault ? "; " : "",
         fault ? inEnglish(disk::notWritten(*fault)).c_str() : "");
  progress_.end_fault = std::move(fault);
  progress_.finished = true;
  progress_.seconds = double(options_.now_ns() - started_ns_) / 1e9;
  QMetaObject::invokeMethod(
      this,
      [this] {
        timer_.stop();
        Q_EMIT finished();
      },
      Qt::QueuedConnection);
}

void Recorder::publish() {
  Written written = tape_.written();
  const EntryQueue::Losses lost = queue_->lost();
  written.lost += lost.entries;
  written.lost_bytes += lost.bytes;
  const std::lock_guard lock(mutex_);
  progress_.written = std::move(written);
}

Recorder::Progress Recorder::progress() const {
  const std::lock_guard lock(mutex_);
  Progress progress = progress_;
  if (!progress.finished) progress.seconds = double(options_.now_ns() - started_ns_) / 1e9;
  return progress;
}

void Recorder::stop() {
  if (std::exchange(stopped_, true)) return;
  if (robot_) {
    if (robot::Delivers* const delivers = robot::deliversOf(*robot_)) delivers->setDeliveryTap({});
    robot_->disconnect(this);
  }
  fetches_.reset();
  queue_->close();
}

void Recorder::finish() {
  stop();
  if (thread_.joinable()) thread_.join();
}

}  // namespace mapwright::recorder

#include "moc_recorder.cpp"
