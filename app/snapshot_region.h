// The part of a map by regions that a snapshot shows (--region).
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QJsonObject>
#include <QSize>
#include <QStringList>

#include "app/commands.h"
#include "geometry/rect.h"
#include "regions/region_fetch.h"
#include "robot/robot.h"
#include "ui/shot/picture.h"

namespace mapwright::app {

class RegionSnapshot {
 public:
  /// `robot`: its address. `scale_m_per_px`: 0 = a pixel is a cell.
  RegionSnapshot(QString robot, const geometry::WorldRect& rect, double scale_m_per_px)
      : robot_(std::move(robot)), rect_(rect), scale_m_per_px_(scale_m_per_px) {}

  /// Begins to fetch it as soon as `robot` offers that; `finished`: all of it is decided. Fails if it is not
  /// offered within `within_s`.
  std::optional<CommandFailure> begin(robot::Robot& robot, double online_for_s, double within_s,
                                      std::function<void()> finished);
  bool begun() const { return fetch_ != nullptr; }
  /// Nothing more will come.
  bool over() const { return fetch_ && fetch_->over(); }
  bool complete() const { return fetch_ && fetch_->complete(); }
  bool anyCame() const { return fetch_ && fetch_->counts().answered > 0; }
  /// Of the picture; nullopt while the size of a cell is unknown. Fails if that is too large for a picture.
  CommandResult<std::optional<QSize>> size() const;
  /// Metres; 0 while it is unknown.
  double scale() const;

  /// What is to be said about it, before it is drawn. Fails if there is nothing to draw. `link`: of the
  /// connection.
  CommandResult<QStringList> notes(const QString& link) const;
  /// What has come of it; nothing more will change there.
  regions::RegionMap* still();
  /// Its cells; a sentence if parts of them cannot be drawn.
  std::optional<QString> putInto(ui::shot::RawContent& content);
  /// {"center", "lengths", …} of the report.
  QJsonObject json() const;

 private:
  const regions::MapRegions& regions() const { return fetch_->map().regions(); }

  QString robot_;
  geometry::WorldRect rect_;
  double scale_m_per_px_;
  std::unique_ptr<regions::RegionFetch> fetch_;
};

}  // namespace mapwright::app
