// Who has chosen where the map is looked at: until the user has, what arrives may be fitted into the view.
#pragma once

#include <QObject>

#include "geometry/rect.h"

namespace mapwright::window {

class MapView;

class Viewpoint : public QObject {
  Q_OBJECT
 public:
  /// `view` must outlive this.
  explicit Viewpoint(MapView& view, QObject* parent = nullptr);

  /// Nothing moves the camera by itself any more.
  bool chosen() const { return chosen_; }
  void choose() { chosen_ = true; }
  /// Another robot: its maps lie elsewhere.
  void forget() { chosen_ = false; }

  /// Fits what has arrived into the view.
  void fit(const geometry::WorldRect& world);
  /// The same, and strips and panels that come later move nothing.
  void fitOnce(const geometry::WorldRect& world);
  /// Goes where the user wants to look: nearer when it would be a speck, farther when it would not fit; else
  /// the scale stays.
  void lookAt(const geometry::WorldRect& world);

 private:
  MapView& view_;
  bool chosen_ = false;
};

}  // namespace mapwright::window
