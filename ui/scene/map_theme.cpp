#include "scene/map_theme.h"

namespace mapwright::scene {
namespace {

QFont labelFont() {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(11);
  // The same glyph shapes on every machine and at every sub-pixel position.
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

}  // namespace

MapTheme lightMapTheme() {
  MapTheme theme;
  theme.map = {0xff778899, 0xffffffff, 0xff15181c, 0xff8fb8f0, 0xffe04b4b};
  theme.grid_minor = QColor(16, 24, 40, 26);
  theme.grid_major = QColor(16, 24, 40, 56);
  theme.axis = QColor(0x1f, 0x6f, 0xeb, 150);
  theme.text = QColor(0x10, 0x14, 0x1a);
  theme.text_halo = QColor(255, 255, 255, 220);
  theme.accent = QColor(0x1f, 0x6f, 0xeb);
  theme.robot = QColor(0x1f, 0x6f, 0xeb);
  theme.robot_outline = Qt::white;
  theme.trail = QColor(0x1f, 0x6f, 0xeb, 190);
  theme.outline = QColor(0xb3, 0x5c, 0x00, 200);
  theme.outline_frozen = QColor(0x33, 0x44, 0x58, 150);
  theme.measure = QColor(0xa8, 0x1e, 0x7a);
  theme.stale_veil = QColor(0xe6, 0xe9, 0xee, 130);
  theme.cloud = QColor(0xc2, 0x18, 0x5b);
  theme.path = QColor(0x1f, 0x6f, 0xeb);
  theme.trajectory = QColor(0x0f, 0x8b, 0x8d);
  theme.target = QColor(0xa8, 0x1e, 0x7a);
  theme.other_robot = QColor(0x7a, 0x4d, 0xd8);
  theme.constraint = QColor(0x0f, 0x8b, 0x8d);
  theme.region = QColor(0x6b, 0x4f, 0xc4);
  theme.place = QColor(0x0a, 0x58, 0xca);
  theme.good = QColor(0x2e, 0x9e, 0x5b);
  theme.warn = QColor(0xd9, 0x8c, 0x00);
  theme.bad = QColor(0xd1, 0x38, 0x3d);
  theme.label_font = labelFont();
  theme.dark = false;
  return theme;
}

MapTheme darkMapTheme() {
  MapTheme theme = lightMapTheme();
  theme.map = {0xff2b3440, 0xffd9dee4, 0xff05070a, 0xff8fb8f0, 0xffe04b4b};
  theme.grid_minor = QColor(140, 160, 190, 38);
  theme.grid_major = QColor(140, 160, 190, 80);
  theme.axis = QColor(0x5c, 0x9b, 0xff, 170);
  theme.text = QColor(0xf2, 0xf5, 0xf9);
  theme.text_halo = QColor(10, 14, 20, 220);
  theme.outline = QColor(0xff, 0xb4, 0x54, 220);
  theme.outline_frozen = QColor(0x8d, 0xa2, 0xbb, 170);
  theme.measure = QColor(0xff, 0x6a, 0xd5);
  theme.stale_veil = QColor(0x14, 0x18, 0x1e, 130);
  theme.cloud = QColor(0xff, 0x5d, 0x9e);
  theme.path = QColor(0x5c, 0x9b, 0xff);
  theme.trajectory = QColor(0x3f, 0xd0, 0xd2);
  theme.target = QColor(0xff, 0x6a, 0xd5);
  theme.other_robot = QColor(0xb0, 0x90, 0xff);
  theme.constraint = QColor(0x3f, 0xd0, 0xd2);
  theme.region = QColor(0xa9, 0x92, 0xf5);
  theme.place = QColor(0x6f, 0xae, 0xff);
  theme.dark = true;
  return theme;
}

}  // namespace mapwright::scene
