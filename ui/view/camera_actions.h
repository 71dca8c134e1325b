// Camera commands: zoom, fit, rotate.
#pragma once

namespace mapwright::window {

class Actions;
class MapView;

/// "zoomIn", "zoomOut", "native", "fit", "northUp", "rotateLeft", "rotateRight". The view must outlive them.
void addCameraActions(Actions& actions, MapView& view);

}  // namespace mapwright::window
