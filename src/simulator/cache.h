// What was made lately, so that it is not made again.
#pragma once

#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

namespace mapwright::simulator {

/// Keeps the items that were asked for last. Safe from any thread.
template <typename Key, typename Item>
class Cache {
 public:
  explicit Cache(std::size_t most) : most_(most) {}

  /// The item of `key`, made by make() if it is not kept. Threads that ask at once may each make it.
  template <typename Make>
  Item get(const Key& key, const Make& make) {
    if (std::optional<Item> known = find(key)) return *std::move(known);
    Item made = make();
    const std::lock_guard lock(mutex_);
    items_.emplace_front(key, made);
    if (items_.size() > most_) items_.pop_back();
    return made;
  }

  /// nullopt if it is not kept.
  std::optional<Item> find(const Key& key) {
    const std::lock_guard lock(mutex_);
    for (auto item = items_.begin(); item != items_.end(); ++item) {
      if (item->first != key) continue;
      items_.splice(items_.begin(), items_, item);
      return item->second;
    }
    return std::nullopt;
  }

 private:
  const std::size_t most_;
  std::mutex mutex_;
  std::list<std::pair<Key, Item>> items_;  // newest first
};

}  // namespace mapwright::simulator
