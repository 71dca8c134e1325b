// What docks and dialogs are laid out with: rows and columns in one expression, and the labels, buttons and
// boxes that they share.
#pragma once

#include <initializer_list>
#include <optional>

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QMargins>
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

/// Writes a decimal point in any locale; a comma that is typed is one, too. (Qt would take it for a separator
/// of thousands and drop it: 3,5 became 35.)
class DecimalBox : public QDoubleSpinBox {
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
