// Robot addresses as people type them (cli.md, "Robot addresses").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QUrl>
#include <tl/expected.hpp>

#include "geometry/pose.h"

namespace mapwright::robot {

enum class Backend { Axbot, Aimdk, File, Demo };

/// A parsed address. `url` is the HTTP(S) base of the robot (port filled in), or the demo's query; empty for
/// a file.
struct Address {
  Backend backend = Backend::Axbot;
  QUrl url;
  QString text;  // normalised: "axbot+http://192.0.2.7:8090", "demo:?scene=office", "file:/maps/a.yaml"
  QUrl tf;       // Aimdk: the rosbridge that sends the pose; empty = none
  QString path;  // File: absolute
  std::optional<double> resolution_m;     // File: of a bare picture, metres per cell
  std::optional<geometry::Pose2> origin;  // File: of a bare picture, its lower-left corner
};

/// Parses an address; the error is a sentence. Missing scheme means axbot+http, missing port 8090 (50807 for
/// aimdk+). What exists as a path, or ends like a map file, is a file. An address with a user or password in
/// it is refused: secrets never go there. Schemes of robots that this version cannot talk to yet (kabam,
/// rep130) are refused with a sentence that says so.
tl::expected<Address, QString> parseAddress(const QString& text);

/// "192.0.2.7:8090": which server on the network it is; empty for files and the demo.
QString hostOf(const Address& address);

/// The files that a map is read from at `address`: the one that it names, or `id` in the folder that it
/// names, and the map's picture (each where there is one). None of a robot.
std::vector<std::string> localFiles(const QString& address, const std::string& id,
                                    const std::string& picture);

}  // namespace mapwright::robot
