// The robot's recordings: search, replay, download, delete.
#pragma once

#include <optional>
#include <vector>

#include <QDockWidget>

#include "ui/replay/bags_model.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

/// The state of the list.
struct RecordingsState {
  bool connected = false;  // there is a robot
  bool online = false;     // and it can be reached
  QString why_not;         // why it has none; empty = it has
  bool loading = false, listed = false;
  QString error;           // it could not be listed
  bool replaying = false;  // a bag is on screen: nothing can be changed on the robot
};

class RecordingsDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit RecordingsDock(QWidget* parent = nullptr);
  ~RecordingsDock() override;

  BagsModel* model() const { return model_; }
  void setState(const RecordingsState& state);

  QTableView* table() const { return table_; }
  QLineEdit* search() const { return search_; }
  QPushButton* openButton() const { return open_; }
  QPushButton* downloadButton() const { return download_; }
  QPushButton* stopButton() const { return stop_; }
  QPushButton* deleteButton() const { return delete_; }
  QPushButton* recordButton() const { return record_; }
  QPushButton* retryButton() const { return retry_; }
  /// The text shown instead of rows; empty while there are rows.
  QString emptyShown() const;
  QString summaryShown() const;
  void select(const robot::BagKey& key);
  std::optional<robot::BagKey> selected() const;

 Q_SIGNALS:
  void openWanted(const mapwright::robot::BagKey& key);
  void downloadWanted(const mapwright::robot::BagKey& key);
  void stopWanted(const mapwright::robot::BagKey& key);
  void deleteWanted(const mapwright::robot::BagKey& key);
  void recordWanted();
  void refreshWanted();
  void copyWanted(const QString& text, const QString& said);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void layOut();
  void refresh();
  void refreshButtons();
  void showMenu(const QPoint& at);
  QString emptyText() const;
  std::optional<robot::BagKey> keyAt(const QModelIndex& index) const;

  BagsModel* model_;
  QSortFilterProxyModel* sorted_;
  QLineEdit* search_;
  QToolButton* refresh_;
  QTableView* table_;
  QLabel* empty_;
  PlainLabel* summary_;
  QPushButton *retry_, *open_, *download_, *stop_, *delete_, *record_;
  RecordingsState state_;
};

}  // namespace mapwright::window
