#include "ui/window/layouts.h"

#include <algorithm>
#include <iterator>

namespace mapwright::ui {

namespace {

using Side = PanelPosition::Side;

constexpr int kWidePx = 1700;   // room for docks on both sides
constexpr int kHighPx = 900;    // room for one more dock above another
constexpr int kNarrowPx = 960;  // below it the tools of the timeline need two lines
// A list that the user opens below the map: its tools, heads and five rows. Only the timeline is there at
// first.
constexpr int kOpenedPx = 220;
// Of a small screen the docks get this part, and the map the rest.
constexpr double kColumn = 0.285;

const QString kMaps = QStringLiteral("maps");
const QString kLayers = QStringLiteral("layers");
const QString kWaypoints = QStringLiteral("waypoints");
const QString kOverlays = QStringLiteral("overlays");
const QString kRobot = QStringLiteral("robot");
const QString kInspector = QStringLiteral("inspector");
const QString kProblems = QStringLiteral("problems");
const QString kTimeline = QStringLiteral("timeline");
const QString kEvents = QStringLiteral("events");
const QString kMessages = QStringLiteral("messages");
const QString kPlots = QStringLiteral("plots");

constexpr unsigned of(Role role) { return 1U << unsigned(role); }
constexpr unsigned kOperate = of(Role::Operate), kInspect = of(Role::Inspect), kReplay = of(Role::Replay);

struct Tool {
  const char* action;
  unsigned roles;
};
constexpr Tool kTools[] = {
    {"record", kOperate | kInspect},
    {"modeSubmaps", kInspect | kReplay},
    {"modeWhole", kInspect | kReplay},
    {"modeBoth", kInspect | kReplay},
    {"compare", kInspect},
    {"waypointTool", kOperate},
    {"pictureTool", kOperate},
    {"overlayTool", kOperate},
    {"undo", kOperate},
    {"redo", kOperate},
    {"save", kOperate},
    {"native", kInspect},
    {"northUp", kInspect},
    {"grid", kInspect},
    {"showIds", kInspect},
    {"showOutlines", kInspect},
    {"goTo", kOperate | kInspect},
    {"screenshotSave", kInspect | kReplay},
};

}  // namespace

QString idOf(Role role) {
  switch (role) {
    case Role::Operate:
      return QStringLiteral("operate");
    case Role::Inspect:
      return QStringLiteral("inspect");
    case Role::Replay:
      break;
  }
  return QStringLiteral("replay");
}

Layout layoutFor(Role role, const QSize& window_px) {
  const bool wide = window_px.width() >= kWidePx, high = window_px.height() >= kHighPx;
  Layout layout;
  layout.left_px = wide ? 280 : 220;
  layout.bottom_px = kOpenedPx;
  layout.right_px = std::clamp(int(kColumn * window_px.width()), 300, 440);
  switch (role) {
    case Role::Operate:
      if (high) {
        layout.stacks = {{Side::Right, {kWaypoints, kOverlays, kMaps}, 3, true},
                         {Side::Right, {kRobot}, 2, true}};
      } else {
        layout.stacks = {{Side::Right, {kWaypoints, kOverlays, kRobot, kMaps}, 1, true}};
      }
      break;
    case Role::Inspect:
      if (wide) {
        layout.stacks = {{Side::Left, {kLayers, kMaps}, 1, false},
                         {Side::Right, {kInspector, kRobot}, 2, false},
                         {Side::Right, {kProblems}, 1, true}};
      } else {
        layout.stacks = {{Side::Right, {kLayers, kMaps}, 1, false},
                         {Side::Right, {kInspector, kProblems, kRobot}, 2, false}};
      }
      break;
    case Role::Replay:
      layout.wide_bottom = true;
      layout.bottom_px = high ? 168 : window_px.width() < kNarrowPx ? 172 : 140;
      layout.stacks = {{Side::Bottom, {kTimeline}, 1, true}, {Side::Right, {kEvents}, 2, true}};
      if (high) {
        layout.stacks.push_back({Side::Right, {kMessages}, 3, true});
        layout.stacks.push_back({Side::Right, {kPlots}, 3, true});
      } else {
        layout.stacks.push_back({Side::Right, {kMessages, kPlots}, 3, true});
      }
      break;
  }
  return layout;
}

bool isOnBar(Role role, const QString& action) {
  const auto* const tool = std::find_if(std::begin(kTools), std::end(kTools), [&](const Tool& candidate) {
    return action == QLatin1String(candidate.action);
  });
  return tool == std::end(kTools) || (tool->roles & of(role));
}

QStringList withTextOnBar(Role role) {
  const char* const operate[] = {"waypointTool", "save", "pictureTool", "follow", "measure", "fit", "record"};
  const char* const inspect[] = {"modeSubmaps", "modeWhole", "modeBoth", "fit",
                                 "measure",     "follow",    "compare"};
  const char* const replay[] = {"fit", "follow", "measure", "modeSubmaps", "modeWhole", "modeBoth"};
  QStringList ids;
  const auto addAll = [&](const auto& actions) {
    for (const char* action : actions) ids << QLatin1String(action);
  };
  switch (role) {
    case Role::Operate:
      addAll(operate);
      break;
    case Role::Inspect:
      addAll(inspect);
      break;
    case Role::Replay:
      addAll(replay);
      break;
  }
  return ids;
}

}  // namespace mapwright::ui
