#include "net/rosbridge/fragment_joiner.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace mapwright::net::rosbridge {
namespace {

constexpr std::size_t kOverhead = 128;  // bytes of memory per piece besides its own

std::optional<std::string> idOf(const Field& id) {
  if (id.isNull()) return "";
  if (id.isText()) return 't' + id.text();
  const std::optional<std::int64_t> whole = id.integer();
  return whole && id.isNumber() ? std::optional('n' + std::to_string(*whole)) : std::nullopt;
}

/// Whether the concatenated text is one JSON object from its first to its last brace: checks only brackets
/// and strings. A part of an object never is.
bool isWholeObject(const std::map<std::size_t, std::string>& pieces) {
  const std::string& last = pieces.rbegin()->second;
  const std::size_t end = last.find_last_not_of(" \t\r\n");
  if (end == std::string::npos || last[end] != '}') return false;
  long depth = 0;
  bool in_string = false, escaped = false;
  for (const auto& [number, piece] : pieces) {
    for (const char c : piece) {
      if (escaped) {
        escaped = false;
      } else if (in_string) {
        escaped = c == '\\';
        in_string = c != '"';
      } else if (c == '"') {
        in_string = true;
      } else if (c == '{' || c == '[') {
        ++depth;
      } else if (c == '}' || c == ']') {
        --depth;
      }
    }
  }
  return depth == 0 && !in_string;
}

}  // namespace

tl::expected<std::optional<QByteArray>, FragmentJoiner::Fault> FragmentJoiner::add(
    const Field& fragment, std::chrono::milliseconds now) {
  const std::optional<std::string> id = idOf(fragment["id"]);
  const std::optional<std::int64_t> number = fragment["num"].integer();
  const std::optional<double> total = fragment["total"].number();
  const Field data = fragment["data"];
  if (!id || id->size() > 256 || !number || !total || !data.isText() || *number < 0 || *total < 1 ||
      double(*number) >= std::floor(*total)) {
    return tl::unexpected(Fault::Malformed);
  }
  if (*total >= double(limits_.pieces) + 1) return tl::unexpected(Fault::TooLarge);
  std::string piece = data.text();
  const std::size_t piece_index = std::size_t(*number);
  const std::size_t cost = piece.size() + kOverhead;
  if (cost > limits_.bytes) return tl::unexpected(Fault::TooLarge);

  const auto lacksIt = [&](const Message& message) {
    return message.id == *id && message.total == *total && !message.pieces.contains(piece_index);
  };
  const auto hasTheSame = [&](const Message& message) {
    const auto at = message.pieces.find(piece_index);
    return message.id == *id && message.total == *total && at != message.pieces.end() && at->second == piece;
  };
  Iterator entry = std::find_if(open_.begin(), open_.end(), lacksIt);
  if (entry == open_.end()) {
    if (std::any_of(open_.begin(), open_.end(), hasTheSame)) return std::nullopt;  // sent twice
    if (open_.size() >= limits_.messages) {
      giveUp(open_.begin());
    }
    entry = open_.emplace(open_.end());
    entry->id = *id;
    entry->total = *total;
    entry->count = std::size_t(*total);
  }
  entry->pieces.emplace(piece_index, std::move(piece));
  entry->bytes += cost;
  entry->last = now;
  held_ += cost;
  while (held_ > limits_.bytes) {
    const bool itself = open_.begin() == entry;
    giveUp(open_.begin());
    if (itself) return tl::unexpected(Fault::TooLarge);
  }
  const bool all = entry->pieces.size() == entry->count;
  // One less, and only the last is missing.
  const bool maybe_all = *total == std::floor(*total) && entry->count > 1 &&
                         entry->pieces.size() == entry->count - 1 &&
                         !entry->pieces.contains(entry->count - 1);
  if (all || (maybe_all && isWholeObject(entry->pieces))) return complete(entry);
  return std::nullopt;
}

void FragmentJoiner::expire(std::chrono::milliseconds now) {
  for (Iterator entry = open_.begin(); entry != open_.end();) {
    const Iterator next = std::next(entry);
    if (now - entry->last > limits_.timeout) giveUp(entry);
    entry = next;
  }
}

void FragmentJoiner::clear() {
  open_.clear();
  held_ = 0;
}

void FragmentJoiner::close(Iterator entry) {
  held_ -= entry->bytes;
  open_.erase(entry);
}

void FragmentJoiner::giveUp(Iterator entry) {
  ++dropped_;
  close(entry);
}

std::optional<QByteArray> FragmentJoiner::complete(Iterator entry) {
  std::size_t bytes = 0;
  for (const auto& [number, piece] : entry->pieces) bytes += piece.size();
  QByteArray text;
  text.reserve(qsizetype(bytes));
  for (const auto& [number, piece] : entry->pieces) text.append(piece.data(), qsizetype(piece.size()));
  close(entry);
  return text;
}

}  // namespace mapwright::net::rosbridge
