#include "ui/kit/forms.h"

#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QToolTip>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"

namespace mapwright::window {

namespace {

template <class Layout>
Layout* laidOut(std::initializer_list<LayoutItem> items, int spacing,
                const std::optional<QMargins>& margins) {
  auto* const layout = new Layout;
  if (margins) layout->setContentsMargins(*margins);
  if (spacing >= 0) layout->setSpacing(spacing);
  for (const LayoutItem& item : items) {
    if (item.gap_px) {
      layout->addSpacing(*item.gap_px);
    } else if (item.widget) {
      layout->addWidget(item.widget, item.stretch, item.alignment);
    } else if (item.layout) {
      layout->addLayout(item.layout, item.stretch);
    } else {
      layout->addStretch(item.stretch);
    }
  }
  return layout;
}

}  // namespace

QHBoxLayout* rowOf(std::initializer_list<LayoutItem> items, int spacing, std::optional<QMargins> margins) {
  return laidOut<QHBoxLayout>(items, spacing, margins);
}

QVBoxLayout* columnOf(std::initializer_list<LayoutItem> items, int spacing, std::optional<QMargins> margins) {
  return laidOut<QVBoxLayout>(items, spacing, margins);
}

void setScrolledWidget(QDockWidget& dock, QWidget* body) {
  auto* const scroll = new QScrollArea(&dock);
  scroll->setWidget(body);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  dock.setWidget(scroll);
}

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
  auto* const label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);
  label->setText(text);
  label->setWordWrap(true);
  return label;
}

QLabel* textLabel(const QString& text, QWidget* parent) {
  QLabel* const label = wrappedLabel(text, parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

void makeHeading(QWidget& widget, double scale) {
  QFont font = widget.font();
  if (scale != 1) font.setPointSizeF(font.pointSizeF() * scale);
  font.setWeight(QFont::DemiBold);
  widget.setFont(font);
}

void setTextColor(QWidget& widget, const QColor& color) {
  QPalette palette = widget.palette();
  palette.setColor(QPalette::WindowText, color);
  widget.setPalette(palette);
}

QPushButton* compactButton(const QString& text, QWidget* parent, const QString& tip) {
  auto* const button = new QPushButton(text, parent);
  button->setObjectName(QStringLiteral("compact"));
  button->setToolTip(tip);
  return button;
}

QToolButton* iconButton(const QString& icon, int icon_px, const QString& tip, QWidget* parent,
                        const QString& name) {
  auto* const button = new QToolButton(parent);
  button->setIcon(themedIcon(icon));
  button->setIconSize({icon_px, icon_px});
  button->setToolTip(tip);
  button->setAccessibleName(name.isEmpty() ? tip : name);
  return button;
}

void markBeyond(QAbstractSpinBox& box, bool beyond, const QString& range) {
  if (box.property("beyond").toBool() == beyond) return;
  box.setProperty("beyond", beyond);
  // Its look follows from that.
  box.style()->unpolish(&box);
  box.style()->polish(&box);
  box.setAccessibleDescription(beyond ? range : QString());
  if (!box.hasFocus()) return;
  beyond ? QToolTip::showText(box.mapToGlobal(QPoint(0, box.height() / 2)), range, &box)
         : QToolTip::hideText();
}

bool isUndoOfOthers(const QEvent& event, const QLineEdit& text) {
  if (event.type() != QEvent::ShortcutOverride) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  return (key.matches(QKeySequence::Undo) && !text.isUndoAvailable()) ||
         (key.matches(QKeySequence::Redo) && !text.isRedoAvailable());
}

DecimalBox::DecimalBox(QWidget* parent) : BoundedBox(parent) { setLocale(QLocale::c()); }

QValidator::State DecimalBox::validate(QString& input, int& pos) const {
  input.replace(QLatin1Char(','), QLatin1Char('.'));
  return BoundedBox::validate(input, pos);
}

double DecimalBox::valueFromText(const QString& text) const {
  QString plain = text;
  return QDoubleSpinBox::valueFromText(plain.replace(QLatin1Char(','), QLatin1Char('.')));
}

QDoubleSpinBox* numberField(QWidget* parent, const NumberField& field) {
  auto* const box = new DecimalBox(parent);
  box->setRange(field.least, field.most);
  box->setDecimals(field.decimals);
  box->setSingleStep(field.step);
  box->setSuffix(field.unit);
  box->setAlignment(Qt::AlignRight);
  box->setMinimumWidth(field.width_px);
  box->setAccessibleName(field.name);
  return box;
}

void allow(QAction* action, bool allowed, const QString& why_not) {
  action->setEnabled(allowed);
  if (!action->property("tip").isValid()) action->setProperty("tip", action->toolTip());
  const QString tip = action->property("tip").toString();
  action->setToolTip(allowed || why_not.isEmpty() ? tip : plainToolTip(why_not));
}

}  // namespace mapwright::window
