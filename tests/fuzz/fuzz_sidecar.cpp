// Side-car files of large maps. The checksums of the header and of the index are set here, as a change of
// either would be all that is found otherwise.
#include <cstring>

#include "grids/sidecar.h"
#include "packed/codec.h"
#include "scratch.h"
#include "target.h"

namespace mapwright::fuzz::sidecar {
namespace {

using namespace grids;

constexpr std::size_t kHeaderBytes = 64, kDataAt = 4096;

void mend(std::string& file) {
  if (file.size() < kDataAt) return;
  const auto bytesOf = [&](std::size_t at, std::size_t count) {
    return Input(reinterpret_cast<const std::uint8_t*>(file.data()) + at, count);
  };
  std::uint64_t data_bytes = 0;
  std::memcpy(&data_bytes, file.data() + 32, sizeof(data_bytes));
  if (data_bytes <= file.size() - kDataAt) {
    const std::size_t tail = kDataAt + std::size_t(data_bytes);
    const std::uint32_t sum = packed::crc32(0, bytesOf(tail, file.size() - tail));
    std::memcpy(file.data() + 56, &sum, sizeof(sum));
  }
  const std::uint32_t sum = packed::crc32(0, bytesOf(0, kHeaderBytes - 4));
  std::memcpy(file.data() + 60, &sum, sizeof(sum));
}

void read(Input input) {
  static const ScratchFolder folder;
  GridOptions options;
  options.sidecar_folder = folder.path();
  options.fingerprint = "a";
  const SidecarKey key(options, 300, 260);
  std::string file = textOf(input);
  mend(file);
  ScratchFolder::writeTo(key.path(), {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()});
  const auto pyramid = openSidecar(key);
  if (!pyramid) return;
  for (int level = 0; level < pyramid->levels(); ++level) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        const auto tile = pyramid->tile(level, x, y);
        if (tile) use(tile->cells.get()[256 * 256 - 1]);
      }
    }
  }
  use(pyramid->at(299, 259));
  use(pyramid->trouble());
}

}  // namespace
}  // namespace mapwright::fuzz::sidecar

MAPWRIGHT_FUZZ_TARGET(sidecar)
