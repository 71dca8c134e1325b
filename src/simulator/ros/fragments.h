// Splits long texts like rosbridge servers do.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// The text itself if it has at most `size` characters or `size` is 0; otherwise {"op":"fragment"} messages
/// of `size` characters each. Their id is that of the message, 0 if it has none; their total is a fraction.
std::vector<std::string> fragmentsOf(std::string text, std::size_t size, const Value& id, RosWriter writer);

/// Joins fragments sent by a client ({"op":"fragment","id","num","total","data"}, rosbridge v2), like the
/// servers do: by id, in any order.
class FragmentShelf {
 public:
  /// The whole text after its last fragment. `complaint`: why a fragment was ignored.
  std::optional<std::string> take(const Value& piece, std::string& complaint);

 private:
  struct Message {
    std::size_t total = 0, bytes = 0;
    std::map<std::size_t, std::string> pieces;
  };
  std::map<std::string, Message> messages_;
};

}  // namespace mapwright::simulator::ros
