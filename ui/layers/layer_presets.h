// Named sets of visible layers: some that are always there, and those that the user saves.
#pragma once

#include <map>
#include <vector>

#include <QSettings>
#include <QString>

#include "ui/layers/layer_settings.h"

namespace mapwright::ui {

struct LayerPreset {
  QString name;
  bool built_in = false;  // opacity and styles stay what the user has made of them
  /// Layers that are missing here stay as they are.
  std::map<scene::Layer, LayerLook> layers;
};

/// Navigation, Mapping, Map only, All. But for the last, they leave it alone which of whole map and
/// submaps is on screen.
std::vector<LayerPreset> builtInPresets();

/// The present state of all layers.
LayerPreset presetOf(const scene::MapScene& scene, const QString& name);
void apply(scene::MapScene& scene, const LayerPreset& preset);
/// The map looks as the preset says.
bool matches(const scene::MapScene& scene, const LayerPreset& preset);

/// The user's own.
void savePresets(const std::vector<LayerPreset>& presets, QSettings& settings);
/// Those without a name are left out.
std::vector<LayerPreset> savedPresets(QSettings& settings);

}  // namespace mapwright::ui
