// The part of a range of a bag that affects all later times, in a fraction of its size, and what is known of
// a bag up to a time by the ranges read so far. Pure. Most topics only tell the present state of something:
// only their last message counts. What depends on more than the last message is kept message by message,
// unless it changes nothing: the robot's trail, starts and ends of alerts and conditions, accumulated
// outlines, and changes of the frame. tests/replay checks that a world made from this equals one made from
// everything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "map/world.h"
#include "replay/chunks.h"

namespace mapwright::replay {

/// What a message replaces: its type, and the picture's layer or the cloud's topic.
using Slot = std::pair<std::size_t, std::string>;
Slot slotOf(const map::TopicMessage& message);

/// The messages of one topic in a range.
struct TopicSpan {
  double first_s = 0, last_s = 0;
  std::size_t count = 0;
  bool operator==(const TopicSpan&) const = default;
};

/// A pause of at least this length is worth showing.
inline constexpr double kSilenceS = 5;

struct Digest {
  /// The last message of a slot. `index` is its position in Chunk::order.
  struct Last {
    double stamp_s = 0;
    std::uint32_t index = 0;
    std::shared_ptr<const map::TopicMessage> message;  // null: it is large; get it from the chunk
    std::string picture_url = {};                      // for a picture given only by its address
  };
  /// A message that counts besides the last one. Lists of submaps and of overlays are removed from it.
  struct Kept {
    double stamp_s = 0;
    std::uint32_t index = 0;
    map::TopicMessage message;
  };
  struct Pose {
    double stamp_s = 0;
    std::uint32_t index = 0;
    geometry::Pose2 pose;
  };
  /// When the state of the planner changed.
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
  double last_known_s = 0;                  // the stamp of the last message that affects the world
  std::size_t messages = 0, known = 0;
  double first_s = 0, last_s = 0;                   // of the messages, if there are any
  std::vector<std::pair<double, double>> silences;  // inside the range: from one message to the next
};

Digest digestOf(const Chunk& chunk);

/// Where the robot was then.
inline map::TrailPoint placeOf(const Digest::Pose& pose) {
  return {{pose.pose.x_m, pose.pose.y_m}, pose.stamp_s};
}

/// Whether it is small enough to be kept permanently.
bool isSmall(const map::TopicMessage& message);
/// Without the parts that do not affect later messages: the entries of a list, the overlays of a map.
map::TopicMessage lightened(const map::TopicMessage& message);
/// A message that must be kept whatever follows, unless it equals `before`, the last kept one of its slot
/// (null = none).
bool countsLater(const map::TopicMessage& message, const map::TopicMessage* before);

class PrefixIndex {
 public:
  /// For the range that begins at `from`; replaces an earlier one.
  void add(Tick from, Digest digest);
  /// Removes a range.
  void forget(Tick from);
  void clear();
  const std::map<Tick, Digest>& digests() const { return digests_; }

  /// The state that depends on more than the last messages (see above), after all ranges before
  /// `from`. Nothing else in the result is valid. The result for each range is kept, so that repeating costs
  /// a copy. All ranges before `from` must be there, or be added before the next call.
  map::World historyBefore(Tick from) const;

  /// Every topic in the ranges before `from` with its last stamp.
  void addTopicsBefore(Tick from, std::map<std::string, double>& last_s) const;

  /// The last message of a slot before `from`: calls `find(slot, range, last)` for each slot that occurs
  /// there.
  template <typename Find>
  void forLastBefore(Tick from, Find find) const {
    for (const auto& [slot, ranges] : slots_) {
      if (const std::optional<Tick> range = lastOf(ranges, from))
        find(slot, *range, digests_.at(*range).last.at(slot));
    }
  }

 private:
  using Ranges = std::vector<Tick>;  // sorted
  static std::optional<Tick> lastOf(const Ranges& ranges, Tick before);
  void share(const Slot& slot, Digest::Last& last, const Ranges& ranges, Tick from) const;
  void unfile(Tick from, const Digest& digest);
  void foldUntil(Tick from) const;

  /// The state after a range. A trail is long, and each range adds to it: only the addition is stored.
  struct Fold {
    std::shared_ptr<const map::World> besides;  // everything except pose and trail; shared while unchanged
    std::optional<geometry::Pose2> pose;
    double at_s = 0;
    std::vector<map::TrailPoint> trail;  // what came to it
    bool trail_begins = false;           // the earlier trail was cleared
  };

  std::map<Tick, Digest> digests_;
  std::map<std::string, Ranges> topics_;  // where each was heard
  std::map<Slot, Ranges> slots_;
  mutable std::map<Tick, Fold> folds_;  // for the first ranges, without a gap
};

/// Applies the messages of `digest` that count besides the last ones, up to `at_s`.
void foldHistory(map::World& world, const Digest& digest, double at_s);

}  // namespace mapwright::replay
