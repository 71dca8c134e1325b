#include "robot/axbot/parse_clouds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "robot/axbot/faults.h"
#include "robot/wire/faults.h"
#include "robot/wire/packed_number.h"
#include "robot/wire/picture_bytes.h"
#include "ros_messages/wrapper.pb.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

constexpr std::size_t kMaxCloudBytes = std::size_t(128) << 20;

double plainNumber(const Json& value) {
  double number = 0;
  if (!value.get(number)) return number;
  return wire::asNumber(value).value_or(std::nan(""));
}

map::TopicMessage listedPoints(const std::string& topic, const wire::JsonList& rows) {
  CloudPoints cloud;
  cloud.reserve(rows.size());
  for (const Json row : rows) {
    if (cloud.full()) break;
    wire::JsonList numbers;
    if (row.get(numbers)) {
      if (const auto at = wire::asPoint(row)) {
        cloud.add(at->x(), at->y(), wire::number(row, {"z"}).value_or(0), 0);
      }
      continue;
    }
    double values[4] = {std::nan(""), std::nan(""), 0, 0};
    std::size_t count = 0;
    for (const Json value : numbers) {
      if (count == 4) break;
      values[count++] = plainNumber(value);
    }
    cloud.add(values[0], values[1], values[2], values[3]);
  }
  return cloud.message(topic);
}

struct Field {
  std::string name;  // in lower case
  wire::PackedNumber number;
};

/// The robot's names, and the numbers and names of ROS PointField.
std::optional<wire::NumberType> fieldType(std::string text) {
  constexpr std::array<std::array<std::string_view, 3>, 8> kNames{{{"i8", "int8", "1"},
                                                                   {"u8", "uint8", "2"},
                                                                   {"i16", "int16", "3"},
                                                                   {"u16", "uint16", "4"},
                                                                   {"i32", "int32", "5"},
                                                                   {"u32", "uint32", "6"},
                                                                   {"f32", "float32", "7"},
                                                                   {"f64", "float64", "8"}}};
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (std::find(kNames[i].begin(), kNames[i].end(), text) != kNames[i].end())
      return wire::NumberType(i + 1);
  }
  return std::nullopt;
}

struct Layout {
  std::vector<Field> fields;
  std::size_t record = 0;  // bytes
  const Field* find(std::string_view name) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
    return found == fields.end() ? nullptr : &*found;
  }
  const Field* brightness() const {
    const Field* intensity = find("intensity");
    return intensity ? intensity : find("probability");
  }
};

/// nullopt if a type is unknown (the record length is then unknown, too) or there is no x or y.
std::optional<Layout> layoutOf(const wire::JsonList& fields) {
  Layout layout;
  for (const Json row : fields) {
    const auto type = fieldType(wire::text(row, {"data_type", "datatype", "type"}));
    if (!type) return std::nullopt;
    std::string name = wire::text(row, {"name"});
    for (char& c : name) c = char(std::tolower(static_cast<unsigned char>(c)));
    layout.fields.push_back({std::move(name), {*type, layout.record}});
    layout.record += wire::bytesOf(*type);
  }
  return layout.find("x") && layout.find("y") ? std::optional(std::move(layout)) : std::nullopt;
}

map::TopicMessage unreadable(const std::string& topic, Fault why,
                             Consequence then = Consequence::TheyWereLeftOut) {
  return map::UnreadableMessage{topic, std::move(why).followedBy(then)};
}

map::TopicMessage packedPoints(const std::string& topic, const Layout& layout, std::string_view base64) {
  const auto bytes = wire::fromBase64(base64, kMaxCloudBytes);
  if (!bytes) return unreadable(topic, faultText("axbot", "Its points are not valid base64, or too many."));
  const Field *x = layout.find("x"), *y = layout.find("y"), *z = layout.find("z");
  const Field* bright = layout.brightness();
  CloudPoints cloud;
  cloud.reserve(bytes->size() / layout.record);
  for (std::size_t at = 0; at + layout.record <= bytes->size() && !cloud.full(); at += layout.record) {
    const char* record = bytes->data() + at;
    cloud.add(wire::numberAt(record, x->number), wire::numberAt(record, y->number),
              z ? wire::numberAt(record, z->number) : 0, bright ? wire::numberAt(record, bright->number) : 0);
  }
  return cloud.message(topic, bright && wire::isByte(bright->number.type));
}

/// The same fields, with records as lists of numbers.
map::TopicMessage tabledPoints(const std::string& topic, const Layout& layout, const wire::JsonList& rows) {
  const auto column = [&](const Field* field) { return field ? field - layout.fields.data() : -1; };
  const auto x = column(layout.find("x")), y = column(layout.find("y")), z = column(layout.find("z"));
  const auto bright = column(layout.brightness());
  CloudPoints cloud;
  cloud.reserve(rows.size());
  for (const Json row : rows) {
    wire::JsonList numbers;
    if (cloud.full() || row.get(numbers)) continue;
    double point[4] = {std::nan(""), std::nan(""), 0, 0};
    std::ptrdiff_t at = 0;
    for (const Json value : numbers) {
      if (at == x) point[0] = plainNumber(value);
      if (at == y) point[1] = plainNumber(value);
      if (at == z) point[2] = plainNumber(value);
      if (at == bright) point[3] = plainNumber(value);
      ++at;
    }
    cloud.add(point[0], point[1], point[2], point[3]);
  }
  return cloud.message(topic, layout.brightness() && wire::isByte(layout.brightness()->number.type));
}

}  // namespace

// Other topics have points of other frames or kinds: those are not clouds of the map.
bool isCloudTopic(const std::string& topic) {
  return topic == "/scan_matched_points2" || topic == "/semantic_points" ||
         topic.starts_with("/matched_depth_points/") || topic.ends_with("_laser_2d/matched");
}

map::TopicMessage readCloud(const std::string& topic, const Json& message) {
  if (const auto rows = wire::list(message, {"points"})) return listedPoints(topic, *rows);
  if (const auto fields = wire::list(message, {"fields"})) {
    const auto data = wire::member(message, {"data", "points"});
    const auto layout = layoutOf(*fields);
    if (data && layout) {
      std::string_view base64;
      if (!data->get(base64)) return packedPoints(topic, *layout, base64);
      wire::JsonList rows;
      if (!data->get(rows)) return tabledPoints(topic, *layout, rows);
    }
    return unreadable(topic, robot::wire::fault::PointsWithoutFields, Consequence::ItsPointsWereLeftOut);
  }
  return unreadable(topic, faultText("axbot", "It contains no readable points."));
}

map::TopicMessage readCloud(const std::string& topic, const ros_messages::PointCloud& message) {
  // On the wire, a resolution of 0 means "not given".
  const double resolution = message.resolution() == 0 ? 1 : double(message.resolution());
  if (!std::isfinite(resolution) || !std::isfinite(message.center_x()) ||
      !std::isfinite(message.center_y())) {
    return unreadable(topic, faultText("axbot", "Its points have no valid scale or centre."));
  }
  const int count = std::min(message.xs_size(), message.ys_size());
  const std::string& brightness =
      message.intensities().empty() ? message.probabilities() : message.intensities();
  CloudPoints cloud;
  cloud.reserve(std::size_t(count));
  const bool delta = message.is_delta_encoded();
  std::int64_t x = 0, y = 0, z = 0;
  for (int i = 0; i < count && !cloud.full(); ++i) {
    x = message.xs(i) + (delta ? x : 0);
    y = message.ys(i) + (delta ? y : 0);
    const bool has_z = i < message.zs_size();
    if (has_z) z = message.zs(i) + (delta ? z : 0);
    const std::size_t at = std::size_t(i);
    cloud.add(message.center_x() + double(x) * resolution, message.center_y() + double(y) * resolution,
              has_z ? message.center_z() + double(z) * resolution : 0,
              at < brightness.size() ? double(std::uint8_t(brightness[at])) : 0);
  }
  return cloud.message(topic, true);
}

}  // namespace mapwright::robot::axbot
