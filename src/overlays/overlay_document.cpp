#include "overlays/overlay_document.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "overlays/faults.h"

namespace mapwright::overlays {
namespace {

constexpr std::string_view kFeatures = "features";
constexpr std::string_view kNoFeatures = R"({"type": "FeatureCollection", "features": []})";

std::string textOf(const std::optional<JsonValue>& value) {
  if (!value) return {};
  if (value->kind() == JsonKind::String) return value->string();
  return value->kind() == JsonKind::Number ? canonical(*value) : std::string();
}

/// `held` with `object` in the place of its value: what stands around that stays.
std::string withObject(const std::string& held, const std::string& object) {
  const auto json = JsonText::read(held);
  if (!json) return held + object;  // there are only blanks
  return held.substr(0, json->root().begin()) + object + held.substr(json->root().end());
}

JsonText null() { return *JsonText::read("null"); }

}  // namespace

Feature::Feature(std::string text) {
  auto json = JsonText::read(std::move(text));
  json_ = std::make_shared<const JsonText>(json ? std::move(*json) : null());
}

std::optional<JsonValue> Feature::property(std::string_view name) const {
  const auto properties = root().member("properties");
  return properties ? properties->member(name) : std::nullopt;
}

std::string Feature::id() const {
  const std::string own = textOf(root().member("id"));
  return own.empty() ? textOf(property("id")) : own;
}

std::string Feature::name() const { return textOf(property("name")); }

Shape Feature::shape() const {
  const auto geometry = root().member("geometry");
  const std::string type = geometry ? textOf(geometry->member("type")) : std::string();
  if (type.empty()) return Shape::None;
  return type == "Point"        ? Shape::Point
         : type == "LineString" ? Shape::Line
         : type == "Polygon"    ? Shape::Polygon
                                : Shape::Other;
}

Shape partShapeOf(const Feature& feature) {
  const auto geometry = feature.root().member("geometry");
  const std::string type = geometry ? textOf(geometry->member("type")) : std::string();
  return type == "MultiPoint"        ? Shape::Point
         : type == "MultiLineString" ? Shape::Line
         : type == "MultiPolygon"    ? Shape::Polygon
                                     : feature.shape();
}

bool isFeature(const Feature& feature) {
  const JsonValue root = feature.root();
  const auto type = root.isObject() ? root.member("type") : std::nullopt;
  return root.kind() == JsonKind::Null || (root.isObject() && (!type || type->string() == "Feature"));
}

int Feature::type() const {
  const Shape is = partShapeOf(*this);
  const std::string written = textOf(property(is == Shape::Line      ? "lineType"
                                              : is == Shape::Polygon ? "regionType"
                                                                     : "type"));
  int type = 0;
  std::from_chars(written.data(), written.data() + written.size(), type);
  return type;
}

std::optional<JsonValue> Feature::coordinates() const {
  const auto geometry = root().member("geometry");
  return geometry ? geometry->member("coordinates") : std::nullopt;
}

OverlayDocument OverlayDocument::taken(const JsonText& json, const std::optional<JsonValue>& list) {
  OverlayDocument document;
  if (!list) {
    document.head_ = json.text();
    return document;
  }
  const std::string& text = json.text();
  std::size_t at = list->begin() + 1;
  document.head_ = text.substr(0, at);
  for (const JsonValue& feature : list->children()) {
    document.before_.push_back(text.substr(at, feature.begin() - at));
    document.features_.emplace_back(JsonText::of(feature));
    at = feature.end();
  }
  document.tail_ = text.substr(at);
  return document;
}

tl::expected<OverlayDocument, Fault> OverlayDocument::read(std::string text) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    OverlayDocument none;
    none.head_ = std::move(text);
    return none;
  }
  const auto json = JsonText::read(std::move(text));
  if (!json) return tl::make_unexpected(faultOf(json.error()));
  const JsonValue root = json->root();
  if (root.isArray()) return taken(*json, root);
  if (root.kind() == JsonKind::Null) return taken(*json, std::nullopt);
  const auto list = root.member(kFeatures);
  const bool listed = list && list->isArray();
  const auto holds = [&root](const char* name) { return root.member(name).has_value(); };
  const bool none = root.isObject() && (!list || list->kind() == JsonKind::Null) && !holds("geometry") &&
                    !holds("geometries") && !holds("coordinates");
  if (!listed && !none) return tl::make_unexpected(Fault(fault::NoCollection));
  const auto members = root.children();
  const auto isList = [](const JsonValue& member) { return member.key() == kFeatures; };
  if (std::count_if(members.begin(), members.end(), isList) > 1)
    return tl::make_unexpected(Fault(fault::SeveralLists));
  return taken(*json, listed ? list : std::nullopt);
}

bool OverlayDocument::isCollection(const std::string& text) {
  const auto json = JsonText::read(text);
  if (!json || !json->root().isObject()) return false;
  const auto type = json->root().member("type"), list = json->root().member(kFeatures);
  return type && type->string() == "FeatureCollection" && list && list->isArray();
}

std::string OverlayDocument::text() const {
  std::string text = head_;
  for (std::size_t i = 0; i < features_.size(); ++i) {
    text += before_[i];
    text += features_[i].text();
  }
  return text + tail_;
}

bool OverlayDocument::isSameText(const OverlayDocument& other) const {
  return head_ == other.head_ && tail_ == other.tail_ && before_ == other.before_ &&
         std::ranges::equal(features_, other.features_, [](const Feature& a, const Feature& b) {
           return &a.text() == &b.text() || a.text() == b.text();
         });
}

std::optional<JsonText> OverlayDocument::collection() const {
  auto json = JsonText::read(head_ + tail_);
  if (!json || !json->root().isObject()) return std::nullopt;
  return std::move(*json);
}

void OverlayDocument::add(Feature feature) {
  if (tail_.empty()) {
    // No list of features so far.
    const auto json = collection();
    const std::string object = json ? withMember(json->root(), kFeatures, "[]") : std::string(kNoFeatures);
    *this = *read(withObject(head_, object));
  }
  // The style of the features before it.
  before_.push_back(before_.empty()      ? std::string()
                    : before_.size() > 1 ? before_.back()
                                         : ',' + before_.front());
  features_.push_back(std::move(feature));
}

void OverlayDocument::remove(std::size_t index) {
  features_.erase(features_.begin() + std::ptrdiff_t(index));
  if (index == 0 && before_.size() > 1) {
    before_.erase(before_.begin() + 1);  // the comma of the one that is the first now
  } else {
    before_.erase(before_.begin() + std::ptrdiff_t(index));
  }
}

void OverlayDocument::setMember(std::string_view name, const std::optional<std::string>& value) {
  if (name == kFeatures) return;
  const auto json = collection();
  const JsonText from = json ? *json : *JsonText::read(std::string(kNoFeatures));
  const std::string object = value ? withMember(from.root(), name, *value) : withoutMember(from.root(), name);
  OverlayDocument changed = *read(withObject(head_ + tail_, object));
  changed.before_ = std::move(before_);
  changed.features_ = std::move(features_);
  *this = std::move(changed);
}

}  // namespace mapwright::overlays
