// Numbers in messages: fields of their JSON, found by their path ("/tracked_pose.pos[0]",
// "/battery_state.percentage"), and quantities of every kind of robot, independent of topic names. Pure.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "map/live_topics.h"

namespace mapwright::series {

struct FieldPath {
  using Step = std::variant<std::string, std::size_t>;  // a member of an object, an element of an array
  static constexpr std::size_t kLongest = 1000, kMostSteps = 32;

  std::string topic;  // untrusted, as the robot names it
  std::vector<Step> steps;

  /// Topic, then ".member", "[3]" or, for members with unusual names, ["odd.name"] (as in JSON, with \" and
  /// \\). A topic that contains a dot, bracket, blank or quote is itself quoted. nullopt: invalid, or only a
  /// topic.
  static std::optional<FieldPath> parse(std::string_view text);
  /// parse() reads it back.
  std::string text() const;
  /// Without the topic: "pos[0]".
  std::string textOfSteps() const;

  auto operator<=>(const FieldPath&) const = default;
};

/// Reads the wanted fields of messages, parsing each message once. One thread at a time.
class FieldReader {
 public:
  explicit FieldReader(std::vector<FieldPath> paths);
  ~FieldReader();
  FieldReader(FieldReader&&) noexcept;

  const std::vector<FieldPath>& paths() const { return paths_; }
  bool wants(std::string_view topic) const;
  /// By index of the path: its value in this message. Booleans are 0 and 1, numbers may be strings; null,
  /// infinite and "nan" are NaN. nullopt: of another topic, missing, not a number, or the message is not
  /// JSON. Valid until the next call.
  const std::vector<std::optional<double>>& read(std::string_view topic, std::string_view json);

 private:
  struct Parsing;
  std::vector<FieldPath> paths_;
  std::vector<std::optional<double>> values_;
  std::unique_ptr<Parsing> parsing_;
};

/// The fields of a message with numbers or booleans, in order: the first few of long arrays, at most `most`
/// in all, and not too deep. Empty: it is not a JSON object.
std::vector<FieldPath> numericFields(const std::string& topic, std::string_view json, std::size_t most = 300);

enum class Quantity {
  X,                // metres
  Y,                // metres
  Yaw,              // degrees, -180..180
  Speed,            // metres per second, from the poses (speeds())
  PositionQuality,  // 0 unknown, 1 lost, 3 poor, 8 good, 10 excellent
  MatchingScore,    // of the lidar, as reported by the robot
  Battery,          // percent
};
inline constexpr std::array kQuantities{Quantity::X,
                                        Quantity::Y,
                                        Quantity::Yaw,
                                        Quantity::Speed,
                                        Quantity::PositionQuality,
                                        Quantity::MatchingScore,
                                        Quantity::Battery};

/// The value in this message; nullopt = none. For Speed no single message has a value.
std::optional<double> valueOf(Quantity quantity, const map::TopicMessage& message);
std::optional<double> valueOf(Quantity quantity, const geometry::Pose2& pose);
/// It is derived from poses.
bool isOfPose(Quantity quantity);
/// It keeps its value until the next message: drawn in steps.
bool isStepped(Quantity quantity);

}  // namespace mapwright::series
