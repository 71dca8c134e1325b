// Why a place on the map is blank or old: said where the cursor rests.
#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "window/map/map_view.h"

namespace mapwright::window {

class RegionTip : public QObject {
  Q_OBJECT
 public:
  /// `words`: plain text about a place in the world; empty = there is nothing to say, and no tip.
  RegionTip(MapView& view, std::function<QString(const Eigen::Vector2d& world_m)> words,
            QObject* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  MapView& view_;
  std::function<QString(const Eigen::Vector2d&)> words_;
};

}  // namespace mapwright::window
