#include "ui/kit/ui_colors.h"

#include <algorithm>
#include <cmath>

#include <QGuiApplication>

namespace mapwright::window {

UiColors uiColors(bool dark) {
  UiColors c;
  c.dark = dark;
  c.accent = QColor(0x1f, 0x6f, 0xeb);
  if (dark) {
    c.ok = QColor(0x3f, 0xb4, 0x72);
    c.warning = QColor(0xd9, 0x8c, 0x00);
    c.error = QColor(0xe8, 0x67, 0x6b);
    c.focus = QColor(0x5b, 0x9b, 0xff);
    c.outline = QColor(0x78, 0x83, 0x8f);
    c.disabled = QColor(0x80, 0x8a, 0x96);
    c.accent_text = QColor(0x7a, 0xb0, 0xff);
    c.ok_text = QColor(0x5c, 0xc9, 0x8b);
    c.warning_text = QColor(0xf0, 0xb0, 0x40);
    c.error_text = QColor(0xff, 0x8a, 0x8a);
    c.window = QColor(0x1d, 0x22, 0x29);
    c.base = QColor(0x16, 0x1a, 0x20);
    c.text = QColor(0xe4, 0xe8, 0xee);
    c.secondary_text = QColor(0x9f, 0xa9, 0xb6);
    c.border = QColor(0x38, 0x40, 0x4b);
    c.hover = QColor(0x2b, 0x32, 0x3c);
    c.tooltip = QColor(0x2b, 0x32, 0x3c);
    c.selection = QColor(0x1d, 0x38, 0x61);
    c.neutral = QColor(0x8a, 0x94, 0xa1);
  } else {
    c.ok = QColor(0x25, 0x8a, 0x4e);
    c.warning = QColor(0xa8, 0x6a, 0x00);
    c.error = QColor(0xd1, 0x38, 0x3d);
    c.focus = c.accent;
    c.outline = QColor(0x7a, 0x84, 0x8e);
    c.disabled = QColor(0x77, 0x80, 0x8a);
    c.accent_text = QColor(0x17, 0x5c, 0xc8);
    c.ok_text = QColor(0x1c, 0x70, 0x3f);
    c.warning_text = QColor(0x85, 0x54, 0x00);
    c.error_text = QColor(0xb3, 0x26, 0x2c);
    c.window = QColor(0xf4, 0xf6, 0xf8);
    c.base = QColor(0xff, 0xff, 0xff);
    c.text = QColor(0x1b, 0x1f, 0x24);
    c.secondary_text = QColor(0x57, 0x60, 0x6a);
    c.border = QColor(0xd3, 0xd9, 0xe0);
    c.hover = QColor(0xe6, 0xea, 0xef);
    c.tooltip = QColor(0xff, 0xff, 0xff);
    c.selection = QColor(0xd9, 0xe7, 0xfd);
    c.neutral = QColor(0x6b, 0x75, 0x80);
  }
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

}  // namespace mapwright::window
