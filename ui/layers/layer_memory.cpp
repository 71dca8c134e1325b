#include "ui/layers/layer_memory.h"

#include <algorithm>
#include <cmath>

#include <QSettings>
#include <QStringList>
#include <QUrl>

namespace mapwright::window {

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

scene::LayerStyle readStyle(Layer layer, const QSettings& settings) {
  const scene::LayerTraits traits = scene::layerTraits(layer);
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

void saveLayers(const scene::MapScene& scene, QSettings& settings) {
  QStringList order;
  for (const Layer layer : scene.layerOrder()) order << scene::layerName(layer);
  settings.setValue(kOrderKey, order);
  for (const Layer layer : scene::allLayers()) {
    settings.setValue(key(layer, "visible"), scene.layerVisible(layer));
    settings.setValue(key(layer, "opacity"), scene.layerOpacity(layer));
    const scene::LayerStyle& style = scene.layerStyle(layer);
    const auto put = [&](const char* what, bool special, const QVariant& value) {
      special ? settings.setValue(key(layer, what), value) : settings.remove(key(layer, what));
    };
    put("color", style.color.isValid(), style.color.name(QColor::HexArgb));
    put("size", style.size > 0, style.size);
    put("choice", style.choice > 0, style.choice);
  }
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
  for (const Layer layer : scene::allLayers()) {
    const double opacity = settings.value(key(layer, "opacity"), 1.0).toDouble();
    scene.setLayerOpacity(layer, std::isfinite(opacity) ? opacity : 1.0);
    scene.setLayerStyle(layer, readStyle(layer, settings));
    scene.setLayerVisible(layer, settings.value(key(layer, "visible"), scene::specOf(layer).shown).toBool());
  }
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
  for (const Layer layer : scene::allLayers()) {
    scene.setLayerOpacity(layer, 1.0);
    scene.setLayerStyle(layer, {});
  }
}

void resetVisibility(scene::MapScene& scene) {
  for (const Layer layer : scene::allLayers()) scene.setLayerVisible(layer, scene::specOf(layer).shown);
}

}  // namespace mapwright::window
