// A drive by the schemas of Foxglove, as JSON and as protobuf with its definitions in the file.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/timestamp.pb.h>
#include <google/protobuf/util/json_util.h>

#include "../recording/recordings.h"

#ifndef Q_MOC_RUN  // which loses count of the braces in raw strings
namespace foxglove {

namespace pb = google::protobuf;

/// The members that are used here; the numbers are of no matter to who reads the definition.
class Schemas {
 public:
  Schemas() {
    file_.set_name("all.proto");
    file_.set_package("foxglove");
    file_.set_syntax("proto3");
    file_.add_dependency("google/protobuf/timestamp.proto");
    message("Vector2", {"double x", "double y"});
    message("Vector3", {"double x", "double y", "double z"});
    message("Quaternion", {"double x", "double y", "double z", "double w"});
    message("Pose", {"Vector3 position", "Quaternion orientation"});
    message("PackedElementField", {"string name", "int offset", "int type"});
    message("Grid",
            {"time timestamp", "string frame_id", "Pose pose", "int column_count", "Vector2 cell_size",
             "int row_stride", "int cell_stride", "*PackedElementField fields", "bytes data"});
    message("LaserScan", {"time timestamp", "string frame_id", "Pose pose", "double start_angle",
                          "double end_angle", "*double ranges", "*double intensities"});
    message("PointCloud", {"time timestamp", "string frame_id", "Pose pose", "int point_stride",
                           "*PackedElementField fields", "bytes data"});
    message("PosesInFrame", {"time timestamp", "string frame_id", "*Pose poses"});
    message("FrameTransform", {"time timestamp", "string parent_frame_id", "string child_frame_id",
                               "Vector3 translation", "Quaternion rotation"});
    message("FrameTransforms", {"*FrameTransform transforms"});
    pb::Timestamp::descriptor()->file()->CopyTo(&time_);
    pool_.BuildFile(time_);
    pool_.BuildFile(file_);
  }
  std::string set() const {
    pb::FileDescriptorSet set;
    // Whoever needs another one stands before it, here.
    *set.add_file() = file_;
    *set.add_file() = time_;
    return set.SerializeAsString();
  }
  std::string bytesOf(const std::string& type, const std::string& json) {
    const std::unique_ptr<pb::Message> message(
        factory_.GetPrototype(pool_.FindMessageTypeByName("foxglove." + type))->New());
    const auto status = pb::util::JsonStringToMessage(json, message.get());
    if (!status.ok()) qFatal("%s", std::string(status.message()).c_str());
    return message->SerializeAsString();
  }

 private:
  /// "double x", "*Pose poses" (several).
  void message(const std::string& name, const std::vector<std::string>& members) {
    using Field = pb::FieldDescriptorProto;
    pb::DescriptorProto& made = *file_.add_message_type();
    made.set_name(name);
    for (std::string member : members) {
      Field& field = *made.add_field();
      const bool several = member.front() == '*';
      if (several) member.erase(0, 1);
      const std::string type = member.substr(0, member.find(' '));
      field.set_name(member.substr(type.size() + 1));
      field.set_number(made.field_size());
      field.set_label(several ? Field::LABEL_REPEATED : Field::LABEL_OPTIONAL);
      if (type == "double") {
        field.set_type(Field::TYPE_DOUBLE);
      } else if (type == "string") {
        field.set_type(Field::TYPE_STRING);
      } else if (type == "bytes") {
        field.set_type(Field::TYPE_BYTES);
      } else if (type == "int") {
        field.set_type(Field::TYPE_UINT32);
      } else {
        field.set_type(Field::TYPE_MESSAGE);
        field.set_type_name(type == "time" ? ".google.protobuf.Timestamp" : ".foxglove." + type);
      }
    }
  }

  pb::FileDescriptorProto file_, time_;
  pb::DescriptorPool pool_;
  pb::DynamicMessageFactory factory_{&pool_};
};

/// Three seconds: a map of 3 x 2 cells, the robot at x = 12, a scan, a point, a path.
inline std::string drive(bool protobuf) {
  constexpr double kStartS = 1'717'405'200;
  Schemas schemas;
  const auto bytes = std::make_shared<std::string>();
  const auto writer = recordings::writerInto(bytes);
  const auto say = [&](double after_s, const std::string& topic, const std::string& type, std::string json) {
    const int whole = int(after_s);
    const std::string time =
        protobuf ? "\"2024-06-03T09:00:0" + std::to_string(whole) + "Z\""
                 : "{\"sec\":" + std::to_string(std::int64_t(kStartS) + whole) + ",\"nsec\":0}";
    for (std::size_t at = json.find("TIME"); at != std::string::npos; at = json.find("TIME"))
      json.replace(at, 4, time);
    mapwright::recording::Channel channel;
    channel.topic = topic;
    channel.message_encoding = protobuf ? "protobuf" : "json";
    channel.schema_name = "foxglove." + type;
    channel.schema_encoding = protobuf ? "protobuf" : "jsonschema";
    channel.schema_data = protobuf ? schemas.set() : "{\"type\":\"object\"}";
    const std::string content = protobuf ? schemas.bytesOf(type, json) : json;
    const std::int64_t at_ns = std::llround((kStartS + after_s) * 1e9);
    writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(content));
  };
  const std::string turn = R"({"x":0,"y":0,"z":0,"w":1})";
  const auto transform = [&](const char* parent, const char* child, double x_m) {
    return std::string(R"({"timestamp":TIME,"parent_frame_id":")") + parent + R"(","child_frame_id":")" +
           child + R"(","translation":{"x":)" + std::to_string(x_m) + R"(,"y":0,"z":0},"rotation":)" + turn +
           "}";
  };
  const auto pose = [&](double x_m, double y_m) {
    return R"({"position":{"x":)" + std::to_string(x_m) + R"(,"y":)" + std::to_string(y_m) +
           R"(,"z":0},"orientation":)" + turn + "}";
  };
  say(0, "/static_frames", "FrameTransforms", R"({"transforms":[)" + transform("map", "odom", 10) + "]}");
  for (int i = 0; i < 30; ++i) {
    // Each tells the whole second that it is in.
    say(i * 0.1, "/frames", "FrameTransform", transform("odom", "base_link", 2));
    if (i % 10 != 5) continue;
    // 0 100 255 / 0 0 100
    say(i * 0.1, "/map", "Grid",
        R"({"timestamp":TIME,"frame_id":"map","pose":)" + pose(1, 2) +
            R"(,"column_count":3,"cell_size":{"x":0.5,"y":0.5},"row_stride":3,"cell_stride":1,)"
            R"("fields":[{"name":"occupancy","offset":0,"type":1}],"data":"AGT/AABk"})");
    say(i * 0.1, "/scan", "LaserScan",
        R"({"timestamp":TIME,"frame_id":"base_link","pose":)" + pose(1, 0) +
            R"(,"start_angle":0,"end_angle":0,"ranges":[1,0,2],"intensities":[]})");
    // x 1, y 0, z 0.5 as floats, then what it reflects
    say(i * 0.1, "/lidar", "PointCloud",
        R"({"timestamp":TIME,"frame_id":"base_link","pose":)" + pose(0, 0) +
            R"(,"point_stride":13,"fields":[{"name":"x","offset":0,"type":7},{"name":"y","offset":4,"type":7},)"
            R"({"name":"z","offset":8,"type":7},{"name":"intensity","offset":12,"type":1}],)"
            R"("data":"AACAPwAAAAAAAAA/Bw=="})");
    say(i * 0.1, "/plan", "PosesInFrame",
        R"({"timestamp":TIME,"frame_id":"map","poses":[)" + pose(12, 0) + "," + pose(20, 0) + "]}");
  }
  writer->close();
  return *bytes;
}

/// A type with a member of every kind, in a file with two messages of it: one that says much, and one that
/// says nothing.
class Everything {
 public:
  Everything() {
    using Field = pb::FieldDescriptorProto;
    file_.set_name("everything.proto");
    file_.set_package("test");
    file_.set_syntax("proto3");
    pb::EnumDescriptorProto& kinds = *file_.add_enum_type();
    kinds.set_name("Kind");
    for (int number = 0; number < 3; ++number) {
      pb::EnumValueDescriptorProto& value = *kinds.add_value();
      value.set_name("KIND_" + std::to_string(number));
      value.set_number(number);
    }
    pb::DescriptorProto& all = *file_.add_message_type();
    all.set_name("Everything");
    const auto add = [&](const char* name, Field::Type type, const char* type_name, bool several) {
      Field& field = *all.add_field();
      field.set_name(name);
      field.set_number(all.field_size());
      field.set_type(type);
      if (type_name) field.set_type_name(type_name);
      field.set_label(several ? Field::LABEL_REPEATED : Field::LABEL_OPTIONAL);
    };
    for (const bool several : {false, true}) {
      add(several ? "smalls" : "small", Field::TYPE_SINT32, nullptr, several);
      add(several ? "larges" : "large", Field::TYPE_UINT64, nullptr, several);
      add(several ? "reals" : "real", Field::TYPE_FLOAT, nullptr, several);
      add(several ? "yeses" : "yes", Field::TYPE_BOOL, nullptr, several);
      add(several ? "names" : "name", Field::TYPE_STRING, nullptr, several);
      add(several ? "kinds" : "kind", Field::TYPE_ENUM, ".test.Kind", several);
      add(several ? "inners" : "inner", Field::TYPE_MESSAGE, ".test.Everything", several);
    }
    pb::DescriptorProto& entry = *all.add_nested_type();
    entry.set_name("ByNameEntry");
    entry.mutable_options()->set_map_entry(true);
    for (const auto& [name, type] : {std::pair("key", Field::TYPE_STRING), {"value", Field::TYPE_INT32}}) {
      Field& field = *entry.add_field();
      field.set_name(name);
      field.set_number(entry.field_size());
      field.set_type(type);
      field.set_label(Field::LABEL_OPTIONAL);
    }
    add("by_name", Field::TYPE_MESSAGE, ".test.Everything.ByNameEntry", true);
    pool_.BuildFile(file_);
  }
  std::string recording() {
    pb::FileDescriptorSet set;
    *set.add_file() = file_;
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    mapwright::recording::Channel channel;
    channel.topic = "/all";
    channel.message_encoding = channel.schema_encoding = "protobuf";
    channel.schema_name = "test.Everything";
    channel.schema_data = set.SerializeAsString();
    const auto id = *writer->addChannel(channel);
    std::int64_t at_ns = 1'717'405'200'000'000'000;
    for (const char* json :
         {R"({"small":-3,"large":"18446744073709551615","real":0.5,"yes":true,"name":"q","kind":2,)"
          R"("inner":{"small":7},"smalls":[1,0,-1],"larges":["9223372036854775808","1"],"reals":[0.25,0],)"
          R"("yeses":[true,false],"names":["a",""],"kinds":[0,2],"by_name":{"right":0,"left":1}})",
          "{}"}) {
      const std::unique_ptr<pb::Message> message(
          factory_.GetPrototype(pool_.FindMessageTypeByName("test.Everything"))->New());
      pb::util::JsonParseOptions options;
      const auto status = pb::util::JsonStringToMessage(json, message.get(), options);
      if (!status.ok()) qFatal("%s", std::string(status.message()).c_str());
      writer->write(id, {at_ns, at_ns, 0}, recordings::bytesOf(message->SerializeAsString()));
      at_ns += 1'000'000'000;
    }
    writer->close();
    return *bytes;
  }

 private:
  pb::FileDescriptorProto file_;
  pb::DescriptorPool pool_;
  pb::DynamicMessageFactory factory_{&pool_};
};

}  // namespace foxglove
#endif
