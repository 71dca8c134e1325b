#include "robot/aimdk/parse_rpc.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <QJsonDocument>
#include <QJsonObject>

#include "robot/aimdk/faults.h"
#include "robot/wire/faults.h"
#include "robot/wire/picture_bytes.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::aimdk {
namespace {

using wire::Json;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxPictureBytes = std::size_t(256) << 20;
constexpr std::size_t kMaxNotes = 20;

/// It cannot be read.
auto refused(Fault cause) { return tl::make_unexpected(RpcError{false, {}, {}, std::move(cause)}); }

auto passed(RpcError error) { return tl::make_unexpected(std::move(error)); }

std::string explanation(const Json& object) {
  std::string text = wire::text(object, {"message", "msg", "detail", "error", "reason"});
  if (const auto inner = wire::member(object, {"error", "status"});
      text.empty() && inner && inner->is_object()) {
    text = wire::text(*inner, {"message", "msg", "detail"});
  }
  return text.substr(0, 300);
}

/// The error of a failed call, as far as its members tell.
std::optional<RpcError> failure(const Json& root) {
  const auto error = wire::member(root, {"error", "err"});
  bool truth = true;
  const bool has_error =
      error && (error->get(truth) || truth) && !(error->is_string() && wire::asText(*error).empty());
  const auto code = wire::integer(root, {"code", "error_code", "err_code", "errcode"});
  // 0 and 200 mean success.
  const bool bad_code = code && *code != 0 && *code != 200;
  if (!has_error && !bad_code) return std::nullopt;
  // The code may be next to the error or inside it.
  const auto inner = bad_code || !error || !error->is_object()
                         ? code
                         : wire::integer(*error, {"code", "error_code", "err_code", "errcode"});
  return RpcError{true, inner && *inner != 0 ? std::to_string(*inner) : std::string(), explanation(root), {}};
}

/// The `data` of an answer.
Read<Json> dataOf(wire::JsonReader& reader, std::string_view body) {
  const auto root = reader.readKeepingDigits(body);
  if (!root || !root->is_object()) {
    return refused({fault::AnswerIsNoJson, {"Agibot"}});
  }
  if (auto why = failure(*root)) return passed(std::move(*why));
  const auto data = wire::member(*root, {"data"});
  simdjson::dom::object members;
  if (!data || data->get(members) || members.size() == 0) {
    // This is also how it refuses.
    const std::string why = explanation(*root);
    return passed({true, {}, why, why.empty() ? fault::AnswerHoldsNoData : FaultCode()});
  }
  return *data;
}

QByteArray command(const char* name, QJsonObject members = {}) {
  members.insert(QStringLiteral("command"), QLatin1String(name));
  return QJsonDocument(members).toJson(QJsonDocument::Compact);
}

std::optional<double> angleOf(const Json& point) {
  const auto pixel_pose = wire::member(point, {"pixel_pose"});
  return pixel_pose ? wire::number(*pixel_pose, {"angle"}) : std::nullopt;
}

/// The documentation gives no unit for the angle. If no point of a list exceeds one turn in radians they are
/// taken as radians, otherwise all as degrees; counter-clockwise in both cases.
bool anglesAreDegrees(const wire::JsonList& points) {
  for (const Json point : points) {
    if (const auto angle = angleOf(point); angle && std::abs(*angle) > 2 * std::numbers::pi) return true;
  }
  return false;
}

std::optional<double> headingOf(const Json& point, bool degrees) {
  const auto angle = angleOf(point);
  if (!angle) return std::nullopt;
  return geometry::normalizeAngle(degrees ? geometry::radiansFromDegrees(*angle) : *angle);
}

/// The distance between a point's pixels and its metres at a scale; nullopt if it has no pixels.
std::optional<double> pixelsOff(const Json& point, const Eigen::Vector2d& position, const ParsedMap& frame,
                                double pixels_per_m) {
  const auto pixel_pose = wire::member(point, {"pixel_pose"});
  const auto pixel = pixel_pose ? wire::member(*pixel_pose, {"position"}) : std::nullopt;
  if (!pixel) return std::nullopt;
  const auto u = wire::number(*pixel, {"u", "x"}), v = wire::number(*pixel, {"v", "y"});
  if (!u || !v) return std::nullopt;
  const double du = *u - (frame.u0 + position.x() * pixels_per_m);
  const double dv = *v - (frame.v0 - position.y() * pixels_per_m);
  return std::max(std::abs(du), std::abs(dv));
}

/// Some programs read the resolution as pixels per metre, others as centimetres per pixel: what the points
/// say of that. None: the first fits, or there is no point that could tell.
Fault doubtOfScale(const wire::JsonList& points, const ParsedMap& frame) {
  constexpr double kRoundingPx = 1;
  const double first = frame.pixels_per_m, other = 100 / first;
  int told = 0, fit_first = 0, fit_other = 0;
  for (const Json point : points) {
    const auto pose = wire::member(point, {"pose"});
    const auto position = pose ? wire::asPoint(*pose) : std::nullopt;
    const auto off = position ? pixelsOff(point, *position, frame, first) : std::nullopt;
    if (!off) continue;
    ++told;
    if (*off <= kRoundingPx) ++fit_first;
    if (*pixelsOff(point, *position, frame, other) <= kRoundingPx) ++fit_other;
  }
  // A few points that were moved prove nothing. At 10 both readings are the same.
  const bool first_fits = 2 * fit_first > told, other_fits = 2 * fit_other > told;
  if (told == 0 || first == other || (first_fits && !other_fits)) return {};
  if (first_fits) return told > 1 ? Fault(fault::ScaleFitsBoth, {first}) : Fault();
  if (other_fits) return {fault::ScaleInCentimetres, {first}};
  constexpr int kEnough = 3;
  return told >= kEnough ? Fault(fault::ScaleFitsNeither, {first}) : Fault();
}

}  // namespace

Read<std::vector<map::CatalogueEntry>> parseMapNames(std::string_view body) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  std::vector<map::CatalogueEntry> entries;
  const auto member = wire::member(*data, {"map_lists", "map_list", "maps"});
  if (!member) return entries;  // some encoders omit an empty list
  const auto rows = wire::asList(*member);
  if (!rows) return refused(fault::MapsAreNoList);
  for (const Json row : *rows) {
    map::CatalogueEntry entry;
    entry.key = {map::MapKind::Stored, wire::text(row, {"map_id", "id"})};
    entry.name = wire::text(row, {"map_name", "name"});
    entry.index = wire::smallInteger(row, {"map_index", "index"});
    if (!entry.key.id.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

Read<std::string> parseCurrentMap(std::string_view body) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  std::string id = wire::text(*data, {"map_id", "id"});
  return id == "0" || id == "-1" ? std::string() : id;
}

Read<ParsedMap> parseWholeMap(std::string_view body, const map::MapKey& asked) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  ParsedMap parsed;
  map::WholeMap& whole = parsed.map;
  whole.key = asked;
  whole.name = wire::text(*data, {"map_name", "name"});
  parsed.pixels_per_m = wire::number(*data, {"resolution"}).value_or(kNaN);
  parsed.u0 = wire::number(*data, {"origin_x"}).value_or(kNaN);
  parsed.v0 = wire::number(*data, {"origin_y"}).value_or(kNaN);
  if (!(parsed.pixels_per_m > 0) || !std::isfinite(parsed.pixels_per_m)) {
    return refused(fault::ScaleNotPositive);
  }
  const std::string given = wire::text(*data, {"map_id"});
  if (!given.empty() && given != asked.id) {
    return refused({fault::WrongMapSent, {given.substr(0, 100)}});
  }
  const auto base64 = wire::member(*data, {"map_data"});
  std::string_view text;
  if (!base64 || base64->get(text) || text.empty()) return refused(fault::NoPictureOfItSent);
  auto picture = wire::fromBase64(text, kMaxPictureBytes);
  if (!picture || picture->empty()) return refused(fault::PictureNotBase64);
  const int width = wire::smallInteger(*data, {"width"}).value_or(0);
  const int height = wire::smallInteger(*data, {"height"}).value_or(0);
  whole.grid.width = width;
  whole.grid.height = height;
  if (const auto size = wire::pngSize(*picture)) {
    std::tie(whole.grid.width, whole.grid.height) = *size;
    if (*size != std::pair(width, height)) {
      whole.notes.push_back({map::Severity::Warning,
                             map::subjectOf(asked),
                             {fault::SizesDisagree, {size->first, size->second, width, height}}});
    }
  } else if (width <= 0 || height <= 0) {
    return refused(fault::HeightNotSaid);
  }
  // Pixel (origin_x, origin_y) is the world's origin and rows run down: the lower-left corner is (height -
  // origin_y) rows below it.
  whole.grid.resolution_m = 1 / parsed.pixels_per_m;
  whole.grid.origin = {-parsed.u0 / parsed.pixels_per_m,
                       (parsed.v0 - double(whole.grid.height)) / parsed.pixels_per_m, 0};
  if (const auto why = map::whyUnusable(whole.grid)) return refused(*why);
  if (const auto degrees = wire::number(*data, {"rotate_angle"}); degrees && *degrees != 0) {
    whole.display_rotation_rad = geometry::radiansFromDegrees(*degrees);
  }
  whole.fingerprint = wire::fingerprint(*picture);
  whole.bytes = std::make_shared<const std::string>(std::move(*picture));
  return parsed;
}

Read<map::WaypointList> parseTopology(std::string_view body, const ParsedMap* frame) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  map::WaypointList list;
  const auto member = wire::member(*data, {"points"});
  if (!member) return list;
  const auto rows = wire::asList(*member);
  if (!rows) return refused(robot::wire::fault::PointsAreNoList);
  const bool degrees = anglesAreDegrees(*rows);
  const Fault scale = frame ? doubtOfScale(*rows, *frame) : Fault();
  if (scale.any()) list.notes.push_back(scale);
  std::size_t unplaced = 0, unsaid = 0;
  const auto note = [&](Fault odd) {
    if (list.notes.size() < kMaxNotes) {
      list.notes.push_back(std::move(odd));
    } else {
      ++unsaid;
    }
  };
  for (const Json row : *rows) {
    const auto pose = wire::member(row, {"pose"});
    const auto position = pose ? wire::asPoint(*pose) : std::nullopt;
    if (!position) {
      ++unplaced;
      continue;
    }
    map::Waypoint point{wire::text(row, {"point_id", "id"}), wire::text(row, {"name"}),
                        wire::text(row, {"point_type", "type"}), *position, headingOf(row, degrees)};
    const auto off = frame ? pixelsOff(row, *position, *frame, frame->pixels_per_m) : std::nullopt;
    if (off && !(*off <= 1)) {
      note({fault::PointOff, {point.id, point.name, *off}});
    }
    list.points.push_back(std::move(point));
  }
  if (unplaced > 0) list.notes.push_back({robot::wire::fault::PointsUnplaced, {std::int64_t(unplaced)}});
  if (unsaid > 0) list.notes.push_back({fault::MorePointsOff, {std::int64_t(unsaid)}});
  return list;
}

QByteArray mapNamesRequest() { return command("MappingCommand_GET_STORED_MAP_NAME"); }

QByteArray currentMapRequest() { return command("MappingCommand_GET_CURRENT_WORKING_MAP"); }

QByteArray wholeMapRequest(std::string_view map_id) {
  return command("MappingCommand_GET_2D_WHOLE_MAP",
                 {{QStringLiteral("map_id"), QString::fromUtf8(map_id.data(), qsizetype(map_id.size()))}});
}

std::optional<QByteArray> topologyRequest(std::string_view map_id) {
  const bool number = !map_id.empty() && map_id.find_first_not_of("0123456789") == std::string_view::npos &&
                      (map_id == "0" || map_id.front() != '0');
  if (!number) return std::nullopt;
  // Written by hand: JSON libraries use doubles for numbers, which may lose digits.
  return R"({"command":"TopoCommand_GET_TOPO_MSG","map_id":)" +
         QByteArray(map_id.data(), qsizetype(map_id.size())) + '}';
}

}  // namespace mapwright::robot::aimdk
