// Reusable buffers for bands of rows. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace mapwright::grids {

/// A buffer returns to the pool when its last owner releases it, even if the pool is gone.
class BandPool {
 public:
  explicit BandPool(std::size_t buffer_bytes);
  ~BandPool();
  /// Not initialised.
  std::shared_ptr<std::uint8_t[]> take();
  std::size_t bytes() const;  // allocated in total, in use or not

 private:
  struct Shelf;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace mapwright::grids
