// Waypoints as a file asks for them: what it does not say stays as it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace mapwright::exchange {

/// Why a row of a file means nothing.
inline tl::unexpected<QString> wrong(const QString& why) { return tl::make_unexpected(why); }

inline constexpr std::size_t kMaxWantedBytes = std::size_t(64) << 20;
inline constexpr std::size_t kMaxWanted = 100'000;

/// nullopt = the file does not say. Texts are UTF-8, as they stand there; positions are finite metres.
struct WantedWaypoint {
  int row = 0;     // of the file: a line of a CSV, a feature of a GeoJSON; counted from 1
  std::string id;  // empty = none
  std::optional<std::string> name = {}, type = {};
  std::optional<Eigen::Vector2d> position_m = {};
  std::optional<std::optional<double>> yaw_rad = {};  // said to be none: {nullopt}
  std::optional<std::vector<std::string>> tags = {};
  std::string frame = {};  // other than "map", of one that has an id; empty = that of the map
  bool operator==(const WantedWaypoint&) const = default;
};

/// What headings are in that have no unit in the file.
enum class AngleUnit {
  Guess,  // radians, unless one of them is too large for that
  Radians,
  Degrees,
};

struct WantedList {
  std::vector<WantedWaypoint> points;
  QStringList notes;          // what of the file is of no use, and what was guessed, a sentence each
  bool unit_guessed = false;  // of headings; a note says so
};

/// The error is a sentence without the name of the file: "Line 3: …".
using WantedFile = tl::expected<WantedList, QString>;

}  // namespace mapwright::exchange
