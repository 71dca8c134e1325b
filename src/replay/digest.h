// What of a range of a bag matters for all later times, in a fraction of its size. Pure.
//
// Most topics only tell how something is now: their last message is all that counts. What is made of more
// than the last message is kept message by message, but for those that change nothing: where the robot was
// (the trail), when alerts and states that people must know of began and ended, outlines that add up, and
// where the frame begins anew. tests/replay holds that a world made of this equals one made of everything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "map/world.h"
#include "replay/chunk.h"

namespace mapwright::replay {

/// What a message replaces: its kind, and among these the picture's layer or the cloud's topic.
using Slot = std::pair<std::size_t, std::string>;
Slot slotOf(const map::TopicMessage& message);

/// The messages of one topic in a range.
struct TopicSpan {
  double first_s = 0, last_s = 0;
  std::size_t count = 0;
  bool operator==(const TopicSpan&) const = default;
};

/// So long without any message is worth to be told.
inline constexpr double kSilenceS = 5;

struct Digest {
  /// The last message of a slot. `place` is that in Chunk::order.
  struct Last {
    double stamp_s = 0;
    std::uint32_t place = 0;
    std::shared_ptr<const map::TopicMessage> message;  // null: it is large, and found in the chunk
    std::string picture_url = {};                      // of a picture that it only names
  };
  /// A message that counts besides being the last one. Lists of submaps and of overlays are left out of it.
  struct Kept {
    double stamp_s = 0;
    std::uint32_t place = 0;
    map::TopicMessage message;
  };
  struct Pose {
    double stamp_s = 0;
    std::uint32_t place = 0;
    geometry::Pose2 pose;
  };
  /// When the planner said something else than before.
  struct Move {
    double stamp_s = 0;
    std::string state;
  };

  double from_s = 0, until_s = 0;
  std::map<Slot, Last> last;
  std::vector<Kept> history;
  std::vector<Pose> poses;
  std::vector<Move> moves;
  std::map<std::string, TopicSpan> topics;  // unknown ones, too
  double last_known_s = 0;                  // the stamp of the last message that says something of the world
  std::size_t messages = 0, known = 0;
  double first_s = 0, last_s = 0;                   // of the messages, where there are any
  std::vector<std::pair<double, double>> silences;  // within it: from one message to the next one
};

Digest digestOf(const Chunk& chunk);

/// Where the robot was then.
inline map::TrailPoint placeOf(const Digest::Pose& pose) {
  return {{pose.pose.x_m, pose.pose.y_m}, pose.stamp_s};
}

/// Whether it is small enough to be kept for good.
bool isSmall(const map::TopicMessage& message);
/// Without what does not matter to what comes after it: the entries of a list, the overlays of a map.
map::TopicMessage lightened(const map::TopicMessage& message);
/// One that must not be left out, whatever comes after it, unless it says the same as `before`, the last kept
/// one of its slot (null = there is none).
bool countsLater(const map::TopicMessage& message, const map::TopicMessage* before);

}  // namespace mapwright::replay
