#include "recording/source.h"

#include <algorithm>
#include <array>

#include "recording/mcap_reader.h"
#include "recording/ros1_bag.h"

namespace mapwright::recording {

Opened openRecording(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, 16> start{};
  const auto there =
      std::span(start).first(std::size_t(std::min<std::uint64_t>(start.size(), bytes->size())));
  if (bytes->read(there, 0)) {
    if (looksLikeMcap(there)) return McapReader::open(std::move(bytes), limits);
    if (looksLikeBag(there)) return Ros1Bag::open(std::move(bytes), limits);
  }
  return tl::unexpected(Failure{Failure::Code::NotOne, {}});
}

Opened openRecording(const std::string& path, const Limits& limits) {
  auto bytes = fileBytes(path);
  if (!bytes) return tl::unexpected(Failure{Failure::Code::File, std::move(bytes.error())});
  return openRecording(std::move(*bytes), limits);
}

}  // namespace mapwright::recording
