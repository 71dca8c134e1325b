// Stores the cells of many textures: in memory up to the budget, the rest on disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cells/cell_texture.h"

namespace mapwright::disk {
class ScratchFile;
}

namespace mapwright::cells {

/// Thread-safe. The least recently used textures are written once to an unnamed file and read back on demand:
/// reading from disk is many times faster than decoding again. Cells stay in memory while anyone holds them.
/// Textures keep their store alive.
class TextureStore : public std::enable_shared_from_this<TextureStore> {
 public:
  struct Options {
    std::size_t budget_bytes = std::size_t(256) << 20;
    std::string folder = {};  // for the file; empty = the system's folder for temporary files
  };
  /// Called on any thread, never while the store is locked.
  struct Listener {
    /// The cells of a texture of this owner cannot be read back. They are no longer drawn.
    std::function<void(std::uint64_t owner)> lost;
    /// The disk is full: the text that follows "cannot be written: ". Reported once; the cells stay in
    /// memory.
    std::function<void(const std::string& why)> no_room;
  };
  static std::shared_ptr<TextureStore> make(Options options, Listener listener = {});
  ~TextureStore();
  /// Stops notifications. Waits for one in progress before it returns.
  void silence();

  /// Stores the cells from now on. Precondition: nobody else has the texture yet, and it is in no store.
  void keep(const CellTexture& texture, std::uint64_t owner = 0);

  std::size_t bytesInMemory() const;
  std::size_t bytesOnDisk() const;
  /// Number of lost textures.
  std::size_t lost() const;

 private:
  friend class CellTexture;
  using Body = CellTexture::Body;
  using BodyPtr = std::shared_ptr<const Body>;
  struct Range {
    std::uint64_t at = 0;
    std::size_t size = 0;
  };
  struct Entry {
    BodyPtr body;  // null: on disk alone, or lost
    std::size_t bytes = 0;
    Range on_disk;  // size 0: not yet
    std::uint64_t owner = 0;
    std::list<std::uint32_t>::iterator used;  // while `body` is set
    std::uint32_t tenant = 0;                 // number of textures that have used this entry
    bool leaving = false;                     // is being written
    bool is_lost = false;
  };
  explicit TextureStore(Options options, Listener listener);
  BodyPtr bodyOf(const CellTexture& texture);
  void forget(std::uint32_t index);
  void admit(std::uint32_t index, BodyPtr body);
  void makeRoom(std::unique_lock<std::mutex>& lock);
  Range allocateRange(std::size_t size);
  void giveBack(Range range);

  const Options options_;
  mutable std::mutex mutex_;
  std::mutex told_;  // locked while the listener is called
  Listener listener_;
  const std::unique_ptr<disk::ScratchFile> file_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_indexes_;
  std::list<std::uint32_t> recent_;                 // most recently used first
  std::multimap<std::size_t, std::uint64_t> gaps_;  // in the file, by size
  std::uint64_t file_end_ = 0;
  std::size_t in_memory_ = 0, on_disk_ = 0, lost_ = 0;
  bool no_room_ = false;
};

}  // namespace mapwright::cells
