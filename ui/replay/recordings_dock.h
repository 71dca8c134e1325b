// The robot's recordings: search, replay, download, delete.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include "robot/bag_library.h"
#include "ui/kit/status_text.h"
#include "ui/replay/list_dock.h"

class QPushButton;
class QToolButton;

namespace mapwright::ui {

/// Additional text for a row.
struct BagNote {
  enum class Kind {
    None,
    Opening,
    Downloading,
    Stopped,  // goes on where it was
    Downloaded,
    Deleting,
    Failed,
  };
  Kind kind = Kind::None;
  QString text;
  QString path = {};  // of a download
};

/// The bags and recordings of a robot as a table, each with its progress.
class BagsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, KindColumn, SizeColumn, DurationColumn, EndColumn, NoteColumn, kColumns };
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;

  /// Notes of bags that are still listed are kept.
  void setRows(std::vector<robot::BagEntry> rows);
  void clear();
  void setNote(const robot::BagKey& key, BagNote note);
  /// Robots report it for one bag on request. Kept when the list is cleared.
  void setDuration(const robot::BagKey& key, double length_s);
  void forgetDurations() { durations_.clear(); }
  BagNote note(const robot::BagKey& key) const;
  /// nullptr: there is no such row.
  const robot::BagEntry* entry(int row) const;
  QModelIndex indexOf(const robot::BagKey& key) const;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(rows_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant sortValue(const robot::BagEntry& entry, int column) const;
  QString text(const robot::BagEntry& entry, int column) const;

  std::vector<robot::BagEntry> rows_;
  std::map<robot::BagKey, BagNote> notes_;
  std::map<robot::BagKey, double> durations_;  // seconds
};

/// "recording".
QString kindWord(robot::BagKind kind);
/// A bag's name as one line of plain text.
QString bagCalled(const robot::BagKey& key);

/// The state of the list.
struct RecordingsState {
  bool connected = false;      // there is a robot
  bool online = false;         // and it can be reached
  QString unavailable_reason;  // why it has none; empty = it has
  bool loading = false, listed = false;
  QString error;           // it could not be listed
  bool replaying = false;  // a bag is on screen: nothing can be changed on the robot
};

class RecordingsDock : public ListDock {
  Q_OBJECT
 public:
  explicit RecordingsDock(QWidget* parent = nullptr);
  ~RecordingsDock() override;

  BagsModel* model() const { return model_; }
  void setState(const RecordingsState& state);

  QPushButton* openButton() const { return open_; }
  QPushButton* rehearseButton() const { return rehearse_; }
  QPushButton* stopButton() const { return stop_; }
  QPushButton* deleteButton() const { return delete_; }
  QPushButton* recordButton() const { return record_; }
  QPushButton* retryButton() const { return retry_; }
  void select(const robot::BagKey& key);
  std::optional<robot::BagKey> selected() const;

 Q_SIGNALS:
  void openWanted(const mapwright::robot::BagKey& key);
  /// On the map on screen.
  void rehearseWanted(const mapwright::robot::BagKey& key);
  void downloadWanted(const mapwright::robot::BagKey& key);
  void stopWanted(const mapwright::robot::BagKey& key);
  void deleteWanted(const mapwright::robot::BagKey& key);
  void recordWanted();
  void refreshWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showMenu(const QPoint& at) override;

 private:
  void refresh();
  void refreshButtons();
  QString emptyText() const;
  std::optional<robot::BagKey> keyAt(const QModelIndex& index) const;

  BagsModel* model_;
  QSortFilterProxyModel* sorted_;
  QToolButton* refresh_;
  QPushButton *retry_, *open_, *rehearse_, *download_, *stop_, *delete_, *record_;
  RecordingsState state_;
};

}  // namespace mapwright::ui
