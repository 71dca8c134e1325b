// Which earlier messages still count at a time: with them, in this order, everything is as after all messages
// until then. A topic of most kinds only tells the present: its last message counts. Transforms, markers and
// patches last otherwise (Lasts). The file is read once, from its beginning on; what is kept are positions
// in it.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "recording/source.h"
#include "robot/recorded/earlier_messages.h"
#include "robot/recorded/message_fields.h"
#include "robot/recorded/ros_shape.h"

namespace mapwright::robot::recorded {

/// How long a message counts.
enum class Lasts {
  UntilNext,   // until the next one of the topic
  Transforms,  // as long as tf2 keeps it; and wherever something that still counts was placed by it
  PerChild,    // static transforms: until the next one of the same child frame
  PerMarker,   // until it is put again or deleted, or its lifetime is over
  Patches,     // until the next whole grid of `base`
  Autoxing,    // what begins a session or a map, until the second next; outlines of other robots: always
};

struct LastingTopic {
  std::string topic;
  Lasts lasts = Lasts::UntilNext;
  std::string base = {};
};

/// Each topic of the recording, also those that are not drawn: by type and quality of service, whatever their
/// namespace.
std::vector<LastingTopic> lastingTopics(const recording::Source& file, const RosShape& shape);
/// Those on which it depends where the robot and its markers are.
std::vector<LastingTopic> placingTopics(const recording::Source& file, const RosShape& shape);

/// One thread, that of the file.
class Lasting {
 public:
  /// tf2 keeps transforms that long.
  static constexpr std::int64_t kHistoryNs = 10'000'000'000;

  /// `shape`: which robots it holds, and which frame needs no transforms.
  Lasting(recording::Source& file, MessageFields& fields, std::vector<LastingTopic> topics,
          const RosShape& shape);
  /// Other topics: forgets everything.
  void reset(std::vector<LastingTopic> topics, const RosShape& shape);
  /// The file has grown, and nothing is known from there on.
  void forgetFrom(std::int64_t at_ns);

  /// Reads on towards `at_ns`, at most so many messages; true: everything before it is known.
  bool reach(std::int64_t at_ns, int most = std::numeric_limits<int>::max());
  /// The messages said before `at_ns` that still count then, in the order in which they were said.
  std::vector<recording::Message> before(std::int64_t at_ns);
  /// Whether there were any markers before; as of the last reach().
  bool anyMarkers() const { return state_.any_markers; }
  /// When the next marker's lifetime ends; nullopt: never. As of the last reach().
  std::optional<std::int64_t> nextMarkerEnd() const;

 private:
  /// A message in the file: the n-th of its topic at that log time.
  struct Position {
    std::int64_t log_ns = 0;
    std::uint32_t topic = 0, ordinal = 0;
    auto operator<=>(const Position&) const = default;
  };
  static constexpr std::uint32_t kLastOfTopic = std::numeric_limits<std::uint32_t>::max();  // as an ordinal
  /// A child frame of a robot, whatever its topic, or a marker.
  static constexpr std::uint32_t kTransform = std::numeric_limits<std::uint32_t>::max();
  struct Key {
    std::uint32_t topic = 0, name = 0;
    std::int64_t id = 0;
    auto operator<=>(const Key&) const = default;
  };
  /// The last message about it.
  struct Entry {
    Position position;
    std::int64_t until_ns = 0;  // its end; the lowest number: it is deleted
    std::uint64_t content = 0;  // of a static transform, to recognise repetitions
  };
  /// As it is before `until_ns`.
  struct State {
    std::int64_t until_ns = std::numeric_limits<std::int64_t>::min();
    std::map<Key, Entry> entries;
    bool any_markers = false;
  };
  using Checkpoint = std::shared_ptr<const State>;
  static std::size_t weightOf(const State& state) { return state.entries.size() + 16; }
  /// A message with the time of its content.
  struct Stamped {
    Position position;
    std::int64_t at_ns = 0;
    std::vector<std::optional<double>> stamps_s;  // nullopt: the latest
  };
  using Found = std::map<Position, recording::Message>;

  std::uint32_t nameOf(const std::string& name);
  std::string frameOfRobot(const std::string& topic, const std::string& frame) const;
  Position positionOf(const recording::Message& message, std::uint32_t topic);
  void apply(const recording::Message& message);
  void applyTransforms(const recording::Message& message, const Position& position);
  void applyMarkers(const recording::Message& message, const Position& position);
  void applyFrame(const recording::Message& message, const Position& position);
  bool isMarker(const Key& key) const;
  void keepCheckpoint();
  void dropDeleted();
  std::set<Position> live(std::int64_t at_ns, Found& found);
  void read(const std::set<Position>& positions, Found& found);
  FramePtr frameOf(const Position& position, const recording::Message& message);
  void addStamps(const recording::Message& message, Lasts lasts, Stamped& need);
  void addPlacing(std::vector<Stamped> needs, std::set<Position>& positions);
  void addRest(std::int64_t at_ns, Found& found, std::vector<Stamped>& needs);
  static std::vector<recording::Message> inOrder(Found found);

  recording::Source& file_;
  MessageFields& fields_;
  std::vector<LastingTopic> topics_;
  std::vector<std::string> robots_;
  std::string fixed_frame_;
  std::map<std::string, std::uint32_t> by_topic_, names_;
  std::vector<std::string> indexed_, transforms_;  // topics: of PerChild and PerMarker; of Transforms

  State state_;
  std::unique_ptr<recording::Cursor> cursor_;                                // reads on from state_ ...
  std::int64_t target_ns_ = 0;                                               // ... up to there
  std::map<std::uint32_t, std::pair<std::int64_t, std::uint32_t>> counted_;  // of a topic: messages at a time
  std::map<std::int64_t, Checkpoint> checkpoints_;
  std::size_t checkpoint_entries_ = 0, since_checkpoint_ = 0, deleted_ = 0;
  std::size_t cleaned_ = 0;  // how many were left when they were last cleaned up

  /// Each change of a child frame's static transform, with its time.
  std::map<std::uint32_t, std::set<std::pair<std::int64_t, Position>>> statics_;

  std::map<Position, FramePtr> frames_;               // of the last before()
  std::map<Position, std::set<Position>> placed_by_;  // by markers: of the last before()
};

}  // namespace mapwright::robot::recorded
