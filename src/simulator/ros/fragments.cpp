#include "simulator/ros/fragments.h"

#include "simulator/ros/value_json.h"

namespace mapwright::simulator::ros {
namespace {

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

}  // namespace mapwright::simulator::ros
