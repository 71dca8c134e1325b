// What is drawn: the layers, which maps are on screen, the colours of the submaps.
#pragma once

#include <optional>

#include "ui/kit/actions.h"
#include "ui/kit/controller.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"
#include "ui/view/on_screen.h"

class QActionGroup;

namespace mapwright::render {
enum class ColorMode;
}

namespace mapwright::ui {

class LayersDock;
class LegendDock;
class PresetMenu;

class LayersController : public Controller {
  Q_OBJECT
 public:
  explicit LayersController(WindowContext& context, QObject* parent = nullptr);

  LayersDock* dock() const { return dock_; }
  LegendDock* legend() const { return legend_; }
  PresetMenu* presets() const { return presets_; }
  void setMode(ViewMode mode);
  void setColorMode(render::ColorMode mode);

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  /// While the window is used.
  void save(QSettings& settings);
  void reset() override;

 Q_SIGNALS:
  void colorModeChanged(mapwright::render::ColorMode mode);

 private:
  QAction* addSwitch(const ActionSpec& spec, scene::Layer layer);
  void addModes();
  void addColors();
  void sync();
  void syncModes();
  void applyPreset();
  void zoomTo(scene::Layer layer);
  void beginMode(session::Session& session);
  void sayColors(session::Session* session);
  void endMode();

  struct Switch {
    QAction* action;
    scene::Layer layer;
  };
  WindowContext& context_;
  LayersDock* dock_;
  LegendDock* legend_;
  PresetMenu* presets_;
  std::vector<Switch> switches_;
  QActionGroup *modes_, *colors_;
  QString said_colors_;  // the message about them, if one was shown
  /// The mode before a robot without submaps left no choice.
  std::optional<ViewMode> mode_before_;
};

}  // namespace mapwright::ui
