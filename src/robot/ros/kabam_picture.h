// The picture of a map in the form that KABAM's update_map_image expects. Source:
// docs/protocols/kabam-map-manager.md, "Pictures", ROS map_server (its gray levels for free, occupied and
// unknown).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QCryptographicHash>

#include "grids/grid_pyramid.h"
#include "net/rosbridge/requests.h"
#include "robot/ros/kabam_messages.h"

namespace mapwright::robot::ros {

/// The gray of a cell of CellCode::Occupancy: 254 free, 0 occupied, 205 unknown, which map_server reads the
/// same in all its modes. nullopt: a value in between, whose gray would be read differently by each mode.
std::optional<std::uint8_t> shadeOf(std::uint8_t cell);

/// The arguments of update_map_image, one band of rows after the other, so that neither the picture nor its
/// text is ever in memory as a whole. One thread.
class PictureArgs : public net::rosbridge::ArgsSource {
 public:
  /// `cells`: complete, of CellCode::Occupancy. `wanted` is called before each band: false ends it.
  PictureArgs(const KabamMap& map, std::shared_ptr<const grids::GridPyramid> cells,
              std::function<bool()> wanted);

  qint64 bytes() const override;
  std::optional<QByteArray> next() override;

  /// The cell without a gray level that ended it; nullopt: none.
  std::optional<std::uint8_t> cellBetween() const { return between_; }
  /// Once all has been handed out: wire::fingerprint of pgmOf() of these cells, as a topic brings them.
  const std::string& fingerprint() const { return fingerprint_; }

 private:
  bool makeBand();

  std::shared_ptr<const grids::GridPyramid> cells_;
  std::function<bool()> wanted_;
  QByteArray head_, shades_;  // shades_ waits for a third one: base64 takes three at a time
  int row_ = 0;
  bool began_ = false;
  std::optional<std::uint8_t> between_;
  QCryptographicHash hash_{QCryptographicHash::Sha1};
  std::string fingerprint_;
};

/// How many cells of a PGM from pgmOf() differ from these; nullopt: another size, or not a PGM.
std::optional<std::int64_t> differingCells(const grids::GridPyramid& cells, const std::string& pgm);

}  // namespace mapwright::robot::ros
