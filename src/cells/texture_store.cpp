#include "cells/texture_store.h"

#include <utility>

#include "cells/cell_levels.h"
#include "disk/scratch_file.h"

namespace mapwright::cells {

TextureStore::TextureStore(Options options, Listener listener)
    : options_(std::move(options)),
      listener_(std::move(listener)),
      file_(std::make_unique<disk::ScratchFile>(options_.folder)) {}

TextureStore::~TextureStore() = default;

std::shared_ptr<TextureStore> TextureStore::make(Options options, Listener listener) {
  return std::shared_ptr<TextureStore>(new TextureStore(std::move(options), std::move(listener)));
}

void TextureStore::silence() {
  const std::lock_guard telling(told_);
  listener_ = {};
}

void TextureStore::keep(const CellTexture& texture, std::uint64_t owner) {
  std::unique_lock lock(mutex_);
  std::uint32_t index = std::uint32_t(entries_.size());
  if (free_indexes_.empty()) {
    entries_.emplace_back();
  } else {
    index = free_indexes_.back();
    free_indexes_.pop_back();
  }
  Entry& entry = entries_[index];
  entry.bytes = texture.bytes();
  entry.owner = owner;
  admit(index, std::exchange(texture.body_, nullptr));
  texture.index_ = index;
  texture.store_ = shared_from_this();
  makeRoom(lock);
}

void TextureStore::admit(std::uint32_t index, BodyPtr body) {
  Entry& entry = entries_[index];
  entry.body = std::move(body);
  recent_.push_front(index);
  entry.used = recent_.begin();
  in_memory_ += entry.bytes;
}

TextureStore::BodyPtr TextureStore::bodyOf(const CellTexture& texture) {
  std::unique_lock lock(mutex_);
  Entry& entry = entries_[texture.index_];
  if (entry.body) {
    recent_.splice(recent_.begin(), recent_, entry.used);
    return entry.body;
  }
  if (entry.is_lost) return nullptr;
  const Range range = entry.on_disk;
  lock.unlock();
  // The texture exists, so its index is reserved.
  std::vector<std::uint8_t> packed(range.size);
  auto body = std::make_shared<Body>(texture.width(), texture.height(), texture.layout());
  const bool whole = file_->read(packed, range.at) && body->unpack(packed);
  lock.lock();
  Entry& again = entries_[texture.index_];
  if (again.body) return again.body;
  if (!whole) {
    if (std::exchange(again.is_lost, true)) return nullptr;
    ++lost_;
    const std::uint64_t owner = again.owner;
    lock.unlock();
    const std::lock_guard telling(told_);
    if (listener_.lost) listener_.lost(owner);
    return nullptr;
  }
  admit(texture.index_, body);
  makeRoom(lock);
  return body;
}

void TextureStore::makeRoom(std::unique_lock<std::mutex>& lock) {
  auto at = recent_.end();
  while (in_memory_ > options_.budget_bytes && at != recent_.begin()) {
    const std::uint32_t index = *--at;
    Entry& entry = entries_[index];
    if (entry.leaving) continue;
    if (entry.on_disk.size > 0) {
      in_memory_ -= entry.bytes;
      entry.body.reset();
      at = recent_.erase(at);
      continue;
    }
    if (no_room_) return;
    entry.leaving = true;
    const BodyPtr body = entry.body;
    const std::uint32_t tenant = entry.tenant;
    lock.unlock();
    const std::vector<std::uint8_t> packed = body->packed();
    lock.lock();
    const Range range = allocateRange(packed.size());
    lock.unlock();
    const std::string why = file_->write(packed, range.at);
    lock.lock();
    Entry& written = entries_[index];
    if (written.tenant != tenant || !why.empty()) giveBack(range);
    if (written.tenant == tenant) {
      written.leaving = false;
      if (why.empty()) written.on_disk = range;
    }
    if (!why.empty()) {
      no_room_ = true;
      lock.unlock();
      const std::lock_guard telling(told_);
      if (listener_.no_room) listener_.no_room(why);
      return;
    }
    at = recent_.end();  // others may have changed it meanwhile
  }
}

TextureStore::Range TextureStore::allocateRange(std::size_t size) {
  on_disk_ += size;
  const auto gap = gaps_.lower_bound(size);
  if (gap == gaps_.end()) return {std::exchange(file_end_, file_end_ + size), size};
  const Range range{gap->second, size};
  const std::size_t rest = gap->first - size;
  gaps_.erase(gap);
  if (rest > 0) gaps_.emplace(rest, range.at + size);
  return range;
}

void TextureStore::giveBack(Range range) {
  if (range.size == 0) return;
  on_disk_ -= range.size;
  gaps_.emplace(range.size, range.at);
}

void TextureStore::forget(std::uint32_t index) {
  BodyPtr body;  // goes after the lock
  const std::lock_guard lock(mutex_);
  Entry& entry = entries_[index];
  if (entry.body) {
    in_memory_ -= entry.bytes;
    recent_.erase(entry.used);
    body = std::move(entry.body);
  }
  giveBack(entry.on_disk);
  const std::uint32_t tenant = entry.tenant + 1;
  entry = {};
  entry.tenant = tenant;
  free_indexes_.push_back(index);
}

std::size_t TextureStore::bytesInMemory() const {
  const std::lock_guard lock(mutex_);
  return in_memory_;
}

std::size_t TextureStore::bytesOnDisk() const {
  const std::lock_guard lock(mutex_);
  return on_disk_;
}

std::size_t TextureStore::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

}  // namespace mapwright::cells
