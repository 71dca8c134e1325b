// One reader of foreign bytes, for libFuzzer (./test fuzz) and for the test that reads the kept corpus. A
// source defines `read` in a namespace of its own, and says MAPWRIGHT_FUZZ_TARGET(name) at its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A statement about the reader that holds for all bytes.
#define MUST(statement)                                                                        \
  do {                                                                                         \
    if (!(statement)) {                                                                        \
      std::fprintf(stderr, "%s:%d: this does not hold: %s\n", __FILE__, __LINE__, #statement); \
      std::abort();                                                                            \
    }                                                                                          \
  } while (false)

namespace mapwright::fuzz {

using Input = std::span<const std::uint8_t>;

/// The bytes on the heap, with nothing behind them: AddressSanitizer sees a reader go too far.
inline std::vector<std::uint8_t> exactly(Input bytes) {
  std::vector<std::uint8_t> copy;
  copy.reserve(bytes.size());
  copy.assign(bytes.begin(), bytes.end());
  return copy;
}
inline std::string textOf(Input bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
/// Texts are never null, also where they are empty.
inline std::string_view viewOf(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return "";
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What the first bytes of an input choose; zeros where there are no more.
class Choices {
 public:
  explicit Choices(Input bytes) : bytes_(bytes) {}
  unsigned byte() {
    if (bytes_.empty()) return 0;
    const unsigned first = bytes_[0];
    bytes_ = bytes_.subspan(1);
    return first;
  }
  unsigned twoBytes() {
    const unsigned low = byte();
    return low | byte() << 8;
  }
  Input bytes(std::size_t most) {
    const Input taken = bytes_.first(most < bytes_.size() ? most : bytes_.size());
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }
  Input rest() const { return bytes_; }

 private:
  Input bytes_;
};

/// Uses a value, so that reading it is not left out.
template <typename Value>
void use(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Makes a target known to the program that reads the corpus.
struct Registration {
  Registration(const char* name, void (*read)(Input));
};

}  // namespace mapwright::fuzz

#ifdef MAPWRIGHT_FUZZ
#define MAPWRIGHT_FUZZ_TARGET(name)                                                   \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);  \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    mapwright::fuzz::name::read({data, size});                                        \
    return 0;                                                                         \
  }
#else
#define MAPWRIGHT_FUZZ_TARGET(name) \
  static const mapwright::fuzz::Registration registered_##name(#name, &mapwright::fuzz::name::read);
#endif
