#include "ui/plots/plot_feed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDateTime>

#include "replay/recorded_message.h"
#include "series/read_fields.h"
#include "series/speed.h"

namespace mapwright::window {

using series::Quantity;
using series::Sample;

namespace {

constexpr int kNoteMs = 100;
constexpr std::size_t kSmall = 64 * 1024, kMostFields = 4'000;

bool isPose(const PlotWish& wish) {
  const auto* quantity = std::get_if<Quantity>(&wish);
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
  for (auto& [wish, entry] : entries_) entry.series->clear();
  x_.clear();
  y_.clear();
  last_raw_.clear();
  noteSoon();
}

void PlotFeed::noteSoon() {
  if (!note_.isActive()) note_.start(kNoteMs);
}

PlotFeed::SeriesPtr PlotFeed::want(const PlotWish& wish) {
  Entry& entry = entries_[wish];
  if (entry.users++ == 0) {
    entry.series = std::make_shared<series::Series>(series::Series::Options{.most_samples = kMostSamples});
    catch_up_.start(0);
    tellWishes();
  }
  return entry.series;
}

void PlotFeed::letGo(const PlotWish& wish) {
  const auto found = entries_.find(wish);
  if (found == entries_.end() || --found->second.users > 0) return;
  entries_.erase(found);
  tellWishes();
}

void PlotFeed::setReading(replay::Reading* reading) {
  if (reading_) reading_->disconnect(this);
  reading_ = reading;
  clear();
  if (reading_) {
    connect(reading_, &replay::Reading::chunkRead, this, [this](const replay::ChunkPtr& chunk) {
      const auto digest = reading_->index().digests().find(replay::tickOf(chunk->from_s));
      if (digest != reading_->index().digests().end())
        takePoses(digest->second, lacking(chunk->from_s, chunk->until_s, true));
      takeMessages(chunk);
    });
    catch_up_.start(0);
  }
  tellWishes();
}

PlotFeed::Wishes PlotFeed::lacking(double from_s, double until_s, bool poses) const {
  Wishes wishes;
  for (const auto& [wish, entry] : entries_) {
    if (isPose(wish) == poses && !entry.series->isCovered(from_s, until_s)) wishes.push_back(wish);
  }
  return wishes;
}

void PlotFeed::catchUp() {
  if (!reading_ || !reading_->info()) return;
  const auto& digests = reading_->index().digests();
  std::vector<replay::Tick> again;
  for (const auto& [from, cell] : reading_->chunks().cells()) {
    if (cell.state != replay::CellState::Read) continue;
    const double from_s = replay::secondsOf(cell.from), until_s = replay::secondsOf(cell.until);
    if (const auto digest = digests.find(from); digest != digests.end())
      takePoses(digest->second, lacking(from_s, until_s, true));
    if (lacking(from_s, until_s, false).empty()) continue;
    if (const replay::ChunkPtr chunk = reading_->chunkAt(from)) {
      takeMessages(chunk);
    } else {
      again.push_back(from);
    }
  }
  if (!again.empty()) reading_->readAgain(again);
}

void PlotFeed::takePoses(const replay::Digest& digest, const Wishes& wishes) {
  if (wishes.empty()) return;
  const double from_s = digest.from_s, until_s = digest.until_s;
  const auto samplesOf = [&](Quantity quantity) {
    std::vector<Sample> samples;
    samples.reserve(digest.poses.size());
    for (const replay::Digest::Pose& each : digest.poses)
      samples.push_back({each.stamp_s, series::valueOf(quantity, each.pose).value_or(std::nan(""))});
    return samples;
  };
  for (const PlotWish& wish : wishes) {
    const Quantity quantity = std::get<Quantity>(wish);
    series::Series& series = *entries_.at(wish).series;
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
  noteSoon();
}

void PlotFeed::takeMessages(const replay::ChunkPtr& chunk) {
  const Wishes wishes = lacking(chunk->from_s, chunk->until_s, false);
  if (wishes.empty()) return;
  share_.start(work::Urgency::Wanted,
               [this, chunk, wishes, number = *reading_number_, current = reading_number_] {
                 std::vector<Read> all;
                 std::vector<series::FieldPath> paths;
                 std::vector<std::size_t> of_path;
                 for (const PlotWish& wish : wishes) {
                   if (const auto* path = std::get_if<series::FieldPath>(&wish)) {
                     paths.push_back(*path);
                     of_path.push_back(all.size());
                   }
                   all.push_back({wish, {}});
                 }
                 series::FieldReader reader(std::move(paths));
                 for (std::size_t place = 0; place < chunk->order.size(); ++place) {
                   const robot::BagMessage& message = chunk->at(place);
                   const double at_s = chunk->stampAt(place);
                   for (Read& read : all) {
                     const auto* quantity = std::get_if<Quantity>(&read.wish);
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
    const auto found = entries_.find(read.wish);
    if (found != entries_.end()) found->second.series->insert(from_s, until_s, read.samples);
  }
  noteSoon();
}

QStringList PlotFeed::fields() const {
  QStringList words;
  const auto add = [&](const std::string& topic, std::string_view json) {
    if (json.size() > kSmall) return;
    for (const series::FieldPath& path : series::numericFields(topic, json)) {
      if (std::size_t(words.size()) < kMostFields) words << QString::fromStdString(path.text());
    }
  };
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
      for (const std::uint32_t place : chunk->back_filled) look(chunk->source->messages[place]);
      for (std::size_t place = 0; place < chunk->order.size(); ++place) look(chunk->at(place));
    }
    for (const auto& [topic, json] : by_topic) add(topic, json);
  } else {
    for (const auto& [topic, json] : last_raw_) add(topic, {json.constData(), std::size_t(json.size())});
  }
  return words;
}

}  // namespace mapwright::window

#include "moc_plot_feed.cpp"
