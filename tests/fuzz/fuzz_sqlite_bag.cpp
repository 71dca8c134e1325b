// Databases of rosbag2 (SQLite).
#include <algorithm>

#include "recording_reads.h"
#include "scratch.h"
#include "target.h"

namespace mapwright::fuzz::sqlite_bag {
namespace {

void read(Input input) {
  static const ScratchFolder folder;
  const auto opened = mapwright::recording::openRecording(folder.write("bag_0.db3", input), smallLimits());
  if (opened) readSource(**opened);
}

}  // namespace
}  // namespace mapwright::fuzz::sqlite_bag

MAPWRIGHT_FUZZ_TARGET(sqlite_bag)
