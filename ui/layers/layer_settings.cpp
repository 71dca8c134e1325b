#include "ui/layers/layer_settings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QUrl>

namespace mapwright::ui {

using scene::Layer;

namespace {

const QString kOrderKey = QStringLiteral("layers/order");

QString key(Layer layer, const char* what) {
  return QStringLiteral("layers/%1/%2").arg(scene::layerName(layer), QLatin1String(what));
}

/// Addresses contain slashes, which would create groups.
QString topicsKey(const QString& address) {
  return QStringLiteral("topics/") + QString::fromLatin1(QUrl::toPercentEncoding(address));
}

scene::LayerStyle readStyle(const QSettings& settings, Layer layer) {
  const scene::LayerTraits traits = scene::specOf(layer).traits();
  scene::LayerStyle style;
  if (traits.color) {
    const QColor color(settings.value(key(layer, "color")).toString());
    if (color.isValid()) style.color = color;
  }
  if (traits.size_px) {
    const double size = settings.value(key(layer, "size"), 0).toDouble();
    if (std::isfinite(size) && size > 0)
      style.size = std::clamp(size, traits.size_px->first, traits.size_px->second);
  }
  const int choice = settings.value(key(layer, "choice"), 0).toInt();
  if (choice > 0 && choice < int(traits.choices.size())) style.choice = choice;
  return style;
}

}  // namespace

LayerLook lookOf(const scene::MapScene& scene, Layer layer) {
  return {scene.layerVisible(layer), scene.layerOpacity(layer), scene.layerStyle(layer)};
}

void setStyles(scene::MapScene& scene, Layer layer, const LayerLook& look) {
  if (scene.layerOpacity(layer) != look.opacity) scene.setLayerOpacity(layer, look.opacity);
  if (!(scene.layerStyle(layer) == look.style)) scene.setLayerStyle(layer, look.style);
}

void writeLook(QSettings& settings, Layer layer, const LayerLook& look) {
  settings.setValue(key(layer, "visible"), look.shown);
  settings.setValue(key(layer, "opacity"), look.opacity);
  const scene::LayerStyle& style = look.style;
  const auto put = [&](const char* what, bool special, const QVariant& value) {
    special ? settings.setValue(key(layer, what), value) : settings.remove(key(layer, what));
  };
  put("color", style.color.isValid(), style.color.name(QColor::HexArgb));
  put("size", style.size > 0, style.size);
  put("choice", style.choice > 0, style.choice);
}

LayerLook readLook(const QSettings& settings, Layer layer) {
  const double opacity = settings.value(key(layer, "opacity"), 1.0).toDouble();
  return {settings.value(key(layer, "visible"), scene::specOf(layer).shown).toBool(),
          std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1.0, readStyle(settings, layer)};
}

bool holdsLook(const QSettings& settings, Layer layer) { return settings.contains(key(layer, "visible")); }

void saveLayers(const scene::MapScene& scene, QSettings& settings) {
  QStringList order;
  for (const Layer layer : scene.layerOrder()) order << scene::layerName(layer);
  settings.setValue(kOrderKey, order);
  for (const Layer layer : scene::allLayers()) writeLook(settings, layer, lookOf(scene, layer));
}

void restoreLayers(scene::MapScene& scene, const QSettings& settings) {
  const QStringList names = settings.value(kOrderKey).toStringList();
  std::vector<Layer> order;
  for (const QString& name : names) {
    for (const Layer layer : scene::allLayers()) {
      if (scene::layerName(layer) == name) order.push_back(layer);
    }
  }
  // Layers of a newer version get their own position, not one on top of everything.
  for (const Layer layer : scene::allLayers()) {
    if (std::find(order.begin(), order.end(), layer) != order.end()) continue;
    const auto above = std::find_if(order.begin(), order.end(), [&](Layer other) { return other > layer; });
    order.insert(above, layer);
  }
  scene.setLayerOrder(order);
  std::set<Layer> shown;
  for (const Layer layer : scene::allLayers()) {
    const LayerLook look = readLook(settings, layer);
    setStyles(scene, layer, look);
    if (look.shown) shown.insert(layer);
  }
  scene.setLayersVisible(shown);
}

void saveTopics(const robot::TopicChoices& choices, const QString& address, QSettings& settings) {
  QStringList rows;
  for (const Layer layer : scene::allLayers()) {
    const auto stream = scene::chosenStream(layer);
    if (!stream) continue;
    const auto chosen = choices.find(*stream);
    if (chosen != choices.end()) rows << scene::layerName(layer) + QLatin1Char('=') + chosen->second;
  }
  rows.isEmpty() ? settings.remove(topicsKey(address)) : settings.setValue(topicsKey(address), rows);
}

robot::TopicChoices savedTopics(const QString& address, const QSettings& settings) {
  robot::TopicChoices choices;
  for (const QString& row : settings.value(topicsKey(address)).toStringList()) {
    const QString name = row.section(QLatin1Char('='), 0, 0), topic = row.section(QLatin1Char('='), 1);
    for (const Layer layer : scene::allLayers()) {
      if (scene::layerName(layer) != name || !topic.startsWith(QLatin1Char('/'))) continue;
      if (const auto stream = scene::chosenStream(layer)) choices.insert_or_assign(*stream, topic);
    }
  }
  return choices;
}

void resetOrderAndStyles(scene::MapScene& scene) {
  scene.setLayerOrder(scene::allLayers());
  for (const Layer layer : scene::allLayers()) setStyles(scene, layer, {});
}

void resetVisibility(scene::MapScene& scene) {
  std::set<Layer> shown;
  for (const Layer layer : scene::allLayers()) {
    if (scene::specOf(layer).shown) shown.insert(layer);
  }
  scene.setLayersVisible(shown);
}

}  // namespace mapwright::ui
