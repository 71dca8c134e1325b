#include "excerpt/excerpt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "disk/written_file.h"
#include "excerpt/bag_mcap.h"
#include "replay/digest.h"
#include "replay/prefix_index.h"
#include "replay/track.h"

namespace mapwright::excerpt {
namespace {

std::int64_t oddIn(const replay::Chunk& chunk) {
  return std::int64_t(chunk.source->without_stamp + chunk.source->unreadable);
}

class Lines : public Writing {
 public:
  explicit Lines(const Order& order) : order_(order), file_(order.path) {}

  std::optional<disk::FileError> take(const replay::Chunk& chunk) override {
    done_.odd += oddIn(chunk);
    for (std::size_t place = 0; place < chunk.order.size(); ++place) {
      const robot::BagMessage& message = chunk.at(place);
      if (!order_.span.holds(message.message.received_s)) continue;
      if (!isOneOf(order_.topics, message.message.topic)) continue;
      file_.write(jsonLine(chunk.source->textOf(message)));
      file_.write("\n");
      ++done_.messages;
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

class Mcap : public Writing {
 public:
  Mcap(std::unique_ptr<BagMcap> file, std::vector<std::string> topics)
      : file_(std::move(file)), topics_(std::move(topics)) {}

  std::optional<disk::FileError> take(const replay::Chunk& chunk) override {
    odd_ += oddIn(chunk);
    for (std::size_t place = 0; place < chunk.order.size(); ++place) {
      const robot::BagMessage& message = chunk.at(place);
      if (!isOneOf(topics_, message.message.topic)) continue;
      if (auto fault = file_->take(message, chunk.source->textOf(message))) return fault;
    }
    return std::nullopt;
  }
  tl::expected<Written, disk::FileError> place() override {
    if (auto fault = file_->finish()) return tl::make_unexpected(std::move(*fault));
    Written done;
    done.messages = file_->messages();
    done.said_before = file_->saidBefore();
    done.odd = odd_;
    return done;
  }

 private:
  std::unique_ptr<BagMcap> file_;
  std::vector<std::string> topics_;
  std::int64_t odd_ = 0;
};

class Track : public Writing {
 public:
  explicit Track(const Order& order) : order_(order), file_(order.path) {}

  std::optional<disk::FileError> take(const replay::Chunk& chunk) override {
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
                                                : replay::geoJsonOf(track));
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
  std::unique_ptr<Writing> writing;
  switch (order.kind) {
    case Kind::Mcap: {
      auto file = BagMcap::create(order.path, order.address, order.bag, order.span);
      if (!file) return tl::make_unexpected(file.error());
      return std::make_unique<Mcap>(std::move(*file), order.topics);
    }
    case Kind::Lines:
      return std::make_unique<Lines>(order);
    case Kind::TrackCsv:
    case Kind::TrackGeoJson:
    case Kind::TrackTum:
      break;
  }
  return std::make_unique<Track>(order);
}

}  // namespace mapwright::excerpt
