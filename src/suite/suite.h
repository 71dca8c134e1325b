// A list of views of maps (docs/maps-in-ci.md, "suite.yaml"). Values.
#pragma once

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

struct View {
  QString name;  // also that of its files
  Position at;
  std::vector<ViewOption> options;
  QString mask;  // as written; empty = none
  int tolerance = 0;
  double max_differing_percent = 0;

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
