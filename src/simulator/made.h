// What follows from a scene alone is made once, also for the robots that come to live in it later: tests
// start hundreds of them in one process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "simulator/pictures.h"
#include "simulator/scene.h"
#include "simulator/submap_source.h"

namespace mapwright::simulator {

constexpr std::size_t kBodiesKept = 600;  // some 64 MiB

/// Safe from any thread.
struct MadeOfScene {
  explicit MadeOfScene(Scene whole) : scene(std::move(whole)), pictures(scene) {}

  const Scene scene;
  MapPictures pictures;
  BodyCache bodies{kBodiesKept};  // those that isOfSceneAlone()
};

/// False: its robot has a part in it.
inline bool isOfSceneAlone(const SubmapSource& source) { return source.session == 0 && source.extra.empty(); }

/// Null when there is no such scene. What was made of the last small one stays for the next robot.
std::shared_ptr<MadeOfScene> madeOf(const std::string& scene, int submaps, std::uint32_t seed);

}  // namespace mapwright::simulator
