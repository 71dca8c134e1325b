// A map that the robot left while it had unsaved changes: said in the strip above the map, with an offer to
// show it again, until that is done. GUI thread.
#pragma once

#include <optional>

#include <QString>

#include "map/catalogue.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class LeftMap {
 public:
  /// `context` outlives this.
  explicit LeftMap(WindowContext& context) : context_(context) {}

  /// The changes to `map` are kept as a draft. `sentence`: what is kept.
  void onLeft(const map::MapKey& map, const QString& sentence);
  /// This one is edited now, or none: nothing is to be said of a map that is open again.
  void onOpened(const std::optional<map::MapKey>& map);
  /// Its robot is gone.
  void clear();
  /// Which it is; nullopt: none.
  const std::optional<map::MapKey>& map() const { return map_; }

 private:
  WindowContext& context_;
  std::optional<map::MapKey> map_;
};

}  // namespace mapwright::window
