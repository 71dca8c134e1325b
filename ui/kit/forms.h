// What docks and dialogs are laid out with: rows and columns in one expression, and the labels, buttons and
// boxes that they share.
#pragma once

#include <initializer_list>
#include <optional>
#include <utility>

#include <QBoxLayout>
#include <QDoubleSpinBox>
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

namespace mapwright::window {

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
/// A body in a dock that scrolls upwards and downwards only.
void setScrolledWidget(QDockWidget& dock, QWidget* body);

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

/// Shows every digit that is typed: what is out of range is marked, and becomes the nearest bound when the
/// field is left. (Qt would drop the digit that is too much: 1234 became 123.)
template <class Box>
class BoundedBox : public Box {
 public:
  explicit BoundedBox(QWidget* parent = nullptr) : Box(parent) {
    const auto mark = [this] {
      QString written = Box::text();
      int at = 0;
      // What more digits would bring into the range is not finished.
      const bool beyond = Box::validate(written, at) == QValidator::Invalid && boundOf(written).has_value();
      const QString range =
          QStringLiteral("%1 – %2%3")
              .arg(this->textFromValue(Box::minimum()), this->textFromValue(Box::maximum()), Box::suffix());
      markBeyond(*this, beyond, range);
    };
    QObject::connect(Box::lineEdit(), &QLineEdit::textChanged, this, mark);
    // What the box itself writes is not told by its text.
    QObject::connect(this, &Box::valueChanged, this, mark);
    QObject::connect(this, &Box::editingFinished, this, mark);
  }

 protected:
  bool event(QEvent* event) override {
    if (!isUndoOfOthers(*event, *Box::lineEdit())) return Box::event(event);
    event->ignore();
    return false;
  }
  QValidator::State validate(QString& input, int& pos) const override {
    const QValidator::State state = Box::validate(input, pos);
    return state == QValidator::Invalid && boundOf(input) ? QValidator::Intermediate : state;
  }
  void fixup(QString& input) const override {
    const auto bound = boundOf(input);
    if (!bound) return Box::fixup(input);
    input = Box::prefix() + this->textFromValue(*bound) + Box::suffix();
  }

 private:
  using Number = decltype(std::declval<Box>().value());
  /// The nearest one of a number that is out of range.
  std::optional<Number> boundOf(const QString& input) const {
    constexpr qsizetype kLongest = 24;
    QString text = input;
    if (text.startsWith(Box::prefix())) text.remove(0, Box::prefix().size());
    if (text.endsWith(Box::suffix())) text.chop(Box::suffix().size());
    bool number = false;
    const double value = QLocale::c().toDouble(text.trimmed(), &number);
    if (!number || text.size() > kLongest) return std::nullopt;
    if (value > double(Box::maximum())) return Box::maximum();
    return value < double(Box::minimum()) ? std::optional(Box::minimum()) : std::nullopt;
  }
};

using WholeBox = BoundedBox<QSpinBox>;

/// Writes a decimal point in any locale; a comma that is typed is one, too. (Qt would take it for a separator
/// of thousands and drop it: 3,5 became 35.)
class DecimalBox : public BoundedBox<QDoubleSpinBox> {
 public:
  explicit DecimalBox(QWidget* parent = nullptr);

 protected:
  QValidator::State validate(QString& input, int& pos) const override;
  double valueFromText(const QString& text) const override;
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
void allow(QAction* action, bool allowed, const QString& why_not);

}  // namespace mapwright::window
