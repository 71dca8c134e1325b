// A list of views of maps (docs/maps-in-ci.md, "suite.yaml"). Values.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>

namespace mapwright::suite {

/// In the file, counted from 1; 0 = unknown.
struct Position {
  int line = 0, column = 0;
};

/// An option of a snapshot, as written; a switch that is on has no value.
struct ViewOption {
  std::string name, value;
  bool is_switch = false;
  Position at;
};

/// Limits of the SLAM session behind a view; nullopt = none, and nothing is looked at.
struct Quality {
  std::optional<double> closures_over_m;    // the largest residual of a loop closure (INTER)
  int closures_at_least = 0;                // so many loop closures; only together with the one before
  std::optional<double> disagreement_over;  // the share of occupied cells that contradict, 0..1
  int tolerance_cells = 4;                  // of the disagreement: walls so far apart are the same wall
  static constexpr int kMostTolerance = 40, kMostClosures = 1'000'000;
  bool asked() const { return closures_over_m || disagreement_over; }
};

struct View {
  QString name;  // also that of its files
  Position at;
  std::vector<ViewOption> options;
  QString mask;  // as written; empty = none
  int tolerance = 0;
  double max_differing_percent = 0;
  Quality quality;

  /// Its value; empty = not given.
  std::string option(const std::string& name) const {
    for (const ViewOption& option : options) {
      if (option.name == name) return option.value;
    }
    return {};
  }
};

struct Suite {
  std::vector<View> views;  // no two names are alike, nor those of their files
};

}  // namespace mapwright::suite
