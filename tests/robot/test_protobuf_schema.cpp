// Messages of protobuf by the definition in their recording.
#include <QTest>
#include <google/protobuf/descriptor.pb.h>

#include "robot/recorded/protobuf_schema.h"
#include "test_program.h"

namespace test_protobuf_schema {

using namespace mapwright;
using robot::recorded::ProtobufSchema;

namespace {

namespace pb = google::protobuf;

/// Rows of many columns, whose names are long.
ProtobufSchema tableOf(int columns) {
  pb::FileDescriptorSet files;
  pb::FileDescriptorProto& file = *files.add_file();
  file.set_name("table.proto");
  file.set_syntax("proto3");
  pb::DescriptorProto& row = *file.add_message_type();
  row.set_name("Row");
  for (int i = 1; i <= columns; ++i) {
    pb::FieldDescriptorProto& column = *row.add_field();
    column.set_name(std::string(100, 'c') + std::to_string(i));
    column.set_number(i);
    column.set_type(pb::FieldDescriptorProto::TYPE_INT32);
    column.set_label(pb::FieldDescriptorProto::LABEL_OPTIONAL);
  }
  pb::DescriptorProto& table = *file.add_message_type();
  table.set_name("Table");
  pb::FieldDescriptorProto& rows = *table.add_field();
  rows.set_name("rows");
  rows.set_number(1);
  rows.set_type(pb::FieldDescriptorProto::TYPE_MESSAGE);
  rows.set_type_name(".Row");
  rows.set_label(pb::FieldDescriptorProto::LABEL_REPEATED);
  recording::Channel channel;
  channel.schema_encoding = channel.message_encoding = "protobuf";
  channel.schema_name = "Table";
  channel.schema_data = files.SerializeAsString();
  auto schema = ProtobufSchema::of(channel);
  if (!schema) qFatal("no schema");
  return std::move(*schema);
}

/// So many empty rows, two bytes each.
std::vector<std::uint8_t> rows(int count) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < count; ++i) bytes.insert(bytes.end(), {0x0A, 0x00});
  return bytes;
}

}  // namespace

class ProtobufSchemaTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aFewBytesDoNotBecomeAnyNumberOfNames() {
    const ProtobufSchema schema = tableOf(1000);
    const auto some = schema.toCbor(rows(100));
    QVERIFY(some);
    QVERIFY(some->size() > 100 * 1000 * 100);
    QVERIFY(!schema.toCbor(rows(1000)));  // 100 MB of names for 2 kB
  }
};

}  // namespace test_protobuf_schema

MAPWRIGHT_TEST(test_protobuf_schema, ProtobufSchemaTest, Core)

#include "test_protobuf_schema.moc"
