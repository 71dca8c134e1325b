// What other programs make of a recording, for test_recordings_elsewhere: read with the public @mcap/core, each channel
// taken by the rules of Lichtblick (mcap-support, parseChannel) and of PlotJuggler (no channel without a schema), each
// message by the public parsers of its encoding.
//   node shown_elsewhere.mjs PACKAGES FILE    {"channels":[{"topic","encoding","schema","messages","sample"}],"wrong":[…]}
import {createRequire} from 'node:module';
import {open} from 'node:fs/promises';

const [packages, path] = process.argv.slice(2);
const require = createRequire(packages + '/');
const {McapIndexedReader} = require('@mcap/core');
const {parse} = require('@foxglove/rosmsg');
const ros1 = require('@foxglove/rosmsg-serialization');
const ros2 = require('@foxglove/rosmsg2-serialization');
const protobuf = require('protobufjs');
const {FileDescriptorSet} = require('protobufjs/ext/descriptor');
const fzstd = require('fzstd');

const text = (bytes) => new TextDecoder().decode(bytes);
const expect = (channel, schema, encoding) => {
  if (schema.encoding !== encoding) throw new Error(`${channel.messageEncoding} with a schema of '${schema.encoding}'`);
  if (schema.data.length === 0) throw new Error(`the schema of ${schema.name} is empty`);
};

function readerOf(channel, schema) {
  if (!schema) throw new Error('no schema');
  switch (channel.messageEncoding) {
    case 'json': {
      expect(channel, schema, 'jsonschema');
      if (JSON.parse(text(schema.data)).type !== 'object') throw new Error('a JSON schema of no object');
      return (data) => JSON.parse(text(data));
    }
    case 'ros1': {
      expect(channel, schema, 'ros1msg');
      const reader = new ros1.MessageReader(parse(text(schema.data)));
      return (data) => reader.readMessage(data);
    }
    case 'cdr': {
      expect(channel, schema, 'ros2msg');
      const reader = new ros2.MessageReader(parse(text(schema.data), {ros2: true}));
      return (data) => reader.readMessage(data);
    }
    case 'protobuf': {
      expect(channel, schema, 'protobuf');
      const type = protobuf.Root.fromDescriptor(FileDescriptorSet.decode(schema.data)).lookupType(schema.name);
      return (data) => type.toObject(type.decode(data));
    }
  }
  throw new Error(`the encoding '${channel.messageEncoding}'`);
}

const file = await open(path);
const readable = {
  size: async () => BigInt((await file.stat()).size),
  read: async (offset, length) => {
    const buffer = Buffer.alloc(Number(length));
    await file.read(buffer, 0, Number(length), Number(offset));
    return new Uint8Array(buffer);
  },
};
const reader = await McapIndexedReader.Initialize({readable, decompressHandlers: {zstd: (bytes) => fzstd.decompress(bytes)}});
const wrong = [];
const rows = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  const row = {topic: channel.topic, encoding: channel.messageEncoding, schema: schema?.name ?? '', messages: 0};
  rows.set(channel.id, row);
  try {
    row.read = readerOf(channel, schema);
  } catch (error) {
    wrong.push(`${channel.topic}: ${error.message}`);
  }
}
for await (const message of reader.readMessages({validateCrcs: true})) {
  const row = rows.get(message.channelId);
  if (!row.read) continue;
  try {
    const value = row.read(message.data);
    row.sample ??= value;
    ++row.messages;
  } catch (error) {
    wrong.push(`${row.topic}: ${error.message}`);
    row.read = undefined;
  }
}
const plain = (_, value) => typeof value === 'bigint' ? String(value) : ArrayBuffer.isView(value) ? {length: value.length} : value;
console.log(JSON.stringify({channels: [...rows.values()], wrong}, plain));
