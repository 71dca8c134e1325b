// The panel that lists the events of a bag, as far as it has been read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QAbstractTableModel>

#include "replay/events.h"
#include "ui/replay/list_dock.h"
#include "ui/shell/replay_clock.h"

class QComboBox;
class QPushButton;
class QToolButton;

namespace mapwright::ui {

/// Which events are rows.
struct EventFilter {
  std::optional<replay::EventGroup> group;  // nullopt: of all
  QString text;                             // in the texts of kind and event, case-insensitive; empty: all
  bool operator==(const EventFilter&) const = default;
};

/// The events of a bag as rows, by time.
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
  void replaceEvents(std::vector<replay::Event> events);
  void onPresent();
  QString text(const replay::Event& event, int column) const;
  std::size_t at(int row) const { return rows_[std::size_t(row)]; }

  std::vector<replay::Event> events_;
  std::vector<std::uint32_t> rows_;  // indexes in events_
  EventFilter filter_;
  std::optional<double> at_s_;
  double start_s_ = 0;
  int present_ = -1;
};

class EventsDock : public ListDock {
  Q_OBJECT
 public:
  /// `clock` outlives it.
  explicit EventsDock(ReplayClock& clock, QWidget* parent = nullptr);

  /// By time; of the open bag, as far as it has been read.
  void setEvents(const std::vector<replay::Event>& events);
  /// The rest of the bag is being read automatically.
  void setReadsAll(bool all);
  bool follows() const;
  void setFollows(bool follows);

  EventsModel* model() const { return model_; }
  QComboBox* groupBox() const { return group_; }
  QPushButton* readButton() const { return read_; }
  QPushButton* retryButton() const { return retry_; }
  QPushButton* saveButton() const { return save_; }

 Q_SIGNALS:
  void readAllWanted();
  void saveWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void showMenu(const QPoint& at) override;

 private:
  void onTime();
  bool presentInView() const;
  void scrollToPresent();
  void onState();
  void applyFilter();
  void goTo(const QModelIndex& index);
  void copy();
  /// How many there are, and how much of the bag has been read.
  QString summaryText() const;

  ReplayClock& clock_;
  EventsModel* model_;
  QComboBox* group_;
  QToolButton* follow_;
  QPushButton *read_, *retry_, *save_;
  std::vector<replay::Event> waiting_;  // while nobody sees the list
  replay::Event now_;                   // the present one, to which it was scrolled
  bool reads_all_ = true;
};

}  // namespace mapwright::ui
