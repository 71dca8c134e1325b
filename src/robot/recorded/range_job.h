// Reads a range of a recording, block by block, so that other requests get their turn in between.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "map/problem.h"
#include "recording/source.h"
#include "robot/bag_library.h"
#include "robot/recorded/block_placing.h"
#include "robot/recorded/kept_things.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::recorded {

/// One thread, that of the file. Stamps are log times. The text of a message is one JSON object
/// (MessageText).
class RangeJob {
 public:
  struct Parts : PlacingParts {
    const KeptThings& kept;
  };
  RangeJob(BagKey key, BagRange range);

  enum class Step { More, Done, TooLong };
  /// The next block that contains a message, or a part of what comes before it.
  Step step(const Parts& parts);
  /// Once Done. `untimed`: number of messages without a valid time, to report with it.
  BagChunkPtr chunk(std::size_t untimed);
  /// Problems with messages, and recoveries.
  std::vector<map::Problem> releaseProblems() { return std::exchange(problems_, {}); }
  const BagKey& key() const { return key_; }
  const BagRange& range() const { return range_; }

 private:
  /// The last messages before the range, each as it is when played.
  void findLast(const Parts& parts);
  void finishLast(const Parts& parts);
  /// The next block with messages that overlaps the range.
  std::optional<std::int64_t> nextBlock(const Parts& parts) const;
  /// Whether what still counts at the beginning of a block is known; otherwise goes on to find out.
  static bool knowsEarlier(const Parts& parts, std::int64_t block_ns);
  bool takes(double stamp_s) const {
    return adding_last_ ? stamp_s < range_.from_s : stamp_s >= range_.from_s && stamp_s < range_.until_s;
  }
  void onMessage(const Parts& parts, const recording::Message& message, BlockPlacing* placing);
  void onFrame(const Parts& parts, const wire::Json& root, const recording::Message& message,
               BagMessage& told);
  void add(BagMessage told, std::string_view text);
  /// Messages of the same time come in any order: their combined result is the robot's pose.
  void keepLastPose();
  void addResults(ros::WorldResults results, BagMessage* told);
  /// Only its bytes are there: for programs that is a loss, for people to be known.
  void reportUndecoded(const std::string& topic, Fault reason);
  void addProblem(const std::string& topic, map::ProblemCode code, Fault reason,
                  map::Severity severity = map::Severity::Warning);

  BagKey key_;
  BagRange range_;
  std::int64_t next_ns_, last_ns_;  // widened: stamps are rounded
  std::shared_ptr<BagChunk> chunk_ = std::make_shared<BagChunk>();
  std::string text_;
  std::size_t bytes_ = 0;                                // of the messages in the file and of the results
  std::optional<std::vector<recording::Message>> last_;  // to be added, latest first; nullopt: not found
  bool adding_last_ = false;
  std::optional<std::size_t> last_pose_;  // in the chunk: the last message with the robot's pose
  std::vector<map::Problem> problems_;
  wire::JsonReader json_;
};

}  // namespace mapwright::robot::recorded
