// What the window lends to its controllers.
#pragma once

#include <QMainWindow>
#include <QSettings>
#include <QUndoGroup>

#include "robot/address.h"
#include "work/budgets.h"
#include "work/workers.h"

namespace mapwright::edit {
struct EditOptions;
}
namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class Actions;
class CurrentSession;
class Findings;
class HitList;
class MapOverlay;
class MapView;
class Notices;
class Panels;
class ToolChoice;
class UnsavedChanges;
class Viewpoint;
class WindowStatusBar;

/// All of it outlives the controllers.
struct WindowContext {
  QMainWindow& window;  // the parent of docks and dialogs
  MapView& view;
  scene::MapScene& scene;
  Actions& actions;     // with their positions in menus and tool bar
  Findings& findings;   // what the palette finds besides commands
  ToolChoice& tools;    // which one is in the hand
  MapOverlay& overlay;  // toasts, what is floating over the map, the hint
  Panels& panels;       // docks
  Notices& notices;     // the strip above the map that all share
  Viewpoint& viewpoint;
  WindowStatusBar& bar;
  CurrentSession& current;
  QSettings& settings;
  HitList& hits;                           // what can be taken hold of on the map
  QUndoGroup& undo;                        // whose active stack Ctrl+Z is about
  UnsavedChanges& unsaved;                 // asked before the present map is left
  const edit::EditOptions& edit;           // where drafts are kept
  robot::Addresses addresses;              // that people may type
  work::Budgets budgets;                   // of all caches
  std::shared_ptr<work::Workers> workers;  // what takes long is not done on the GUI thread
};

}  // namespace mapwright::ui
