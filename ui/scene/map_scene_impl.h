// What a MapScene holds besides its face. Private to this room.
#pragma once

#include "scene/map_scene.h"
#include "scene/scene_items.h"

namespace mapwright::scene {

class MapScene::Impl : public SceneItems {
 public:
  using SceneItems::SceneItems;
};

}  // namespace mapwright::scene
