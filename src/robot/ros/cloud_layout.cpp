#include "robot/ros/cloud_layout.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "robot/ros/faults.h"
#include "robot/ros/parts.h"
#include "robot/wire/faults.h"

namespace mapwright::robot::ros {

Read<CloudLayout> readCloudLayout(const Field& msg, std::size_t most_bytes) {
  // More would not fit into the data; products of two of them do not overflow.
  const auto most = std::int64_t(most_bytes);
  CloudLayout layout;
  const auto take = [&](const char* name, std::size_t& to) -> std::optional<Fault> {
    const auto value = msg[name].integer();
    if (!value) return fieldMissing(name).value();
    if (*value < 0 || *value > most) return fieldWrong(name, double(*value)).value();
    to = std::size_t(*value);
    return std::nullopt;
  };
  for (const auto& why :
       {take("width", layout.width), take("height", layout.height), take("point_step", layout.point_step)}) {
    if (why) return tl::unexpected(*why);
  }
  // Without points the layout does not matter: many senders omit it then.
  if (layout.width == 0 || layout.height == 0) return layout;
  if (layout.point_step == 0) return fieldWrong("point_step", 0);
  const auto row_step = msg["row_step"].integer();
  const std::size_t packed = layout.width * layout.point_step;
  // Senders of clouds with a single row often omit it.
  layout.row_step = row_step && *row_step > 0 ? std::size_t(*row_step) : packed;
  if (layout.height > 1 && layout.row_step < packed) return fieldWrong("row_step", double(layout.row_step));
  layout.big_endian = msg["is_bigendian"].flag().value_or(false);

  const Field fields = msg["fields"];
  if (!fields.isList()) return fieldMissing("fields");
  fields.each([&layout](const Field& row) {
    const std::string name = row["name"].text();
    const auto type = row["datatype"].integer(), offset = row["offset"].integer();
    const bool color = name == "rgb" || name == "rgba";
    std::optional<NumberPlace>* const wanted = name == "x"           ? &layout.x
                                               : name == "y"         ? &layout.y
                                               : name == "z"         ? &layout.z
                                               : name == "intensity" ? &layout.intensity
                                               : color               ? &layout.color
                                                                     : nullptr;
    if (!wanted) return;
    const bool known = type && *type >= 1 && *type <= 8 && offset && *offset >= 0;
    const NumberPlace place =
        known ? NumberPlace{wire::NumberType(*type), std::size_t(*offset)} : NumberPlace{};
    if (!known || !place.liesIn(layout.point_step)) {
      if (layout.outside.size() < 8) layout.outside.push_back(name);
      return;
    }
    if (color && wire::bytesOf(place.type) != 4) return;
    *wanted = place;
  });
  if (!layout.x || !layout.y) return tl::unexpected(Fault(robot::wire::fault::PointsWithoutFields));
  return layout;
}

Fault cloudCutShort(const CloudLayout& layout, std::size_t bytes) {
  const double needed =
      double(layout.height - 1) * double(layout.row_step) + double(layout.width) * double(layout.point_step);
  return {fault::RosLengthDiffers, {"data", std::int64_t(bytes), std::int64_t(std::min(needed, 9e18))}};
}

}  // namespace mapwright::robot::ros
