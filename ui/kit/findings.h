// Whatever can be found by typing, besides commands: each feature says what it has, the palette shows it.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QString>

namespace mapwright::ui {

struct Finding {
  QString text;   // "Auto door Gate 3"; plain
  QString where;  // what it is, or where it belongs: "Waypoint", "Map"
  QString icon;   // as for themedIcon()
  std::function<void()> go;
};

class Findings {
 public:
  using See = std::function<void(Finding)>;
  /// Calls `see` with what may match what was typed (not empty); the palette matches again, and ranks.
  using Search = std::function<void(const QString& typed, const See& see)>;
  /// Begins a search: called when the palette opens. What takes long is done here, once.
  using Begin = std::function<Search()>;

  /// `begin` must be callable as long as this exists.
  void add(Begin begin) { sources_.push_back(std::move(begin)); }
  std::vector<Search> begin() const {
    std::vector<Search> searches;
    for (const Begin& source : sources_) searches.push_back(source());
    return searches;
  }

 private:
  std::vector<Begin> sources_;
};

}  // namespace mapwright::ui
