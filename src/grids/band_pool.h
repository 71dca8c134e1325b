// Buffers for bands of rows, used again and again. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace mapwright::grids {

/// A buffer comes back by itself when its last owner lets go of it, also after the pool is gone.
class BandPool {
 public:
  explicit BandPool(std::size_t buffer_bytes);
  ~BandPool();
  /// Not initialised.
  std::shared_ptr<std::uint8_t[]> take();
  std::size_t bytes() const;  // held in all, in use or not

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace mapwright::grids
