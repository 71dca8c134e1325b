#include "excerpt/excerpt.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <variant>

#include "excerpt/whole_target.h"
#include "recorder/layout.h"
#include "replay/digest.h"
#include "replay/track.h"

namespace mapwright::excerpt {
namespace {

std::int64_t oddIn(const replay::Chunk& chunk) {
  return std::int64_t(chunk.source->without_stamp + chunk.source->unreadable);
}

class Lines : public Writing {
 public:
  explicit Lines(const Order& order) : order_(order), file_(order.path, order.existing) {}

  std::optional<disk::FileError> add(const replay::Chunk& chunk) override {
    done_.odd += oddIn(chunk);
    for (std::size_t i = 0; i < chunk.order.size(); ++i) {
      const robot::BagMessage& message = chunk.at(i);
      if (!order_.span.holds(message.message.received_s)) continue;
      if (!isOneOf(order_.topics, message.message.topic)) continue;
      file_.write(jsonLine(chunk.source->textOf(message)));
      file_.write("\n");
      ++done_.messages;
      done_.topics.insert(message.message.topic);
    }
    // After a failure everything fails, and place() gives the reason.
    return file_.good() ? std::nullopt : file_.place();
  }
  tl::expected<Written, disk::FileError> place() override {
    if (auto fault = file_.place()) return tl::make_unexpected(std::move(*fault));
    return done_;
  }

 private:
  Order order_;
  disk::WrittenFile file_;
  Written done_;
};

/// A part of a bag laid out like a session recorded here (recorder/layout.h): played alone it shows what the
/// bag shows in that time, except how it came about.
class Mcap : public Writing {
 public:
  Mcap(WholeMcap file, const Order& order) : file_(std::move(file)), order_(order), span_(order.span) {}

  std::optional<disk::FileError> describe() {
    recording::Values about{{"version", "1"},
                            {"address", order_.address},
                            {"kind", order_.robot_kind},
                            {"bag", order_.bag},
                            {"recorded_by", "mapwright " MAPWRIGHT_VERSION}};
    for (const char* unknown : {"model", "serial", "name", "firmware"}) about[unknown];
    if (span_.from_s) about["started_ns"] = std::to_string(nanosecondsOf(*span_.from_s));
    return file_.writer().addMetadata({recorder::kAbout, std::move(about)});
  }

  std::optional<disk::FileError> add(const replay::Chunk& chunk) override {
    done_.odd += oddIn(chunk);
    for (std::size_t i = 0; i < chunk.order.size(); ++i) {
      const robot::BagMessage& message = chunk.at(i);
      const std::string& topic = message.message.topic;
      const double stamp_s = message.message.received_s;
      if (!isOneOf(order_.topics, topic) || (span_.to_s && stamp_s > *span_.to_s)) continue;
      done_.topics.insert(topic);
      const std::string_view json = chunk.source->textOf(message);
      if (span_.from_s && stamp_s < *span_.from_s) {
        keep(message, json);
        continue;
      }
      if (auto fault = begin()) return fault;
      ++done_.messages;
      if (auto fault = write(topic, false, stamp_s, stamp_s, json)) return fault;
    }
    return std::nullopt;
  }

  tl::expected<Written, disk::FileError> place() override {
    auto fault = begin();
    recording::Metadata end{
        recorder::kEnd, {{"messages", std::to_string(done_.messages)}, {"lost", "0"}, {"lost_bytes", "0"}}};
    if (span_.to_s) end.values["ended_ns"] = std::to_string(nanosecondsOf(*span_.to_s));
    if (!fault) fault = file_.writer().addMetadata(end);
    if (!fault) fault = file_.finish();
    if (fault) return tl::make_unexpected(std::move(*fault));
    return done_;
  }

 private:
  struct Said {
    std::string topic;
    double stamp_s = 0;
    std::string json;
  };
  using SaidPtr = std::shared_ptr<const Said>;

  /// Of messages before the span the last one of each topic is kept as its initial state; and what begins a
  /// session or a map, with the one before it, so that it forgets what lay in that one; and the last outline
  /// of each other robot.
  void keep(const robot::BagMessage& message, std::string_view json) {
    const std::string& topic = message.message.topic;
    const auto said =
        std::make_shared<const Said>(Said{topic, message.message.received_s, std::string(json)});
    said_before_[{topic, "last"}] = said;
    if (!message.known) return;
    const map::TopicMessage& content = message.message.message;
    if (const auto* outlines = std::get_if<map::NearbyFootprintsMessage>(&content)) {
      for (const auto& [digest, outline] : outlines->by_digest) said_before_[{topic, "of " + digest}] = said;
    }
    const bool frame =
        std::holds_alternative<map::SubmapList>(content) || std::holds_alternative<map::MapInfo>(content);
    if (!frame) return;
    const auto known = frames_.find(topic);
    if (!replay::countsLater(content, known == frames_.end() ? nullptr : &known->second)) return;
    frames_.insert_or_assign(topic, replay::lightened(content));
    if (const auto now = said_before_.find({topic, "begins"}); now != said_before_.end())
      said_before_[{topic, "began"}] = now->second;
    said_before_[{topic, "begins"}] = said;
  }

  std::optional<disk::FileError> begin() {
    if (std::exchange(begun_, true)) return std::nullopt;
    std::vector<SaidPtr> all;
    for (const auto& [key, said] : said_before_) all.push_back(said);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::sort(all.begin(), all.end(), [](const SaidPtr& a, const SaidPtr& b) {
      return std::tie(a->stamp_s, a->topic) < std::tie(b->stamp_s, b->topic);
    });
    for (const SaidPtr& said : all) {
      if (auto fault = write(said->topic, true, *span_.from_s, said->stamp_s, said->json)) return fault;
      ++done_.said_before;
    }
    said_before_.clear();
    return std::nullopt;
  }

  std::optional<disk::FileError> write(const std::string& topic, bool before, double log_s, double stamp_s,
                                       std::string_view json) {
    recording::Channel channel;
    channel.topic = topic;
    channel.message_encoding = "json";
    channel.schema_name = recorder::kPlainJson;
    channel.schema_encoding = "jsonschema";
    channel.schema_data = R"({"type":"object"})";
    if (before) channel.metadata[recorder::kSaid] = recorder::kBefore;
    const std::uint32_t sequence = before ? 0 : ++sequences_[topic];
    return file_.write(channel, {nanosecondsOf(log_s), nanosecondsOf(stamp_s), sequence},
                       {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
  }

  WholeMcap file_;
  Order order_;
  TimeSpan span_;
  std::map<std::pair<std::string, std::string>, SaidPtr> said_before_;  // by topic, and why
  std::map<std::string, map::TopicMessage> frames_;                     // the last one of `begins`, by topic
  std::map<std::string, std::uint32_t> sequences_;
  bool begun_ = false;
  Written done_;
};

class Track : public Writing {
 public:
  explicit Track(const Order& order) : order_(order), file_(order.path, order.existing) {}

  std::optional<disk::FileError> add(const replay::Chunk& chunk) override {
    done_.odd += oddIn(chunk);
    index_.add(replay::tickOf(chunk.from_s), replay::digestOf(chunk));
    // If the output cannot be written there is no point in reading on.
    return file_.good() ? std::nullopt : file_.place();
  }
  tl::expected<Written, disk::FileError> place() override {
    const std::vector<replay::TrackPoint> track =
        replay::within(replay::trackOf(index_.digests()), order_.span.from_s.value_or(-HUGE_VAL),
                       order_.span.to_s.value_or(HUGE_VAL));
    file_.write(order_.kind == Kind::TrackCsv   ? replay::csvOf(track)
                : order_.kind == Kind::TrackTum ? replay::tumOf(track)
                                                : replay::geoJsonOf(track, replay::mapsOf(index_.digests())));
    if (auto fault = file_.place()) return tl::make_unexpected(std::move(*fault));
    done_.samples = std::int64_t(track.size());
    done_.pieces = track.empty() ? 0 : std::int64_t(track.back().piece - track.front().piece + 1);
    return done_;
  }

 private:
  Order order_;
  disk::WrittenFile file_;
  replay::PrefixIndex index_;
  Written done_;
};

}  // namespace

bool isOneOf(const std::vector<std::string>& topics, const std::string& topic) {
  return topics.empty() || std::find(topics.begin(), topics.end(), topic) != topics.end();
}

std::string jsonLine(std::string_view json) {
  std::string line(json);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

std::optional<double> readsFrom(const Order& order) {
  return order.kind == Kind::Mcap ? std::nullopt : order.span.from_s;
}

bool wantsWholeTexts(Kind kind) { return kind == Kind::Lines; }

tl::expected<std::unique_ptr<Writing>, disk::FileError> begin(const Order& order) {
  if (order.kind == Kind::Lines) return std::make_unique<Lines>(order);
  if (order.kind != Kind::Mcap) return std::make_unique<Track>(order);
  auto file = WholeMcap::create(order);
  if (!file) return tl::make_unexpected(file.error());
  auto mcap = std::make_unique<Mcap>(std::move(*file), order);
  if (const auto fault = mcap->describe()) return tl::make_unexpected(*fault);
  return mcap;
}

}  // namespace mapwright::excerpt
