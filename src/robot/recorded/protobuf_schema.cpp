#include "robot/recorded/protobuf_schema.h"

#include <limits>
#include <utility>
#include <vector>

#include <QCborArray>
#include <QCborMap>
#include <QCborValue>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/descriptor_database.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/stubs/logging.h>

namespace mapwright::robot::recorded {
namespace {

namespace pb = google::protobuf;
using Field = pb::FieldDescriptor;

constexpr int kDeepest = 16;      // messages in messages that are looked at
constexpr int kFloat64List = 86;  // RFC 8746, 2.1: little-endian

/// What is wrong with a definition is told by the channel's reason.
class Silent final : public pb::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string&, const std::string&, const pb::Message*, ErrorLocation,
                const std::string&) override {}
};

QString nameOf(const Field& field) { return QString::fromStdString(field.name()); }

QCborMap valueOf(const pb::Message& message, int depth);

QCborValue single(const pb::Message& message, const Field& field, int depth) {
  const pb::Reflection& of = *message.GetReflection();
  switch (field.cpp_type()) {
    case Field::CPPTYPE_INT32:
      return qint64(of.GetInt32(message, &field));
    case Field::CPPTYPE_INT64:
      return qint64(of.GetInt64(message, &field));
    case Field::CPPTYPE_UINT32:
      return qint64(of.GetUInt32(message, &field));
    case Field::CPPTYPE_UINT64: {
      const std::uint64_t value = of.GetUInt64(message, &field);
      if (value > std::uint64_t(std::numeric_limits<qint64>::max())) return double(value);
      return qint64(value);
    }
    case Field::CPPTYPE_DOUBLE:
      return of.GetDouble(message, &field);
    case Field::CPPTYPE_FLOAT:
      return double(of.GetFloat(message, &field));
    case Field::CPPTYPE_BOOL:
      return of.GetBool(message, &field);
    case Field::CPPTYPE_ENUM:
      return qint64(of.GetEnumValue(message, &field));
    case Field::CPPTYPE_STRING: {
      const std::string text = of.GetString(message, &field);
      const QByteArray bytes(text.data(), qsizetype(text.size()));
      if (field.type() == Field::TYPE_BYTES) return bytes;
      return QString::fromUtf8(bytes);
    }
    case Field::CPPTYPE_MESSAGE:
      return valueOf(of.GetMessage(message, &field), depth + 1);
  }
  return {};
}

QCborValue numbers(const std::vector<double>& values) {
  const QByteArray bytes(reinterpret_cast<const char*>(values.data()),
                         qsizetype(values.size() * sizeof(double)));
  return {QCborTag(kFloat64List), QCborValue(bytes)};
}

QCborValue repeated(const pb::Message& message, const Field& field, int depth) {
  const pb::Reflection& of = *message.GetReflection();
  const int count = of.FieldSize(message, &field);
  if (field.cpp_type() == Field::CPPTYPE_DOUBLE || field.cpp_type() == Field::CPPTYPE_FLOAT) {
    std::vector<double> values;
    values.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
      values.push_back(field.cpp_type() == Field::CPPTYPE_DOUBLE
                           ? of.GetRepeatedDouble(message, &field, i)
                           : double(of.GetRepeatedFloat(message, &field, i)));
    return numbers(values);
  }
  QCborArray all;
  // Lists of other things say nothing here.
  if (field.cpp_type() != Field::CPPTYPE_MESSAGE) return all;
  for (int i = 0; i < count; ++i) all.append(valueOf(of.GetRepeatedMessage(message, &field, i), depth + 1));
  return all;
}

QCborMap valueOf(const pb::Message& message, int depth) {
  QCborMap value;
  if (depth > kDeepest) return value;
  std::vector<const Field*> set;
  message.GetReflection()->ListFields(message, &set);
  for (const Field* const field : set)
    value.insert(nameOf(*field),
                 field->is_repeated() ? repeated(message, *field, depth) : single(message, *field, depth));
  return value;
}

}  // namespace

/// Each is made of the ones before it.
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

tl::expected<ProtobufSchema, map::Reason> ProtobufSchema::of(const recording::Channel& channel) {
  const map::Reason none(map::ReasonCode::RosSchemaMissing, {channel.schema_name});
  if (channel.schema_encoding != "protobuf")
    return tl::unexpected(map::Reason(map::ReasonCode::RosEncodingUnknown,
                                      {channel.message_encoding, channel.schema_encoding}));
  const pb::LogSilencer silent;
  pb::FileDescriptorSet files;
  if (channel.schema_data.size() > std::size_t(std::numeric_limits<int>::max()) ||
      !files.ParseFromString(channel.schema_data))
    return tl::unexpected(none);
  auto parts = std::make_unique<Parts>();
  for (const pb::FileDescriptorProto& file : files.file()) {
    // The same one twice says so on the console of whoever asks.
    pb::FileDescriptorProto known;
    if (!parts->files.FindFileByName(file.name(), &known)) parts->files.Add(file);
  }
  parts->pool = std::make_unique<pb::DescriptorPool>(&parts->files, &parts->errors);
  parts->messages = std::make_unique<pb::DynamicMessageFactory>(parts->pool.get());
  parts->type = parts->pool->FindMessageTypeByName(channel.schema_name);
  if (!parts->type) return tl::unexpected(none);
  return ProtobufSchema(std::move(parts));
}

tl::expected<QByteArray, map::Reason> ProtobufSchema::toCbor(std::span<const std::uint8_t> bytes) const {
  const std::unique_ptr<pb::Message> message(parts_->messages->GetPrototype(parts_->type)->New());
  const bool fits = bytes.size() <= std::size_t(std::numeric_limits<int>::max());
  // What is required and not there is not needed here.
  if (!fits || !message->ParsePartialFromArray(bytes.data(), int(bytes.size())))
    return tl::unexpected(map::Reason(map::ReasonCode::MessageNotUnderstood));
  return valueOf(*message, 0).toCborValue().toCbor();
}

}  // namespace mapwright::robot::recorded
