// The strip over the map for placing waypoints along a line: spacing, number, create.
#pragma once

#include <QFrame>

class QDoubleSpinBox;
class QPushButton;

namespace mapwright::window {

class LineTool;
class PlainLabel;

class LineBar : public QFrame {
  Q_OBJECT
 public:
  /// A child of `map`, at its lower edge. `tool` must outlive this.
  LineBar(LineTool* tool, QWidget* map);
  QDoubleSpinBox* spacing() const { return spacing_; }
  QPushButton* createButton() const { return create_; }
  QString countShown() const;

 Q_SIGNALS:
  void createWanted();
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void place();
  LineTool* tool_;
  QDoubleSpinBox* spacing_;
  PlainLabel* count_;
  QPushButton *create_, *close_;
};

}  // namespace mapwright::window
