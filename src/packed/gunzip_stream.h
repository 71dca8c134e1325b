// Unpacks a gzip stream piece by piece, in little memory however long it is. One thread. Source: RFC 1952.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace mapwright::packed {

class GunzipStream {
 public:
  /// The next packed bytes, valid until the next call; none: there are no more.
  using More = std::function<std::span<const std::uint8_t>()>;
  enum class State : std::uint8_t {
    Going,
    Ended,    // all of it is unpacked, and its checksum is right
    Cut,      // there are no more packed bytes, and it is not over
    Corrupt,  // it is no gzip stream, or its checksum is wrong
  };

  explicit GunzipStream(More more);
  ~GunzipStream();
  /// Another stream: cheaper than another object.
  void restart(More more);
  /// Fills `out`; less than that only when it is not Going any more. Bytes behind the end are ignored.
  std::size_t read(std::span<std::uint8_t> out);
  State state() const { return state_; }

 private:
  struct Inflater;
  More more_;
  std::unique_ptr<Inflater> inflater_;
  State state_ = State::Going;
};

}  // namespace mapwright::packed
