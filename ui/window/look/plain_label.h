// Plain text, one line as a rule, that does not change the layout around it.
#pragma once

#include <QColor>
#include <QStringList>
#include <QWidget>

namespace mapwright::window {

/// Shows text as it is (no markup, no mnemonics), elided when there is no room, with the whole text as
/// tooltip then. Its size comes from a sample, so texts that change ten times a second relayout nothing.
/// Digits keep their places because numbers are right-aligned where wanted.
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
  /// What has no room in one line may take so many; it asks for as much height then.
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
  /// As they are painted in so much room, the last one elided.
  QStringList linesIn(int width) const;
  QString text_, sample_, icon_, hint_;
  QColor icon_color_;
  Qt::Alignment alignment_ = Qt::AlignLeft | Qt::AlignVCenter;
  Qt::TextElideMode elide_ = Qt::ElideRight;
  bool secondary_ = false;
  int most_lines_ = 1;
};

/// Plain text made safe for places that guess at rich text (tooltips).
QString plainToolTip(const QString& text);

}  // namespace mapwright::window
