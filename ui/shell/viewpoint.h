// Whether the user has chosen the view: until then, arriving data may be fitted into it.
#pragma once

#include <QObject>

#include "geometry/rect.h"

namespace mapwright::ui {

class MapView;

class Viewpoint : public QObject {
  Q_OBJECT
 public:
  /// `view` must outlive this.
  explicit Viewpoint(MapView& view, QObject* parent = nullptr);

  /// The camera no longer moves automatically.
  bool chosen() const { return chosen_; }
  void choose() { chosen_ = true; }
  /// Another robot: its maps are elsewhere.
  void forget() { chosen_ = false; }

  /// Fits arriving data into the view.
  void fit(const geometry::WorldRect& world);
  /// The same, but later strips and panels do not change the view.
  void fitOnce(const geometry::WorldRect& world);
  /// Moves to what the user selected: zooms in if it would be tiny, out if it would not fit; otherwise keeps
  /// the scale.
  void lookAt(const geometry::WorldRect& world);

 private:
  MapView& view_;
  bool chosen_ = false;
};

}  // namespace mapwright::ui
