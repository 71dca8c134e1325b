// The colours of the interface around the map, light and dark.
#pragma once

#include <QColor>
#include <QPalette>

namespace mapwright::ui {

/// Semantic colours. The plain ones are for shapes (dots, icons, bars, frames) with a contrast of at least
/// 3:1 against the window, the base and a selected or hovered row; the `_text` ones have 4.5:1, for text.
/// `accent` is also a background for white text; `border` only separates areas.
struct UiColors {
  bool dark = false;
  QColor accent, ok, warning, error;
  QColor accent_text, ok_text, warning_text, error_text;
  QColor window, base, text, secondary_text, border, hover, tooltip, selection;
  QColor neutral;   // shapes that say nothing special
  QColor focus;     // the frame of the focused widget, the bar of selected rows
  QColor outline;   // the edge of input fields, check boxes and buttons
  QColor disabled;  // text and marks of disabled items
};

UiColors uiColors(bool dark);
/// The colours of the application's present theme. Call it while painting: the style sheet may have changed a
/// widget's own palette.
UiColors appColors();
/// The colours for a palette from themePalette() (or any other), chosen by its lightness.
UiColors uiColors(const QPalette& palette);
QPalette themePalette(const UiColors& colors);
/// The same with a soft selection: in lists, marks and text keep their own colours on a selected row.
QPalette listPalette(const QPalette& theme, const UiColors& colors);

/// The same for data that is no longer live: without colours.
UiColors greyed(UiColors colors);

/// Contrast ratio of WCAG 2, 1..21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace mapwright::ui
