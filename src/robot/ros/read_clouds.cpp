// Scans and clouds of points. Source: sensor_msgs/LaserScan, PointCloud2, PointField.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostRays = 10'000'000;
constexpr std::size_t kMostCloudBytes = std::size_t(256) << 20;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void noteThinned(Points& points, std::size_t came) {
  if (came <= kMostPoints) return;
  points.notes.push_back(
      {map::ReasonCode::RosPointsThinned, {std::int64_t(came), std::int64_t(strideFor(came, kMostPoints))}});
}

/// A number inside a record. The numbers are those of PointField.
enum class Type : std::uint8_t { I8 = 1, U8, I16, U16, I32, U32, F32, F64 };
constexpr std::array<std::size_t, 9> kTypeBytes{0, 1, 1, 2, 2, 4, 4, 4, 8};

struct Place {
  Type type = Type::F32;
  std::size_t offset = 0;
};

template <typename T>
double valueAt(const char* at, bool big_endian) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), at, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  return double(std::bit_cast<T>(raw));
}

double valueOf(const char* record, const Place& place, bool big_endian) {
  const char* const at = record + place.offset;
  switch (place.type) {
    case Type::I8:
      return valueAt<std::int8_t>(at, big_endian);
    case Type::U8:
      return valueAt<std::uint8_t>(at, big_endian);
    case Type::I16:
      return valueAt<std::int16_t>(at, big_endian);
    case Type::U16:
      return valueAt<std::uint16_t>(at, big_endian);
    case Type::I32:
      return valueAt<std::int32_t>(at, big_endian);
    case Type::U32:
      return valueAt<std::uint32_t>(at, big_endian);
    case Type::F32:
      return valueAt<float>(at, big_endian);
    case Type::F64:
      break;
  }
  return valueAt<double>(at, big_endian);
}

struct Layout {
  std::optional<Place> x, y, z, intensity;
  std::size_t width = 0, height = 0, point_step = 0, row_step = 0;
  bool big_endian = false;
};

Read<Layout> readLayout(const Field& msg) {
  // More would not fit into the data; products of two of them are numbers still.
  constexpr std::int64_t kMost = std::int64_t(kMostCloudBytes);
  Layout layout;
  const auto take = [&](const char* name, std::size_t& to) -> std::optional<map::Reason> {
    const auto value = msg[name].integer();
    if (!value) return fieldMissing(name).value();
    if (*value < 0 || *value > kMost) return fieldWrong(name, double(*value)).value();
    to = std::size_t(*value);
    return std::nullopt;
  };
  for (const auto& why :
       {take("width", layout.width), take("height", layout.height), take("point_step", layout.point_step)}) {
    if (why) return tl::unexpected(*why);
  }
  if (layout.point_step == 0) return fieldWrong("point_step", 0);
  const auto row_step = msg["row_step"].integer();
  const std::size_t packed = layout.width * layout.point_step;
  // Senders of clouds in one row often leave it out.
  layout.row_step = row_step && *row_step > 0 ? std::size_t(*row_step) : packed;
  if (layout.height > 1 && layout.row_step < packed) return fieldWrong("row_step", double(layout.row_step));
  layout.big_endian = msg["is_bigendian"].flag().value_or(false);

  const Field fields = msg["fields"];
  if (!fields.isList()) return fieldMissing("fields");
  fields.each([&layout](const Field& row) {
    const std::string name = row["name"].text();
    const auto type = row["datatype"].integer(), offset = row["offset"].integer();
    const auto lies_in = [&] {
      if (!type || *type < 1 || *type > 8 || !offset || *offset < 0) return false;
      const std::size_t bytes = kTypeBytes[std::size_t(*type)];
      return bytes <= layout.point_step && std::size_t(*offset) <= layout.point_step - bytes;
    };
    std::optional<Place>* const wanted = name == "x"           ? &layout.x
                                         : name == "y"         ? &layout.y
                                         : name == "z"         ? &layout.z
                                         : name == "intensity" ? &layout.intensity
                                                               : nullptr;
    if (wanted && lies_in()) *wanted = Place{Type(*type), std::size_t(*offset)};
  });
  if (!layout.x || !layout.y) return tl::unexpected(map::Reason(map::ReasonCode::PointsWithoutFields));
  return layout;
}

}  // namespace

Read<Points> readLaserScan(const Field& msg) {
  const double angle_min = numberOr(msg["angle_min"], kNaN);
  const double angle_step = numberOr(msg["angle_increment"], kNaN);
  if (!std::isfinite(angle_min)) return fieldMissing("angle_min");
  if (!std::isfinite(angle_step)) return fieldMissing("angle_increment");
  const Field list = msg["ranges"];
  const auto ranges = list.numbers(kMostRays);
  if (!ranges) return fieldMissing("ranges");
  const double nearest = numberOr(msg["range_min"], 0), farthest_said = numberOr(msg["range_max"], 0);
  const double farthest = farthest_said > nearest ? farthest_said : std::numeric_limits<double>::infinity();
  auto intensities = msg["intensities"].numbers(kMostRays);
  if (intensities && intensities->size() != ranges->size()) intensities.reset();

  const std::size_t stride = std::max<std::size_t>(1, strideFor(ranges->size(), kMostPoints));
  PointList points;
  points.reserve(ranges->size() / stride + 1);
  for (std::size_t i = 0; i < ranges->size(); i += stride) {
    const double range = (*ranges)[i], angle = angle_min + double(i) * angle_step;
    if (range >= nearest && range <= farthest) {
      points.add(range * std::cos(angle), range * std::sin(angle), 0, intensities ? (*intensities)[i] : 0);
    } else {
      points.leaveOut();
    }
  }
  Points read = std::move(points).points(headerOf(msg), false);
  noteThinned(read, ranges->size());
  return read;
}

Read<Points> readPointCloud2(const Field& msg) {
  const auto layout = readLayout(msg);
  if (!layout) return tl::unexpected(layout.error());
  const Layout& of = *layout;
  const auto data = msg["data"].bytes(kMostCloudBytes);
  if (!data) return fieldMissing("data");
  const std::size_t count = of.width * of.height;
  if (count > 0) {
    // By division: the numbers of a message may be chosen so that their product is small again.
    const std::size_t last_row = of.width * of.point_step;
    const bool rows_fit =
        last_row <= data->size() && of.height - 1 <= (data->size() - last_row) / of.row_step;
    if (!rows_fit) {
      return tl::unexpected(map::Reason(
          map::ReasonCode::RosLengthDiffers,
          {"data", std::int64_t(data->size()),
           std::int64_t(std::min(double(of.height - 1) * double(of.row_step) + double(last_row), 9e18))}));
    }
  }
  const std::size_t stride = std::max<std::size_t>(1, strideFor(count, kMostPoints));
  PointList points;
  points.reserve(count / stride + 1);
  const auto value = [&](const char* record, const std::optional<Place>& place) {
    return place ? valueOf(record, *place, of.big_endian) : 0;
  };
  for (std::size_t i = 0; i < count; i += stride) {
    const char* const record = data->data() + i / of.width * of.row_step + i % of.width * of.point_step;
    points.add(value(record, of.x), value(record, of.y), value(record, of.z), value(record, of.intensity));
  }
  const bool bytes = of.intensity && (of.intensity->type == Type::U8 || of.intensity->type == Type::I8);
  Points read = std::move(points).points(headerOf(msg), bytes);
  noteThinned(read, count);
  return read;
}

}  // namespace mapwright::robot::ros
