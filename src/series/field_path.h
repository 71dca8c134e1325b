// Identifies a number in the messages of a topic: "/tracked_pose.pos[0]", "/battery_state.percentage".
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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

}  // namespace mapwright::series
