#include "ui/kit/form.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/kit/plain_label.h"

namespace mapwright::window {

QLabel* textLabel(QWidget* parent, const QString& text) {
  auto* const label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setText(text);
  return label;
}

void setTextColor(QWidget* widget, const QColor& color) {
  QPalette palette = widget->palette();
  palette.setColor(QPalette::WindowText, color);
  widget->setPalette(palette);
}

QPushButton* compactButton(const QString& text, QWidget* parent, const QString& tip) {
  auto* const button = new QPushButton(text, parent);
  button->setObjectName(QStringLiteral("compact"));
  button->setToolTip(tip);
  return button;
}

QDoubleSpinBox* numberField(QWidget* parent, const NumberField& field) {
  auto* const box = new QDoubleSpinBox(parent);
  box->setLocale(QLocale::c());
  box->setRange(field.least, field.most);
  box->setDecimals(field.decimals);
  box->setSingleStep(field.step);
  box->setSuffix(field.unit);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(field.width_px);
  box->setAccessibleName(field.name);
  return box;
}

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets, int spacing_px) {
  auto* const row = new QHBoxLayout;
  row->setSpacing(spacing_px);
  for (QWidget* const widget : widgets) widget ? row->addWidget(widget) : row->addStretch();
  return row;
}

void allow(QAction* action, bool allowed, const QString& why_not) {
  action->setEnabled(allowed);
  if (!action->property("tip").isValid()) action->setProperty("tip", action->toolTip());
  const QString tip = action->property("tip").toString();
  action->setToolTip(allowed || why_not.isEmpty() ? tip : plainToolTip(why_not));
}

}  // namespace mapwright::window
