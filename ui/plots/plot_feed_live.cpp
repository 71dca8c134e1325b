// The samples of a live robot: the last half hour.
#include <algorithm>
#include <cmath>

#include "replay/replay_robot.h"
#include "series/read_fields.h"
#include "series/speed.h"
#include "ui/plots/plot_feed.h"

namespace mapwright::window {

using series::Quantity;

namespace {
const QString kPlotsOwner = QStringLiteral("plots");
constexpr int kPlotsTickMs = 500;
constexpr qsizetype kSmallMessage = 64 * 1024;
constexpr std::size_t kMostTopics = 300;
}  // namespace

void PlotFeed::setSession(session::Session* session) {
  if (live_) live_->disconnect(this);
  if (session_) session_->disconnect(this);
  live_ = nullptr;
  live_since_s_.reset();
  tick_.stop();
  session_ = session;
  if (!replays()) clear();
  const bool speaks = session && session->robot().liveTopics() != nullptr;
  if (speaks && !qobject_cast<replay::ReplayRobot*>(&session->robot())) {
    live_ = &session->robot();
    connect(live_, &QObject::destroyed, this, [this] { live_ = nullptr; });
    connect(live_, &robot::Robot::topicReceived, this, &PlotFeed::heard);
    connect(live_, &robot::Robot::rawReceived, this, &PlotFeed::heardRaw);
    connect(live_, &robot::Robot::connectionChanged, this, &PlotFeed::listen);
    listen();
  }
  tellWishes();
}

void PlotFeed::listen() {
  const bool online = live_ && live_->connection().phase == robot::ConnectionPhase::Online;
  // From here on there are no gaps; earlier data is a separate stretch.
  if (!online) live_since_s_.reset();
  if (online && !live_since_s_) live_since_s_ = now();
}

void PlotFeed::tellWishes() {
  bool raw = false;
  map::Streams streams;
  QStringList topics;
  if (live_ && !replays()) {
    for (const auto& [wish, entry] : entries_) {
      if (const auto* path = std::get_if<series::FieldPath>(&wish)) {
        raw = true;
        topics << QString::fromStdString(path->topic);
      } else if (std::get<Quantity>(wish) == Quantity::Battery) {
        streams.insert(map::Stream::Battery);
      } else if (series::isOfPose(std::get<Quantity>(wish))) {
        streams.insert(map::Stream::Pose);
      }
    }
    topics.removeDuplicates();
    if (session_) session_->want(kPlotsOwner, streams, topics);
  }
  // Without viewers no clock is needed.
  if (!live_ || replays() || entries_.empty()) {
    tick_.stop();
  } else if (!tick_.isActive()) {
    tick_.start(kPlotsTickMs);
  }
  if (std::exchange(raw_wanted_, raw) != raw) Q_EMIT rawWanted(raw);
}

void PlotFeed::add(const PlotWish& wish, double at_s, double value) {
  const auto found = entries_.find(wish);
  if (found == entries_.end()) return;
  found->second.series->append(at_s, value);
  noteSoon();
}

void PlotFeed::heard(const map::StampedMessage& message) {
  if (replays()) return;
  const double at_s = message.at_s();
  for (const auto& [wish, entry] : entries_) {
    const auto* quantity = std::get_if<Quantity>(&wish);
    const auto value = quantity ? series::valueOf(*quantity, message.message) : std::nullopt;
    if (value) add(wish, at_s, *value);
  }
  const auto* tracked = std::get_if<map::TrackedPose>(&message.message);
  if (!tracked || !entries_.contains(Quantity::Speed)) return;
  x_.append(at_s, tracked->pose.x_m);
  y_.append(at_s, tracked->pose.y_m);
  coverLive();
  const auto speeds = series::speeds(x_, y_, at_s, std::nextafter(at_s, 1e300));
  if (!speeds.empty()) add(Quantity::Speed, at_s, speeds.back().value);
}

void PlotFeed::heardRaw(const robot::RawMessage& message) {
  if (replays()) return;
  const std::string topic = message.topic.toStdString();
  if (message.text.size() <= kSmallMessage && (last_raw_.size() < kMostTopics || last_raw_.contains(topic)))
    last_raw_[topic] = message.text;
  std::vector<series::FieldPath> paths;
  for (const auto& [wish, entry] : entries_) {
    if (const auto* path = std::get_if<series::FieldPath>(&wish); path && path->topic == topic)
      paths.push_back(*path);
  }
  if (paths.empty()) return;
  series::FieldReader reader(paths);
  const auto& values = reader.read(topic, {message.text.constData(), std::size_t(message.text.size())});
  const double at_s =
      message.received.isValid() ? double(message.received.toMSecsSinceEpoch()) / 1000 : now();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (values[i]) add(paths[i], at_s, *values[i]);
  }
}

void PlotFeed::coverLive() {
  if (!live_since_s_ || replays()) return;
  // Messages may have stamps of the present or slightly later.
  const double until_s = now() + 1, oldest_s = until_s - kLive_s;
  const auto keep = [&](series::Series& series) {
    series.forgetBefore(oldest_s);
    series.cover(std::max(*live_since_s_, oldest_s), until_s);
  };
  for (auto& [wish, entry] : entries_) keep(*entry.series);
  keep(x_);
  keep(y_);
  noteSoon();
}

}  // namespace mapwright::window
