#include "ui/scene/map_theme.h"

namespace mapwright::ui::scene {
namespace {

/// 0xAARRGGBB. What can be on screen together is told apart on every ground, also by colour-blind people: the
/// test map_colors measures it.
struct ColorRow {
  QColor MapTheme::*color;
  QRgb light, dark;
};
constexpr ColorRow kColorRows[] = {
    {&MapTheme::grid_minor, 0x1a101828, 0x268ca0be},     {&MapTheme::grid_major, 0x38101828, 0x508ca0be},
    {&MapTheme::axis, 0x961f6feb, 0xaa5c9bff},           {&MapTheme::text, 0xff10141a, 0xfff2f5f9},
    {&MapTheme::text_halo, 0xdcffffff, 0xdc0a0e14},      {&MapTheme::accent, 0xff1f6feb, 0xff1f6feb},
    {&MapTheme::robot, 0xff1f6feb, 0xff1f6feb},          {&MapTheme::robot_outline, 0xffffffff, 0xffffffff},
    {&MapTheme::trail, 0xff68abfd, 0xff1c57ac},          {&MapTheme::outline, 0xc8b35c00, 0xdcffb454},
    {&MapTheme::outline_frozen, 0x96334458, 0xaa8da2bb}, {&MapTheme::measure, 0xff6d0714, 0xfffaea93},
    {&MapTheme::stale_veil, 0x82e6e9ee, 0x8214181e},     {&MapTheme::cloud, 0xffa43472, 0xffd58eb0},
    {&MapTheme::path, 0xff277aff, 0xff5c9bff},           {&MapTheme::trajectory, 0xff7fad75, 0xff42deb3},
    {&MapTheme::target, 0xff7b0367, 0xffc75292},         {&MapTheme::other_robot, 0xff2f00fa, 0xffa97cbc},
    {&MapTheme::constraint, 0xff039d81, 0xff00b579},     {&MapTheme::region, 0xffcf7cc7, 0xffb40c72},
    {&MapTheme::place, 0xff0050b1, 0xff9fc6ff},          {&MapTheme::good, 0xff00751b, 0xff018f59},
    {&MapTheme::warn, 0xffd88c01, 0xffd98602},           {&MapTheme::bad, 0xffd93e48, 0xffdd3749}};

MapTheme themeOf(bool dark) {
  MapTheme theme;
  theme.dark = dark;
  theme.map = dark ? render::MapColors{0xff2b3440, 0xffd9dee4, 0xff05070a, 0xff8fb8f0, 0xffe04b4b}
                   : render::MapColors{0xff778899, 0xffffffff, 0xff15181c, 0xff8fb8f0, 0xffe04b4b};
  for (const ColorRow& row : kColorRows) theme.*row.color = QColor::fromRgba(dark ? row.dark : row.light);
  // In the order in which commands find them (app/display.cpp), whatever else is installed.
  theme.label_font.setFamilies({QStringLiteral("DejaVu Sans"), QStringLiteral("Noto Sans CJK SC"),
                                QStringLiteral("Noto Color Emoji")});
  theme.label_font.setPixelSize(11);
  // The same glyph shapes on every machine and at every sub-pixel position.
  theme.label_font.setHintingPreference(QFont::PreferNoHinting);
  return theme;
}

}  // namespace

MapTheme lightMapTheme() { return themeOf(false); }

MapTheme darkMapTheme() { return themeOf(true); }

}  // namespace mapwright::ui::scene
