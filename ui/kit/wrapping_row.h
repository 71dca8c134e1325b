// A row of tools above or below a list: where a panel is narrow it continues on the next line.
#pragma once

#include <vector>

#include <QLayout>

namespace mapwright::ui {

class WrappingRow : public QLayout {
 public:
  explicit WrappingRow(const QMargins& margins = QMargins(8, 4, 8, 4), int spacing = 6);
  ~WrappingRow() override;

  /// `stretch`: its part of the room that is left on its line. `wanted_px`: it goes to the next line before
  /// it becomes narrower, unless a line is narrower still; below 0: the widget's own wish.
  void add(QWidget* widget, int stretch = 0, int wanted_px = -1);

  void addItem(QLayoutItem* item) override;
  int count() const override { return int(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, false); }
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

 private:
  struct Item {
    QLayoutItem* item;
    int stretch;
    int wanted_px;
    int width() const;
  };
  /// Returns the height.
  int arrange(const QRect& rect, bool apply) const;

  std::vector<Item> items_;
};

}  // namespace mapwright::ui
