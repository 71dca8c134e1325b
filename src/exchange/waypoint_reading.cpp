#include "exchange/waypoint_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <QCoreApplication>

#include "geometry/pose.h"
#include "sentences/plural.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::exchange {
namespace {

class WaypointReadingText {
  Q_DECLARE_TR_FUNCTIONS(WaypointReading)
};

constexpr double kFullTurn = 2 * std::numbers::pi + 0.01;
constexpr double kFlat = 1e-3;  // a quaternion whose x and y are smaller does not tilt
constexpr double kSamePlaceDegrees = 1e-4;

using Meanings = std::unordered_map<std::string, FieldMeaning>;

Meanings allMeanings() {
  Meanings all{{"id", FieldMeaning::Id},          {"type", FieldMeaning::Type},
               {"kind", FieldMeaning::Type},      {"tags", FieldMeaning::Tags},
               {"tag", FieldMeaning::Tags},       {"frame", FieldMeaning::Frame},
               {"frameid", FieldMeaning::Frame},  {"map", FieldMeaning::Map},
               {"lat", FieldMeaning::Latitude},   {"latitude", FieldMeaning::Latitude},
               {"lon", FieldMeaning::Longitude},  {"lng", FieldMeaning::Longitude},
               {"long", FieldMeaning::Longitude}, {"longitude", FieldMeaning::Longitude}};
  for (const char* name : {"name", "label", "title", "waypoint", "waypointname", "posename", "goalname",
                           "locationname", "poiname"})
    all[name] = FieldMeaning::Name;
  for (int axis = 0; axis < 4; ++axis) {
    const std::string letter(1, "xyzw"[axis]);
    if (axis < 3) {
      for (const char* before : {"", "p", "pos", "position", "pose", "point", "poseposition"})
        all[before + letter] = FieldMeaning(int(FieldMeaning::X) + axis);
      for (const char* after : {"m", "metres", "meters", "pos", "position", "coord", "coordinate"})
        all[letter + after] = FieldMeaning(int(FieldMeaning::X) + axis);
    }
    for (const char* before : {"q", "o", "ori", "orientation", "rot", "rotation", "quat", "quaternion",
                               "poseorientation", "poseposeorientation"})
      all[before + letter] = FieldMeaning(int(FieldMeaning::QuaternionX) + axis);
  }
  for (const std::string stem : {"yaw", "heading", "theta", "angle", "psi", "orientation", "rotation",
                                 "poseyaw", "posetheta", "orientationyaw"}) {
    all[stem] = FieldMeaning::Yaw;
    for (const char* unit : {"rad", "radian", "radians"}) all[stem + unit] = FieldMeaning::YawRadians;
    for (const char* unit : {"deg", "degree", "degrees"}) all[stem + unit] = FieldMeaning::YawDegrees;
  }
  all["th"] = FieldMeaning::Yaw;
  all["degrees"] = FieldMeaning::YawDegrees;
  return all;
}

std::string bareName(std::string_view name) {
  std::string bare;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (name.substr(i).starts_with("\xc2\xb0")) {  // °
      bare += "deg";
      ++i;
    } else if (c >= 'A' && c <= 'Z') {
      bare += char(c - 'A' + 'a');
    } else if (std::string_view(" \t_-.[](){}/#:").find(c) == std::string_view::npos) {
      bare += c;
    }
  }
  return bare;
}

enum class Part { Whole, Position, Orientation };

/// Which part of a waypoint a map or list of this name is; nullopt = none.
std::optional<Part> partCalled(std::string_view name) {
  static const std::unordered_map<std::string, Part> kParts{{"pose", Part::Whole},
                                                            {"posestamped", Part::Whole},
                                                            {"transform", Part::Whole},
                                                            {"header", Part::Whole},
                                                            {"goal", Part::Whole},
                                                            {"target", Part::Whole},
                                                            {"waypoint", Part::Whole},
                                                            {"position", Part::Position},
                                                            {"pos", Part::Position},
                                                            {"point", Part::Position},
                                                            {"location", Part::Position},
                                                            {"translation", Part::Position},
                                                            {"xyz", Part::Position},
                                                            {"coordinates", Part::Position},
                                                            {"orientation", Part::Orientation},
                                                            {"rotation", Part::Orientation},
                                                            {"quaternion", Part::Orientation},
                                                            {"quat", Part::Orientation},
                                                            {"rot", Part::Orientation},
                                                            {"heading", Part::Orientation}};
  const auto found = kParts.find(bareName(name));
  return found == kParts.end() ? std::nullopt : std::optional(found->second);
}

QString shownValue(const FileValue& value) { return words::plainName(words::text(value.text.substr(0, 80))); }
QString shownField(const std::string& field) { return words::plainName(words::text(field)).left(60); }

std::optional<std::vector<double>> numbersOf(const std::vector<FileValue>& items) {
  std::vector<double> numbers;
  for (const FileValue& item : items) {
    const auto number = item.asNumber();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

QString named(const std::vector<std::string>& fields) {
  constexpr std::size_t kMostNamed = 20;
  QStringList names;
  for (std::size_t i = 0; i < std::min(fields.size(), kMostNamed); ++i) names << shownField(fields[i]);
  QString list = words::listed(names);
  if (fields.size() > kMostNamed)
    list = WaypointReadingText::tr("%1 and %2 more").arg(list, QString::number(fields.size() - kMostNamed));
  return list;
}

}  // namespace

FieldMeaning meaningOf(std::string_view name) {
  static const Meanings kMeanings = allMeanings();
  const auto found = kMeanings.find(bareName(name));
  return found == kMeanings.end() ? FieldMeaning::None : found->second;
}

bool isPlace(const FileValue& map) {
  const auto has = [&](FieldMeaning meaning) {
    return std::any_of(map.members.begin(), map.members.end(),
                       [&](const auto& member) { return meaningOf(member.first) == meaning; });
  };
  return has(FieldMeaning::X) && has(FieldMeaning::Y);
}

/// One waypoint as far as it is read.
class WaypointReading::Entry {
 public:
  Entry(WaypointReading& all, int row) : all_(all) { wanted_.row = row; }

  Why readMap(const std::string& path, Part inside, const FileValue& map) {
    for (const auto& [name, value] : map.members) {
      if (auto why = readMember(path, name, inside, value); !why) return why;
    }
    return {};
  }

  Why readList(const std::string& path, const std::vector<FileValue>& items) {
    if (items.size() == 2 && items[0].isList() && items[1].isList()) {
      if (auto why = readPosition(path, items[0].items); !why) return why;
      return readOrientation(path, items[1].items);
    }
    if (items.size() > 2 && items[0].kind == FileValue::Kind::Text && !items[0].asNumber()) {
      wanted_.name = items[0].text;
      return readList(path, {items.begin() + 1, items.end()});
    }
    const auto numbers = numbersOf(items);
    const std::size_t size = numbers ? numbers->size() : 0;
    if (size != 2 && size != 3 && size != 6 && size != 7)
      return wrong(
          WaypointReadingText::tr("the list is no pose. Known are [x, y], [x, y, yaw], "
                                  "[x, y, z, roll, pitch, yaw] and [x, y, z, qx, qy, qz, qw]."));
    x_ = items[0];
    y_ = items[1];
    if (size == 3) third_ = std::pair(path, (*numbers)[2]);
    if (size < 6) return {};
    z_ = (*numbers)[2];
    return readOrientation(path, {items.begin() + 3, items.end()});
  }

  void called(const std::string& name) {
    if (!wanted_.name && !name.empty()) wanted_.name = name;
  }

  Why settle() {
    settleOrientation();
    if (third_ && headings_.empty()) {
      all_.triples_ = true;
      headings_.push_back(
          {HeadingKind::NoUnit, third_->first.empty() ? "yaw" : third_->first, {third_->second}});
    } else if (third_) {
      z_ = third_->second;
    }
    if (auto why = settlePlace(); !why) return why;
    // Only of one that is there already it can be known whether it is kept in that frame.
    if (!wanted_.frame.empty() && wanted_.id.empty())
      return wrong(wrongFrame(shownValue(FileValue::ofText(wanted_.frame))));
    if (z_ && std::abs(*z_) > 1e-9) ++all_.heights_;
    const std::size_t point = all_.points_.size();
    if (headings_.empty() && without_heading_) wanted_.yaw_rad.emplace();
    all_.points_.push_back(std::move(wanted_));
    if (headings_.empty()) return {};
    // The most certain one.
    std::stable_sort(headings_.begin(), headings_.end(),
                     [](const Heading& a, const Heading& b) { return a.kind < b.kind; });
    for (std::size_t i = 1; i < headings_.size(); ++i) all_.leaveOut(headings_[i].field);
    all_.turn(point, headings_.front());
    return {};
  }

 private:
  Why readMember(const std::string& path, const std::string& name, Part inside, const FileValue& value) {
    const std::string whole = path.empty() ? name : path + "." + name;
    const std::optional<Part> part = partCalled(name);
    if (value.isMap() && (part || isPlace(value))) return readMap(whole, part.value_or(Part::Whole), value);
    if (value.isList() && part) {
      if (*part == Part::Position) return readPosition(whole, value.items);
      if (*part == Part::Orientation) return readOrientation(whole, value.items);
      return readList(whole, value.items);
    }
    FieldMeaning meaning = meaningOf(name);
    if (inside == Part::Orientation && name.size() == 1) {
      const std::size_t axis = std::string_view("xyzw").find(name);
      if (axis != std::string_view::npos) meaning = FieldMeaning(int(FieldMeaning::QuaternionX) + int(axis));
    }
    return readField(whole, meaning, value);
  }

  Why readField(const std::string& path, FieldMeaning meaning, const FileValue& value) {
    const auto text = [&](std::optional<std::string>& into) -> Why {
      if (value.kind == FileValue::Kind::Null) return {};
      if (value.isList() || value.isMap())
        return wrong(WaypointReadingText::tr("%1 is not a text.").arg(shownField(path)));
      into ? all_.leaveOut(path) : void(into = value.text);
      return {};
    };
    switch (meaning) {
      case FieldMeaning::Map:
        return {};  // which map it was of is no matter
      case FieldMeaning::Id:
        return readId(path, value);
      case FieldMeaning::Name:
        if (value.kind == FileValue::Kind::Text && value.text.empty()) return {};
        return text(wanted_.name);
      case FieldMeaning::Type:
        return text(wanted_.type);
      case FieldMeaning::Tags:
        return readTags(path, value);
      case FieldMeaning::Frame:
        if (value.isBlank() || value.text == "map" || value.text == "/map") return {};
        if (value.kind != FileValue::Kind::Text) return wrong(wrongFrame(shownValue(value)));
        wanted_.frame = value.text;
        return {};
      case FieldMeaning::X:
        return x_ ? leave(path) : (x_ = value, Why());
      case FieldMeaning::Y:
        return y_ ? leave(path) : (y_ = value, Why());
      case FieldMeaning::YawRadians:
        return readAngle(HeadingKind::Radians, path, value);
      case FieldMeaning::YawDegrees:
        return readAngle(HeadingKind::Degrees, path, value);
      case FieldMeaning::Yaw:
        return readAngle(HeadingKind::NoUnit, path, value);
      case FieldMeaning::None:
        return leave(path);
      default:
        break;
    }
    if (value.isBlank()) return {};
    const auto number = value.asNumber();
    if (!number) return leave(path);
    const auto keep = [&](std::optional<double>& into) { into ? all_.leaveOut(path) : void(into = *number); };
    if (meaning == FieldMeaning::Z) {
      keep(z_);
    } else if (meaning == FieldMeaning::Latitude) {
      keep(latitude_);
      degrees_fields_ << shownField(path);
    } else if (meaning == FieldMeaning::Longitude) {
      keep(longitude_);
      degrees_fields_ << shownField(path);
    } else {
      keep(quaternion_[std::size_t(int(meaning) - int(FieldMeaning::QuaternionX))]);
      quaternion_fields_.push_back(path);
    }
    return {};
  }

  static QString wrongFrame(const QString& frame) {
    return WaypointReadingText::tr("the frame is \"%1\". Only \"map\" is supported.").arg(frame);
  }

  Why leave(const std::string& path) {
    all_.leaveOut(path);
    return {};
  }

  /// Numbers are valid ids as long as no digit is lost.
  Why readId(const std::string& path, const FileValue& value) {
    if (value.kind == FileValue::Kind::Null) return {};
    constexpr double kExact = 9007199254740992.0;
    const bool whole = value.kind == FileValue::Kind::Number && std::abs(value.number) <= kExact &&
                       value.number == std::floor(value.number);
    if (value.kind != FileValue::Kind::Text && !whole)
      return wrong(WaypointReadingText::tr("the id is not a text."));
    if (!wanted_.id.empty()) return leave(path);
    wanted_.id = value.text;
    return {};
  }

  Why readTags(const std::string& path, const FileValue& value) {
    if (value.kind == FileValue::Kind::Null) return {};
    if (wanted_.tags) return leave(path);
    std::vector<std::string> tags;
    for (const FileValue& tag : value.items) {
      if (tag.kind != FileValue::Kind::Text && tag.kind != FileValue::Kind::Number)
        return wrong(WaypointReadingText::tr("the tags are not a list of texts."));
      tags.push_back(tag.text);
    }
    if (!value.isList()) return wrong(WaypointReadingText::tr("the tags are not a list of texts."));
    wanted_.tags = std::move(tags);
    return {};
  }

  Why readAngle(HeadingKind kind, const std::string& path, const FileValue& value) {
    if (value.isBlank()) {
      without_heading_ = true;
      return {};
    }
    const auto angle = value.asNumber();
    if (!angle)
      return wrong(WaypointReadingText::tr("%1 \"%2\" is not a number such as 1.5.")
                       .arg(shownField(path), shownValue(value)));
    headings_.push_back({kind, path, {*angle}});
    return {};
  }

  Why readPosition(const std::string& path, const std::vector<FileValue>& items) {
    const auto numbers = numbersOf(items);
    if (!numbers || numbers->size() < 2 || numbers->size() > 3)
      return wrong(WaypointReadingText::tr("%1 is not a list of two or three numbers.")
                       .arg(path.empty() ? QStringLiteral("x, y, z") : shownField(path)));
    if (x_ || y_) return leave(path);
    x_ = items[0];
    y_ = items[1];
    if (numbers->size() == 3) z_ = (*numbers)[2];
    return {};
  }

  /// Four numbers are a quaternion, three are roll, pitch and yaw.
  Why readOrientation(const std::string& path, const std::vector<FileValue>& items) {
    const auto numbers = numbersOf(items);
    if (!numbers || (numbers->size() != 3 && numbers->size() != 4))
      return wrong(WaypointReadingText::tr("%1 is no orientation: neither four numbers nor three.")
                       .arg(path.empty() ? QStringLiteral("qx, qy, qz, qw") : shownField(path)));
    const auto& n = *numbers;
    const std::string field = path.empty() ? "orientation" : path;
    if (n.size() == 4) {
      headings_.push_back({HeadingKind::QuaternionList, field, {n[0], n[1], n[2], n[3]}});
      return {};
    }
    if (std::abs(n[0]) > kFlat || std::abs(n[1]) > kFlat) ++all_.tilted_;
    headings_.push_back({HeadingKind::NoUnit, field, {n[2]}});
    return {};
  }

  void settleOrientation() {
    if (quaternion_fields_.empty()) return;
    if (!quaternion_[2] || !quaternion_[3]) {
      for (const std::string& field : quaternion_fields_) all_.leaveOut(field);
      return;
    }
    headings_.push_back(
        {HeadingKind::Quaternion,
         quaternion_fields_.front(),
         {quaternion_[0].value_or(0), quaternion_[1].value_or(0), *quaternion_[2], *quaternion_[3]}});
  }

  Why settlePlace() {
    const bool none = (!x_ || x_->isBlank()) && (!y_ || y_->isBlank());
    if (!none) {
      const FileValue x = x_.value_or(FileValue()), y = y_.value_or(FileValue());
      const auto x_m = x.asNumber(), y_m = y.asNumber();
      if (!x_m || !y_m)
        return wrong(WaypointReadingText::tr("x \"%1\" and y \"%2\" are not two numbers such as 1.5.")
                         .arg(shownValue(x), shownValue(y)));
      wanted_.position_m = Eigen::Vector2d(*x_m, *y_m);
    }
    if (degrees_fields_.isEmpty()) return {};
    const auto isPlace = [&](double x, double y) {
      return std::abs(x - longitude_.value_or(NAN)) < kSamePlaceDegrees &&
             std::abs(y - latitude_.value_or(NAN)) < kSamePlaceDegrees;
    };
    if (none || isPlace(wanted_.position_m->x(), wanted_.position_m->y()) ||
        isPlace(wanted_.position_m->y(), wanted_.position_m->x()))
      return wrong(
          WaypointReadingText::tr("its place is in longitude and latitude (%1), not in metres of the map.")
              .arg(words::listed(degrees_fields_)));
    for (const QString& field : degrees_fields_) all_.leaveOut(field.toStdString());
    return {};
  }

  WaypointReading& all_;
  WantedWaypoint wanted_;
  std::optional<FileValue> x_, y_;
  std::optional<double> z_, latitude_, longitude_;
  std::optional<std::pair<std::string, double>> third_;  // of a list: a heading, or z beside an orientation
  std::array<std::optional<double>, 4> quaternion_;
  std::vector<std::string> quaternion_fields_;
  QStringList degrees_fields_;
  std::vector<Heading> headings_;
  bool without_heading_ = false;  // it is said that it has none
};

tl::expected<void, QString> WaypointReading::add(int row, const FileValue& entry, const std::string& called) {
  Entry read(*this, row);
  Why why = entry.isMap()    ? read.readMap({}, Part::Whole, entry)
            : entry.isList() ? read.readList({}, entry.items)
                             : Why(wrong(WaypointReadingText::tr("it is neither fields nor a list.")));
  if (!why) return why;
  read.called(called);
  return read.settle();
}

void WaypointReading::leaveOut(const std::string& field) {
  if (known_left_out_.insert(field).second) left_out_.push_back(field);
}

/// The heading of a point, or what will decide it.
void WaypointReading::turn(std::size_t point, const Heading& heading) {
  const auto& n = heading.numbers;
  switch (heading.kind) {
    case HeadingKind::Radians:
      points_[point].yaw_rad.emplace(n[0]);
      if (std::abs(n[0]) > kFullTurn) ++beyond_a_turn_;
      break;
    case HeadingKind::Degrees:
      points_[point].yaw_rad.emplace(geometry::radiansFromDegrees(n[0]));
      break;
    case HeadingKind::Quaternion:
      turnBy(point, {n[0], n[1], n[2], n[3]});
      break;
    case HeadingKind::QuaternionList:
    case HeadingKind::NoUnit:
      undecided_.emplace_back(point, heading);
      break;
  }
}

void WaypointReading::turnBy(std::size_t point, const std::array<double, 4>& xyzw) {
  const auto rotation = geometry::toIsometry({0, 0, 0, xyzw[0], xyzw[1], xyzw[2], xyzw[3]});
  if (!rotation) {
    ++no_rotation_;
    return;
  }
  if (std::hypot((*rotation)(0, 2), (*rotation)(1, 2)) > 2 * kFlat) ++tilted_;
  points_[point].yaw_rad.emplace(geometry::projectToPlane(*rotation).yaw_rad);
}

/// In which order quaternions are that are lists: floors are flat, so two of four are zero.
bool WaypointReading::scalarFirst() const {
  bool last_fits = true, first_fits = true;
  for (const auto& [point, heading] : undecided_) {
    if (heading.kind != HeadingKind::QuaternionList) continue;
    const auto& n = heading.numbers;
    last_fits = last_fits && std::abs(n[0]) < kFlat && std::abs(n[1]) < kFlat;
    first_fits = first_fits && std::abs(n[1]) < kFlat && std::abs(n[2]) < kFlat;
  }
  return last_fits == first_fits ? scalar_first_ : first_fits;
}

WantedList WaypointReading::finish() && {
  WantedList list;
  const bool scalar_first = scalarFirst();
  double largest = 0;
  bool any_list = false;
  std::vector<std::string> without_unit;
  for (const auto& [point, heading] : undecided_) {
    if (heading.kind == HeadingKind::QuaternionList) {
      const auto& n = heading.numbers;
      any_list = true;
      scalar_first ? turnBy(point, {n[1], n[2], n[3], n[0]}) : turnBy(point, {n[0], n[1], n[2], n[3]});
      continue;
    }
    largest = std::max(largest, std::abs(heading.numbers[0]));
    if (std::find(without_unit.begin(), without_unit.end(), heading.field) == without_unit.end() &&
        without_unit.size() < 3)
      without_unit.push_back(heading.field);
  }
  const bool degrees = angles_ == AngleUnit::Degrees || (angles_ == AngleUnit::Guess && largest > kFullTurn);
  for (const auto& [point, heading] : undecided_) {
    if (heading.kind == HeadingKind::NoUnit)
      points_[point].yaw_rad.emplace(degrees ? geometry::radiansFromDegrees(heading.numbers[0])
                                             : heading.numbers[0]);
  }
  if (triples_) notes_ << WaypointReadingText::tr("Lists of three numbers were read as x, y and heading.");
  if (any_list)
    notes_ << WaypointReadingText::tr("Orientations that are lists were read in the order %1.")
                  .arg(scalar_first ? QStringLiteral("w, x, y, z") : QStringLiteral("x, y, z, w"));
  list.unit_guessed = angles_ == AngleUnit::Guess && largest > 0;
  if (list.unit_guessed && degrees)
    notes_ << WaypointReadingText::tr(
                  "The unit of the headings (%1) is not given. They were read as degrees: %2 is too much for "
                  "radians.")
                  .arg(named(without_unit), words::text(digitsOf(largest)));
  if (list.unit_guessed && !degrees)
    notes_ << WaypointReadingText::tr(
                  "The unit of the headings (%1) is not given. They were read as radians: none is more than "
                  "a full turn.")
                  .arg(named(without_unit));
  const auto count = [&](qint64 number, const QString& sentence) {
    if (number > 0) notes_ << sentences::counted(sentence, number);
  };
  count(beyond_a_turn_,
        WaypointReadingText::tr("%1 headings in radians are more than a full turn. Are they degrees?",
                                nullptr, sentences::formOf(beyond_a_turn_)));
  count(no_rotation_, WaypointReadingText::tr("%1 orientations are no rotation (all zero) and were left out.",
                                              nullptr, sentences::formOf(no_rotation_)));
  count(tilted_, WaypointReadingText::tr("%1 waypoints are tilted; only their heading was read.", nullptr,
                                         sentences::formOf(tilted_)));
  count(heights_, WaypointReadingText::tr("The heights (z) of %1 waypoints were left out.", nullptr,
                                          sentences::formOf(heights_)));
  if (!left_out_.empty())
    notes_
        << WaypointReadingText::tr("Left out, as waypoints have no place for it: %1.").arg(named(left_out_));
  list.points = std::move(points_);
  list.notes = std::move(notes_);
  return list;
}

}  // namespace mapwright::exchange
