// Frames that are not valid messages.
#pragma once

#include <cstddef>
#include <string>

namespace mapwright::simulator::ros {

struct Garbage {
  std::string bytes;
  bool binary = false;
};

/// The `number`th of a repeating sequence.
Garbage garbageOf(std::size_t number);

}  // namespace mapwright::simulator::ros
