// Plain text, usually one line, that does not change the layout around it.
#pragma once

#include <QColor>
#include <QStringList>
#include <QWidget>

namespace mapwright::ui {

/// Shows text literally (no markup, no mnemonics), elided if there is no room, then with the whole text as
/// tooltip. Its size comes from a sample, so texts that change ten times a second cause no relayout. Digits
/// keep their positions because numbers are right-aligned where wanted.
class PlainLabel : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QString text READ text WRITE setText)
 public:
  explicit PlainLabel(QWidget* parent = nullptr);
  explicit PlainLabel(const QString& text, QWidget* parent = nullptr);

  QString text() const { return text_; }
  void setText(const QString& text);
  void setAlignment(Qt::Alignment alignment);
  void setElideMode(Qt::TextElideMode mode);
  /// The preferred width is that of `sample` (empty: of the text).
  void setSample(const QString& sample);
  /// Text that does not fit into one line may take this many; the height grows accordingly.
  void setMostLines(int lines);
  void setSecondary(bool secondary);
  bool secondary() const { return secondary_; }
  void setIcon(const QString& icon_name, const QColor& color);  // drawn before the text; empty = none
  /// Shown before the elided text in the tooltip. Plain.
  void setHint(const QString& hint);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  int iconWidth() const { return icon_.isEmpty() ? 0 : 20; }
  /// The lines as painted at this width, the last one elided.
  QStringList linesIn(int width) const;
  QString text_, sample_, icon_, hint_;
  QColor icon_color_;
  Qt::Alignment alignment_ = Qt::AlignLeft | Qt::AlignVCenter;
  Qt::TextElideMode elide_ = Qt::ElideRight;
  bool secondary_ = false;
  int most_lines_ = 1;
};

/// Plain text escaped for widgets that may interpret rich text (tooltips).
QString plainToolTip(const QString& text);

}  // namespace mapwright::ui
