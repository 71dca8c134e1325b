#include "robot/axbot/parse_bags.h"

#include <algorithm>
#include <utility>

#include <QDateTime>
#include <QLocale>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/plain_messages.h"
#include "robot/wire/read_json.h"
#include "words/qt_versions.h"

namespace mapwright::robot::axbot {
namespace {

auto wrong(Fault reason) { return tl::make_unexpected(std::move(reason)); }

Fault notJson(std::string_view utf8) { return {fault::MessageNotJson, {std::int64_t(utf8.size())}}; }

/// "31-Oct-2023 14:36:17", always in English.
std::optional<double> listedTime(const std::string& text) {
  const QDateTime time =
      QLocale::c().toDateTime(QString::fromStdString(text), QStringLiteral("d-MMM-yyyy HH:mm:ss"));
  return time.isValid() ? std::optional(double(words::takenAsUtc(time).toSecsSinceEpoch())) : std::nullopt;
}

std::optional<BagEntry> readRow(const wire::Json& row, BagKind kind) {
  BagEntry entry;
  entry.key = {kind, wire::text(row, {"filename", "name"})};
  if (entry.key.name.empty()) return std::nullopt;
  entry.size_bytes = wire::integer(row, {"size_bytes"});
  entry.size_text = wire::text(row, {"size"});
  entry.end_text = wire::text(row, {"end"});
  entry.end_s = listedTime(entry.end_text);
  if (!entry.end_s) entry.end_s = wire::epochSeconds(row, {"end", "end_time"});
  return entry;
}

/// A buffer with the padding that simdjson needs.
std::shared_ptr<const std::string> padded(std::string_view utf8) {
  auto text = std::make_shared<std::string>();
  text->reserve(utf8.size() + simdjson::SIMDJSON_PADDING);
  text->assign(utf8);
  return text;
}

/// Invalid UTF-8 in one message would make the whole range unreadable.
std::shared_ptr<const std::string> validText(std::string_view bytes) {
  if (simdjson::validate_utf8(bytes.data(), bytes.size())) return padded(bytes);
  const QByteArray repaired = QString::fromUtf8(bytes.data(), qsizetype(bytes.size())).toUtf8();
  return padded({repaired.constData(), std::size_t(repaired.size())});
}

class ChunkReader {
 public:
  explicit ChunkReader(BagChunk& chunk) : chunk_(chunk) {}

  /// A message, or something else. false: it is not JSON at all.
  bool add(std::string_view json) {
    const std::optional<wire::Json> root = read(json);
    if (!root || !root->is_object()) {
      ++chunk_.unreadable;
      return root.has_value();
    }
    const std::optional<double> stamp_s = wire::number(*root, {"__stamp"});
    if (!stamp_s) {
      ++chunk_.without_stamp;
      return true;
    }
    TextFrame frame = readFrame(*root);
    BagMessage message;
    message.latched = wire::flag(*root, {"__latched"}).value_or(false);
    message.message.received_s = *stamp_s;
    message.message.recorded_s = wire::epochSeconds(*root, {"stamp"});
    message.known = frame.message || frame.grid_to_fetch;
    if (frame.message) {
      message.message.message = std::move(*frame.message);
    } else if (frame.grid_to_fetch) {
      message.message.message = std::move(frame.grid_to_fetch->grid);
      message.picture_url = std::move(frame.grid_to_fetch->data_url);
    } else {
      message.message.message = map::UnreadableMessage{frame.topic, {}};
    }
    message.message.topic = std::move(frame.topic);
    keep(std::move(message), json);
    plain_.remember(json, chunk_.messages.back(), chunk_.messages.size() - 1);
    return true;
  }

  /// The end of the message at `at`, if it could be read quickly; otherwise nullptr.
  const char* addPlain(const char* at) {
    BagMessage message;
    if (const char* end = plain_.read(at, message)) {
      keep(std::move(message), {at, std::size_t(end - at)});
      return end;
    }
    std::size_t of = 0;
    double stamp_s = 0;
    const char* const end = plain_.readAgain(at, of, stamp_s);
    if (!end) return nullptr;
    message = chunk_.messages[of];
    message.message.received_s = stamp_s;
    keep(std::move(message), {at, std::size_t(end - at)});
    return end;
  }

 private:
  /// More text follows the message, so nothing has to be copied.
  std::optional<wire::Json> read(std::string_view json) {
    wire::Json root;
    if (!parser_.parse(json.data(), json.size(), false).get(root)) return root;
    return lenient_.read(json);
  }

  void keep(BagMessage message, std::string_view json) {
    message.at = std::size_t(json.data() - chunk_.text->data());
    message.size = json.size();
    chunk_.messages.push_back(std::move(message));
    // Once the typical length is known, memory is reserved for all.
    constexpr std::size_t kEnough = 256;
    if (chunk_.messages.size() == kEnough) {
      const std::size_t read = chunk_.messages.back().at + json.size();
      chunk_.messages.reserve(
          std::max(kEnough, std::size_t(1.1 * kEnough * double(chunk_.text->size()) / double(read))));
    }
  }

  BagChunk& chunk_;
  PlainMessages plain_;
  simdjson::dom::parser parser_;
  wire::JsonReader lenient_;
};

void clear(BagChunk& chunk) {
  chunk.messages.clear();
  chunk.without_stamp = chunk.unreadable = 0;
}

/// The elements of the list at the cursor. Each is read in place; as all are valid JSON, so is the list.
bool readList(JsonCursor& json, const char* end, ChunkReader& reader, BagChunk& chunk) {
  if (!json.consume('[')) return false;
  if (json.peek() == ']') return json.consume(']');
  do {
    if (json.peek() != '{') {
      if (!json.readScalar()) return false;
      ++chunk.unreadable;
      continue;
    }
    const char* const start = json.at();
    const char* behind = reader.addPlain(start);
    if (!behind) {
      behind = endOfNested(start, end);
      if (!behind || !reader.add({start, std::size_t(behind - start)})) return false;
    }
    json = JsonCursor(behind);
  } while (json.consume(','));
  return json.consume(']');
}

/// Reads the messages of chunk.text in one pass. false: unusual formatting, or not JSON; nothing was read.
bool readQuickly(BagChunk& chunk) {
  clear(chunk);
  const char* const end = chunk.text->data() + chunk.text->size();
  ChunkReader reader(chunk);
  JsonCursor json(chunk.text->c_str());
  json.skipSpace();
  if (!json.consume('{')) return false;
  bool has_messages = false;
  do {
    std::string_view key;
    if (!json.readString(key) || !json.consume(':')) return false;
    if (key != "messages") {
      if (!json.readScalar()) return false;
    } else if (std::exchange(has_messages, true) || !readList(json, end, reader, chunk)) {
      return false;
    }
  } while (json.consume(','));
  return has_messages && json.consume('}') && json.at() == end;
}

/// The same for any JSON; returns what is wrong with the text as a whole. On failure there are no messages.
std::optional<Fault> readMessages(BagChunk& chunk) {
  namespace ondemand = simdjson::ondemand;
  clear(chunk);
  const Fault no_json = notJson(*chunk.text);
  ondemand::parser parser;
  ondemand::document document;
  const simdjson::padded_string_view text(chunk.text->data(), chunk.text->size(), chunk.text->capacity());
  if (parser.iterate(text).get(document)) return no_json;
  ondemand::object root;
  if (document.get_object().get(root)) return no_json;
  ondemand::array messages;
  if (const auto error = root.find_field_unordered("messages").get_array().get(messages)) {
    const bool absent = error == simdjson::NO_SUCH_FIELD || error == simdjson::INCORRECT_TYPE;
    return absent ? Fault(faultText("axbot", "the answer contains no list of messages")) : no_json;
  }
  ChunkReader reader(chunk);
  for (auto each : messages) {
    ondemand::value value;
    ondemand::json_type type{};
    if (each.get(value) || value.type().get(type)) return no_json;
    if (type != ondemand::json_type::object) {
      ++chunk.unreadable;
      continue;
    }
    ondemand::object message;
    std::string_view json;
    if (value.get_object().get(message) || message.raw_json().get(json)) return no_json;
    reader.add(json.substr(0, json.rfind('}') + 1));
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::vector<BagEntry>, Fault> parseBagRows(std::string_view utf8, BagKind kind) {
  wire::JsonReader json;
  const auto root = json.read(utf8);
  if (!root) return wrong(notJson(utf8));
  const auto rows = wire::asList(*root, {"bags", "recordings", "files"});
  if (!rows) return wrong(fault::AnswerIsNoList);
  std::vector<BagEntry> entries;
  for (const wire::Json row : *rows) {
    if (auto entry = readRow(row, kind)) entries.push_back(std::move(*entry));
  }
  return entries;
}

std::optional<BagEntry> parseBagRow(std::string_view utf8, BagKind kind) {
  wire::JsonReader json;
  const auto root = json.read(utf8);
  return root ? readRow(*root, kind) : std::nullopt;
}

tl::expected<BagInfo, Fault> parseBagInfo(std::string_view utf8) {
  wire::JsonReader json;
  const auto root = json.read(utf8);
  if (!root) return wrong(notJson(utf8));
  BagInfo info;
  auto messages = wire::integer(*root, {"total_messages"});
  if (messages && *messages < 0) messages.reset();
  const auto start_s = wire::number(*root, {"start_time"}), end_s = wire::number(*root, {"end_time"});
  // A bag without messages has no start and end.
  if (!(start_s && end_s) && messages != 0)
    return wrong(faultText("axbot", "the answer does not contain its start and end time"));
  info.messages = messages;
  info.start_s = start_s.value_or(0);
  info.end_s = end_s.value_or(info.start_s);
  return info;
}

tl::expected<BagChunk, Fault> parseBagChunk(std::string_view utf8, const BagRange& range) {
  BagChunk chunk;
  chunk.from_s = range.from_s;
  chunk.until_s = range.until_s;
  chunk.text = validText(utf8);
  if (readQuickly(chunk)) return chunk;
  if (auto why = readMessages(chunk)) return wrong(*std::move(why));
  return chunk;
}

}  // namespace mapwright::robot::axbot
