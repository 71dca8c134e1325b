#include "exchange/waypoint_poses.h"

#include <algorithm>
#include <set>

#include <QCoreApplication>

#include "exchange/waypoint_reading.h"
#include "sentences/plural.h"
#include "words/qt_plain.h"

namespace mapwright::exchange {
namespace {

class WaypointPosesText {
  Q_DECLARE_TR_FUNCTIONS(WaypointPoses)
};

constexpr int kDeepestList = 4;

bool isNumberList(const FileValue& value) {
  return value.isList() && value.items.size() >= 2 &&
         std::all_of(value.items.begin(), value.items.end(),
                     [](const FileValue& item) { return item.asNumber().has_value(); });
}

/// A list that is a pose itself: of numbers, of a name and numbers, or of a position and an orientation.
bool isPoseList(const FileValue& value) {
  if (!value.isList()) return false;
  if (isNumberList(value)) return true;
  const auto& items = value.items;
  if (items.size() == 2 && isNumberList(items[0]) && isNumberList(items[1]))
    return items[0].items.size() == 3 && items[1].items.size() == 4;
  return items.size() >= 3 && items.size() <= 8 && items[0].kind == FileValue::Kind::Text &&
         std::all_of(items.begin() + 1, items.end(),
                     [](const FileValue& item) { return item.asNumber().has_value(); });
}

/// A map that says where something is: itself, or in a member beside its name.
bool isPoseMap(const FileValue& value) {
  if (!value.isMap()) return false;
  const bool is_named = std::any_of(value.members.begin(), value.members.end(), [](const auto& member) {
    return meaningOf(member.first) == FieldMeaning::Name && !member.second.isMap() && !member.second.isList();
  });
  return std::any_of(value.members.begin(), value.members.end(), [&](const auto& member) {
    const FieldMeaning meaning = meaningOf(member.first);
    if (is_named && member.second.isMap() && isPlace(member.second)) return true;
    if (meaning == FieldMeaning::X || meaning == FieldMeaning::Latitude || meaning == FieldMeaning::Longitude)
      return !member.second.isMap() && !member.second.isList();
    static const std::set<std::string> kParts{"pose", "position", "point", "translation", "transform"};
    return kParts.contains(member.first) && (member.second.isMap() || member.second.isList());
  });
}

/// Finds the poses of a file.
class PoseList {
 public:
  explicit PoseList(AngleUnit angles) : reading_(angles) {}

  WantedFile read(const std::vector<FileValue>& documents) {
    for (const FileValue& document : documents) {
      if (const auto why = noneReason(document)) return wrong(*why);
      if (const auto why = isGraph(document) ? readGraph(document) : readIn(document, {}, {}, 0))
        return wrong(*why);
    }
    if (reading_.size() == 0)
      return wrong(
          WaypointPosesText::tr("No waypoints were found in it. Known are lists of poses: {name, x, y, yaw}, "
                                "{name, pose: {position, "
                                "orientation}}, [x, y, yaw], also by name."));
    return std::move(reading_).finish();
  }

 private:
  using Trouble = std::optional<QString>;

  static bool isGraph(const FileValue& document) { return document.find("levels") != nullptr; }

  /// What is something else, by what only that has.
  static Trouble noneReason(const FileValue& document) {
    if (document.find("image") && document.find("resolution"))
      return WaypointPosesText::tr("It is a map.yaml, not a list of waypoints.");
    const FileValue* const levels = document.find("levels");
    if (!levels) return {};
    for (const auto& [name, level] : levels->members) {
      if (level.find("drawing") || level.find("measurements") || level.find("layers"))
        return WaypointPosesText::tr(
            "It is a building map of Open-RMF: its vertices are pixels of a drawing, not metres of a map. "
            "Build "
            "its navigation graph and import that.");
    }
    return {};
  }

  Trouble add(const FileValue& entry, const std::string& called) {
    if (reading_.size() == kMaxWanted)
      return WaypointPosesText::tr("It has more than %1 waypoints.").arg(kMaxWanted);
    // The panel of Nav2 in rviz writes both as lists.
    const FileValue *const pose = entry.find("pose"), *const orientation = entry.find("orientation");
    if (pose && orientation && pose->isList() && orientation->isList()) reading_.expectScalarFirst();
    const int row = int(reading_.size()) + 1;
    if (const auto read = reading_.add(row, entry, called); !read) {
      const QString where = called.empty()
                                ? QString::number(row)
                                : QStringLiteral("%1 (%2)").arg(row).arg(words::plainName(called).left(80));
      return WaypointPosesText::tr("Waypoint %1: %2").arg(where, read.error());
    }
    return {};
  }

  /// `path`: where it is in the file; `called`: the name of the member.
  Trouble readIn(const FileValue& value, const std::string& path, const std::string& called, int depth) {
    if (depth > kDeepestList) return leave(path);
    if (isPoseMap(value)) return add(value, called);
    if (value.isMap()) {
      // Beside lists of poses a list of numbers is something else: a size, an origin.
      const bool lists = std::any_of(value.members.begin(), value.members.end(), [](const auto& member) {
        const bool holds = member.second.isMap() || member.second.isList();
        return holds && member.first != "header" && !isPoseList(member.second) && !isPoseMap(member.second);
      });
      for (const auto& [name, member] : value.members) {
        const std::string inside = path.empty() ? name : path + "." + name;
        if (lists && isPoseList(member)) {
          reading_.leaveOut(inside);
          continue;
        }
        if (const auto why = readMember(name, member, inside, depth)) return why;
      }
      return {};
    }
    if (!value.isList()) return leave(path.empty() ? value.text : path);
    for (const FileValue& item : value.items) {
      const bool pose = isPoseMap(item) || isPoseList(item);
      // {dock: [1, 2, 0]}: lists of single names.
      const bool holds = item.isMap() && !pose;
      if (const auto why = holds ? readIn(item, path, {}, depth + 1) : add(item, {})) return why;
    }
    return {};
  }

  Trouble readMember(const std::string& name, const FileValue& member, const std::string& path, int depth) {
    const FieldMeaning meaning = meaningOf(name);
    if (meaning == FieldMeaning::Frame || name == "header") {
      const FileValue* const frame = name == "header" ? member.find("frame_id") : &member;
      if (!frame || frame->isBlank() || frame->text == "map" || frame->text == "/map") return {};
      return WaypointPosesText::tr("The frame is \"%1\". Only \"map\" is supported.")
          .arg(words::plainName(frame->text.substr(0, 80)));
    }
    if (isPoseMap(member)) return add(member, name);
    if (isPoseList(member)) {
      static const std::set<std::string> kLists{"waypoints", "poses", "goals",  "points",
                                                "locations", "nodes", "places", "path"};
      if (kLists.contains(name))
        return WaypointPosesText::tr(
                   "%1 is one flat list of numbers. A list of lists is needed: [[x, y, yaw], …].")
            .arg(words::plainName(path).left(80));
      return add(member, name);
    }
    if (member.isMap() || member.isList()) return readIn(member, path, {}, depth + 1);
    return leave(path);
  }

  /// levels: {L1: {vertices: [[x, y, {name: dock, …}], …], lanes: […]}}, in metres.
  Trouble readGraph(const FileValue& document) {
    for (const auto& [name, member] : document.members) {
      if (name != "levels") reading_.leaveOut(name);
    }
    const FileValue* const levels = document.find("levels");
    const auto has_vertices = [](const auto& level) { return level.second.find("vertices") != nullptr; };
    if (std::count_if(levels->members.begin(), levels->members.end(), has_vertices) > 1)
      return WaypointPosesText::tr(
          "It holds several levels of a building, but a map is one. Leave one level in it.");
    qint64 lanes = 0;
    for (const auto& [level_name, level] : levels->members) {
      for (const auto& [name, member] : level.members) {
        if (name == "lanes") lanes += qint64(member.items.size());
        if (name != "lanes" && name != "vertices") reading_.leaveOut(level_name + "." + name);
        if (name != "vertices") continue;
        for (const FileValue& vertex : member.items) {
          if (const auto why = readVertex(vertex)) return why;
        }
      }
    }
    if (lanes > 0)
      reading_.addRemark(sentences::counted(
          WaypointPosesText::tr("%1 lanes were left out.", nullptr, sentences::formOf(lanes)), lanes));
    return {};
  }

  Trouble readVertex(const FileValue& vertex) {
    FileValue entry{FileValue::Kind::Map};
    if (vertex.items.size() > 2 && vertex.items[2].isMap()) entry = vertex.items[2];
    if (vertex.items.size() > 0) entry.members.emplace_back("x", vertex.items[0]);
    if (vertex.items.size() > 1) entry.members.emplace_back("y", vertex.items[1]);
    return add(entry, {});
  }

  Trouble leave(const std::string& what) {
    if (!what.empty()) reading_.leaveOut(what);
    return {};
  }

  WaypointReading reading_;
};

}  // namespace

WantedFile wantedFromPoses(const std::vector<FileValue>& documents, AngleUnit angles) {
  return PoseList(angles).read(documents);
}

}  // namespace mapwright::exchange
