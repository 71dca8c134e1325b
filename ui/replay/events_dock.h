// The panel that lists the events of a bag, as far as it has been read.
#pragma once

#include <vector>

#include <QDockWidget>

#include "replay/events.h"
#include "ui/replay/events_model.h"
#include "ui/shell/replay_clock.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

class EventsDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `clock` outlives it.
  explicit EventsDock(ReplayClock& clock, QWidget* parent = nullptr);
  ~EventsDock() override;

  /// By time; of the open bag, as far as it has been read.
  void setEvents(const std::vector<replay::Event>& events);
  /// The rest of the bag is being read automatically.
  void setReadsAll(bool all);
  bool follows() const;
  void setFollows(bool follows);

  EventsModel* model() const { return model_; }
  QTableView* table() const { return table_; }
  QLineEdit* search() const { return search_; }
  QComboBox* groupBox() const { return group_; }
  QToolButton* followButton() const { return follow_; }
  QPushButton* readButton() const { return read_; }
  QPushButton* retryButton() const { return retry_; }
  QPushButton* saveButton() const { return save_; }
  /// How many there are, and how much of the bag has been read.
  QString summaryShown() const;
  /// Shown instead of the list; empty = the list.
  QString emptyShown() const;

 Q_SIGNALS:
  void readAllWanted();
  void copyWanted(const QString& text, const QString& said);
  void saveWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void layOut();
  void takeTime();
  bool presentInView() const;
  void scrollToPresent();
  void takeState();
  void takeFilter();
  void goTo(const QModelIndex& index);
  void copy();
  void showMenu(const QPoint& at);
  QString summaryText() const;

  ReplayClock& clock_;
  EventsModel* model_;
  QTableView* table_;
  QLineEdit* search_;
  QComboBox* group_;
  PlainLabel* summary_;
  QLabel* empty_;
  QToolButton* follow_;
  QPushButton *read_, *retry_, *save_;
  std::vector<replay::Event> waiting_;  // while nobody sees the list
  replay::Event now_;                   // the present one, to which it was scrolled
  bool reads_all_ = true;
};

}  // namespace mapwright::window
