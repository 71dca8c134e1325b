// The events of a bag as rows, by time.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include <QAbstractTableModel>

#include "replay/events.h"

namespace mapwright::window {

/// Which events are rows.
struct EventFilter {
  std::optional<replay::EventGroup> group;  // nullopt: of all
  QString text;                             // in the texts of kind and event, case-insensitive; empty: all
  bool operator==(const EventFilter&) const = default;
};

class EventsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { TimeColumn, SinceColumn, KindColumn, TextColumn, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  /// `events` by time, of a bag that begins at `start_s`. Unchanged rows stay selected.
  void setEvents(std::vector<replay::Event> events, double start_s);
  void setFilter(const EventFilter& filter);
  /// The present time; the last event before it is marked. nullopt: none.
  void setAt(std::optional<double> at_s);
  /// -1: none.
  int presentRow() const { return present_; }

  const replay::Event* event(int row) const;
  /// Including those that the filter hides.
  std::size_t total() const { return events_.size(); }
  /// Tab-separated cells, one line per row.
  QString copied(const QModelIndexList& rows) const;
  /// All rows, for tables: stamp_s, time_utc, since_start_s, kind, event. Lines end in "\r\n" (RFC 4180).
  std::string csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<std::uint32_t> passing(const std::vector<replay::Event>& events) const;
  bool passes(const replay::Event& event) const;
  void take(std::vector<replay::Event> events);
  void takePresent();
  QString text(const replay::Event& event, int column) const;
  std::size_t at(int row) const { return rows_[std::size_t(row)]; }

  std::vector<replay::Event> events_;
  std::vector<std::uint32_t> rows_;  // places in events_
  EventFilter filter_;
  std::optional<double> at_s_;
  double start_s_ = 0;
  int present_ = -1;
};

}  // namespace mapwright::window
