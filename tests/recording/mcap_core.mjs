// Reads or writes a recording with the public reader of MCAP, @mcap/core, for test_mcap_core.
//   node mcap_core.mjs read PACKAGES FILE    what is in it, as JSON
//   node mcap_core.mjs write PACKAGES FILE   a recording of its own
import {createRequire} from 'node:module';
import {open, writeFile} from 'node:fs/promises';

const [mode, packages, path] = process.argv.slice(2);
const require = createRequire(packages + '/');
const {McapIndexedReader, McapStreamReader, McapWriter, TempBuffer} = require('@mcap/core');
const fzstd = require('fzstd');
const decompressHandlers = {zstd: (bytes) => fzstd.decompress(bytes)};

async function read() {
  const file = await open(path);
  const readable = {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, length) => {
      const buffer = Buffer.alloc(Number(length));
      await file.read(buffer, 0, Number(length), Number(offset));
      return new Uint8Array(buffer);
    },
  };
  const out = {messages: [], streamed: 0, attachments: [], metadata: []};
  const reader = await McapIndexedReader.Initialize({readable, decompressHandlers});
  out.profile = reader.header.profile;
  out.counted = String(reader.statistics.messageCount);
  for await (const message of reader.readMessages({validateCrcs: true})) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    out.messages.push({
      topic: channel.topic, encoding: channel.messageEncoding, schema: schema?.name, log: String(message.logTime),
      sequence: message.sequence, data: Buffer.from(message.data).toString('base64'),
    });
  }
  for await (const attachment of reader.readAttachments({validateCrcs: true})) {
    out.attachments.push({name: attachment.name, size: attachment.data.byteLength});
  }
  for await (const metadata of reader.readMetadata()) {
    out.metadata.push({name: metadata.name, words: Object.fromEntries(metadata.metadata)});
  }
  // From start to end, which looks at the checksums of chunks, data and summary too.
  const stream = new McapStreamReader({decompressHandlers, validateCrcs: true});
  const {size} = await file.stat();
  const bytes = Buffer.alloc(size);
  await file.read(bytes, 0, size, 0);
  stream.append(bytes);
  for (let record; (record = stream.nextRecord()) != undefined;) {
    if (record.type === 'Message') ++out.streamed;
  }
  out.done = stream.done();
  console.log(JSON.stringify(out));
}

async function write() {
  const parts = [];
  let size = 0n;
  const writable = {
    write: async (bytes) => { parts.push(Buffer.from(bytes)); size += BigInt(bytes.byteLength); },
    position: () => size,
  };
  const writer = new McapWriter({writable, chunkSize: 500});
  await writer.start({profile: 'x', library: 'theirs'});
  const schemaId = await writer.registerSchema({name: 'S', encoding: 'jsonschema', data: Buffer.from('{}')});
  const ids = [];
  for (const topic of ['/one', '/two']) {
    ids.push(await writer.registerChannel({schemaId, topic, messageEncoding: 'json', metadata: new Map([['k', 'v']])}));
  }
  for (let i = 0; i < 200; ++i) {
    await writer.addMessage({
      channelId: ids[i % 2], sequence: i, logTime: BigInt(1000 + i * 10 - (i % 5) * 25), publishTime: 1n,
      data: Buffer.from(JSON.stringify({i})),
    });
  }
  await writer.addAttachment({logTime: 5n, createTime: 4n, name: 'a.txt', mediaType: 'text/plain', data: Buffer.from('hello')});
  await writer.addMetadata({name: 'm', metadata: new Map([['a', 'b']])});
  await writer.end();
  await writeFile(path, Buffer.concat(parts));
}

await (mode === 'read' ? read() : write());
