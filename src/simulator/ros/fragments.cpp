#include "simulator/ros/fragments.h"

#include "simulator/value_json.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::int64_t kMostPieces = 1'000'000;
constexpr std::size_t kMostBytes = std::size_t{512} << 20;
constexpr std::size_t kMostMessages = 16;

bool beginsCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

}  // namespace

std::vector<std::string> fragmentsOf(std::string text, std::size_t size, const Value& id, RosWriter writer) {
  std::vector<std::string> pieces;
  std::size_t characters = 0;
  if (size > 0 && text.size() > size) {
    for (const char byte : text) {
      if (!beginsCharacter(byte)) continue;
      if (characters++ % size == 0) pieces.emplace_back();
    }
  }
  if (pieces.size() < 2) return {std::move(text)};
  const double total = static_cast<double>(characters - 1) / static_cast<double>(size) + 1;
  std::size_t at = 0;
  for (std::size_t number = 0; number < pieces.size(); ++number) {
    const std::size_t from = at;
    for (std::size_t taken = 0; at < text.size(); ++at) {
      if (beginsCharacter(text[at]) && taken++ == size) break;
    }
    pieces[number] = toJson(Value::Object{{"op", "fragment"},
                                          {"id", id.isNull() ? Value(0) : id},
                                          {"data", text.substr(from, at - from)},
                                          {"num", number},
                                          {"total", total}},
                            writer);
  }
  return pieces;
}

std::optional<std::string> FragmentShelf::take(const Value& piece, std::string& complaint) {
  const std::int64_t* const number = piece["num"].as<std::int64_t>();
  const std::int64_t* const total = piece["total"].as<std::int64_t>();
  const std::string* const data = piece["data"].as<std::string>();
  const std::int64_t* const id = piece["id"].as<std::int64_t>();
  const std::string name = id != nullptr ? std::to_string(*id) : piece["id"].text();
  if (number == nullptr || total == nullptr || data == nullptr || name.empty() || *total < 1 ||
      *total > kMostPieces || *number < 0 || *number >= *total) {
    complaint = "A field of fragment is missing or of another type";
    return std::nullopt;
  }
  if (messages_.count(name) == 0 && messages_.size() >= kMostMessages) messages_.erase(messages_.begin());
  Message& message = messages_[name];
  if (message.total == 0) message.total = static_cast<std::size_t>(*total);
  message.bytes += data->size();
  if (message.total != static_cast<std::size_t>(*total) || message.bytes > kMostBytes) {
    messages_.erase(name);
    complaint = "The pieces of a message do not fit together";
    return std::nullopt;
  }
  message.pieces[static_cast<std::size_t>(*number)] = *data;
  if (message.pieces.size() < message.total) return std::nullopt;
  std::string whole;
  whole.reserve(message.bytes);
  for (const auto& [at, text] : message.pieces) whole += text;
  messages_.erase(name);
  return whole;
}

}  // namespace mapwright::simulator::ros
