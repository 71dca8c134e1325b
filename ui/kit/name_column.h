// The columns of a table: names give way last.
#pragma once

#include <vector>

#include <QObject>
#include <QTimer>

class QAbstractItemView;
class QHeaderView;

namespace mapwright::ui {

/// A column beside that of the names. Its width at first is the one that it has as long as it is shown.
struct ColumnBeside {
  int column = 0;
  /// Not 0: text of any length, which has what it needs where there is room, and is elided down to this
  /// before names are.
  int least_px = 0;
  bool may_go = least_px == 0;
};

/// Gives one column of a table or tree what the others leave. If names do not fit, long texts become as
/// narrow as they are; then the others go, in the order of the list; then long texts are elided. Belongs to
/// the view, which must have its model.
class NameColumn : public QObject {
  Q_OBJECT
 public:
  NameColumn(QAbstractItemView* view, QHeaderView* header, int column, std::vector<ColumnBeside> shrinking);

  int column() const { return column_; }
  /// How wide it has to be to show every name in view.
  int wanted() const;
  /// At once; otherwise it follows the view and its model by itself.
  void fit();
  const std::vector<ColumnBeside>& beside() const { return beside_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void watchModel();
  int contentsOf(int column) const;

  QAbstractItemView* view_;
  QHeaderView* header_;
  int column_;
  std::vector<ColumnBeside> beside_;
  std::vector<int> full_px_;  // where there is room; dragged by the user
  std::vector<bool> gone_;    // hidden by this
  bool fitting_ = false;
  QTimer soon_;
};

}  // namespace mapwright::ui
