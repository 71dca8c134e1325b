#include "ui/kit/ui_colors.h"

#include <algorithm>
#include <cmath>

#include <QGuiApplication>

namespace mapwright::ui {

namespace {

/// 0xRRGGBB.
struct ColorRow {
  QColor UiColors::*color;
  QRgb light, dark;
};
constexpr ColorRow kColorRows[] = {
    {&UiColors::accent, 0x1f6feb, 0x1f6feb},         {&UiColors::ok, 0x258a4e, 0x3fb472},
    {&UiColors::warning, 0xa86a00, 0xd98c00},        {&UiColors::error, 0xd1383d, 0xe8676b},
    {&UiColors::focus, 0x1f6feb, 0x5b9bff},          {&UiColors::outline, 0x7a848e, 0x78838f},
    {&UiColors::disabled, 0x77808a, 0x808a96},       {&UiColors::accent_text, 0x175cc8, 0x7ab0ff},
    {&UiColors::ok_text, 0x1c703f, 0x5cc98b},        {&UiColors::warning_text, 0x855400, 0xf0b040},
    {&UiColors::error_text, 0xb3262c, 0xff8a8a},     {&UiColors::window, 0xf4f6f8, 0x1d2229},
    {&UiColors::base, 0xffffff, 0x161a20},           {&UiColors::text, 0x1b1f24, 0xe4e8ee},
    {&UiColors::secondary_text, 0x57606a, 0x9fa9b6}, {&UiColors::border, 0xd3d9e0, 0x38404b},
    {&UiColors::hover, 0xe6eaef, 0x2b323c},          {&UiColors::tooltip, 0xffffff, 0x2b323c},
    {&UiColors::selection, 0xd9e7fd, 0x1d3861},      {&UiColors::neutral, 0x6b7580, 0x8a94a1}};

}  // namespace

UiColors uiColors(bool dark) {
  UiColors c;
  c.dark = dark;
  for (const ColorRow& row : kColorRows) c.*row.color = QColor(dark ? row.dark : row.light);
  return c;
}

UiColors uiColors(const QPalette& palette) {
  return uiColors(palette.color(QPalette::Active, QPalette::Window).lightness() < 128);
}

UiColors appColors() { return uiColors(QGuiApplication::palette()); }

UiColors greyed(UiColors colors) {
  for (QColor* color : {&colors.error, &colors.warning, &colors.ok, &colors.accent}) *color = colors.neutral;
  for (QColor* color : {&colors.error_text, &colors.warning_text, &colors.ok_text, &colors.accent_text})
    *color = colors.secondary_text;
  return colors;
}

QPalette themePalette(const UiColors& c) {
  QPalette p;
  const auto all = [&p](QPalette::ColorRole role, const QColor& color) { p.setColor(role, color); };
  all(QPalette::Window, c.window);
  all(QPalette::WindowText, c.text);
  all(QPalette::Base, c.base);
  all(QPalette::AlternateBase, c.dark ? QColor(0x1a, 0x1f, 0x26) : QColor(0xf8, 0xf9, 0xfb));
  all(QPalette::ToolTipBase, c.tooltip);
  all(QPalette::ToolTipText, c.text);
  all(QPalette::PlaceholderText, c.secondary_text);
  all(QPalette::Text, c.text);
  all(QPalette::Button, c.dark ? QColor(0x2b, 0x32, 0x3c) : QColor(0xfd, 0xfd, 0xfe));
  all(QPalette::ButtonText, c.text);
  all(QPalette::BrightText, QColor(Qt::white));
  all(QPalette::Light, c.dark ? QColor(0x3d, 0x46, 0x52) : QColor(0xff, 0xff, 0xff));
  all(QPalette::Midlight, c.dark ? QColor(0x33, 0x3b, 0x46) : QColor(0xec, 0xef, 0xf2));
  all(QPalette::Mid, c.border);
  all(QPalette::Dark, c.dark ? QColor(0x10, 0x13, 0x17) : QColor(0xa8, 0xb0, 0xba));
  all(QPalette::Shadow, c.dark ? QColor(0x00, 0x00, 0x00) : QColor(0x7d, 0x86, 0x90));
  all(QPalette::Highlight, c.accent);
  all(QPalette::HighlightedText, QColor(Qt::white));
  all(QPalette::Link, c.accent_text);
  all(QPalette::LinkVisited, c.accent_text);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText}) {
    p.setColor(QPalette::Disabled, role, c.disabled);
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
  return p;
}

QPalette listPalette(const QPalette& theme, const UiColors& colors) {
  QPalette palette = theme;
  palette.setColor(QPalette::Highlight, colors.selection);
  palette.setColor(QPalette::HighlightedText, colors.text);
  return palette;
}

double contrastRatio(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& c) {
    const auto linear = [](double v) {
      return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace mapwright::ui
