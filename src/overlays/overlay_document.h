// The overlays of a map as a document that keeps every byte that is not edited: unknown features and members,
// notation of numbers, escapes, order and blanks. Source: docs/protocols/autoxing.md, "Overlays"; RFC 7946.
// Values: copies are independent, features are shared and never change.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include "json/json_text.h"

namespace mapwright::overlays {

using json::JsonKind;
using json::JsonText;
using json::JsonValue;

enum class Shape { None, Point, Line, Polygon, Other };
/// What the parts of its geometry are: Line for a LineString and a MultiLineString, Other for a collection.
class Feature;
Shape partShapeOf(const Feature& feature);
/// Robots leave the type out, and keep nulls in their list.
bool isFeature(const Feature& feature);

/// One feature, as written.
class Feature {
 public:
  /// `text` must be JSON. It need not be a feature: what a robot keeps in its list is kept.
  explicit Feature(std::string text);
  explicit Feature(JsonText json) : json_(std::make_shared<const JsonText>(std::move(json))) {}

  const std::string& text() const { return json_->text(); }
  JsonValue root() const { return json_->root(); }

  /// From the feature or else its properties, a number in its plain notation (1 for 1.0); empty: none.
  /// Untrusted plain text.
  std::string id() const;
  std::string name() const;
  Shape shape() const;
  /// The number of properties.type (points), lineType (lines) or regionType (polygons, of several parts,
  /// too), written as a number or as a text; 0 = none or unknown.
  int type() const;
  std::optional<JsonValue> property(std::string_view name) const;
  std::optional<JsonValue> coordinates() const;

 private:
  std::shared_ptr<const JsonText> json_;
};

class OverlayDocument {
 public:
  /// No features.
  OverlayDocument() = default;
  /// A FeatureCollection, a bare list of features, or nothing at all.
  static tl::expected<OverlayDocument, Fault> read(std::string text);
  /// A FeatureCollection as RFC 7946 has it, for what people hand in: nothing else stands for "no features".
  static bool isCollection(const std::string& text);
  /// The same text if nothing was changed.
  std::string text() const;
  /// Faster than comparing text(); true only if that is the same.
  bool isSameText(const OverlayDocument& other) const;

  const std::vector<Feature>& features() const { return features_; }
  /// The members of the collection besides its features; nullopt: it has none.
  std::optional<JsonText> collection() const;

  void add(Feature feature);
  void replace(std::size_t index, Feature feature) { features_[index] = std::move(feature); }
  void remove(std::size_t index);
  /// A member of the collection other than its features. `value`: JSON; nullopt: removed.
  void setMember(std::string_view name, const std::optional<std::string>& value);

 private:
  static OverlayDocument taken(const JsonText& json, const std::optional<JsonValue>& list);

  // text = head + before[0] + features[0] + before[1] + … + tail
  std::string head_, tail_;
  std::vector<std::string> before_;  // blanks and the comma before each feature
  std::vector<Feature> features_;
};

}  // namespace mapwright::overlays
