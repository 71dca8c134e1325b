// Which tool is active: one of them, each with its action. Leaving one returns to the first.
#pragma once

#include <vector>

#include <QAction>
#include <QObject>

#include "ui/view/map_tool.h"

namespace mapwright::ui {

class MapOverlay;
class MapView;

class ToolChoice : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  ToolChoice(MapView* view, MapOverlay* overlay, QObject* parent = nullptr);
  /// Neither is owned. Triggering the checkable action activates the tool; triggering it again leaves it. The
  /// first tool is the one that the view already has.
  void add(MapTool* tool, QAction* action);
  void choose(MapTool* tool);
  /// Unknown or disabled tools select the first.
  void choose(const QString& name);
  void putAway() { choose(tools_.front().tool); }
  MapTool* chosen() const;
  QList<QAction*> actions() const;

 Q_SIGNALS:
  /// Another tool is in the hand.
  void chosenChanged();

 private:
  void sync();
  struct Entry {
    MapTool* tool;
    QAction* action;
  };
  MapView* view_;
  MapOverlay* overlay_;
  std::vector<Entry> tools_;
};

}  // namespace mapwright::ui
