#include "ui/view/camera_actions.h"

#include "geometry/pose.h"
#include "ui/kit/actions.h"
#include "ui/kit/status_text.h"
#include "ui/view/map_view.h"

namespace mapwright::window {

namespace {
constexpr double kTurn = geometry::radiansFromDegrees(15);
}

void addCameraActions(Actions& actions, MapView& view) {
  actions.add({.id = "zoomIn",
               .text = MapView::tr("Zoom &in"),
               .icon = "zoom-in",
               .keys = {"+", "="},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Zoom in"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 10}},
              &view, [&view] { view.zoomSteps(1); });
  actions.add({.id = "zoomOut",
               .text = MapView::tr("Zoom &out"),
               .icon = "zoom-out",
               .keys = {"-"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Zoom out"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 20}},
              &view, [&view] { view.zoomSteps(-1); });
  actions.add({.id = "native",
               .text = QStringLiteral("&1:1"),
               .icon = "native",
               .keys = {"0"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("One cell of 5 cm on one pixel"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 30},
               .bar = {BarGroup::Look, 20}},
              &view, [&view] { view.setScale(kNativeScaleMPerPx); });
  actions.add({.id = "fit",
               .text = MapView::tr("&Fit"),
               .icon = "fit",
               .keys = {"F"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Show the whole map"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 40},
               .bar = {BarGroup::Look, 10},
               .map_menu = {MapMenuGroup::Look, 10}},
              &view, [&view] { view.fit(view.mapScene()->contentBounds(), true); });
  actions.add({.id = "northUp",
               .text = MapView::tr("&North up"),
               .icon = "north",
               .keys = {"N"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view so that the map's y axis points up"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 10},
               .bar = {BarGroup::Look, 40},
               .map_menu = {MapMenuGroup::Look, 20}},
              &view, [&view] { view.setRotation(0); });
  actions.add({.id = "rotateLeft",
               .text = MapView::tr("Rotate &left"),
               .icon = "rotate-left",
               .keys = {"["},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view by 15° counter-clockwise"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 30}},
              &view, [&view] { view.rotateBy(kTurn); });
  actions.add({.id = "rotateRight",
               .text = MapView::tr("Rotate r&ight"),
               .icon = "rotate-right",
               .keys = {"]"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view by 15° clockwise"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 40}},
              &view, [&view] { view.rotateBy(-kTurn); });
}

}  // namespace mapwright::window
