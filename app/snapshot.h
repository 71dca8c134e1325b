// `mapwright snapshot` (docs/command-line.md): a picture of a robot's map without a window.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <Eigen/Core>
#include <QSize>
#include <QString>
#include <tl/expected.hpp>

#include "app/commands.h"
#include "geometry/rect.h"
#include "map/catalogue.h"
#include "render/tile_renderer.h"
#include "robot/offers_topics.h"
#include "suite/suite.h"
#include "ui/scene/map_scene.h"

namespace mapwright::app {

/// The options as typed; empty = not given.
struct SnapshotArguments : RobotArguments {
  std::string output, mode, map, region, center, layers, resolution, origin;
  std::string size = "1280x800", colors = "normal", theme = "light", settle = "complete";
  std::optional<double> scale;
  double rotate_deg = 0;
  int slice = 0;
  bool fit = false, raw = false, average = false, robot_anyway = false, force = false;
  std::string bag, at;  // show the robot as it was at that time
};

/// What to draw: the submaps, or a whole map. Automatic: submaps if the robot has them.
enum class SnapshotMode { Automatic, Submaps, Whole };

struct SnapshotOptions {
  QString robot, output, report;
  std::string bag, at;         // its name (empty = the live robot) and a time in it as typed
  std::optional<double> at_s;  // that time: seconds since the epoch; nullopt: the bag is not open yet
  SnapshotMode mode = SnapshotMode::Automatic;
  std::optional<map::MapKey> map;  // nullopt = the live or the current one
  bool average = false;            // when zoomed out: average instead of "occupied wins"
  /// Only this part of a map that the robot sends by region. The picture gets the size of the region:
  /// `size_px` is unknown until the cell size is known, and so is `scale_m_per_px` unless it was given.
  std::optional<geometry::WorldRect> region;
  std::optional<Eigen::Vector2d> center_m;  // nullopt = fit
  double scale_m_per_px = 0;
  QSize size_px;
  double rotation_rad = 0;
  std::set<ui::scene::Layer>
      layers;  // without Submaps and WholeMap, which follow from the mode unless both are named
  std::set<ui::scene::Layer> named;  // named one by one: a warning is printed if one of them stays empty
  robot::TopicChoices topics;        // --layers NAME=TOPIC
  bool robot_anyway = false;         // draw the robot also on a map that it is not in
  int slice = 0;
  render::ColorMode colors = render::ColorMode::Normal;
  bool dark = false;
  bool raw = false;
  bool json = false;
  bool force = false;              // overwrite files even if the map was read from them
  std::optional<double> settle_s;  // nullopt = complete
  double timeout_s = 60;
  suite::Quality quality;  // what it needs is loaded, too

  bool wantsSubmaps() const;
  bool wantsWhole() const;
};

/// Adds the options of a picture, of a robot or of a bag.
void addSnapshotOptions(CLI::App* command, SnapshotArguments& args);
/// --bag and --at.
void addSnapshotBag(CLI::App* command, SnapshotArguments& args);

/// The size in pixels of a region at this scale; nullopt = larger than a picture may be.
std::optional<QSize> pixelsOf(const geometry::WorldRect& region, double scale_m_per_px);

/// The error is a sentence that names the option.
tl::expected<SnapshotOptions, QString> parseSnapshotOptions(const SnapshotArguments& args);

/// Runs to the end and returns the exit code. Makes its own QApplication, offscreen.
int snapshot(const SnapshotArguments& args, int& argc, char** argv);
/// The same with the options before the subcommand; the name of a recording also gives the robot.
int snapshotOf(SnapshotArguments& args, const Invocation& before);

/// `bags snapshot` and `bags film`; see Commands.
void addBagPictures(Commands& commands, CLI::App& bags);

}  // namespace mapwright::app
