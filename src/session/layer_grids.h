// The small pictures on top of the map (costmaps, incremental map, environment match): decoded off the GUI
// thread, the newest of each kind.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <QObject>

#include "grids/grid_pyramid.h"
#include "map/live_topics.h"
#include "map/problem.h"
#include "work/workers.h"

namespace mapwright::session {

struct LayerGrid {
  map::GridReference reference;  // width and height are the picture's own
  grids::ColoredGrid picture;
};

class LayerGrids : public QObject {
  Q_OBJECT
 public:
  static constexpr std::int64_t kMaxCells = std::int64_t(64) << 20;

  explicit LayerGrids(grids::Resources resources = {}, QObject* parent = nullptr);
  ~LayerGrids() override;

  void onGrid(const map::GridMessage& message);
  /// Null while none has been decoded.
  const LayerGrid* find(map::GridKind kind) const;
  void drop(map::GridKind kind);
  void clear();
  /// A picture is being decoded.
  bool busy() const;
  /// Freezes what is shown: pictures being decoded are ignored.
  void standStill();

 Q_SIGNALS:
  void changed(mapwright::map::GridKind kind);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  /// Its picture cannot be decoded.
  void unreadable(const std::string& fingerprint);

 private:
  struct Row {
    std::optional<LayerGrid> shown;
    std::optional<map::GridMessage> next;  // arrived while another one is being decoded
    bool busy = false;
    bool dropped = false;  // the one being decoded is no longer needed
    bool broken = false;   // the last one could not be shown
  };
  void start(map::GridKind kind, map::GridMessage message);

  std::map<map::GridKind, Row> rows_;
  quint64 generation_ = 0;
  grids::Resources resources_;
  work::Tasks tasks_;
};

}  // namespace mapwright::session
