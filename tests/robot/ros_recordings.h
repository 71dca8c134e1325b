// A drive of a ROS robot as a recording, in each encoding that recordings come in.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../recording/bags.h"

namespace recordings {

enum class Encoding { Json, Cdr, Ros1, Bag };

/// One message in the making, in JSON and as bytes at once.
class RosOut {
 public:
  explicit RosOut(Encoding encoding) : encoding_(encoding) {}

  RosOut& f64(const char* name, double value) { return number(name, value, value); }
  RosOut& f32(const char* name, double value) { return number(name, value, float(value)); }
  RosOut& u32(const char* name, std::uint32_t value) { return number(name, value, value); }
  RosOut& u64(const char* name, std::uint64_t value) {
    member(name, std::to_string(value));
    put(value);
    return *this;
  }
  /// In the place of members.
  RosOut& nothing() {
    if (cdr()) bytes_ += '\0';
    return *this;
  }
  RosOut& i32(const char* name, std::int32_t value) { return number(name, value, value); }
  RosOut& u8(const char* name, std::uint8_t value) { return number(name, value, value); }
  RosOut& text(const char* name, const std::string& value) {
    member(name, '"' + value + '"');
    put(std::uint32_t(value.size() + (cdr() ? 1 : 0)));
    bytes_ += value;
    if (cdr()) bytes_ += '\0';
    return *this;
  }
  RosOut& time(const char* name, double at_s) {
    const auto whole = std::uint32_t(std::floor(at_s));
    const auto rest = std::uint32_t(std::llround((at_s - whole) * 1e9));
    member(name, "{\"secs\":" + std::to_string(whole) + ",\"nsecs\":" + std::to_string(rest) + '}');
    put(whole);
    put(rest);
    return *this;
  }
  RosOut& header(double at_s, const std::string& frame) {
    return object("header", [&] {
      if (!cdr()) u32("seq", 0);
      time("stamp", at_s);
      text("frame_id", frame);
    });
  }
  RosOut& object(const char* name, const std::function<void()>& fill) {
    begin(name, '{');
    fill();
    json_ += '}';
    return *this;
  }
  RosOut& list(const char* name, std::size_t count, const std::function<void(std::size_t)>& fill) {
    begin(name, '[');
    put(std::uint32_t(count));
    for (std::size_t i = 0; i < count; ++i) {
      begin(nullptr, '{');
      fill(i);
      json_ += '}';
    }
    json_ += ']';
    return *this;
  }
  template <typename T>
  RosOut& numbers(const char* name, const std::vector<T>& values) {
    begin(name, '[');
    put(std::uint32_t(values.size()));
    for (const T value : values) {
      separate();
      json_ += std::to_string(value);
      put(value);
    }
    json_ += ']';
    return *this;
  }
  RosOut& pose(const char* name, double x, double y, double yaw) {
    return object(name, [&] {
      object("position", [&] { f64("x", x).f64("y", y).f64("z", 0); });
      turn("orientation", yaw);
    });
  }
  RosOut& turn(const char* name, double yaw) {
    return object(name,
                  [&] { f64("x", 0).f64("y", 0).f64("z", std::sin(yaw / 2)).f64("w", std::cos(yaw / 2)); });
  }
  std::string done() const {
    if (encoding_ == Encoding::Json) return json_ + '}';
    return cdr() ? std::string("\0\1\0\0", 4) + bytes_ : bytes_;
  }

 private:
  bool cdr() const { return encoding_ == Encoding::Cdr; }
  void separate() {
    if (json_.back() != '{' && json_.back() != '[') json_ += ',';
  }
  void begin(const char* name, char with) {
    separate();
    if (name) json_ += '"' + std::string(name) + "\":";
    json_ += with;
  }
  void member(const char* name, const std::string& value) {
    separate();
    json_ += '"' + std::string(name) + "\":" + value;
  }
  template <typename T>
  RosOut& number(const char* name, double value, T as) {
    char written[40];
    std::snprintf(written, sizeof(written), "%.17g", std::is_same_v<T, float> ? double(float(value)) : value);
    member(name, written);
    put(as);
    return *this;
  }
  template <typename T>
  void put(T value) {
    if (cdr()) bytes_.resize((bytes_.size() + sizeof(T) - 1) / sizeof(T) * sizeof(T));
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  Encoding encoding_;
  std::string json_ = "{", bytes_;
};

/// The definitions that a recording holds of a type.
inline std::string definitionOf(const std::string& type, bool ros2) {
  if (type == "std_msgs/String") return "string data\n";
  if (type == "std_msgs/Empty") return "";
  if (type == "std_msgs/UInt64MultiArray") return "uint64 one\nuint64[] data\n";
  const std::string rule = "\n" + std::string(80, '=') + "\nMSG: ";
  const std::string header = rule + "std_msgs/Header\n" + (ros2 ? "" : "uint32 seq\n") +
                             (ros2 ? "builtin_interfaces/Time stamp\n" : "time stamp\n") +
                             "string frame_id\n";
  const std::string pose =
      rule + "geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n" +
      rule + "geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" + rule +
      "geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n";
  const std::string time = ros2 ? "builtin_interfaces/Time" : "time";
  if (type == "tf2_msgs/TFMessage")
    return "geometry_msgs/TransformStamped[] transforms\n" + rule +
           "geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring child_frame_id\n"
           "geometry_msgs/Transform transform\n" +
           rule +
           "geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n" +
           rule + "geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" + header + pose;
  if (type == "nav_msgs/OccupancyGrid")
    return "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n" + rule +
           "nav_msgs/MapMetaData\n" + time +
           " map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\ngeometry_msgs/Pose origin\n" +
           header + pose;
  if (type == "map_msgs/OccupancyGridUpdate")
    return "std_msgs/Header header\nint32 x\nint32 y\nuint32 width\nuint32 height\nint8[] data\n" + header;
  if (type == "nav_msgs/Odometry")
    return "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n" + rule +
           "geometry_msgs/PoseWithCovariance\ngeometry_msgs/Pose pose\n" + header + pose;
  if (type == "sensor_msgs/LaserScan")
    return "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
           "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
           "float32[] ranges\nfloat32[] intensities\n" +
           header;
  if (type == "visualization_msgs/MarkerArray")
    return "visualization_msgs/Marker[] markers\n" + rule +
           "visualization_msgs/Marker\nstd_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 "
           "action\n"
           "geometry_msgs/Pose pose\ngeometry_msgs/Point scale\n" +
           (ros2 ? "builtin_interfaces/Duration" : "duration") + " lifetime\n" + header + pose;
  return "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n" + rule +
         "geometry_msgs/PoseStamped\nstd_msgs/Header header\ngeometry_msgs/Pose pose\n" + header + pose;
}

/// What the robot of the drive does: it goes along x at 0.5 m/s; its map lies turned beside its odometry.
struct Drive {
  static constexpr double kStartS = 1'700'000'000.5, kSpeed = 0.5, kOffsetX = 10, kOffsetY = -3;
  double seconds = 60;

  static double xAt(double at_s) { return (at_s - kStartS) * kSpeed + kOffsetX; }

  struct Said {
    std::string topic, type;
    double at_s = 0;
    std::function<void(RosOut&)> fill;
  };
  std::vector<Said> all() const {
    std::vector<Said> said;
    const auto tf = [&](const char* topic, double at_s, std::string parent, std::string child, double x,
                        double y) {
      said.push_back({topic, "tf2_msgs/TFMessage", at_s, [=](RosOut& out) {
                        out.list("transforms", 1, [&](std::size_t) {
                          out.header(at_s, parent).text("child_frame_id", child);
                          out.object("transform", [&] {
                            out.object("translation", [&] { out.f64("x", x).f64("y", y).f64("z", 0); });
                            out.turn("rotation", 0);
                          });
                        });
                      }});
    };
    tf("/tf_static", kStartS, "base_link", "laser", 0.25, 0);
    tf("/tf_static", kStartS + 0.001, "base_link", "camera", 0, 0);
    grid(said, "/map", kStartS + 0.01, 6);
    grid(said, "/global_costmap/costmap", kStartS + 0.02, 8);
    for (int step = 0; step < int(seconds * 20); ++step) {
      const double at_s = kStartS + step * 0.05 + 0.003;
      // Transforms come later than what they place.
      if (step % 4 == 0) scan(said, at_s - 0.002);
      tf("/tf", at_s, "odom", "base_link", (at_s - kStartS) * kSpeed, 0);
      if (step % 2 == 0) tf("/tf", at_s + 0.01, "map", "odom", kOffsetX, kOffsetY);
      if (step % 40 == 7) path(said, at_s + 0.011);
      if (step % 30 == 11) patch(said, at_s + 0.012, step);
      // They live for two seconds, and are put again at odd times.
      if (step % 70 == 9 || step == 200) markers(said, at_s + 0.014, step);
      if (step % 50 == 3)
        said.push_back(
            {"/chatter", "std_msgs/String", at_s + 0.013, [](RosOut& out) { out.text("data", "hi"); }});
    }
    std::stable_sort(said.begin(), said.end(), [](const Said& a, const Said& b) { return a.at_s < b.at_s; });
    return said;
  }

 private:
  static void grid(std::vector<Said>& said, const char* topic, double at_s, std::uint32_t size) {
    said.push_back({topic, "nav_msgs/OccupancyGrid", at_s, [=](RosOut& out) {
                      out.header(at_s, "map").object("info", [&] {
                        out.time("map_load_time", at_s).f32("resolution", 0.5);
                        out.u32("width", size).u32("height", size).pose("origin", -1, -2, 0);
                      });
                      std::vector<std::int8_t> cells(size * size);
                      for (std::size_t i = 0; i < cells.size(); ++i)
                        cells[i] = std::int8_t(i % 5 == 0 ? 100 : 0);
                      out.numbers("data", cells);
                    }});
  }
  static void patch(std::vector<Said>& said, double at_s, int step) {
    said.push_back(
        {"/global_costmap/costmap_updates", "map_msgs/OccupancyGridUpdate", at_s, [=](RosOut& out) {
           out.header(at_s, "map").i32("x", step % 7).i32("y", step % 5).u32("width", 1).u32("height", 2);
           out.numbers("data", std::vector<std::int8_t>{std::int8_t(step % 100), 50});
         }});
  }

 public:
  static void scan(std::vector<Said>& said, double at_s, const char* topic = "/scan") {
    said.push_back(
        {topic, "sensor_msgs/LaserScan", at_s, [=](RosOut& out) {
           out.header(at_s, "laser").f32("angle_min", 0).f32("angle_max", 0.5);
           out.f32("angle_increment", 0.5).f32("time_increment", 0).f32("scan_time", 0);
           out.f32("range_min", 0.125).f32("range_max", 30);
           out.numbers("ranges", std::vector<float>{2, 4}).numbers("intensities", std::vector<float>{});
         }});
  }

 private:
  static void markers(std::vector<Said>& said, double at_s, int step) {
    said.push_back({"/markers", "visualization_msgs/MarkerArray", at_s, [=](RosOut& out) {
                      out.list("markers", 1, [&](std::size_t) {
                        out.header(at_s - 0.1, "base_link").text("ns", "box").i32("id", step % 3);
                        out.i32("type", 1).i32("action", 0).pose("pose", 1, step % 4, 0);
                        out.object("scale", [&] { out.f64("x", 1).f64("y", 1).f64("z", 1); });
                        out.time("lifetime", 2);
                      });
                    }});
  }
  static void path(std::vector<Said>& said, double at_s) {
    said.push_back({"/plan", "nav_msgs/Path", at_s, [=](RosOut& out) {
                      out.header(at_s, "map").list("poses", 2, [&](std::size_t i) {
                        out.header(at_s, "map").pose("pose", xAt(at_s) + double(i), kOffsetY, 0);
                      });
                    }});
  }
};

inline std::int64_t nanoseconds(double at_s) {
  return std::int64_t(std::floor(at_s)) * 1'000'000'000 + std::llround((at_s - std::floor(at_s)) * 1e9);
}

/// A bag of ROS 1 without an index, one chunk a hundred messages.
inline std::string bagOf(const std::vector<Drive::Said>& said) {
  std::map<std::string, std::uint32_t> connections;
  std::string file = "#ROSBAG V2.0\n";
  const std::string fields = field("chunk_count", number32(0)) + field("conn_count", number32(0)) +
                             field("index_pos", number64(0)) + op(3);
  file += record(fields, std::string(4096 - 8 - fields.size(), ' '));
  for (std::size_t from = 0; from < said.size(); from += 100) {
    std::string inside;
    for (std::size_t i = from; i < std::min(from + 100, said.size()); ++i) {
      const auto [at, is_new] = connections.try_emplace(said[i].topic, std::uint32_t(connections.size()));
      if (is_new) {
        inside += record(field("conn", number32(at->second)) + op(7) + field("topic", said[i].topic),
                         field("md5sum", std::string(32, 'a')) +
                             field("message_definition", definitionOf(said[i].type, false)) +
                             field("topic", said[i].topic) + field("type", said[i].type));
      }
      RosOut out(Encoding::Ros1);
      said[i].fill(out);
      inside += record(
          field("conn", number32(at->second)) + op(2) + field("time", rosTime(nanoseconds(said[i].at_s))),
          out.done());
    }
    file += record(
        field("compression", "none") + op(5) + field("size", number32(std::uint32_t(inside.size()))), inside);
  }
  return file;
}

inline std::string recordingOf(const std::vector<Drive::Said>& said, Encoding encoding,
                               WriterOptions options = {}) {
  if (encoding == Encoding::Bag) return bagOf(said);
  const auto bytes = std::make_shared<std::string>();
  const auto writer = writerInto(bytes, options);
  const bool ros2 = encoding == Encoding::Cdr;
  for (const Drive::Said& one : said) {
    Channel channel;
    channel.topic = one.topic;
    channel.message_encoding = encoding == Encoding::Json ? "json" : ros2 ? "cdr" : "ros1";
    channel.schema_name = one.type;
    if (ros2) channel.schema_name.insert(channel.schema_name.find('/'), "/msg");
    if (encoding != Encoding::Json) {
      channel.schema_encoding = ros2 ? "ros2msg" : "ros1msg";
      channel.schema_data = definitionOf(one.type, ros2);
    }
    RosOut out(encoding);
    one.fill(out);
    const std::int64_t at_ns = nanoseconds(one.at_s);
    writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, bytesOf(out.done()));
  }
  writer->close();
  return *bytes;
}

}  // namespace recordings
