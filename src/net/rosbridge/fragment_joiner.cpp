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
  const std::size_t place_of_piece = std::size_t(*number);
  const std::size_t cost = piece.size() + kOverhead;
  if (cost > limits_.bytes) return tl::unexpected(Fault::TooLarge);

  const auto lacksIt = [&](const Message& message) {
    return message.id == *id && message.total == *total && !message.pieces.contains(place_of_piece);
  };
  const auto hasTheSame = [&](const Message& message) {
    const auto at = message.pieces.find(place_of_piece);
    return message.id == *id && message.total == *total && at != message.pieces.end() && at->second == piece;
  };
  Place place = std::find_if(open_.begin(), open_.end(), lacksIt);
  if (place == open_.end()) {
    if (std::any_of(open_.begin(), open_.end(), hasTheSame)) return std::nullopt;  // sent twice
    if (open_.size() >= limits_.messages) {
      giveUp(open_.begin());
    }
    place = open_.emplace(open_.end());
    place->id = *id;
    place->total = *total;
    place->count = std::size_t(*total);
  }
  place->pieces.emplace(place_of_piece, std::move(piece));
  place->bytes += cost;
  place->last = now;
  held_ += cost;
  while (held_ > limits_.bytes) {
    const bool itself = open_.begin() == place;
    giveUp(open_.begin());
    if (itself) return tl::unexpected(Fault::TooLarge);
  }
  const bool all = place->pieces.size() == place->count;
  // One less, and only the last is missing.
  const bool maybe_all = *total == std::floor(*total) && place->count > 1 &&
                         place->pieces.size() == place->count - 1 &&
                         !place->pieces.contains(place->count - 1);
  if (all || (maybe_all && isWholeObject(place->pieces))) return complete(place);
  return std::nullopt;
}

void FragmentJoiner::expire(std::chrono::milliseconds now) {
  for (Place place = open_.begin(); place != open_.end();) {
    const Place next = std::next(place);
    if (now - place->last > limits_.timeout) giveUp(place);
    place = next;
  }
}

void FragmentJoiner::clear() {
  open_.clear();
  held_ = 0;
}

void FragmentJoiner::close(Place place) {
  held_ -= place->bytes;
  open_.erase(place);
}

void FragmentJoiner::giveUp(Place place) {
  ++dropped_;
  close(place);
}

std::optional<QByteArray> FragmentJoiner::complete(Place place) {
  std::size_t bytes = 0;
  for (const auto& [number, piece] : place->pieces) bytes += piece.size();
  QByteArray text;
  text.reserve(qsizetype(bytes));
  for (const auto& [number, piece] : place->pieces) text.append(piece.data(), qsizetype(piece.size()));
  close(place);
  return text;
}

}  // namespace mapwright::net::rosbridge
