// What docks and dialogs are laid out with: rows and columns in one expression, and the labels, buttons and
// boxes that they share.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <utility>

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMargins>
#include <QSpinBox>
#include <QString>

class QAction;
class QDockWidget;
class QLabel;
class QPushButton;
class QToolButton;

namespace mapwright::ui {

/// A widget, a layout, or room, in a row or column.
struct LayoutItem {
  LayoutItem(QWidget* what, int its_stretch = 0, Qt::Alignment where = {})
      : widget(what), stretch(its_stretch), alignment(where) {}
  LayoutItem(QLayout* what, int its_stretch = 0) : layout(what), stretch(its_stretch) {}
  /// Takes what room is left.
  static LayoutItem rest() { return {static_cast<QWidget*>(nullptr), 1}; }
  static LayoutItem gap(int px) {
    LayoutItem item = rest();
    item.gap_px = px;
    return item;
  }

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int stretch = 0;
  Qt::Alignment alignment = {};
  std::optional<int> gap_px = {};
};

/// `spacing` below 0: the style's. `margins` nullopt: the style's, none inside of another layout. They belong
/// to whoever they are given to: QWidget::setLayout(), another row or column.
QHBoxLayout* rowOf(std::initializer_list<LayoutItem> items, int spacing = -1,
                   std::optional<QMargins> margins = {});
QVBoxLayout* columnOf(std::initializer_list<LayoutItem> items, int spacing = -1,
                      std::optional<QMargins> margins = {});
/// A body in a dock that scrolls upwards and downwards only, where there is less room than it needs at least.
/// `below`, if there is one, stays in view: what saves and discards.
void setScrolledWidget(QDockWidget& dock, QWidget* body, QWidget* below = nullptr);
bool isScrolled(const QDockWidget& dock);

/// Limits what can be typed or pasted there, and says so where something was cut off.
void setLongest(QLineEdit& field, int letters);
/// Shows a text in such a field, whole, however long it is: what is cut off would be lost with the next edit.
void showWhole(QLineEdit& field, const QString& text);

/// Plain text in as many lines as it needs.
QLabel* wrappedLabel(const QString& text, QWidget* parent);
/// The same; it can be selected.
QLabel* textLabel(const QString& text, QWidget* parent);
/// In semi-bold letters, `scale` times as large.
void makeHeading(QWidget& widget, double scale = 1);
void setTextColor(QWidget& widget, const QColor& color);
QPushButton* compactButton(const QString& text, QWidget* parent, const QString& tip = {});
/// `name`: for assistive technology; empty = the tip.
QToolButton* iconButton(const QString& icon, int icon_px, const QString& tip, QWidget* parent,
                        const QString& name = {});

/// Marks a field whose number is out of its range, with the range beside it.
void markBeyond(QAbstractSpinBox& box, bool beyond, const QString& range);

/// Whether the key is one of undo or redo that the text has no use for: then it is the window's.
bool isUndoOfOthers(const QEvent& event, const QLineEdit& text);

/// A number, or what may become one by typing on: "-", "1.", "1e".
bool isNumberBegun(const QString& typed);

/// Beside the field for a while: its number was not taken, or not as it was typed.
void sayOutOfRange(const QAbstractSpinBox& field, const QString& text);
/// "0 is too small: at least 0.05 m."
QString tooSmallText(const QString& typed, const QString& least);
QString tooLargeText(const QString& typed, const QString& most);
/// "0.0001 has too many decimals: 0.000 m is used."
QString roundedText(const QString& typed, const QString& taken);
QString noNumberText(const QString& typed);

/// Any notation of a number can be typed. One outside of the range is marked, and not taken: when the field
/// is left the one before it is back, and the user is told, as of decimals that are rounded. (Qt would drop
/// the characters, or put the old number back, without a word.)
template <class Box>
class RangedBox : public Box {
 public:
  explicit RangedBox(QWidget* parent = nullptr) : Box(parent) {
    const auto mark = [this] {
      QString written = this->text();
      int at = 0;
      // What more digits would bring into the range is not finished.
      const std::optional<double> number = numberIn(written);
      const bool beyond = Box::validate(written, at) == QValidator::Invalid && number && isOut(*number);
      markBeyond(
          *this, beyond,
          QStringLiteral("%1 – %2%3")
              .arg(this->textFromValue(leastNumber()), this->textFromValue(this->maximum()), this->suffix()));
    };
    QObject::connect(this->lineEdit(), &QLineEdit::textChanged, this, mark);
    // textChanged is not emitted for what the box itself writes.
    QObject::connect(this, &Box::valueChanged, this, mark);
    QObject::connect(this, &Box::editingFinished, this, mark);
  }
  void stepBy(int steps) override {
    Box::stepBy(steps);
    before_ = this->value();
  }

 protected:
  bool event(QEvent* event) override {
    if (!isUndoOfOthers(*event, *this->lineEdit())) return Box::event(event);
    event->ignore();
    return false;
  }
  QValidator::State validate(QString& input, int& pos) const override {
    const QValidator::State state = Box::validate(input, pos);
    return state == QValidator::Invalid && isNumberBegun(plain(input)) ? QValidator::Intermediate : state;
  }
  void fixup(QString& input) const override {
    const std::optional<double> number = numberIn(input);
    if (!number) {
      if (const QString typed = plain(input); !typed.isEmpty()) sayOutOfRange(*this, noNumberText(typed));
      if (before_) input = shown(*before_);
      return;
    }
    if (!isOut(*number)) {
      const Number taken = std::is_integral_v<Number> ? Number(std::llround(*number)) : Number(*number);
      const QString text = shown(taken);
      if (const auto written = numberIn(this->textFromValue(taken)); written && *written != *number)
        sayOutOfRange(*this, roundedText(plain(input), text));
      input = text;
      return;
    }
    const bool small = *number < this->minimum();
    const QString least = this->prefix() + this->textFromValue(leastNumber()) + this->suffix();
    sayOutOfRange(*this, small ? tooSmallText(plain(input), least)
                               : tooLargeText(plain(input), shown(this->maximum())));
    if (before_) input = shown(*before_);
  }
  void focusInEvent(QFocusEvent* event) override {
    before_ = this->value();
    Box::focusInEvent(event);
  }
  void focusOutEvent(QFocusEvent* event) override {
    Box::focusOutEvent(event);
    before_ = this->value();
  }
  void keyPressEvent(QKeyEvent* event) override {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool taken = this->lineEdit()->hasAcceptableInput();
    if (!this->lineEdit()->isModified()) before_ = this->value();
    Box::keyPressEvent(event);
    if (!enter) return;
    before_ = this->value();
    if (!taken) event->accept();  // it does not go on with another number
  }

 private:
  using Number = decltype(std::declval<const Box&>().value());
  bool isOut(double number) const { return number < this->minimum() || number > this->maximum(); }
  /// What the special text stands for is no number, unless it is 0.
  Number leastNumber() const {
    const bool none = !this->specialValueText().isEmpty() && this->minimum() != 0;
    return this->minimum() + (none ? 1 : 0);
  }
  QString shown(Number number) const {
    return number == this->minimum() && !this->specialValueText().isEmpty()
               ? this->specialValueText()
               : this->prefix() + this->textFromValue(number) + this->suffix();
  }
  QString plain(QString text) const {
    if (text.startsWith(this->prefix())) text.remove(0, this->prefix().size());
    if (text.endsWith(this->suffix())) text.chop(this->suffix().size());
    return text.trimmed();
  }
  std::optional<double> numberIn(const QString& text) const {
    bool is_number = false;
    const double number =
        QLocale::c().toDouble(plain(text).replace(QLatin1Char(','), QLatin1Char('.')), &is_number);
    return is_number ? std::optional(number) : std::nullopt;
  }

  std::optional<Number> before_;  // what was last taken, whatever has been typed since
};

using WholeBox = RangedBox<QSpinBox>;

/// Writes a decimal point in any locale; a comma that is typed is one, too. (Qt would take it for a separator
/// of thousands and drop it: 3,5 became 35.)
class DecimalBox : public RangedBox<QDoubleSpinBox> {
 public:
  explicit DecimalBox(QWidget* parent = nullptr);

 protected:
  QValidator::State validate(QString& input, int& pos) const override;
  double valueFromText(const QString& text) const override;
  QString textFromValue(double value) const override;
};

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

/// While it is not allowed its tooltip says why, if that is known.
void allow(QAction* action, bool allowed, const QString& unavailable_reason);

}  // namespace mapwright::ui
