// Waypoints in and out of the window: copied between maps and to spreadsheets, pasted, imported from files
// and exported. What comes from outside is shown before it changes anything. GUI thread.
#pragma once

#include <optional>

#include <QObject>
#include <QPointer>

#include "map/catalogue.h"
#include "ui/shell/window_context.h"
#include "ui/view/map_tool.h"
#include "ui/waypoints/import_dialog.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::window {

class WaypointTransfer : public QObject {
  Q_OBJECT
 public:
  /// GeoJSON of what was copied, as other windows of this program take it.
  static constexpr const char* kMime = "application/x-mapwright-waypoints";

  /// All must outlive this. While `tool` is in the hand, Ctrl+C and Ctrl+V on the map are about waypoints.
  WaypointTransfer(WindowContext& context, WaypointEditing* editing, const MapTool* tool, QObject* parent);
  /// Which map they are of; nullopt = none.
  void setMap(const std::optional<map::MapKey>& map) { map_ = map; }

  /// What is selected: for other maps, and as a table between tabs.
  void copy();
  /// Waypoints of this program at once, as one command; a table after a look at what it changes.
  void paste();
  void importFile(const QString& path);
  /// All of the list; .csv is CSV, else GeoJSON.
  void exportTo(const QString& path);
  ImportDialog* dialog() const { return dialog_; }  // null = none is open

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addActions();
  void refresh();
  void ask(ImportSource source);
  void pasteCopied(const std::string& geojson);
  void say(bool good, const QString& text);
  std::vector<map::Waypoint> listed(const std::set<edit::Key>* only) const;

  WindowContext& context_;
  WaypointEditing* editing_;
  const MapTool* tool_;
  std::optional<map::MapKey> map_;
  QPointer<ImportDialog> dialog_;
  QAction *copy_ = nullptr, *paste_ = nullptr, *import_ = nullptr, *export_ = nullptr;
};

}  // namespace mapwright::window
