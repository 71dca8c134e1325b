// Frames that are no messages, or none that anybody could mean.
#pragma once

#include <cstddef>
#include <string>

namespace mapwright::simulator::ros {

struct Garbage {
  std::string bytes;
  bool binary = false;
};

/// The `number`th of a round that comes again.
Garbage garbageOf(std::size_t number);

}  // namespace mapwright::simulator::ros
