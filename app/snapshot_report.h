// The JSON report of a snapshot (docs/command-line.md, "mapwright snapshot"), and its state while it is made.
#pragma once

#include <mutex>
#include <optional>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "geometry/view_transform.h"
#include "session/session.h"

namespace mapwright::app {

struct SnapshotFacts {
  bool complete = false;
  bool whole = false;  // draws a whole map instead of submaps
  QString uuid;        // of the submap list
  session::SubmapCounts counts;
  double made = 0;                                               // the share of the picture, 0..1
  double connected_s = -1, first_paint_s = -1, complete_s = -1;  // since the command began; -1 = not yet
  geometry::ViewTransform view;
  QStringList warnings;
  std::optional<QJsonObject> map;
  std::optional<QJsonObject> region;  // of a picture of one
};
QJsonObject reportOf(const SnapshotFacts& facts);

/// A recent state of the snapshot, for another thread that ends the run.
struct SnapshotStanding {
  int exit_code = 0;
  QString sentence;
  QJsonObject report;
};

/// On any thread.
class SnapshotBoard {
 public:
  void put(SnapshotStanding standing);
  SnapshotStanding take() const;

 private:
  mutable std::mutex mutex_;
  SnapshotStanding standing_;
};

}  // namespace mapwright::app
