#include "window/tools_controller.h"

#include <QMenu>

#include "ui/kit/icons.h"
#include "ui/view/map_view.h"
#include "ui/view/measure_tool.h"
#include "ui/view/tool_choice.h"

namespace mapwright::window {

namespace {
const QString kToolKey = QStringLiteral("view/tool");
}

ToolsController::ToolsController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), measure_(new MeasureTool(&context.scene, this)) {
  auto* const pan = static_cast<PanTool*>(context_.view.tool());  // with which a view begins
  context_.tools.add(pan, context_.actions.add({.id = "pan",
                                                .text = tr("&Pan"),
                                                .icon = "pan",
                                                .keys = {"P"},
                                                .reach = Reach::OutsideText,
                                                .tip = tr("Drag the map"),
                                                .toggle = true,
                                                .menu = {MenuGroup::Tools, 10},
                                                .bar = {BarGroup::Tools, 10}}));
  context_.tools.add(measure_, context_.actions.add({.id = "measure",
                                                     .text = tr("&Measure"),
                                                     .icon = "measure",
                                                     .keys = {"M"},
                                                     .reach = Reach::OutsideText,
                                                     .tip = tr("Measure distances between clicked points"),
                                                     .toggle = true,
                                                     .needs_session = true,
                                                     .menu = {MenuGroup::Tools, 20},
                                                     .bar = {BarGroup::Tools, 20}}));
  context_.actions.placeOnMapMenu(
      {MapMenuGroup::Point, 20}, [this](QMenu& menu, const Eigen::Vector2d& world) {
        menu.addAction(themedIcon(QStringLiteral("measure")), tr("Measure from here"), this, [this, world] {
          context_.tools.choose(measure_);
          measure_->clicked({world, {}, {}});
        });
      });
  connect(pan, &PanTool::clickedAt, this, &ToolsController::clicked);
}

void ToolsController::recall(const QSettings& settings) {
  context_.tools.choose(settings.value(kToolKey).toString());
}

void ToolsController::remember(QSettings& settings) {
  settings.setValue(kToolKey, context_.tools.chosen()->name());
}

void ToolsController::reset() { context_.tools.putAway(); }

}  // namespace mapwright::window

#include "moc_tools_controller.cpp"
