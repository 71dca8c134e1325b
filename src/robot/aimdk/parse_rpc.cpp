#include "robot/aimdk/parse_rpc.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <tuple>

#include <QJsonArray>
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
  if (const auto header = wire::member(object, {"header"}); text.empty() && header)
    text = wire::text(*header, {"message", "msg", "detail"});
  return text.substr(0, 300);
}

/// The error of a failed call, as far as its members tell.
std::optional<RpcError> failure(const Json& root) {
  const auto error = wire::member(root, {"error", "err"});
  bool truth = true;
  const bool has_error =
      error && (error->get(truth) || truth) && !(error->is_string() && wire::asText(*error).empty());
  auto code = wire::integer(root, {"code", "error_code", "err_code", "errcode"});
  // Newer firmware says it in a header.
  const auto header = wire::member(root, {"header"});
  if (header && !code) code = wire::integer(*header, {"code"});
  // 0 and 200 mean success.
  const bool bad_code = code && *code != 0 && *code != 200;
  if (!has_error && !bad_code) return std::nullopt;
  // The code may be next to the error or inside it.
  const auto inner = bad_code || !error || !error->is_object()
                         ? code
                         : wire::integer(*error, {"code", "error_code", "err_code", "errcode"});
  return RpcError{true, inner && *inner != 0 ? std::to_string(*inner) : std::string(), explanation(root), {}};
}

/// An answer that tells of no error.
Read<Json> goodAnswer(wire::JsonReader& reader, std::string_view body) {
  const auto root = reader.readKeepingDigits(body);
  if (!root || !root->is_object()) {
    return refused({fault::AnswerIsNoJson, {"Agibot"}});
  }
  if (auto why = failure(*root)) return passed(std::move(*why));
  return *root;
}

/// The `data` of an answer.
Read<Json> dataOf(wire::JsonReader& reader, std::string_view body) {
  const auto root = goodAnswer(reader, body);
  if (!root) return root;
  const auto data = wire::member(*root, {"data"});
  simdjson::dom::object members;
  if (!data || data->get(members) || members.size() == 0) {
    // This is also how it refuses.
    const std::string why = explanation(*root);
    return passed(
        {true, {}, why, why.empty() ? faultText("aimdk", "the answer contains no data") : FaultCode()});
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
/// taken as radians, otherwise all as degrees.
bool anglesAreDegrees(const wire::JsonList& points) {
  for (const Json point : points) {
    if (const auto angle = angleOf(point); angle && std::abs(*angle) > 2 * std::numbers::pi) return true;
  }
  return false;
}

/// From +u to +v, which runs down: clockwise. Where the robot gives an orientation in the world, that counts.
std::optional<double> headingOf(const Json& point, bool degrees) {
  const auto pose = wire::member(point, {"pose"});
  const auto turn = pose ? wire::member(*pose, {"orientation"}) : std::nullopt;
  if (turn) {
    const auto x = wire::number(*turn, {"x"}), y = wire::number(*turn, {"y"}), z = wire::number(*turn, {"z"}),
               w = wire::number(*turn, {"w"});
    const bool any = x && y && z && w && (*x != 0 || *y != 0 || *z != 0 || *w != 0);
    if (any) return std::atan2(2 * (*w * *z + *x * *y), *w * *w + *x * *x - *y * *y - *z * *z);
  }
  const auto angle = angleOf(point);
  if (!angle) return std::nullopt;
  return geometry::normalizeAngle(-(degrees ? geometry::radiansFromDegrees(*angle) : *angle));
}

/// The pixel (u, v) of a point.
std::optional<Eigen::Vector2d> pixelOf(const Json& point) {
  const auto pixel_pose = wire::member(point, {"pixel_pose"});
  const auto pixel = pixel_pose ? wire::member(*pixel_pose, {"position"}) : std::nullopt;
  const auto u = pixel ? wire::number(*pixel, {"u", "x"}) : std::nullopt;
  const auto v = pixel ? wire::number(*pixel, {"v", "y"}) : std::nullopt;
  return u && v ? std::optional(Eigen::Vector2d(*u, *v)) : std::nullopt;
}

/// Where a pixel lies at a scale; nullopt where the map does not say.
std::optional<Eigen::Vector2d> placeOf(const Eigen::Vector2d& pixel, const ParsedMap& frame,
                                       double pixels_per_m) {
  const Eigen::Vector2d place((pixel.x() - frame.u0) / pixels_per_m, (frame.v0 - pixel.y()) / pixels_per_m);
  return place.allFinite() ? std::optional(place) : std::nullopt;
}

/// The distance between a point's pixels and its metres at a scale; nullopt if it has no pixels.
std::optional<double> pixelsOff(const Json& point, const Eigen::Vector2d& position, const ParsedMap& frame,
                                double pixels_per_m) {
  const auto pixel = pixelOf(point);
  if (!pixel) return std::nullopt;
  const double du = pixel->x() - (frame.u0 + position.x() * pixels_per_m);
  const double dv = pixel->y() - (frame.v0 - position.y() * pixels_per_m);
  return std::max(std::abs(du), std::abs(dv));
}

std::int64_t countOf(const Json& object, const char* member) {
  const auto rows = wire::list(object, {member});
  return rows ? std::int64_t(rows->size()) : 0;
}

Scale scaleBy(const wire::JsonList& points, const ParsedMap& frame) {
  constexpr double kRoundingPx = 1;
  const double first = frame.resolution, other = 100 / first;
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
  // A few points that were moved prove nothing.
  const bool first_fits = 2 * fit_first > told, other_fits = 2 * fit_other > told;
  if (first_fits && (!other_fits || first == other)) return {first, true};
  if (other_fits && !first_fits) return {other, true, {fault::ScaleInCentimetres, {first}}};
  constexpr int kEnough = 3;
  if (!first_fits && told >= kEnough) return {first, false, {fault::ScaleFitsNeither, {first}}};
  return untoldScale(frame);
}

QByteArray compactJson(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

QString qtText(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

/// An id in JSON: a number digit by digit, because JSON libraries use doubles, which may lose some; anything
/// else as the text that it is.
QByteArray jsonOfId(std::string_view id) {
  const bool number = !id.empty() && id.find_first_not_of("0123456789") == std::string_view::npos &&
                      (id == "0" || id.front() != '0');
  if (number) return {id.data(), qsizetype(id.size())};
  const QByteArray list = QJsonDocument(QJsonArray{qtText(id)}).toJson(QJsonDocument::Compact);
  return list.mid(1, list.size() - 2);
}

}  // namespace

Read<std::vector<map::CatalogueEntry>> parseMapNames(std::string_view body, std::int64_t* left_out) {
  if (left_out) *left_out = 0;
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  std::vector<map::CatalogueEntry> entries;
  const auto member = wire::member(*data, {"map_lists", "map_list", "maps"});
  if (!member) return entries;  // some encoders omit an empty list
  const auto rows = wire::asList(*member);
  if (!rows) return refused(faultText("aimdk", "The robot's list of maps is not a list."));
  for (const Json row : *rows) {
    map::CatalogueEntry entry;
    entry.key = {map::MapKind::Stored, wire::text(row, {"map_id", "id"})};
    entry.name = wire::text(row, {"map_name", "name"});
    entry.index = wire::smallInteger(row, {"map_index", "index"});
    if (entry.key.id.empty()) {
      if (left_out) ++*left_out;
      continue;
    }
    entries.push_back(std::move(entry));
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
  parsed.resolution = wire::number(*data, {"resolution"}).value_or(kNaN);
  parsed.u0 = wire::number(*data, {"origin_x"}).value_or(kNaN);
  parsed.v0 = wire::number(*data, {"origin_y"}).value_or(kNaN);
  if (!(parsed.resolution > 0) || !std::isfinite(parsed.resolution)) {
    return refused(faultText(
        "aimdk", "Its resolution is missing or not above 0 pixels per metre, so its position is unknown."));
  }
  const std::string given = wire::text(*data, {"map_id"});
  if (!given.empty() && given != asked.id) {
    return refused({faultText("aimdk", "The robot sent the map %1 instead."), {given.substr(0, 100)}});
  }
  const auto base64 = wire::member(*data, {"map_data"});
  std::string_view text;
  if (!base64 || base64->get(text) || text.empty())
    return refused(faultText("aimdk", "The robot sent no picture for it."));
  auto picture = wire::fromBase64(text, kMaxPictureBytes);
  if (!picture || picture->empty())
    return refused(faultText("aimdk", "Its picture is not valid base64, or larger than 256 MB."));
  const int width = wire::smallInteger(*data, {"width"}).value_or(0);
  const int height = wire::smallInteger(*data, {"height"}).value_or(0);
  whole.grid.width = width;
  whole.grid.height = height;
  if (const auto size = wire::pngSize(*picture)) {
    std::tie(whole.grid.width, whole.grid.height) = *size;
    if (*size != std::pair(width, height)) {
      whole.notes.push_back({map::Severity::Warning,
                             map::subjectOf(asked),
                             {faultText("aimdk",
                                        "Its picture has %1 x %2 cells, but the robot says %3 x %4. The size "
                                        "of the picture was used."),
                              {size->first, size->second, width, height}}});
    }
  } else if (width <= 0 || height <= 0) {
    return refused(
        faultText("aimdk", "Its picture is not a PNG, and the robot does not say how high it is."));
  }
  place(parsed, {parsed.resolution});
  if (const auto why = map::unusableReason(whole.grid)) return refused(*why);
  if (const auto degrees = wire::number(*data, {"rotate_angle"}); degrees && *degrees != 0) {
    whole.display_rotation_rad = geometry::radiansFromDegrees(*degrees);
  }
  whole.fingerprint = wire::fingerprint(*picture);
  whole.bytes = std::make_shared<const std::string>(std::move(*picture));
  return parsed;
}

Scale untoldScale(const ParsedMap& map) {
  const bool same = map.resolution == 100 / map.resolution;  // at 10: either way
  return {map.resolution, false, same ? Fault() : Fault{fault::ScaleUntold, {map.resolution}}};
}

void place(ParsedMap& map, const Scale& scale) {
  map.pixels_per_m = scale.pixels_per_m;
  // Pixel (origin_x, origin_y) is the world's origin and rows run down: the lower-left corner is (height -
  // origin_y) rows below it.
  map::GridReference& grid = map.map.grid;
  grid.resolution_m = 1 / scale.pixels_per_m;
  grid.origin = {-map.u0 / scale.pixels_per_m, (map.v0 - double(grid.height)) / scale.pixels_per_m, 0};
  if (scale.note.any())
    map.map.notes.push_back({map::Severity::Warning, map::subjectOf(map.map.key), scale.note});
}

Read<Topology> parseTopology(std::string_view body, const ParsedMap* frame) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  if (!data) return passed(data.error());
  Topology topology;
  if (frame) topology.scale = untoldScale(*frame);
  map::WaypointList& list = topology.list;
  if (const std::int64_t paths = countOf(*data, "paths"); paths > 0)
    list.notes.push_back({fault::PathsNotShown, {paths}});
  if (const std::int64_t regions = countOf(*data, "regions"); regions > 0)
    list.notes.push_back({fault::RegionsNotShown, {regions}});
  const auto member = wire::member(*data, {"points"});
  if (!member) return topology;
  const auto rows = wire::asList(*member);
  if (!rows) return refused(robot::wire::fault::PointsAreNoList);
  const bool degrees = topology.degrees = anglesAreDegrees(*rows);
  if (frame) topology.scale = scaleBy(*rows, *frame);
  std::size_t unplaced = 0, unsaid = 0, by_pixels = 0;
  const auto addNote = [&](Fault odd) {
    if (list.notes.size() < kMaxNotes) {
      list.notes.push_back(std::move(odd));
    } else {
      ++unsaid;
    }
  };
  for (const Json row : *rows) {
    const auto pose = wire::member(row, {"pose"});
    auto position = pose ? wire::asPoint(*pose) : std::nullopt;
    const auto pixel = position || !frame ? std::nullopt : pixelOf(row);
    if (pixel) position = placeOf(*pixel, *frame, topology.scale.pixels_per_m);
    if (!position) {
      ++unplaced;
      continue;
    }
    by_pixels += pixel ? 1 : 0;
    map::Waypoint point{wire::text(row, {"point_id", "id"}), wire::text(row, {"name"}),
                        wire::text(row, {"point_type", "type"}), *position, headingOf(row, degrees)};
    point.source = simdjson::minify(row);
    const auto off = frame ? pixelsOff(row, *position, *frame, topology.scale.pixels_per_m) : std::nullopt;
    if (off && !(*off <= 1)) {
      addNote({fault::PointOff, {point.id, point.name, *off}});
      topology.two_places.insert(point.id);
    }
    list.points.push_back(std::move(point));
  }
  if (by_pixels > 0) list.notes.push_back({fault::PointsByPixels, {std::int64_t(by_pixels)}});
  if (unplaced > 0) list.notes.push_back({robot::wire::fault::PointsUnplaced, {std::int64_t(unplaced)}});
  if (unsaid > 0) list.notes.push_back({fault::MorePointsOff, {std::int64_t(unsaid)}});
  return topology;
}

bool knowsService(int status, std::string_view body) {
  constexpr std::int64_t kNoSuchMethod[] = {12, 404, 405, 501, -32601};  // of gRPC, HTTP and JSON-RPC
  const auto is = [&](std::int64_t code) {
    return std::find(std::begin(kNoSuchMethod), std::end(kNoSuchMethod), code) != std::end(kNoSuchMethod);
  };
  if (status < 200 || status >= 300) return false;
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  if (!root || !root->is_object()) return false;
  // An error in another form than that of the newer services may be older firmware's for all that it lacks.
  const auto header = wire::member(*root, {"header"});
  if (!header) return !failure(*root) && wire::member(*root, {"data"});
  return !is(wire::integer(*header, {"code"}).value_or(0));
}

Read<bool> parseRealtimeMap(std::string_view body) {
  wire::JsonReader reader;
  const auto root = reader.readKeepingDigits(body);
  if (!root || !root->is_object()) return refused({fault::AnswerIsNoJson, {"Agibot"}});
  // Without a mapping there may be an error as well as no data.
  const auto data = wire::member(*root, {"data"});
  return data && !wire::text(*data, {"map_data"}).empty();
}

Read<void> parseAcceptance(std::string_view body) {
  wire::JsonReader reader;
  const auto root = goodAnswer(reader, body);
  if (!root) return passed(root.error());
  return {};
}

std::string createdPoint(std::string_view body) {
  wire::JsonReader reader;
  const auto data = dataOf(reader, body);
  const std::string id = data ? wire::text(*data, {"point_id", "id"}) : std::string();
  return id == "0" ? std::string() : id;
}

QByteArray mapNamesRequest() { return command("MappingCommand_GET_STORED_MAP_NAME"); }

QByteArray currentMapRequest() { return command("MappingCommand_GET_CURRENT_WORKING_MAP"); }

QByteArray wholeMapRequest(std::string_view map_id) {
  return command("MappingCommand_GET_2D_WHOLE_MAP",
                 {{QStringLiteral("map_id"), QString::fromUtf8(map_id.data(), qsizetype(map_id.size()))}});
}

QByteArray topologyRequest(std::string_view map_id) {
  return R"({"command":"TopoCommand_GET_TOPO_MSG","map_id":)" + jsonOfId(map_id) + '}';
}

QByteArray realtimeMapRequest() { return changeRequest("MappingCommand_GET_REALTIME_MAP"); }

QByteArray changeRequest(const char* command, const std::vector<std::pair<const char*, std::string>>& texts) {
  QJsonObject members{{QStringLiteral("header"), QJsonObject()},
                      {QStringLiteral("command"), QLatin1String(command)}};
  for (const auto& [name, value] : texts) members.insert(QLatin1String(name), qtText(value));
  return compactJson(members);
}

QByteArray pointRequest(std::string_view map_id, const map::Waypoint& point,
                        const std::optional<PixelPose>& pose) {
  const bool is_new = point.source.empty();
  // What is not known here goes back as it came, without the metres: pixels are what counts.
  QJsonObject members = QJsonDocument::fromJson(QByteArray::fromStdString(point.source)).object();
  members.remove(QStringLiteral("pose"));
  const QJsonValue own_id = members[QStringLiteral("point_id")];
  members.remove(QStringLiteral("point_id"));
  members[QStringLiteral("name")] = qtText(point.name);
  // A type that came as a number goes back as one.
  if (members[QStringLiteral("point_type")].toVariant().toString() != qtText(point.type) ||
      point.type.empty())
    members[QStringLiteral("point_type")] =
        qtText(point.type.empty() ? std::string_view(kUsualPointType) : std::string_view(point.type));
  if (pose) {
    const QJsonObject position{{QStringLiteral("u"), qint64(pose->u)},
                               {QStringLiteral("v"), qint64(pose->v)}};
    const QString member = QStringLiteral("pixel_pose"), angle = QStringLiteral("angle");
    const QJsonValue turn = pose->angle ? QJsonValue(*pose->angle) : members[member].toObject()[angle];
    members[member] = QJsonObject{{QStringLiteral("position"), position}, {angle, turn}};
  }
  QByteArray rest = compactJson(members);
  rest[0] = ',';
  QByteArray id = is_new ? QByteArray("0") : jsonOfId(point.id);
  // An id that came as a text goes back as one.
  if (own_id.isString() && !id.startsWith('"')) id = '"' + id + '"';
  return R"({"header":{},"command":"TopoCommand_SET_NAVI_POINT","map_id":)" + jsonOfId(map_id) +
         R"(,"point":{"point_id":)" + id + rest + '}';
}

}  // namespace mapwright::robot::aimdk
