// A dock that lists rows in a table, with a search field and buttons above, or a sentence instead of rows.
#pragma once

#include <initializer_list>

#include <QDockWidget>

class QAbstractItemModel;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace mapwright::ui {

class PlainLabel;

class ListDock : public QDockWidget {
  Q_OBJECT
 public:
  ~ListDock() override;
  QTableView* table() const { return table_; }
  QLineEdit* search() const { return search_; }
  QString summaryShown() const;
  /// The sentence shown instead of rows; empty while there are rows.
  QString emptyShown() const;

 Q_SIGNALS:
  void copyWanted(const QString& text, const QString& said);

 protected:
  /// `search`: what its field says. Key presses of the table come to eventFilter().
  ListDock(const QString& title, const QString& search, QWidget* parent);
  /// Call it once. `tools` stand behind the search field, `buttons` behind the summary.
  void layOut(QAbstractItemModel* rows, std::initializer_list<QWidget*> tools, int summary_stretch,
              std::initializer_list<QPushButton*> buttons);
  /// Instead of the table; empty: the table.
  void showInstead(const QString& sentence);
  virtual void showMenu(const QPoint& at) = 0;

  QLineEdit* search_;
  QTableView* table_;
  PlainLabel* summary_;

 private:
  QLabel* empty_;
};

}  // namespace mapwright::ui
