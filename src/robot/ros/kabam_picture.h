// The picture of a map as KABAM's update_map_image wants it. Source: docs/protocols/kabam-map-manager.md,
// "Pictures", ROS map_server (its shades of free, occupied and unknown).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QCryptographicHash>

#include "grids/grid_pyramid.h"
#include "net/rosbridge/upload.h"
#include "robot/ros/kabam_messages.h"

namespace mapwright::robot::ros {

/// The gray of a cell of CellCode::Occupancy: 254 free, 0 occupied, 205 unknown, which every reading of
/// map_server takes for just these. nullopt: a cell in between, whose gray would be another cell by each of
/// its readings.
std::optional<std::uint8_t> shadeOf(std::uint8_t cell);

/// The arguments of update_map_image, a band of rows after the other: neither the picture nor its text is
/// ever held as a whole. One thread.
class PictureArgs : public net::rosbridge::ArgsSource {
 public:
  /// `cells`: complete, of CellCode::Occupancy. `wanted` is asked before each band: false ends it.
  PictureArgs(const KabamMap& map, std::shared_ptr<const grids::GridPyramid> cells,
              std::function<bool()> wanted);

  qint64 bytes() const override;
  std::optional<QByteArray> next() override;

  /// The cell that has no shade, because of which it ended; nullopt: none.
  std::optional<std::uint8_t> cellBetween() const { return between_; }
  /// Once all has been handed out: wire::fingerprint of pgmOf() of these cells, as a topic brings them.
  const std::string& fingerprint() const { return fingerprint_; }

 private:
  bool makeBand();

  std::shared_ptr<const grids::GridPyramid> cells_;
  std::function<bool()> wanted_;
  QByteArray head_, shades_;  // shades that wait for a third one: base64 takes three at a time
  int row_ = 0;
  bool began_ = false;
  std::optional<std::uint8_t> between_;
  QCryptographicHash hash_{QCryptographicHash::Sha1};
  std::string fingerprint_;
};

/// How many cells of a PGM that pgmOf() made differ from these; nullopt: it is of another size, or none.
std::optional<std::int64_t> differingCells(const grids::GridPyramid& cells, const std::string& pgm);

}  // namespace mapwright::robot::ros
