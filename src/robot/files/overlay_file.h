// The overlays of a local map: a GeoJSON FeatureCollection in metres of the map, next to it or by itself.
#pragma once

#include <map>
#include <string>

#include <QObject>

#include "robot/files/map_files.h"
#include "robot/overlay_store.h"

namespace mapwright::robot::files {

inline constexpr std::size_t kMaxOverlayBytes = std::size_t(256) << 20;

/// "office.yaml" -> "office.overlays.geojson" in the same folder, or "office.geojson" if only that is there;
/// a GeoJSON file is its own.
QString overlayPathOf(const QString& map_path);

struct OverlaysBeside {
  std::vector<map::OverlayFeature> drawn;
  std::vector<map::BrokenOverlay> broken;  // which cannot be drawn, or not all of which
};
/// As the map draws them; none where there is no such file. The error names the file that cannot be read.
tl::expected<OverlaysBeside, Fault> overlaysBeside(const QString& map_path);

/// Reads and writes them. Lives on the thread of the map files.
class OverlayFiles : public QObject {
  Q_OBJECT
 public:
  explicit OverlayFiles(FileOptions options);

  /// The versions are counted here: one more whenever the text is another one than it was.
  Outcome<OverlayText> read(const map::MapKey& key);
  /// A FailureKind::Conflict if the file is not what was read last.
  Outcome<std::monostate> write(const map::MapKey& key, const std::string& text);

 private:
  struct Known {
    std::string text;
    int version = 0;
  };
  struct Location {
    map::MapKey key;
    QString map, path;
  };
  Outcome<Location> locationOf(const map::MapKey& key) const;
  map::Failure failure(const Location& location, map::FailureKind kind, Fault cause) const;
  Outcome<std::string> textOf(const Location& location) const;
  OverlayText remember(const Location& location, std::string text);

  FileOptions options_;
  std::map<QString, Known> known_;  // by path
};

}  // namespace mapwright::robot::files
