// A tooltip saying why a place on the map is blank or old.
#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "ui/view/map_view.h"

namespace mapwright::window {

class RegionTip : public QObject {
  Q_OBJECT
 public:
  /// `words`: plain text about a position in the world; empty = no tooltip.
  RegionTip(MapView& view, std::function<QString(const Eigen::Vector2d& world_m)> words,
            QObject* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  MapView& view_;
  std::function<QString(const Eigen::Vector2d&)> words_;
};

}  // namespace mapwright::window
