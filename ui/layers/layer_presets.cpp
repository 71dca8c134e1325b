#include "ui/layers/layer_presets.h"

#include <algorithm>
#include <set>

#include <QCoreApplication>

namespace mapwright::ui {

using scene::Layer;

namespace {

class LayerPresetsText {
  Q_DECLARE_TR_FUNCTIONS(LayerPresets)
};

const QString kPresetsKey = QStringLiteral("layerPresets");
const QString kNameKey = QStringLiteral("name");

LayerPreset builtIn(const QString& name, scene::LayerSet set) {
  LayerPreset preset{name, true, {}};
  for (const Layer layer : scene::allLayers()) {
    const scene::LayerSpec& spec = scene::specOf(layer);
    if (!spec.left_alone.testFlag(set)) preset.layers[layer].shown = spec.sets.testFlag(set);
  }
  return preset;
}

}  // namespace

std::vector<LayerPreset> builtInPresets() {
  LayerPreset all{LayerPresetsText::tr("All"), true, {}};
  for (const Layer layer : scene::allLayers()) all.layers[layer].shown = true;
  return {builtIn(LayerPresetsText::tr("Navigation"), scene::LayerSet::Navigation),
          builtIn(LayerPresetsText::tr("Mapping"), scene::LayerSet::Mapping),
          builtIn(LayerPresetsText::tr("Map only"), scene::LayerSet::MapOnly), all};
}

LayerPreset presetOf(const scene::MapScene& scene, const QString& name) {
  LayerPreset preset{name, false, {}};
  for (const Layer layer : scene::allLayers()) preset.layers[layer] = lookOf(scene, layer);
  return preset;
}

void apply(scene::MapScene& scene, const LayerPreset& preset) {
  std::set<Layer> shown;
  for (const Layer layer : scene::allLayers()) {
    const auto look = preset.layers.find(layer);
    if (look == preset.layers.end() ? scene.layerVisible(layer) : look->second.shown) shown.insert(layer);
  }
  if (!preset.built_in) {
    for (const auto& [layer, look] : preset.layers) setStyles(scene, layer, look);
  }
  scene.setLayersVisible(shown);
}

bool matches(const scene::MapScene& scene, const LayerPreset& preset) {
  return std::all_of(preset.layers.begin(), preset.layers.end(), [&](const auto& wanted) {
    const LayerLook look = lookOf(scene, wanted.first);
    return preset.built_in ? look.shown == wanted.second.shown : look == wanted.second;
  });
}

void savePresets(const std::vector<LayerPreset>& presets, QSettings& settings) {
  settings.remove(kPresetsKey);
  settings.beginWriteArray(kPresetsKey, int(presets.size()));
  for (std::size_t i = 0; i < presets.size(); ++i) {
    settings.setArrayIndex(int(i));
    settings.setValue(kNameKey, presets[i].name);
    for (const auto& [layer, look] : presets[i].layers) writeLook(settings, layer, look);
  }
  settings.endArray();
}

std::vector<LayerPreset> savedPresets(QSettings& settings) {
  constexpr int kMost = 1000;  // of a broken file
  std::vector<LayerPreset> presets;
  const int count = std::min(settings.beginReadArray(kPresetsKey), kMost);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    LayerPreset preset{settings.value(kNameKey).toString().simplified(), false, {}};
    for (const Layer layer : scene::allLayers()) {
      if (holdsLook(settings, layer)) preset.layers[layer] = readLook(settings, layer);
    }
    if (!preset.name.isEmpty()) presets.push_back(std::move(preset));
  }
  settings.endArray();
  return presets;
}

}  // namespace mapwright::ui
