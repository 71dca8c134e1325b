#include "robot/recorded/protobuf_schema.h"

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <QCborStreamWriter>
#include <google/protobuf/any.pb.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/duration.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/empty.pb.h>
#include <google/protobuf/field_mask.pb.h>
#include <google/protobuf/reflection.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/timestamp.pb.h>
#include <google/protobuf/wrappers.pb.h>

#include "recording/ros_cbor.h"
#include "robot/recorded/faults.h"
#include "robot/ros/faults.h"

namespace mapwright::robot::recorded {
namespace {

namespace pb = google::protobuf;

constexpr int kDeepest = 100;  // nested messages: as deep as protobuf itself allows
// As CBOR every member has its name, also where the message says nothing of it: a few bytes may be many
// names.
constexpr std::uint64_t kMostCbor = std::uint64_t(64) << 20, kMostCborPerByte = 64;

/// Errors in a definition are reported by the channel's reason.
class Silent final : public pb::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string&, const std::string&, const pb::Message*, ErrorLocation,
                const std::string&) override {}
};

/// Writes messages as maps.
class CborOut {
 public:
  CborOut(QByteArray& out, std::uint64_t most) : out_(out), most_(most), writer_(&out) {}
  /// It is nested too deep, or longer than `most`.
  bool gaveUp() const { return gave_up_; }

  void message(const pb::Message& message) {
    if (++depth_ > kDeepest) gave_up_ = true;
    writer_.startMap();
    const pb::Descriptor& type = *message.GetDescriptor();
    for (int i = 0; i < type.field_count() && !gave_up_; ++i) {
      if (std::uint64_t(out_.size()) > most_) gave_up_ = true;
      const pb::FieldDescriptor& field = *type.field(i);
      // For members with presence, absent differs from zero; others are zero or empty if missing.
      const pb::Reflection& of = *message.GetReflection();
      if (!field.is_repeated() && field.has_presence() && !of.HasField(message, &field)) continue;
      text(field.name());
      value(message, field);
    }
    std::vector<const pb::FieldDescriptor*> set;
    if (type.extension_range_count() > 0) message.GetReflection()->ListFields(message, &set);
    for (const pb::FieldDescriptor* const field : set) {
      if (!field->is_extension()) continue;
      text('[' + field->full_name() + ']');  // as in protobuf's own JSON
      value(message, *field);
    }
    writer_.endMap();
    --depth_;
  }

 private:
  void text(const std::string& utf8) { writer_.appendTextString(utf8.data(), qsizetype(utf8.size())); }
  void textOrBytes(const pb::FieldDescriptor& field, const std::string& value) {
    if (field.type() == pb::FieldDescriptor::TYPE_BYTES) {
      writer_.appendByteString(value.data(), qsizetype(value.size()));
    } else {
      text(value);
    }
  }

  void value(const pb::Message& message, const pb::FieldDescriptor& field) {
    if (field.is_map()) {
      mapOf(message, field);
    } else if (field.is_repeated()) {
      list(message, field);
    } else {
      single(message, field);
    }
  }

  void single(const pb::Message& message, const pb::FieldDescriptor& field) {
    const pb::Reflection& of = *message.GetReflection();
    switch (field.cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_INT32:
        return writer_.append(qint64(of.GetInt32(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_INT64:
        return writer_.append(qint64(of.GetInt64(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_UINT32:
        return writer_.append(quint64(of.GetUInt32(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_UINT64:
        return writer_.append(quint64(of.GetUInt64(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_DOUBLE:
        return writer_.append(of.GetDouble(message, &field));
      case pb::FieldDescriptor::CPPTYPE_FLOAT:
        return writer_.append(double(of.GetFloat(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_BOOL:
        return writer_.append(of.GetBool(message, &field));
      case pb::FieldDescriptor::CPPTYPE_ENUM:
        return writer_.append(qint64(of.GetEnumValue(message, &field)));
      case pb::FieldDescriptor::CPPTYPE_STRING: {
        std::string held;
        return textOrBytes(field, of.GetStringReference(message, &field, &held));
      }
      case pb::FieldDescriptor::CPPTYPE_MESSAGE:
        return this->message(of.GetMessage(message, &field));
    }
  }

  void list(const pb::Message& message, const pb::FieldDescriptor& field) {
    const pb::Reflection& of = *message.GetReflection();
    const int count = of.FieldSize(message, &field);
    switch (field.cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_INT32:
        return numbers<std::int32_t>(message, field);
      case pb::FieldDescriptor::CPPTYPE_INT64:
        return numbers<std::int64_t>(message, field);
      case pb::FieldDescriptor::CPPTYPE_UINT32:
        return numbers<std::uint32_t>(message, field);
      case pb::FieldDescriptor::CPPTYPE_UINT64:
        return numbers<std::uint64_t>(message, field);
      case pb::FieldDescriptor::CPPTYPE_DOUBLE:
        return numbers<double>(message, field);
      case pb::FieldDescriptor::CPPTYPE_FLOAT:
        return numbers<float>(message, field);
      default:
        break;
    }
    writer_.startArray(quint64(count));
    for (int i = 0; i < count; ++i) {
      if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_BOOL) {
        writer_.append(of.GetRepeatedBool(message, &field, i));
      } else if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_ENUM) {
        writer_.append(qint64(of.GetRepeatedEnumValue(message, &field, i)));
      } else if (field.cpp_type() == pb::FieldDescriptor::CPPTYPE_STRING) {
        std::string held;
        textOrBytes(field, of.GetRepeatedStringReference(message, &field, i, &held));
      } else {
        this->message(of.GetRepeatedMessage(message, &field, i));
      }
    }
    writer_.endArray();
  }

  template <typename Number>
  void numbers(const pb::Message& message, const pb::FieldDescriptor& field) {
    const auto all = message.GetReflection()->GetRepeatedFieldRef<Number>(message, &field);
    std::vector<Number> values;
    values.reserve(std::size_t(all.size()));
    for (const Number value : all) values.push_back(value);
    writer_.append(QCborTag(recording::cborTagOf<Number>()));
    writer_.appendByteString(reinterpret_cast<const char*>(values.data()),
                             qsizetype(values.size() * sizeof(Number)));
  }

  /// Sorted by key: protobuf has no order.
  void mapOf(const pb::Message& message, const pb::FieldDescriptor& field) {
    const pb::Reflection& of = *message.GetReflection();
    const pb::FieldDescriptor& key = *field.message_type()->map_key();
    const pb::FieldDescriptor& value = *field.message_type()->map_value();
    std::map<std::string, const pb::Message*> entries;  // of duplicate keys the last one counts
    for (int i = 0; i < of.FieldSize(message, &field); ++i) {
      const pb::Message& entry = of.GetRepeatedMessage(message, &field, i);
      entries[keyOf(entry, key)] = &entry;
    }
    writer_.startMap(entries.size());
    for (const auto& [name, entry] : entries) {
      text(name);
      single(*entry, value);
    }
    writer_.endMap();
  }

  static std::string keyOf(const pb::Message& entry, const pb::FieldDescriptor& key) {
    const pb::Reflection& of = *entry.GetReflection();
    switch (key.cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_INT32:
        return std::to_string(of.GetInt32(entry, &key));
      case pb::FieldDescriptor::CPPTYPE_INT64:
        return std::to_string(of.GetInt64(entry, &key));
      case pb::FieldDescriptor::CPPTYPE_UINT32:
        return std::to_string(of.GetUInt32(entry, &key));
      case pb::FieldDescriptor::CPPTYPE_UINT64:
        return std::to_string(of.GetUInt64(entry, &key));
      case pb::FieldDescriptor::CPPTYPE_BOOL:
        return of.GetBool(entry, &key) ? "true" : "false";
      default:
        return of.GetString(entry, &key);
    }
  }

  const QByteArray& out_;
  const std::uint64_t most_;
  QCborStreamWriter writer_;
  int depth_ = 0;
  bool gave_up_ = false;
};

/// Some recorders leave out the definitions that come with protobuf itself.
void addWellKnown(const pb::FileDescriptorSet& files, pb::SimpleDescriptorDatabase& to) {
  const pb::FileDescriptor* const own[] = {
      pb::Any::descriptor()->file(),      pb::Duration::descriptor()->file(),
      pb::Empty::descriptor()->file(),    pb::FieldMask::descriptor()->file(),
      pb::Struct::descriptor()->file(),   pb::Timestamp::descriptor()->file(),
      pb::BoolValue::descriptor()->file()};
  for (const pb::FileDescriptorProto& file : files.file()) {
    for (const std::string& wanted : file.dependency()) {
      pb::FileDescriptorProto made;
      if (to.FindFileByName(wanted, &made)) continue;
      for (const pb::FileDescriptor* const known : own) {
        if (known->name() != wanted) continue;
        known->CopyTo(&made);
        to.Add(made);
      }
    }
  }
}

}  // namespace

/// Each depends on the ones before it.
struct ProtobufSchema::Parts {
  pb::SimpleDescriptorDatabase files;
  Silent errors;
  std::unique_ptr<pb::DescriptorPool> pool;
  std::unique_ptr<pb::DynamicMessageFactory> messages;
  const pb::Descriptor* type = nullptr;
};

ProtobufSchema::ProtobufSchema(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ProtobufSchema::ProtobufSchema(ProtobufSchema&&) noexcept = default;
ProtobufSchema& ProtobufSchema::operator=(ProtobufSchema&&) noexcept = default;

ProtobufSchema::~ProtobufSchema() = default;

tl::expected<ProtobufSchema, Fault> ProtobufSchema::of(const recording::Channel& channel) {
  const Fault none(fault::RosSchemaMissing, {channel.schema_name});
  if (channel.schema_encoding != "protobuf")
    return tl::unexpected(
        Fault(fault::RosEncodingUnknown, {channel.message_encoding, channel.schema_encoding}));
  const pb::LogSilencer silent;
  pb::FileDescriptorSet files;
  if (channel.schema_data.size() > std::size_t(std::numeric_limits<int>::max()) ||
      !files.ParseFromString(channel.schema_data))
    return tl::unexpected(none);
  auto parts = std::make_unique<Parts>();
  for (const pb::FileDescriptorProto& file : files.file()) {
    // Adding the same one twice would print an error to the console.
    pb::FileDescriptorProto known;
    if (!parts->files.FindFileByName(file.name(), &known)) parts->files.Add(file);
  }
  addWellKnown(files, parts->files);
  parts->pool = std::make_unique<pb::DescriptorPool>(&parts->files, &parts->errors);
  parts->messages = std::make_unique<pb::DynamicMessageFactory>(parts->pool.get());
  parts->type = parts->pool->FindMessageTypeByName(
      channel.schema_name.starts_with('.') ? channel.schema_name.substr(1) : channel.schema_name);
  if (!parts->type) return tl::unexpected(none);
  return ProtobufSchema(std::move(parts));
}

tl::expected<QByteArray, Fault> ProtobufSchema::toCbor(std::span<const std::uint8_t> bytes) const {
  const std::unique_ptr<pb::Message> message(parts_->messages->GetPrototype(parts_->type)->New());
  const bool fits = bytes.size() <= std::size_t(std::numeric_limits<int>::max());
  // Missing required members are accepted.
  if (!fits || !message->ParsePartialFromArray(bytes.data(), int(bytes.size())))
    return tl::unexpected(Fault(robot::ros::fault::MessageNotUnderstood));
  QByteArray cbor;
  CborOut out(cbor, kMostCbor + bytes.size() * kMostCborPerByte);
  out.message(*message);
  if (out.gaveUp()) return tl::unexpected(Fault(robot::ros::fault::MessageNotUnderstood));
  return cbor;
}

}  // namespace mapwright::robot::recorded
