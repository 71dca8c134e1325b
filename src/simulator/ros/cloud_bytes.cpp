#include "simulator/ros/cloud_bytes.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace mapwright::simulator::ros {
namespace {

constexpr int kUint32 = 6, kFloat32 = 7, kFloat64 = 8;

class Writer {
 public:
  Writer(std::string& out, bool big_endian) : out_(out), big_endian_(big_endian) {}
  template <typename T>
  void put(std::size_t record, std::size_t offset, T number) {
    using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
    const auto bits = std::bit_cast<Bits>(number);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const std::size_t shift = 8 * (big_endian_ ? sizeof(T) - 1 - i : i);
      out_[record + offset + i] = static_cast<char>((bits >> shift) & 0xFF);
    }
  }

 private:
  std::string& out_;
  bool big_endian_;
};

}  // namespace

Value cloudMessage(Value header, const std::vector<Building::Point>& points, bool colored,
                   const CloudOddities& odd) {
  const std::size_t axis = odd.float64 ? 8 : 4;
  // Between the fields there may be bytes of nobody's.
  std::size_t offset = odd.odd_offsets ? 3 : 0;
  Value::List fields;
  const auto field = [&](const char* name, int type, std::size_t bytes) {
    const std::size_t at = offset;
    fields.push_back(Value::Object{{"name", name}, {"offset", at}, {"datatype", type}, {"count", 1}});
    offset += bytes + (odd.odd_offsets ? 1 : 0);
    return at;
  };
  const int number = odd.float64 ? kFloat64 : kFloat32;
  const std::size_t x = field("x", number, axis), y = field("y", number, axis);
  const std::size_t z = odd.no_z ? 0 : field("z", number, axis);
  const std::size_t intensity = colored ? field("intensity", kFloat32, 4) : 0;
  const std::size_t rgb = colored ? field("rgb", odd.float64 ? kUint32 : kFloat32, 4) : 0;
  const std::size_t step = offset;
  std::string data(points.size() * step, '\x7f');
  Writer writer(data, odd.big_endian);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Building::Point& point = points[i];
    const bool nan = odd.nan && i % 10 == 3;
    const auto put = [&](std::size_t at, double value) {
      const double said = nan ? std::numeric_limits<double>::quiet_NaN() : value + odd.far_m;
      if (odd.float64) return writer.put(i * step, at, said);
      writer.put(i * step, at, static_cast<float>(said));
    };
    put(x, point.at_m.x());
    put(y, point.at_m.y());
    if (!odd.no_z) put(z, point.at_m.z() - odd.far_m);
    if (!colored) continue;
    writer.put(i * step, intensity, point.intensity);
    writer.put(i * step, rgb, point.rgb);
  }
  std::size_t width = points.size(), point_step = step, row_step = data.size();
  if (odd.lie == "point-step") point_step = step / 2 + 1;
  if (odd.lie == "row-step") row_step = data.size() * 3 + 7;
  if (odd.lie == "width") width = points.size() * 1000 + 1;
  if (odd.lie == "data") data.resize(data.size() - data.size() / 3);
  return Value::Object{{"header", std::move(header)},
                       {"height", 1},
                       {"width", width},
                       {"fields", std::move(fields)},
                       {"is_bigendian", odd.big_endian},
                       {"point_step", point_step},
                       {"row_step", row_step},
                       {"data", Value::Bytes{std::move(data)}},
                       {"is_dense", !odd.nan}};
}

}  // namespace mapwright::simulator::ros
