#include "ui/kit/forms.h"

#include <algorithm>
#include <optional>

#include <QAccessible>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "words/figures.h"
#include "words/fixed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr const char* kLongest = "longest";  // how many letters can be typed
constexpr int kNoteGapPx = 4, kNoteMs = 6'000;
constexpr int kLeastScrolledPx = 60;

/// Keeps its margins when the style or the parent changes. (QFrame puts those of its frame in their place.)
class WrappedLabel : public QLabel {
 public:
  using QLabel::QLabel;

 protected:
  bool event(QEvent* event) override {
    const QMargins margins = contentsMargins();
    const bool done = QLabel::event(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::ParentChange)
      setContentsMargins(margins);
    return done;
  }
};

/// The colour of a widget's text, which becomes that of another theme when it is changed.
class TextColor : public QObject {
 public:
  explicit TextColor(QWidget& widget) : QObject(&widget), widget_(widget) { widget.installEventFilter(this); }
  void set(const QColor& color) {
    const UiColors colors = appColors();
    role_ = nullptr;
    for (QColor UiColors::*const role :
         {&UiColors::text, &UiColors::secondary_text, &UiColors::error_text, &UiColors::warning_text,
          &UiColors::ok_text, &UiColors::accent_text}) {
      if (colors.*role == color) role_ = role;
    }
    put(color);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    const bool changed = event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange;
    if (!changed || !role_) return false;
    const QColor now = appColors().*role_;
    if (widget_.palette().color(QPalette::WindowText) != now) put(now);
    return false;
  }

 private:
  void put(const QColor& color) {
    QPalette palette = widget_.palette();
    palette.setColor(QPalette::WindowText, color);
    widget_.setPalette(palette);
  }
  QWidget& widget_;
  QColor UiColors::*role_ = nullptr;
};

/// As high as there is room, but not below what its body needs at least. (A resizable QScrollArea scrolls as
/// soon as there is less room than a body with lines that wrap would like.)
class Scrolled : public QScrollArea {
 public:
  Scrolled(QWidget* body, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(body);
  }
  QSize sizeHint() const override { return widget() ? widget()->sizeHint() : QScrollArea::sizeHint(); }
  QSize minimumSizeHint() const override {
    if (!widget()) return QScrollArea::minimumSizeHint();
    const int width = widget()->minimumSizeHint().expandedTo(widget()->minimumSize()).width();
    return {width, std::min(leastHeight(width), kLeastScrolledPx)};
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    fit();
    QScrollArea::resizeEvent(event);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool done = QScrollArea::eventFilter(watched, event);
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
      fit();
      updateGeometry();
    }
    return done;
  }

 private:
  int leastHeight(int width) const {
    const QLayout* const layout = widget()->layout();
    const int least = !layout                       ? widget()->minimumSizeHint().height()
                      : layout->hasHeightForWidth() ? layout->totalMinimumHeightForWidth(width)
                                                    : layout->totalMinimumSize().height();
    return std::max(least, widget()->minimumHeight());
  }
  void fit() {
    QSize size = maximumViewportSize();
    if (leastHeight(size.width()) > size.height()) size.rwidth() -= verticalScrollBar()->sizeHint().width();
    widget()->resize(size.width(), std::max(size.height(), leastHeight(size.width())));
  }
};

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

void setScrolledWidget(QDockWidget& dock, QWidget* body, QWidget* below) {
  auto* const scrolled = new Scrolled(body, &dock);
  if (!below) return dock.setWidget(scrolled);
  auto* const all = new QWidget(&dock);
  all->setLayout(columnOf({{scrolled, 1}, below}, 0, QMargins()));
  dock.setWidget(all);
}

bool isScrolled(const QDockWidget& dock) {
  return qobject_cast<QScrollArea*>(dock.widget()) ||
         dock.widget()->findChild<QScrollArea*>(QString(), Qt::FindDirectChildrenOnly);
}

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
  auto* const label = new WrappedLabel(parent);
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
  TextColor* found = nullptr;
  for (QObject* const child : widget.children()) {
    if (auto* const one = dynamic_cast<TextColor*>(child)) found = one;
  }
  if (!found) found = new TextColor(widget);
  found->set(color);
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

bool isNumberBegun(const QString& typed) {
  static const QRegularExpression begun(QStringLiteral("^[+-]?\\d*([.,]\\d*)?([eE][+-]?\\d*)?$"));
  return begun.match(typed).hasMatch();
}

QString roundedText(const QString& typed, const QString& taken) {
  return QCoreApplication::translate("window", "%1 has too many decimals: %2 is used.").arg(typed, taken);
}

QString noNumberText(const QString& typed) {
  return QCoreApplication::translate("window", "%1 is no number.").arg(typed);
}

QString tooSmallText(const QString& typed, const QString& least) {
  return QCoreApplication::translate("window", "%1 is too small: at least %2.").arg(typed, least);
}

QString tooLargeText(const QString& typed, const QString& most) {
  return QCoreApplication::translate("window", "%1 is too large: at most %2.").arg(typed, most);
}

namespace {

/// Where a note covers no other field, or few: above or below its field, else beside the panel.
QPoint positionBeside(const QWidget& field, const QSize& size) {
  const QWidget* const window = field.window();
  const QRect at(field.mapTo(window, QPoint()), field.size());
  const QWidget* panel = &field;
  while (panel != window && panel->parentWidget() != window && !qobject_cast<const QDockWidget*>(panel))
    panel = panel->parentWidget();
  const QRect around(panel->mapTo(window, QPoint()), panel->size());
  const int above = at.top() - size.height() - kNoteGapPx, below = at.bottom() + 1 + kNoteGapPx;
  const int middle = at.center().y() - size.height() / 2;
  std::optional<QPoint> best;
  qint64 least = 0;
  for (const QPoint& wanted : {QPoint(at.left(), above), QPoint(at.right() + 1 - size.width(), above),
                               QPoint(at.left(), below), QPoint(at.right() + 1 - size.width(), below),
                               QPoint(around.left() - size.width() - kNoteGapPx, middle),
                               QPoint(around.right() + 1 + kNoteGapPx, middle)}) {
    const QPoint corner(std::clamp(wanted.x(), 0, std::max(0, window->width() - size.width())),
                        std::clamp(wanted.y(), 0, std::max(0, window->height() - size.height())));
    const QRect note(corner, size);
    qint64 covered = 0;
    for (const QWidget* const other : window->findChildren<QWidget*>()) {
      const bool field_or_button = other->inherits("QAbstractSpinBox") || other->inherits("QLineEdit") ||
                                   other->inherits("QComboBox") || other->inherits("QAbstractButton");
      if (!field_or_button || !other->isVisible() || other->visibleRegion().isEmpty()) continue;
      const QRect shared = note & QRect(other->mapTo(window, QPoint()), other->size());
      covered += qint64(shared.width()) * shared.height();
    }
    if (!best || covered < least) {
      best = corner;
      least = covered;
    }
  }
  return *best;
}

void sayBeside(const QWidget& field, const QString& text) {
  QWidget* const window = field.window();
  const QString name = QStringLiteral("outOfRange");
  // No tooltip: that hides when the focus goes to the next field.
  auto* note = window->findChild<QLabel*>(name, Qt::FindDirectChildrenOnly);
  if (!note) {
    note = new WrappedLabel(window);
    note->setObjectName(name);
    note->setTextFormat(Qt::PlainText);
    note->setContentsMargins(8, 4, 8, 4);
    note->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* const away = new QTimer(note);
    away->setSingleShot(true);
    QObject::connect(away, &QTimer::timeout, note, &QWidget::hide);
  }
  note->setText(words::plainText(text));
  note->setAccessibleName(note->text());
  setTextColor(*note, appColors().error_text);
  note->adjustSize();
  note->move(positionBeside(field, note->size()));
  note->show();
  note->raise();
  note->findChild<QTimer*>()->start(kNoteMs);
  QAccessibleEvent told(note, QAccessible::Alert);
  QAccessible::updateAccessibility(&told);
}

}  // namespace

void sayOutOfRange(const QAbstractSpinBox& field, const QString& text) {
  QString said = text;
  // Its prefix names the field, and not the number.
  if (const auto* const whole = qobject_cast<const QSpinBox*>(&field); whole && !whole->prefix().isEmpty())
    said.remove(whole->prefix());
  sayBeside(field, said);
}

void setLongest(QLineEdit& field, int letters) {
  field.setProperty(kLongest, letters);
  field.setMaxLength(letters);
  QObject::connect(&field, &QLineEdit::inputRejected, &field, [&field] {
    if (field.text().size() < field.maxLength()) return;  // refused for what it is
    sayBeside(field, QCoreApplication::translate("window", "Only %1 letters fit. The rest was left out.")
                         .arg(QString::fromStdString(words::grouped(field.maxLength()))));
  });
}

void showWhole(QLineEdit& field, const QString& text) {
  if (const QVariant longest = field.property(kLongest); longest.isValid())
    field.setMaxLength(std::max(longest.toInt(), int(text.size())));
  field.setText(text);
}

DecimalBox::DecimalBox(QWidget* parent) : RangedBox(parent) { setLocale(QLocale::c()); }

QValidator::State DecimalBox::validate(QString& input, int& pos) const {
  input.replace(QLatin1Char(','), QLatin1Char('.'));
  return RangedBox::validate(input, pos);
}

double DecimalBox::valueFromText(const QString& text) const {
  QString plain = text;
  return QDoubleSpinBox::valueFromText(plain.replace(QLatin1Char(','), QLatin1Char('.')));
}

QString DecimalBox::textFromValue(double value) const { return words::fixed(value, decimals()); }

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

void allow(QAction* action, bool allowed, const QString& unavailable_reason) {
  action->setEnabled(allowed);
  if (!action->property("tip").isValid()) action->setProperty("tip", action->toolTip());
  const QString tip = action->property("tip").toString();
  action->setToolTip(allowed || unavailable_reason.isEmpty() ? tip : plainToolTip(unavailable_reason));
}

}  // namespace mapwright::ui
