#include "ui/plots/plot_feed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDateTime>

#include "replay/replay_robot.h"
#include "series/fields.h"

namespace mapwright::ui {

using series::Quantity;
using series::Sample;

namespace {

const QString kPlotsOwner = QStringLiteral("plots");
constexpr int kPlotsTickMs = 500;
constexpr std::size_t kMostTopics = 300;
constexpr int kNoteMs = 100;
constexpr std::size_t kSmall = 64 * 1024, kMostFields = 4'000;

bool isPose(const PlotSelection& selection) {
  const auto* quantity = std::get_if<Quantity>(&selection);
  return quantity && series::isOfPose(*quantity);
}

double systemSeconds() { return double(QDateTime::currentMSecsSinceEpoch()) / 1000; }

}  // namespace

PlotFeed::PlotFeed(std::shared_ptr<work::Workers> workers, std::function<double()> wall, QObject* parent)
    : QObject(parent),
      wall_(wall ? std::move(wall) : systemSeconds),
      share_(work::orOwn(std::move(workers))) {
  for (QTimer* timer : {&catch_up_, &note_}) timer->setSingleShot(true);
  connect(&catch_up_, &QTimer::timeout, this, &PlotFeed::catchUp);
  connect(&note_, &QTimer::timeout, this, &PlotFeed::changed);
  connect(&tick_, &QTimer::timeout, this, &PlotFeed::coverLive);
}

PlotFeed::~PlotFeed() = default;

void PlotFeed::clear() {
  ++*reading_number_;
  share_.drop();
  for (auto& [selection, entry] : entries_) entry.series->clear();
  x_.clear();
  y_.clear();
  last_raw_.clear();
  updateSoon();
}

void PlotFeed::updateSoon() {
  if (!note_.isActive()) note_.start(kNoteMs);
}

PlotFeed::SeriesPtr PlotFeed::want(const PlotSelection& selection) {
  Entry& entry = entries_[selection];
  if (entry.users++ == 0) {
    entry.series = std::make_shared<series::Series>(series::Series::Options{.most_samples = kMostSamples});
    catch_up_.start(0);
    subscribe();
  }
  return entry.series;
}

void PlotFeed::letGo(const PlotSelection& selection) {
  const auto found = entries_.find(selection);
  if (found == entries_.end() || --found->second.users > 0) return;
  entries_.erase(found);
  subscribe();
}

void PlotFeed::setReading(replay::Reading* reading) {
  if (reading_) reading_->disconnect(this);
  reading_ = reading;
  clear();
  if (reading_) {
    connect(reading_, &replay::Reading::chunkRead, this, [this](const replay::ChunkPtr& chunk) {
      const auto digest = reading_->index().digests().find(replay::tickOf(chunk->from_s));
      if (digest != reading_->index().digests().end())
        addPoses(digest->second, lacking(chunk->from_s, chunk->until_s, true));
      addMessages(chunk);
    });
    catch_up_.start(0);
  }
  subscribe();
}

PlotFeed::Selections PlotFeed::lacking(double from_s, double until_s, bool poses) const {
  Selections selections;
  for (const auto& [selection, entry] : entries_) {
    if (isPose(selection) == poses && !entry.series->isCovered(from_s, until_s))
      selections.push_back(selection);
  }
  return selections;
}

void PlotFeed::catchUp() {
  if (!reading_ || !reading_->info()) return;
  const auto& digests = reading_->index().digests();
  std::vector<replay::Tick> again;
  for (const auto& [from, cell] : reading_->chunks().cells()) {
    if (cell.state != replay::CellState::Read) continue;
    const double from_s = replay::secondsOf(cell.from), until_s = replay::secondsOf(cell.until);
    if (const auto digest = digests.find(from); digest != digests.end())
      addPoses(digest->second, lacking(from_s, until_s, true));
    if (lacking(from_s, until_s, false).empty()) continue;
    if (const replay::ChunkPtr chunk = reading_->chunkAt(from)) {
      addMessages(chunk);
    } else {
      again.push_back(from);
    }
  }
  if (!again.empty()) reading_->readAgain(again);
}

void PlotFeed::addPoses(const replay::Digest& digest, const Selections& selections) {
  if (selections.empty()) return;
  const double from_s = digest.from_s, until_s = digest.until_s;
  const auto samplesOf = [&](Quantity quantity) {
    std::vector<Sample> samples;
    samples.reserve(digest.poses.size());
    for (const replay::Digest::Pose& each : digest.poses)
      samples.push_back({each.stamp_s, series::valueOf(quantity, each.pose).value_or(std::nan(""))});
    return samples;
  };
  for (const PlotSelection& selection : selections) {
    const Quantity quantity = std::get<Quantity>(selection);
    series::Series& series = *entries_.at(selection).series;
    if (quantity != Quantity::Speed) {
      series.insert(from_s, until_s, samplesOf(quantity));
      continue;
    }
    x_.insert(from_s, until_s, samplesOf(Quantity::X));
    y_.insert(from_s, until_s, samplesOf(Quantity::Y));
    series.insert(from_s, until_s, series::speeds(x_, y_, from_s, until_s));
    // Later samples may have been read before: their speeds were not known then.
    const double known_s = std::prev(x_.covered().upper_bound(until_s))->second;
    const double end_s = std::min(until_s + series::kSpeedReach_s, known_s);
    if (end_s > until_s) series.insert(until_s, end_s, series::speeds(x_, y_, until_s, end_s));
  }
  updateSoon();
}

void PlotFeed::addMessages(const replay::ChunkPtr& chunk) {
  const Selections selections = lacking(chunk->from_s, chunk->until_s, false);
  if (selections.empty()) return;
  share_.start(work::Urgency::Wanted,
               [this, chunk, selections, number = *reading_number_, current = reading_number_] {
                 std::vector<Read> all;
                 std::vector<series::FieldPath> paths;
                 std::vector<std::size_t> of_path;
                 for (const PlotSelection& selection : selections) {
                   if (const auto* path = std::get_if<series::FieldPath>(&selection)) {
                     paths.push_back(*path);
                     of_path.push_back(all.size());
                   }
                   all.push_back({selection, {}});
                 }
                 series::FieldReader reader(std::move(paths));
                 for (std::size_t index = 0; index < chunk->order.size(); ++index) {
                   const robot::BagMessage& message = chunk->at(index);
                   const double at_s = chunk->stampAt(index);
                   for (Read& read : all) {
                     const auto* quantity = std::get_if<Quantity>(&read.selection);
                     if (!quantity || !message.known) continue;
                     if (const auto value = series::valueOf(*quantity, message.message.message))
                       read.samples.push_back({at_s, *value});
                   }
                   if (!replay::isRecorded(message) || !reader.wants(message.message.topic)) continue;
                   const auto& values = reader.read(message.message.topic, chunk->source->textOf(message));
                   for (std::size_t i = 0; i < values.size(); ++i) {
                     if (values[i]) all[of_path[i]].samples.push_back({at_s, *values[i]});
                   }
                 }
                 QMetaObject::invokeMethod(
                     this,
                     [this, from_s = chunk->from_s, until_s = chunk->until_s, all = std::move(all), number,
                      current]() mutable {
                       if (*current == number) putIn(from_s, until_s, std::move(all));
                     },
                     Qt::QueuedConnection);
               });
}

void PlotFeed::putIn(double from_s, double until_s, std::vector<Read> all) {
  for (const Read& read : all) {
    const auto found = entries_.find(read.selection);
    if (found != entries_.end()) found->second.series->insert(from_s, until_s, read.samples);
  }
  updateSoon();
}

QStringList PlotFeed::fields() const {
  QStringList words;
  eachLast([&](const std::string& topic, std::string_view json) {
    if (json.size() > kSmall) return;
    for (const series::FieldPath& path : series::numericFields(topic, json)) {
      if (std::size_t(words.size()) < kMostFields) words << QString::fromStdString(path.text());
    }
  });
  return words;
}

bool PlotFeed::lacks(const series::FieldPath& path) const {
  bool lacks = false;
  eachLast([&](const std::string& topic, std::string_view json) {
    if (topic != path.topic || json.size() > kSmall || series::numericFields(topic, json, 1).empty()) return;
    lacks = !series::FieldReader({path}).read(topic, json).front();
  });
  return lacks;
}

void PlotFeed::eachLast(const std::function<void(const std::string&, std::string_view)>& see) const {
  if (reading_ && reading_->info()) {
    std::map<std::string, std::string_view> by_topic;  // the last message of each
    std::vector<replay::ChunkPtr> held;
    for (const auto& [from, cell] : reading_->chunks().cells()) {
      const replay::ChunkPtr chunk = cell.held && held.size() < 4 ? reading_->chunkAt(from) : nullptr;
      if (!chunk) continue;
      held.push_back(chunk);
      const auto look = [&](const robot::BagMessage& message) {
        if (replay::isRecorded(message)) by_topic[message.message.topic] = chunk->source->textOf(message);
      };
      for (const std::uint32_t index : chunk->back_filled) look(chunk->source->messages[index]);
      for (std::size_t index = 0; index < chunk->order.size(); ++index) look(chunk->at(index));
    }
    for (const auto& [topic, json] : by_topic) see(topic, json);
  } else {
    for (const auto& [topic, json] : last_raw_) see(topic, {json.constData(), std::size_t(json.size())});
  }
}

// Of a live robot: the last half hour.

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
  subscribe();
}

void PlotFeed::listen() {
  const bool online = live_ && live_->connection().phase == robot::ConnectionPhase::Online;
  // From here on there are no gaps; earlier data is a separate stretch.
  if (!online) live_since_s_.reset();
  if (online && !live_since_s_) live_since_s_ = now();
}

void PlotFeed::subscribe() {
  bool raw = false;
  map::Streams streams;
  QStringList topics;
  if (live_ && !replays()) {
    for (const auto& [selection, entry] : entries_) {
      if (const auto* path = std::get_if<series::FieldPath>(&selection)) {
        raw = true;
        topics << QString::fromStdString(path->topic);
      } else if (std::get<Quantity>(selection) == Quantity::Battery) {
        streams.insert(map::Stream::Battery);
      } else if (series::isOfPose(std::get<Quantity>(selection))) {
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

void PlotFeed::add(const PlotSelection& selection, double at_s, double value) {
  const auto found = entries_.find(selection);
  if (found == entries_.end()) return;
  found->second.series->append(at_s, value);
  updateSoon();
}

void PlotFeed::heard(const map::StampedMessage& message) {
  if (replays()) return;
  const double at_s = message.at_s();
  for (const auto& [selection, entry] : entries_) {
    const auto* quantity = std::get_if<Quantity>(&selection);
    const auto value = quantity ? series::valueOf(*quantity, message.message) : std::nullopt;
    if (value) add(selection, at_s, *value);
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
  if (message.text.size() <= qsizetype(kSmall) &&
      (last_raw_.size() < kMostTopics || last_raw_.contains(topic)))
    last_raw_[topic] = message.text;
  std::vector<series::FieldPath> paths;
  for (const auto& [selection, entry] : entries_) {
    if (const auto* path = std::get_if<series::FieldPath>(&selection); path && path->topic == topic)
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
  for (auto& [selection, entry] : entries_) keep(*entry.series);
  keep(x_);
  keep(y_);
  updateSoon();
}

}  // namespace mapwright::ui

#include "moc_plot_feed.cpp"
