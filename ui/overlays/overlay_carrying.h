// The overlays of the reference map on the map on screen. Why: docs/tasks/new-map.md.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "carry/overlays_carried.h"
#include "edit/overlays/overlay_editing.h"
#include "ui/carry/carrying.h"
#include "ui/overlays/overlay_marks.h"

namespace mapwright::ui {

class OverlayCarrying : public Carrying {
  Q_OBJECT
 public:
  /// The overlays of the map on screen, as far as `editing` does not tell.
  struct There {
    std::function<QString()>
        why_not;  // they cannot be edited, nor will be when they are read; empty: they can
    std::function<double()> radius_m;  // of the robot
    std::function<void()> read;        // opens them, some time
  };

  /// All must outlive this.
  OverlayCarrying(WindowContext& context, edit::OverlayEditing* editing, There there, QObject* parent);

  /// refresh(), and goes on where only the overlays of the map on screen were missing.
  void update();
  const OverlayMarks& marks() const { return marks_; }

 private:
  QString whyNotBetween(robot::Robot& reader) const override;
  bool editable() const override { return editing_->editable(); }
  void read(robot::Robot& reader, const map::MapKey& key) override;
  void forgetCarried() override { became_.clear(); }
  std::vector<CarryRow::State> statesNow() const override;
  geometry::WorldRect boundsOf(int row) const override;
  void mark(std::optional<int> row) override;
  bool put(const std::vector<int>& rows) override;

  void startIfOpen();
  void onFound(std::vector<carry::CarriedFeature> found, const overlays::OverlayDocument& old_overlays);
  /// What a row became; null: it was not carried over.
  const overlays::Feature* placed(int row) const;

  edit::OverlayEditing* editing_;
  There there_;
  OverlayMarks marks_;
  std::optional<std::string> old_text_;                 // was read, and waits for the map on screen
  std::vector<carry::CarriedFeature> found_;            // of the rows
  std::map<std::string, overlays::FeatureKey> became_;  // by the ids of rows
};

}  // namespace mapwright::ui
