#include "recording/note.h"

#include <algorithm>

namespace mapwright::recording {

namespace {
constexpr std::size_t kMostNotes = 200;  // names come from the file
}

void Notes::add(NoteCode code, std::uint64_t offset, std::string_view name, std::uint64_t count) {
  const auto same = [&](const Note& note) { return note.code == code && note.name == name; };
  const auto found = std::find_if(notes_.begin(), notes_.end(), same);
  if (found != notes_.end()) {
    found->count += count;
    return;
  }
  if (notes_.size() < kMostNotes) notes_.push_back({code, offset, count, std::string(name)});
}

void Notes::drop(NoteCode code) {
  std::erase_if(notes_, [&](const Note& note) { return note.code == code; });
}

}  // namespace mapwright::recording
