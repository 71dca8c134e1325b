#include "grids/picture_rows.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "disk/read_file.h"
#include "grids/faults.h"
#include "words/figures.h"

namespace mapwright::grids {

std::optional<Fault> notThisSizeReason(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) {
    return Fault{faultText("grids", "Its header says %1 pixels: it is empty."),
                 {words::dimensions(std::int64_t(width), std::int64_t(height))}};
  }
  if (width > kMaxGridEdge || height > kMaxGridEdge || width * height > std::uint64_t(kMaxGridCells)) {
    return Fault{fault::PictureTooLarge,
                 {words::dimensions(std::int64_t(width), std::int64_t(height)), words::grouped(kMaxGridEdge),
                  words::grouped(kMaxGridCells)}};
  }
  return std::nullopt;
}

tl::expected<std::unique_ptr<PictureRows>, Fault> openPicture(ByteSource bytes) {
  static constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  std::array<std::uint8_t, 60> start{};
  const std::size_t there = std::size_t(std::min<std::uint64_t>(start.size(), bytes.size()));
  if (there == 0) return tl::unexpected(Fault(fault::PictureEmpty));
  if (!bytes.readAt(0, start.data(), there))
    return tl::unexpected(Fault(faultText("grids", "It cannot be read.")));
  if (std::memcmp(start.data(), kPng.data(), kPng.size()) == 0) return openPng(std::move(bytes));
  if (start[0] == 'P' && (start[1] == '2' || start[1] == '5')) return openPgm(std::move(bytes));
  if (start[0] == 'B' && start[1] == 'M') return openBmp(std::move(bytes));
  if (there < kPng.size() && std::memcmp(start.data(), kPng.data(), there) == 0) {
    return tl::unexpected(Fault(fault::PngHeaderShort));
  }
  const std::string_view text(reinterpret_cast<const char*>(start.data()), there);
  return tl::unexpected(Fault(
      disk::isGitLfsPointer(text)
          ? faultText("grids",
                      "It is a pointer of Git LFS, not the picture itself (git lfs pull fetches it).")
          : faultText("grids", "It is not a picture format that can be read as a map: PNG, PGM or BMP.")));
}

}  // namespace mapwright::grids
