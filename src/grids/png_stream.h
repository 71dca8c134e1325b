// The unpacked bytes of a PNG's pixel stream (IDAT). One thread.
// Source: PNG specification (third edition), "IDAT Image data"; RFC 1950.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "fault/fault.h"
#include "grids/byte_source.h"

struct inflate_state;

namespace mapwright::grids {

class PngStream {
 public:
  /// `at`: offset of the first IDAT chunk.
  PngStream(ByteSource bytes, std::uint64_t at);
  ~PngStream();
  /// The next `count` bytes, valid until the next call; null if they are missing: see problem().
  const std::uint8_t* take(std::size_t count);
  /// Checks the checksums after the last byte that is needed. False: see problem().
  bool checkEnd();
  /// "its data ends", "its checksum is wrong", .. ; empty = nothing is wrong.
  const Fault& problem() const { return problem_; }
  std::uint64_t compressedBytes() const { return bytes_.size(); }

 private:
  bool nextInput();
  bool enterChunk();
  bool endChunk();
  bool fill(std::size_t count);

  ByteSource bytes_;
  std::uint64_t at_;        // of the next input byte or chunk
  std::uint32_t left_ = 0;  // input bytes of the chunk not yet used
  bool in_chunk_ = false;
  std::uint32_t sum_ = 0;
  std::unique_ptr<inflate_state> state_;
  std::vector<std::uint8_t> window_;
  std::size_t begin_ = 0, end_ = 0;  // unpacked, not yet taken
  Fault problem_;
};

}  // namespace mapwright::grids
