#include "simulator/map_upload.h"

#include <cmath>
#include <limits>

#include <spng.h>

#include "simulator/map_overlays.h"
#include "simulator/png_writing.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

constexpr std::uint32_t kLongestEdge = 20'000;
constexpr double kMostPixels = 32e6;
constexpr std::uint8_t kUnknown = 128;

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

/// The picture's gray levels; nullopt when it cannot be read, or is too large for this robot.
std::optional<GrayPicture> decoded(const std::string& png) {
  const Context context(spng_ctx_new(0), &spng_ctx_free);
  spng_ihdr header{};
  if (!context || spng_set_image_limits(context.get(), kLongestEdge, kLongestEdge) != 0 ||
      spng_set_png_buffer(context.get(), png.data(), png.size()) != 0 ||
      spng_get_ihdr(context.get(), &header) != 0 || double(header.width) * header.height > kMostPixels)
    return std::nullopt;
  std::size_t size = 0;
  if (spng_decoded_image_size(context.get(), SPNG_FMT_RGBA8, &size) != 0) return std::nullopt;
  std::vector<std::uint8_t> rgba(size);
  if (spng_decode_image(context.get(), rgba.data(), size, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS) != 0)
    return std::nullopt;
  GrayPicture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  picture.levels.reserve(size / 4);
  for (std::size_t i = 0; i + 3 < size; i += 4) {
    const int gray = (299 * rgba[i] + 587 * rgba[i + 1] + 114 * rgba[i + 2] + 500) / 1000;
    picture.levels.push_back(rgba[i + 3] < 128 ? kUnknown : static_cast<std::uint8_t>(gray));
  }
  return picture;
}

/// nullopt for what is no base64. White space is skipped, a data-URL prefix too.
std::optional<std::string> fromUploadedBase64(std::string text) {
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return std::nullopt;
    text.erase(0, comma + 1);
  }
  std::erase_if(text, [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\t'; });
  // Padding may be left out, but not be wrong.
  const std::size_t digits = text.find_last_not_of('=') + 1, padding = text.size() - digits;
  if (padding > 2 || (padding > 0 && text.size() % 4 != 0)) return std::nullopt;
  return fromBase64(text);
}

/// Bytes of a form's part, or base64 of either kind of request.
std::optional<std::string> bytesOf(const RequestFields& fields, std::string_view key,
                                   std::string_view magic) {
  std::optional<std::string> text = fields.text(key);
  if (!text || (!magic.empty() && text->starts_with(magic))) return text;
  return fromUploadedBase64(std::move(*text));
}

/// A number that a version can be.
std::optional<int> versionOf(const RequestFields& fields, std::string_view key) {
  if (!fields.has(key)) return 1;
  const std::optional<std::int64_t> number = fields.integer(key);
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max() / 2) return std::nullopt;
  return static_cast<int>(*number);
}

MapPicturePtr placed(const GrayPicture& picture, std::string png, double resolution_m,
                     const Eigen::Vector2d& origin_m) {
  MapPicture made;
  made.width = picture.width;
  made.height = picture.height;
  made.resolution_m = resolution_m;
  made.origin_m = origin_m;
  made.hash = contentHash(png);
  made.png = std::make_shared<const std::string>(std::move(png));
  return std::make_shared<const MapPicture>(std::move(made));
}

}  // namespace

tl::expected<StoredMap, std::string> readMapUpload(const RequestFields& fields) {
  const auto fail = [](std::string sentence) { return tl::make_unexpected(std::move(sentence)); };
  for (const char* key : {"data_url", "occupancy_grid_filename", "carto_map_filename"}) {
    if (fields.has(key)) return fail(std::string(key) + ": there is no such file on this robot.");
  }
  for (const char* key :
       {"map_name", "carto_map", "occupancy_grid", "grid_origin_x", "grid_origin_y", "grid_resolution"}) {
    if (!fields.has(key)) return fail(std::string(key) + ": this field is required.");
  }
  StoredMap map;
  const std::optional<std::string> name = fields.text("map_name");
  if (!name || name->empty() || name->size() > kLongestMapName)
    return fail("map_name: must be a text of 1 to 255 bytes.");
  map.name = *name;
  const std::optional<double> x = fields.number("grid_origin_x"), y = fields.number("grid_origin_y"),
                              resolution = fields.number("grid_resolution");
  if (!x || !y || !resolution) return fail("grid_origin_x, grid_origin_y, grid_resolution: must be numbers.");
  if (*resolution <= 0 || *resolution > 10) return fail("grid_resolution: must lie between 0 and 10 metres.");
  std::optional<std::string> carto_map = bytesOf(fields, "carto_map", {});
  if (!carto_map) return fail("carto_map: is no base64.");
  map.carto_map = std::make_shared<const std::string>(std::move(*carto_map));
  std::optional<std::string> png = bytesOf(fields, "occupancy_grid", "\x89PNG");
  if (!png) return fail("occupancy_grid: is no base64.");
  const std::optional<GrayPicture> gray = decoded(*png);
  if (!gray) return fail("occupancy_grid: is no PNG of at most 32 million pixels.");
  const Eigen::Vector2d origin(*x, *y);
  map.picture = placed(*gray, std::move(*png), *resolution, origin);
  const GrayPicture small = thumbnailOf(*gray, kUnknown);
  map.thumbnail = placed(small, writePng(small, 8), *resolution * gray->width / small.width, origin);
  const std::optional<int> version = versionOf(fields, "map_version"),
                           overlays_version = versionOf(fields, "overlays_version");
  if (!version || !overlays_version) return fail("map_version, overlays_version: must be whole numbers.");
  map.map_version = *version;
  map.overlays_version = *overlays_version;
  if (fields.has("uid")) {
    const std::optional<std::string> uid = fields.text("uid");
    if (!uid || uid->empty() || uid->size() > kLongestMapName)
      return fail("uid: must be a text of 1 to 255 bytes.");
    map.uid = *uid;
  }
  const std::string overlays = fields.has("overlays") ? fields.text("overlays").value_or("*") : noOverlays();
  if (!isOverlays(overlays)) return fail("overlays: must be the text of a GeoJSON FeatureCollection.");
  map.overlays = std::make_shared<const std::string>(overlays);
  return map;
}

}  // namespace mapwright::simulator
