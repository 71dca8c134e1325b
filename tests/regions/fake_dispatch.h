// A dispatcher whose answers wait until they are let go, over a map that is a formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <QTimer>

#include "robot/map_dispatch.h"

namespace mapwright::regions {

/// The map: `width` x `height` cells whose lower left corner lies at `origin`.
struct FakeGround {
  int width = 8192, height = 8192;
  double resolution_m = 0.05;
  geometry::Pose2 origin{-204.8, -204.8, 0};
  std::string frame = "map";
  /// Of a cell, counted from the lower left.
  std::function<std::int8_t(int x, int y)> cell = [](int x, int y) {
    return std::int8_t((x / 64 + y / 64) % 3 == 0 ? 100 : (x / 64 + y / 64) % 3 == 1 ? 0 : -1);
  };

  /// Columns and rows, counted from the lower left.
  struct Cells {
    int left = 0, bottom = 0, right = 0, top = 0;
    int wide() const { return right - left; }
    int high() const { return top - bottom; }
    std::int64_t count() const { return std::int64_t(wide()) * high(); }
  };
  /// Those that a rectangle touches, cut at the edge of the map; none beside it. Turned as the map is.
  Cells cellsIn(const map::GridRegion& region) const {
    geometry::WorldRect box;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        box.extend(origin.inverse().apply(region.centre_m +
                                          Eigen::Vector2d(x * region.size_m.x(), y * region.size_m.y())) /
                   resolution_m);
      }
    }
    constexpr double kRounding = 1e-6;
    const Cells cells{std::max(0, int(std::floor(box.min_x + kRounding))),
                      std::max(0, int(std::floor(box.min_y + kRounding))),
                      std::min(width, int(std::ceil(box.max_x - kRounding))),
                      std::min(height, int(std::ceil(box.max_y - kRounding)))};
    return cells.wide() > 0 && cells.high() > 0 ? cells : Cells{};
  }
  map::GridPart part(const map::GridRegion& region) const { return cut(cellsIn(region)); }
  map::GridPart all() const { return cut({0, 0, width, height}); }
  map::GridPart nothing() const { return cut({}); }
  map::GridPart cut(const Cells& wanted) const {
    map::GridPart part;
    part.frame = frame;
    part.grid.resolution_m = resolution_m;
    if (wanted.count() == 0) return part;
    const Eigen::Vector2d corner = origin.apply({wanted.left * resolution_m, wanted.bottom * resolution_m});
    part.grid = {wanted.wide(), wanted.high(), resolution_m, {corner.x(), corner.y(), origin.yaw_rad}};
    auto cells = std::make_shared<std::vector<std::int8_t>>(std::size_t(wanted.count()));
    std::int8_t* out = cells->data();
    for (int y = wanted.bottom; y < wanted.top; ++y) {
      for (int x = wanted.left; x < wanted.right; ++x) *out++ = cell(x, y);
    }
    part.cells = std::move(cells);
    return part;
  }
};

class FakeDispatch : public robot::MapDispatch {
 public:
  using MapDispatch::MapDispatch;
  using Reply = robot::OutcomeTo<map::GridPart>;
  struct Waiting {
    std::optional<map::GridRegion> region;
    Reply reply;
    std::shared_ptr<robot::Call::State> state;
    bool cancelled = false;
  };

  FakeGround ground;
  bool offers_regions = true, offers_whole = true, offers_clouds = false;
  bool by_itself = false;  // answers from the event loop
  std::vector<std::shared_ptr<Waiting>> waiting;
  std::vector<map::GridRegion> asked;
  int asked_whole = 0, most_at_once = 0;
  /// Instead of the ground's answer.
  std::function<robot::Outcome<map::GridPart>(const map::GridRegion&)> answer;

  std::vector<robot::DispatchOffer> offers() const override {
    return {{robot::DispatchService::Grid, offers_whole, "/get_map", ""},
            {robot::DispatchService::GridRegion, offers_regions, "/get_sub_map", ""},
            {robot::DispatchService::CloudRegion, offers_clouds, "/get_sub_point_map", ""},
            {robot::DispatchService::Save, true, "/save_map", ""}};
  }
  robot::Call grid(const std::optional<map::GridRegion>& region, Reply reply) override {
    const auto one = std::make_shared<Waiting>();
    one->region = region;
    one->reply = std::move(reply);
    one->state = std::make_shared<robot::Call::State>();
    one->state->cancel = [weak = std::weak_ptr(one)] {
      if (const auto strong = weak.lock()) strong->cancelled = true;
    };
    if (region) {
      asked.push_back(*region);
    } else {
      ++asked_whole;
    }
    waiting.push_back(one);
    most_at_once = std::max(most_at_once, int(waiting.size()));
    if (by_itself) QTimer::singleShot(0, this, [this] { answerOne(); });
    return robot::Call(one->state);
  }
  /// Lets the oldest answer go; false where none waits.
  bool answerOne() {
    if (waiting.empty()) return false;
    const auto one = waiting.front();
    waiting.erase(waiting.begin());
    one->state->over = true;
    if (one->cancelled) {
      one->reply(tl::unexpected(map::Failure{.kind = map::FailureKind::Cancelled}));
    } else if (!one->region) {
      one->reply(ground.all());
    } else {
      one->reply(answer ? answer(*one->region) : robot::Outcome<map::GridPart>(ground.part(*one->region)));
    }
    return true;
  }

  std::optional<robot::MapExtent> extent() const override { return told_extent; }
  std::optional<robot::MapExtent> told_extent;
  robot::Call cloud(robot::CloudKind, const std::optional<map::CloudRegion>&,
                    robot::OutcomeTo<std::shared_ptr<const map::SpatialCloud>>) override {
    return {};
  }
  robot::Call save(const std::string& filename, robot::OutcomeTo<std::string> reply) override {
    saved_as.push_back(filename);
    const auto state = std::make_shared<robot::Call::State>();
    answer_save = [state, reply = std::move(reply)](robot::Outcome<std::string> outcome) {
      state->over = true;
      reply(std::move(outcome));
    };
    return robot::Call(state);
  }
  std::vector<std::string> saved_as;
  std::function<void(robot::Outcome<std::string>)> answer_save;
  robot::Call projections(robot::OutcomeTo<std::vector<map::Projection>>) override { return {}; }
  robot::Call project(const std::vector<map::Projection>&,
                      robot::OutcomeTo<std::vector<map::Projection>>) override {
    return {};
  }
  std::vector<robot::ProjectedPart> projected() const override { return {}; }
};

}  // namespace mapwright::regions
