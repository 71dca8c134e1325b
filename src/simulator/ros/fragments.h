// Long texts in pieces, as rosbridge servers cut them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulator/ros/ros_options.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

/// The text itself when it has no more than `size` characters or `size` is 0; else {"op":"fragment"} messages
/// of `size` characters each. Their id is that of the message, 0 for those without one; their total is a
/// fraction.
std::vector<std::string> fragmentsOf(std::string text, std::size_t size, const Value& id, RosWriter writer);

/// What a client sends in pieces ({"op":"fragment","id","num","total","data"}, rosbridge v2), as the servers
/// join it: by id, whatever order it comes in.
class FragmentShelf {
 public:
  /// The whole text, once its last piece has come. `complaint`: why a piece was left out.
  std::optional<std::string> take(const Value& piece, std::string& complaint);

 private:
  struct Message {
    std::size_t total = 0, bytes = 0;
    std::map<std::size_t, std::string> pieces;
  };
  std::map<std::string, Message> messages_;
};

}  // namespace mapwright::simulator::ros
