// The colours of the interface around the map, light and dark.
#pragma once

#include <QColor>
#include <QPalette>

namespace mapwright::window {

/// Semantic colours. The plain ones are for shapes (dots, icons, bars, frames) and keep a contrast of at
/// least 3:1 against the window, the base and a row that is selected or under the cursor; the `_text` ones
/// keep 4.5:1, so words may use them. `accent` also lies under white words; `border` only parts areas and
/// says nothing.
struct UiColors {
  bool dark = false;
  QColor accent, ok, warning, error;
  QColor accent_text, ok_text, warning_text, error_text;
  QColor window, base, text, secondary_text, border, hover, tooltip, selection;
  QColor neutral;   // shapes that say nothing special
  QColor focus;     // the frame of what has the keyboard, the bar of what is selected
  QColor outline;   // the edge of what can be typed into, ticked or pressed
  QColor disabled;  // words and marks of what cannot be used now
};

UiColors uiColors(bool dark);
/// The colours of the theme that the application has now. To be asked while painting: a widget's own palette
/// may have been bent by the style sheet.
UiColors appColors();
/// The colours that belong to a palette made by themePalette() (or any other): told by its lightness.
UiColors uiColors(const QPalette& palette);
QPalette themePalette(const UiColors& colors);
/// The same with a soft selection: in lists, marks and words keep their own colours on a selected row.
QPalette listPalette(const QPalette& theme, const UiColors& colors);

/// The same for what is no longer live: shapes and words keep their forms, not their colours.
UiColors greyed(UiColors colors);

/// Contrast ratio of WCAG 2, 1..21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace mapwright::window
