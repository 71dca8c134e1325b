// The tools of every map: pan and measure.
#pragma once

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class MeasureTool;

class ToolsController : public Controller {
  Q_OBJECT
 public:
  explicit ToolsController(WindowContext& context, QObject* parent = nullptr);

  MeasureTool* measureTool() const { return measure_; }
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  void reset() override;

 Q_SIGNALS:
  /// A click on the map with the pan tool, world metres.
  void clicked(const Eigen::Vector2d& world_m);

 private:
  WindowContext& context_;
  MeasureTool* measure_;
};

}  // namespace mapwright::window
