// The pieces of forms, docks and dialogs. Each takes its parent, which owns it.
#pragma once

#include <initializer_list>

#include <QString>

class QAction;
class QColor;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace mapwright::window {

/// Plain text that may take several lines.
QLabel* textLabel(QWidget* parent, const QString& text = {});
void setTextColor(QWidget* widget, const QColor& color);
/// A small one, as in docks.
QPushButton* compactButton(const QString& text, QWidget* parent, const QString& tip = {});

struct NumberField {
  double least = 0, most = 0;
  int decimals = 3;
  double step = 0.05;
  QString unit = QStringLiteral(" m");
  QString name = {};  // for assistive technology
  int width_px = 60;  // at least
};
/// With a decimal point in any locale.
QDoubleSpinBox* numberField(QWidget* parent, const NumberField& field);

/// Side by side; null = the free space between them. -1 = the spacing of the style.
QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets, int spacing_px = -1);

/// While it is not allowed its tooltip says why, if that is known.
void allow(QAction* action, bool allowed, const QString& why_not);

}  // namespace mapwright::window
