// What is wrong with overlays: of a feature, among features, and on the map below them. Pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "fault/fault.h"
#include "overlays/overlay_document.h"
#include "placing/ground.h"

namespace mapwright::overlays {

enum class Rule {
  DuplicateId,
  DuplicateName,  // among features of the same shape
  SelfIntersection,
  ZeroArea,
  TooFewPoints,
  OutsideMap,
  InWall,  // a point where a robot goes
  ChargerWithoutDock,
  DoorWithoutMac,
  BadNumber,
  Unreachable,  // from the chargers, through free cells, around walls and forbidden regions
  Unreadable,   // no feature, a geometry of an unknown type, or a member that is written twice
};
inline constexpr Rule kLastRule = Rule::Unreadable;

/// For scripts, never changes: "duplicate_id".
std::string_view nameOf(Rule rule);
std::optional<Rule> ruleCalled(std::string_view name);

struct Flaw {
  Rule rule = Rule::DuplicateId;
  std::size_t feature = 0;  // its index in the document
  Fault why;                // a sentence
  std::optional<Eigen::Vector2d> at_m;
};

struct CheckOptions {
  std::set<Rule> off;
  placing::PlacedMap map;  // without (known) cells OutsideMap, InWall and Unreachable are not checked
  double radius_m = 0.3;   // of the robot
};

/// In the order of the features. Open rings and missing ids, which robots write themselves, are no flaws.
/// Takes as long as reading the map, with Unreachable; not for the GUI thread.
std::vector<Flaw> flawsOf(const OverlayDocument& document, const CheckOptions& options);

/// A feature where robots go: they stop at it, rather than look at it.
bool isDestination(const Feature& feature);

}  // namespace mapwright::overlays
