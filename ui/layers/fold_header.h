// The heading of rows that fold away.
#pragma once

#include <QAbstractButton>

namespace mapwright::ui {

class FoldHeader : public QAbstractButton {
  Q_OBJECT
 public:
  explicit FoldHeader(const QString& text, QWidget* parent = nullptr);
  /// isChecked(): the rows are there.
  void setOpen(bool open);
  bool open() const { return isChecked(); }
  /// At the far end.
  void setNote(const QString& note);
  QString note() const { return note_; }
  /// A long one takes a second line.
  void setTitle(const QString& text);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 Q_SIGNALS:
  void foldWanted(bool open);
  /// Up is negative.
  void focusWanted(int rows);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void nextCheckState() override;

 private:
  QRect textRoom(int width) const;
  QString note_;
};

}  // namespace mapwright::ui
