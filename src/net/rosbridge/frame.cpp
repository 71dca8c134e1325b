#include "net/rosbridge/frame.h"

#include <simdjson.h>

#include "net/rosbridge/access.h"
#include "net/rosbridge/cbor_item.h"
#include "net/rosbridge/png_text.h"
#include "net/rosbridge/repair_json.h"

namespace mapwright::net::rosbridge {

struct Frame::Json {
  simdjson::dom::document document;
};

Frame::Frame() = default;
Frame::~Frame() = default;

std::shared_ptr<const Frame> Frame::read(const QByteArray& bytes, Wire wire, const FrameLimits& limits) {
  const std::shared_ptr<Frame> frame(new Frame);
  frame->wire_ = wire;
  frame->bytes_ = bytes.size();
  if (std::size_t(bytes.size()) > limits.max_bytes) {
    frame->fault_ = Fault::TooLarge;
  } else if (wire == Wire::Text) {
    frame->readText(bytes, limits);
  } else {
    frame->readBinary(bytes);
  }
  return frame;
}

void Frame::readText(const QByteArray& utf8, const FrameLimits& limits) {
  fault_ = parse(utf8);
  if (fault_ != Fault::None || root_["op"].text() != "png") return;
  const std::optional<std::string> picture = root_["data"].bytes(limits.max_bytes);
  const std::optional<QByteArray> text = picture ? textOfPng(*picture, limits.max_bytes) : std::nullopt;
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
  if (fault_ != Fault::None) return std::nullopt;
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
  std::string_view raw;
  if (parser.allocate(padded.size(), std::size_t(kMaxDepth)) != simdjson::SUCCESS ||
      parser.iterate(padded).get(document) || document.get_object().get(root) ||
      root.find_field_unordered(name).get_object().get(member) || member.raw_json().get(raw))
    return std::nullopt;
  return std::string_view(text_.constData() + (raw.data() - padded.data()), raw.size());
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
