// The bags and recordings of a robot as a table, each with its progress.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include "robot/bag_library.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

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

}  // namespace mapwright::window
