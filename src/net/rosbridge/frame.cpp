#include "net/rosbridge/frame.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QString>
#include <simdjson.h>
#include <spng.h>

#include "net/json_numbers.h"
#include "net/rosbridge/access.h"
#include "net/rosbridge/cbor_item.h"

namespace mapwright::net::rosbridge {
namespace {

constexpr std::size_t kMostUnpacked = 1032;  // bytes that one byte of deflate can expand to

/// The code unit of `\uXXXX` at `at`.
std::optional<unsigned> unitAt(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) != "\\u" || text.size() - at < 6) return std::nullopt;
  unsigned unit = 0;
  const char* const end = text.data() + at + 6;
  return std::from_chars(text.data() + at + 2, end, unit, 16).ptr == end ? std::optional(unit) : std::nullopt;
}

/// Appends the string that starts at `i`; returns its end.
std::size_t copyString(std::string_view text, std::size_t i, QByteArray& out) {
  const auto copy = [&](std::size_t bytes) {
    bytes = std::min(bytes, text.size() - i);
    out.append(text.data() + i, qsizetype(bytes));
    i += bytes;
  };
  copy(1);
  while (i < text.size() && text[i] != '"') {
    if (text[i] != '\\') {
      const std::size_t next = text.find_first_of("\"\\", i);
      copy(next == std::string_view::npos ? text.size() - i : next - i);
    } else if (const auto unit = unitAt(text, i); unit && *unit >= 0xd800 && *unit < 0xe000) {
      const auto second = unitAt(text, i + 6);
      if (*unit < 0xdc00 && second && *second >= 0xdc00 && *second < 0xe000) {
        copy(12);
      } else {
        out += "\\ufffd";
        i += 6;
      }
    } else {
      copy(2);
    }
  }
  copy(1);
  return i;
}

/// The almost valid JSON of some servers with NaN, Infinity, -Infinity and numbers out of range replaced by
/// null, and, within strings, invalid UTF-8 and unpaired surrogates by U+FFFD. Other errors stay.
QByteArray repairJson(const QByteArray& text) {
  const bool readable = simdjson::validate_utf8(text.constData(), std::size_t(text.size()));
  const QByteArray source = readable ? text : QString::fromUtf8(text).toUtf8();
  const std::string repaired = repairNumbers({source.constData(), std::size_t(source.size())});
  const std::string_view all = repaired;
  QByteArray result;
  result.reserve(qsizetype(all.size()));
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t quote = std::min(all.find('"', i), all.size());
    result.append(all.data() + i, qsizetype(quote - i));
    i = quote < all.size() ? copyString(all, quote, result) : quote;
  }
  return result;
}

}  // namespace

std::optional<QByteArray> textOfPng(std::string_view png, std::size_t max) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> reader(spng_ctx_new(0), &spng_ctx_free);
  spng_ihdr header{};
  if (!reader || spng_set_png_buffer(reader.get(), png.data(), png.size()) != 0 ||
      spng_get_ihdr(reader.get(), &header) != 0) {
    return std::nullopt;
  }
  if (header.color_type != SPNG_COLOR_TYPE_TRUECOLOR || header.bit_depth != 8) return std::nullopt;
  // Each side has at most 31 bits.
  const std::uint64_t pixels = std::uint64_t(header.width) * header.height;
  if (pixels > max / 3 || pixels * 3 / kMostUnpacked > png.size()) return std::nullopt;
  std::size_t bytes = 0;
  if (spng_decoded_image_size(reader.get(), SPNG_FMT_RGB8, &bytes) != 0 || bytes > max) return std::nullopt;
  QByteArray text(qsizetype(bytes), Qt::Uninitialized);
  if (spng_decode_image(reader.get(), text.data(), bytes, SPNG_FMT_RGB8, 0) != 0) return std::nullopt;
  qsizetype end = text.size();
  while (end > 0 && (text[end - 1] == '\n' || text[end - 1] == '\0')) --end;
  text.truncate(end);
  return text;
}

struct Frame::Json {
  simdjson::dom::document document;
};

Frame::Frame() = default;
Frame::~Frame() = default;

std::shared_ptr<const Frame> Frame::read(const QByteArray& bytes, Wire wire, std::size_t max_bytes) {
  const std::shared_ptr<Frame> frame(new Frame);
  frame->wire_ = wire;
  frame->bytes_ = bytes.size();
  if (std::size_t(bytes.size()) > max_bytes) {
    frame->fault_ = Fault::TooLarge;
  } else if (wire == Wire::Text) {
    frame->readText(bytes, max_bytes);
  } else {
    frame->readBinary(bytes);
  }
  return frame;
}

void Frame::readText(const QByteArray& utf8, std::size_t max_bytes) {
  fault_ = parse(utf8);
  if (fault_ != Fault::None || root_["op"].text() != "png") return;
  const std::optional<std::string> picture = root_["data"].bytes(max_bytes);
  const std::optional<QByteArray> text = picture ? textOfPng(*picture, max_bytes) : std::nullopt;
  root_ = {};
  fault_ = text ? parse(*text) : Fault::NotAPicture;
  // Nested pictures could expand a small message enormously.
  if (fault_ == Fault::NotJson || root_["op"].text() == "png") {
    fault_ = Fault::NotAPicture;
    root_ = {};
  }
}

Frame::Fault Frame::parse(const QByteArray& utf8) {
  json_ = std::make_unique<Json>();
  simdjson::dom::element root;
  const auto parsed = [&](const QByteArray& text) {
    // One parser for each frame: a reused parser keeps twelve times the size of the largest frame so far.
    simdjson::dom::parser parser;
    if (parser.allocate(std::size_t(text.size()), kMaxDepth) != simdjson::SUCCESS) return simdjson::MEMALLOC;
    return parser.parse_into_document(json_->document, text.constData(), std::size_t(text.size())).get(root);
  };
  text_ = utf8;
  simdjson::error_code error = parsed(utf8);
  if (error != simdjson::SUCCESS && error != simdjson::MEMALLOC && error != simdjson::CAPACITY &&
      error != simdjson::DEPTH_ERROR) {
    error = parsed(repairJson(utf8));
  }
  switch (error) {
    case simdjson::SUCCESS:
      root_ = Access::ofJson(root);
      return Fault::None;
    case simdjson::MEMALLOC:
    case simdjson::CAPACITY:
      json_.reset();
      return Fault::TooLarge;
    case simdjson::DEPTH_ERROR:
      json_.reset();
      return Fault::TooDeep;
    default:
      json_.reset();
      return Fault::NotJson;
  }
}

std::optional<std::string_view> Frame::rawMember(std::string_view name) const {
  if (fault_ != Fault::None || !root_.isObject()) return std::nullopt;
  if (wire_ == Wire::Binary) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(cbor_.constData());
    const auto* const end = first + cbor_.size();
    std::optional<std::string_view> found;
    eachMember(CborItem::at(first, end), end, [&](std::string_view member, const std::uint8_t* at) {
      if (member == name)
        found.emplace(reinterpret_cast<const char*>(at), std::size_t(pastItem(at, end) - at));
      return !found;
    });
    return found;
  }
  // The root parser does not keep positions. Non-standard numbers do not matter here, since they are not
  // parsed.
  const simdjson::padded_string padded(text_.constData(), std::size_t(text_.size()));
  simdjson::ondemand::parser parser;
  simdjson::ondemand::document document;
  simdjson::ondemand::object root, member;
  std::string_view found, raw;
  if (parser.allocate(padded.size(), std::size_t(kMaxDepth)) != simdjson::SUCCESS ||
      parser.iterate(padded).get(document) || document.get_object().get(root))
    return std::nullopt;
  for (auto field : root) {
    // Its name as it is meant, as Field reads it: it may be written with escapes.
    if (field.unescaped_key().get(found)) return std::nullopt;
    if (found != name) continue;
    if (field.value().get_object().get(member) || member.raw_json().get(raw)) return std::nullopt;
    return std::string_view(text_.constData() + (raw.data() - padded.data()), raw.size());
  }
  return std::nullopt;
}

void Frame::readBinary(const QByteArray& bytes) {
  cbor_ = bytes;
  const auto* const first = reinterpret_cast<const std::uint8_t*>(cbor_.constData());
  const auto* const end = first + cbor_.size();
  switch (lookThrough(first, end)) {
    case CborFault::None:
      root_ = Access::ofCbor(first, end);
      break;
    case CborFault::TooDeep:
      fault_ = Fault::TooDeep;
      break;
    case CborFault::Broken:
      fault_ = Fault::NotCbor;
      break;
  }
}

}  // namespace mapwright::net::rosbridge
