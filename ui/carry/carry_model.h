// What becomes of the things of an old map, as a list.
#pragma once

#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QString>

#include "carry/carried.h"
#include "ui/kit/sorted_rows.h"

namespace mapwright::ui {

struct CarryRow {
  enum class State {
    Open,
    LeftOut,     // by hand
    There,       // the new map has it
    OtherThere,  // the new map has one that belongs to it
    Carried,     // it is a change of the new map
  };
  QString name;
  carry::Carried carried;
  std::string id;              // of the old map
  std::vector<int> with = {};  // rows that go together with it or not at all
  State state = State::Open;

  bool sound() const { return state == State::Open && carry::sound(carried.verdict); }
  bool toLookAt() const { return state == State::Open && !carry::sound(carried.verdict); }
  /// It is carried over where that is wanted.
  bool goes() const { return state == State::Open || state == State::LeftOut; }
};

/// What differs between the lists of one kind of thing and another.
struct CarryWords {
  QString title;           // of the dock
  QString one;             // the head of the column of names
  QString named;           // for assistive technology: "What becomes of the waypoints"
  QString carried, there;  // what these states mean
  QString looking;         // while nothing is known yet
  QString hint;            // how to begin
};

/// "12 sound, 3 to look at (2 in an obstacle, 1 outside)".
QString carrySumText(const std::vector<CarryRow>& rows);

class CarryModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Called, Became, WallsOff, kColumns };
  CarryModel(const CarryWords& words, QObject* parent);

  void setRows(std::vector<CarryRow> rows);
  const std::vector<CarryRow>& rows() const { return rows_; }
  /// One of each row. Says nothing where nothing is different.
  void setStates(const std::vector<CarryRow::State>& states);

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(rows_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString meansText(const CarryRow& row) const;

  CarryWords words_;
  std::vector<CarryRow> rows_;
};

/// Some of them, in any order.
class CarryFilter : public SortedRows {
  Q_OBJECT
 public:
  enum class Shown { All, Sound, ToLookAt };
  /// `model` must outlive this.
  explicit CarryFilter(CarryModel& model, QObject* parent = nullptr);
  void show(Shown shown);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  SortValue sortValue(const QModelIndex& source) const override;

 private:
  const CarryModel& model_;
  Shown shown_ = Shown::All;
};

}  // namespace mapwright::ui
