#include "ui/view/tool_choice.h"

#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"

namespace mapwright::ui {

ToolChoice::ToolChoice(MapView* view, MapOverlay* overlay, QObject* parent)
    : QObject(parent), view_(view), overlay_(overlay) {}

void ToolChoice::add(MapTool* tool, QAction* action) {
  tools_.push_back({tool, action});
  connect(action, &QAction::triggered, this,
          [this, tool](bool checked) { checked ? choose(tool) : putAway(); });
  connect(tool, &MapTool::finished, this, &ToolChoice::putAway);
  connect(tool, &MapTool::hintChanged, this, [this, tool] {
    if (tool == chosen()) overlay_->setHint(tool->hint());
  });
  sync();
}

void ToolChoice::choose(MapTool* tool) {
  const bool other = tool != chosen();
  view_->setTool(tool);
  overlay_->setHint(tool->hint());
  sync();
  if (other) Q_EMIT chosenChanged();
}

void ToolChoice::choose(const QString& name) {
  for (const Entry& entry : tools_) {
    if (entry.tool->name() == name && entry.action->isEnabled()) return choose(entry.tool);
  }
  putAway();
}

MapTool* ToolChoice::chosen() const { return view_->tool(); }

QList<QAction*> ToolChoice::actions() const {
  QList<QAction*> actions;
  for (const Entry& entry : tools_) actions << entry.action;
  return actions;
}

void ToolChoice::sync() {
  for (const Entry& entry : tools_) entry.action->setChecked(entry.tool == chosen());
}

}  // namespace mapwright::ui

#include "moc_tool_choice.cpp"
