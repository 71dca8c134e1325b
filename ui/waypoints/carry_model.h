// What becomes of the waypoints of an old map, as a list.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>

#include "carry/carried.h"
#include "edit/document.h"
#include "map/waypoint.h"

namespace mapwright::window {

struct CarryRow {
  enum class State {
    Open,
    There,    // the new map has one of that name
    Carried,  // it is in the list of the new map
  };
  map::Waypoint point;  // of the old map
  carry::Carried carried;
  edit::Key key = {};  // of what it became on the new map; empty: it was not carried over
  State state = State::Open;

  bool sound() const { return state == State::Open && carry::sound(carried.verdict); }
  bool toLookAt() const { return state == State::Open && !carry::sound(carried.verdict); }
};

/// "12 sound, 3 to look at (2 in an obstacle, 1 outside)".
QString carrySumText(const std::vector<CarryRow>& rows);

class CarryModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Called, Became, WallsOff, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  void setRows(std::vector<CarryRow> rows);
  const std::vector<CarryRow>& rows() const { return rows_; }
  void setKey(int row, const edit::Key& key) { rows_[std::size_t(row)].key = key; }
  /// What the new map has by now. Says nothing where nothing is different.
  void setThere(const edit::Items& items);

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(rows_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<CarryRow> rows_;
};

/// Some of them, in any order.
class CarryFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class Shown { All, Sound, ToLookAt };
  /// `model` must outlive this.
  explicit CarryFilter(CarryModel& model, QObject* parent = nullptr);
  void show(Shown shown);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  const CarryModel& model_;
  QCollator order_;
  Shown shown_ = Shown::All;
};

}  // namespace mapwright::window
