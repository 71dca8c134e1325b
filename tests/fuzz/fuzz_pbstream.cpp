// Cartographer's state files. Bit 0 of the first byte: the rest is the file as it is; otherwise records, each
// after its length, which are packed here: hardly any change of packed bytes unpacks to something else.
#include "packed/codec.h"
#include "pbstream/state_file.h"
#include "pbstream/submap_texture.h"
#include "scratch.h"
#include "target.h"

namespace mapwright::fuzz::pbstream {
namespace {

using namespace mapwright::pbstream;

std::string fileOf(Choices records) {
  std::string file("\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", 8);
  while (!records.rest().empty()) {
    const auto packed = packed::packGzip(records.bytes(records.twoBytes()));
    for (int shift = 0; shift < 64; shift += 8) file.push_back(char(std::uint64_t(packed.size) >> shift));
    file += textOf(packed.bytes());
  }
  return file;
}

void read(Input input) {
  static const ScratchFolder folder;
  Choices from(input);
  const bool as_it_is = (from.byte() & 1) != 0;
  const std::string bytes = as_it_is ? textOf(from.rest()) : fileOf(from);
  const std::string path =
      folder.write("state.pbstream", {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  const auto state = readStateFile(path);
  if (!state) return;
  MUST(state->graph && state->file);
  use(state->losses());
  int left = 8;
  for (const StoredSubmap& submap : state->submaps) {
    MUST(state->find(submap.id));
    if (left-- <= 0) break;
    const geometry::Pose3* const pose = state->poseOf(submap.id);
    use(readTextures(*state->file, submap, pose != nullptr ? *pose : geometry::Pose3{}));
  }
}

}  // namespace
}  // namespace mapwright::fuzz::pbstream

MAPWRIGHT_FUZZ_TARGET(pbstream)
