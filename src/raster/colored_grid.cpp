#include "raster/grid_pyramid.h"

namespace mapwright::raster {

tl::expected<ColoredGrid, GridError> decodeColors(std::shared_ptr<const std::string>, std::int64_t) {
  return tl::unexpected(GridError{"Pictures in colours are not read yet."});
}

}  // namespace mapwright::raster
