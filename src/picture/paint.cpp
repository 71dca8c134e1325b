#include "picture/paint.h"

namespace mapwright::picture {

namespace {
constexpr std::uint8_t kFreeGray = 255, kOccupiedGray = 0, kFreePercent = 0, kOccupiedPercent = 100;
constexpr int kOccupiedFrom = 50;
}  // namespace

std::array<Kind, 256> kindsOf(grids::CellCode code) {
  const grids::CellMeaning& meaning = grids::meaningOf(code);
  std::array<Kind, 256> kinds{};
  for (std::size_t byte = 0; byte < kinds.size(); ++byte) {
    kinds[byte] = !meaning.known[byte]                       ? Kind::Unknown
                  : meaning.occupancy[byte] >= kOccupiedFrom ? Kind::Occupied
                                                             : Kind::Free;
  }
  return kinds;
}

std::optional<std::uint8_t> byteOf(Kind kind, grids::CellCode code) {
  switch (kind) {
    case Kind::Free:
      return grids::isGray(code) ? kFreeGray : kFreePercent;
    case Kind::Occupied:
      return grids::isGray(code) ? kOccupiedGray : kOccupiedPercent;
    case Kind::Unknown:
      break;
  }
  if (code == grids::CellCode::FullGray) return std::nullopt;
  return grids::unknownByte(code);
}

}  // namespace mapwright::picture
