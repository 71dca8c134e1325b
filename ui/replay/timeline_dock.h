// The panel of a replay: play, speed, time, and the axis of the bag.
#pragma once

#include <QDockWidget>
#include <QTimer>

#include "ui/replay/timeline_view.h"
#include "ui/shell/replay_clock.h"

class QComboBox;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace mapwright::ui {

class PlainLabel;
class StateLabel;

class TimelineDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `clock` outlives it.
  explicit TimelineDock(ReplayClock& clock, QWidget* parent = nullptr);
  ~TimelineDock() override;

  /// The text while nothing is open: "Opening …"; empty = how to open a bag.
  void setOpening(const QString& sentence);
  /// The text of the button "back".
  void setBack(const QString& text);
  void goToNextEvent(int direction);
  void faster(int direction);
  /// Moves the focus to the time field.
  void askForTime();

  TimelineView* view() const { return view_; }
  QToolButton* playButton() const { return play_; }
  QComboBox* speedBox() const { return speed_; }
  QLineEdit* timeField() const { return time_; }
  QPushButton* retryButton() const { return retry_; }
  QPushButton* backButton() const { return back_; }
  /// "buffering", "reading earlier data 40 %", what could not be read; empty = all is known.
  QString stateShown() const;
  QString lengthShown() const;
  QToolButton* eventsButton() const { return events_; }
  QToolButton* listButton() const { return list_; }
  /// The hidden groups of events, by their words; for the settings.
  QStringList hiddenGroups() const;
  void setHiddenGroups(const QStringList& words);

 Q_SIGNALS:
  void backWanted();
  /// Export a part of the bag.
  void exportWanted();
  /// The panel that lists the events.
  void listWanted();
  /// Those in view have been collected again.
  void eventsChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* button(const char* icon, const QString& name, const QString& tip);
  void layOut();
  void connectView();
  void showMenu(const QPoint& global_pos, double at_s);
  void onOpened();
  void onClosed();
  void onTime(double at_s);
  void onState();
  void makeEventsMenu();
  void setGroups();
  void onContent();
  void applyTyped(bool play_until);
  void applySpeed();
  /// Its text, if there is room for it.

  ReplayClock& clock_;
  TimelineView* view_;
  QToolButton *event_back_, *message_back_, *play_, *message_forward_, *event_forward_, *events_, *list_;
  QComboBox* speed_;
  QLineEdit* time_;
  PlainLabel* length_;
  StateLabel* state_;
  QPushButton *retry_, *back_;
  QTimer content_timer_;
  QString opening_;
};

}  // namespace mapwright::ui
