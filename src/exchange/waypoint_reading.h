// What the fields of a waypoint are called in the files that people have, and what they mean: the same for
// tables, GeoJSON and lists of poses. Whatever a waypoint has no field for is named. Pure functions.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "exchange/file_value.h"
#include "exchange/wanted_waypoint.h"

namespace mapwright::exchange {

enum class FieldMeaning {
  None,  // no field of a waypoint
  Id,
  Name,
  Type,
  Tags,
  Frame,
  Map,
  X,
  Y,
  Z,
  YawRadians,
  YawDegrees,
  Yaw,  // without a unit
  QuaternionX,
  QuaternionY,
  QuaternionZ,
  QuaternionW,
  Latitude,
  Longitude,
};
/// By the name of a column, property or member, in upper or lower case: "X [m]", "yaw_deg", "pos.x".
FieldMeaning meaningOf(std::string_view name);

/// A map with both x and y.
bool isPlace(const FileValue& map);

/// Reads waypoints one by one. What can only be decided by all of them (the unit of headings that have none,
/// the order of quaternions that are lists) is decided at the end, with a note.
class WaypointReading {
 public:
  explicit WaypointReading(AngleUnit angles) : angles_(angles) {}

  /// `entry`: a map of fields (poses and parts of poses may be maps of their own), or a list: [x, y],
  /// [x, y, yaw], [x, y, z, roll, pitch, yaw], [x, y, z, qx, qy, qz, qw], [[x, y, z], [qx, qy, qz, qw]].
  /// `called`: its name, unless it has one. The error is a sentence without the position in the file.
  tl::expected<void, QString> add(int row, const FileValue& entry, const std::string& called = {});
  /// What is left out: a field by its name; said once.
  void leaveOut(const std::string& field);
  /// A sentence of its own.
  void addRemark(const QString& sentence) { notes_ << sentence; }
  /// Quaternions that are lists are probably in the order w, x, y, z, as rviz' panel of Nav2 writes them.
  void expectScalarFirst() { scalar_first_ = true; }
  std::size_t size() const { return points_.size(); }
  bool full() const { return points_.size() >= kMaxWanted; }

  WantedList finish() &&;

 private:
  enum class HeadingKind { Radians, Degrees, Quaternion, QuaternionList, NoUnit };
  struct Heading {
    HeadingKind kind = HeadingKind::NoUnit;
    std::string field;
    std::array<double, 4> numbers{};  // the angle, or the quaternion
  };
  class Entry;
  using Why = tl::expected<void, QString>;

  void turn(std::size_t point, const Heading& heading);
  void turnBy(std::size_t point, const std::array<double, 4>& xyzw);
  bool scalarFirst() const;

  AngleUnit angles_;
  bool scalar_first_ = false;
  std::vector<WantedWaypoint> points_;
  std::vector<std::pair<std::size_t, Heading>> undecided_;  // of which point
  std::vector<std::string> left_out_;
  std::set<std::string> known_left_out_;
  QStringList notes_;
  qint64 heights_ = 0, tilted_ = 0, no_rotation_ = 0, beyond_a_turn_ = 0;
  bool triples_ = false;  // lists of three numbers were read as x, y, heading
};

}  // namespace mapwright::exchange
