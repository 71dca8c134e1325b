#include "overlays/overlay_marks.h"

#include <algorithm>
#include <map>
#include <utility>

#include "overlays/overlay_edits.h"
#include "overlays/overlay_shapes.h"
#include "overlays/overlay_types.h"

namespace mapwright::overlays {
namespace {

constexpr const char* kReference = "ref";

using MarkKey = std::pair<Mark::Kind, std::string>;

std::string_view idProperty(Mark::Kind kind) {
  return kind == Mark::Kind::Landmark ? "landmarkId" : "barcodeId";
}

int typeOf(Mark::Kind kind) { return kind == Mark::Kind::Landmark ? kLandmark : kBarcode; }

std::optional<MarkKey> keyOf(const Feature& feature) {
  if (feature.shape() != Shape::Point) return std::nullopt;
  for (const Mark::Kind kind : {Mark::Kind::Landmark, Mark::Kind::Barcode}) {
    if (feature.type() != typeOf(kind)) continue;
    const auto id = feature.property(idProperty(kind));
    if (id) return MarkKey{kind, id->kind() == JsonKind::String ? id->string() : std::string(id->text())};
  }
  return std::nullopt;
}

/// Others have it, so that the robot may want it of this one, too.
Feature asOthers(const OverlayDocument& among, Feature feature) {
  const auto& all = among.features();
  const bool marked = std::any_of(
      all.begin(), all.end(), [](const Feature& other) { return other.property("mapOverlay").has_value(); });
  return marked ? withProperty(feature, "mapOverlay", "true") : feature;
}

/// "landmark_2" before "landmark_10".
std::pair<std::string, unsigned long long> counted(const std::string& id) {
  const std::size_t last = id.find_last_not_of("0123456789");
  const std::size_t digits = last == std::string::npos ? 0 : last + 1;
  if (digits == id.size() || id.size() - digits > 15) return {id, 0};
  return {id.substr(0, digits), std::stoull(id.substr(digits))};
}

}  // namespace

Feature seenFeature(const OverlayDocument& among, int type, const SeenPlace& seen, const std::string& id,
                    const std::string& name) {
  Feature feature = withYaw(newFeature(among, Shape::Point, {seen.at_m}, type, id, name), seen.yaw_deg);
  if (!seen.reference.empty()) feature = withProperty(feature, kReference, json::quoted(seen.reference));
  return asOthers(among, std::move(feature));
}

Feature seenAgain(const Feature& point, const SeenPlace& seen) {
  Feature feature = withYaw(withVertexAt(point, {}, seen.at_m), seen.yaw_deg);
  if (seen.reference.empty()) return feature;
  const std::string written = json::quoted(seen.reference);
  const auto before = feature.property(kReference);
  const bool same = before && before->kind() == JsonKind::String && before->string() == seen.reference;
  return same ? feature : withProperty(feature, kReference, written);
}

std::vector<MarkOffer> offersOf(const OverlayDocument& among, const std::vector<Mark>& marks) {
  std::map<MarkKey, std::size_t> present;
  for (std::size_t i = 0; i < among.features().size(); ++i) {
    if (const auto key = keyOf(among.features()[i])) present.emplace(*key, i);
  }
  std::map<MarkKey, Mark> last;
  for (const Mark& mark : marks) last.insert_or_assign(MarkKey{mark.kind, mark.id}, mark);
  std::vector<MarkOffer> offers;
  for (auto& [key, mark] : last) {
    MarkOffer offer{mark};
    if (const auto known = present.find(key); known != present.end()) {
      offer.present = known->second;
      const auto at = shapesOf(among.features()[known->second]).somewhere();
      offer.away_m = at ? (*at - mark.at_m).norm() : 0;
      if (at && offer.away_m <= kSamePlaceM) continue;
    }
    offers.push_back(std::move(offer));
  }
  std::stable_sort(offers.begin(), offers.end(), [](const MarkOffer& a, const MarkOffer& b) {
    return std::pair(a.mark.kind, counted(a.mark.id)) < std::pair(b.mark.kind, counted(b.mark.id));
  });
  return offers;
}

Feature markFeature(const OverlayDocument& among, const Mark& mark, const std::string& id) {
  // Named by what it is known by, so that people can tell it from others.
  Feature feature = newFeature(among, Shape::Point, {mark.at_m}, typeOf(mark.kind), id, mark.id);
  if (mark.yaw_deg) feature = withYaw(feature, mark.yaw_deg);
  return asOthers(among, withProperty(feature, idProperty(mark.kind), json::quoted(mark.id)));
}

Feature withMark(const Feature& present, const Mark& mark) {
  const Feature moved = withVertexAt(present, {}, mark.at_m);
  return mark.yaw_deg ? withYaw(moved, mark.yaw_deg) : moved;
}

}  // namespace mapwright::overlays
