#include "simulator/value_cbor.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "simulator/png_writing.h"

namespace mapwright::simulator {
namespace {

static_assert(std::endian::native == std::endian::little, "typed arrays are copied as they lie in memory");

enum Major : unsigned {
  kUnsigned = 0,
  kNegative = 1,
  kByteString = 2,
  kText = 3,
  kList = 4,
  kMap = 5,
  kTag = 6
};
constexpr std::uint64_t kInt8Tag = 72, kFloat32Tag = 85, kFloat64Tag = 86;

class CborWriter {
 public:
  explicit CborWriter(std::string& out) : out_(out) {}

  /// false when the message is one that servers lose.
  bool write(const Value& value) {
    return std::visit([this](const auto& data) { return put(data); }, value.data());
  }

 private:
  void head(Major major, std::uint64_t argument) {
    const unsigned bytes = argument < 24               ? 0
                           : argument <= 0xFF          ? 1
                           : argument <= 0xFFFF        ? 2
                           : argument <= 0xFFFF'FFFFUL ? 4
                                                       : 8;
    const std::uint64_t low = bytes == 0   ? argument
                              : bytes == 1 ? 24
                              : bytes == 2 ? 25
                              : bytes == 4 ? 26
                                           : 27;
    out_ += static_cast<char>(major << 5 | low);
    for (unsigned i = bytes; i > 0; --i) out_ += static_cast<char>((argument >> (8 * (i - 1))) & 0xFF);
  }
  void bytes(const void* data, std::size_t size) {
    head(kByteString, size);
    out_.append(static_cast<const char*>(data), size);
  }
  void text(std::string_view text) {
    head(kText, text.size());
    out_ += text;
  }

  bool put(std::monostate) {
    out_ += '\xF6';
    return true;
  }
  bool put(bool flag) {
    out_ += flag ? '\xF5' : '\xF4';
    return true;
  }
  bool put(std::int64_t number) {
    if (number >= 0) {
      head(kUnsigned, static_cast<std::uint64_t>(number));
    } else {
      head(kNegative, static_cast<std::uint64_t>(-(number + 1)));
    }
    return true;
  }
  bool put(double number) {
    out_ += '\xFB';
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int shift = 56; shift >= 0; shift -= 8) out_ += static_cast<char>((bits >> shift) & 0xFF);
    return true;
  }
  bool put(const std::string& string) {
    text(string);
    return true;
  }
  bool put(const Value::List& list) {
    if (!list.empty() && list.front().as<std::string>() != nullptr) return false;
    head(kList, list.size());
    for (const Value& item : list) {
      if (!write(item)) return false;
    }
    return true;
  }
  bool put(const Value::Object& members) {
    head(kMap, members.size());
    for (const auto& [name, value] : members) {
      text(name);
      if (!write(value)) return false;
    }
    return true;
  }
  bool put(const Value::Json&) { return put(std::monostate()); }
  bool put(const Value::Bytes& data) {
    bytes(data.data.data(), data.data.size());
    return true;
  }
  template <typename T>
  bool put(const std::vector<T>& numbers) {
    head(kTag, std::is_same_v<T, std::int8_t> ? kInt8Tag
               : std::is_same_v<T, float>     ? kFloat32Tag
                                              : kFloat64Tag);
    bytes(numbers.data(), numbers.size() * sizeof(T));
    return true;
  }

  std::string& out_;
};

}  // namespace

std::optional<std::string> toCbor(const Value& value) {
  std::string out;
  if (!CborWriter(out).write(value)) return std::nullopt;
  return out;
}

std::string toPng(std::string_view json) {
  const double pixels = static_cast<double>(json.size()) / 3;
  const auto width = std::max(1, static_cast<int>(std::sqrt(pixels)));
  const auto height = std::max(1, static_cast<int>(std::ceil(pixels / width)));
  std::string padded(json);
  padded.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\n');
  return R"({"op":"png","data":")" + base64(writeRgbPng(width, height, padded)) + "\"}";
}

}  // namespace mapwright::simulator
