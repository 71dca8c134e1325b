// The axis of a bag: what has been read, its events, and the present time. Painted here; user input becomes
// signals.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QPointF>
#include <QWidget>

#include "replay/events.h"
#include "replay/player.h"
#include "ui/replay/timeline_axis.h"
#include "ui/replay/timeline_events.h"

namespace mapwright::ui {

enum class RangeState { Unread, InProgress, Read, Held, Failed };

struct TimelineRange {
  double from_s = 0, until_s = 0;
  RangeState state = RangeState::Unread;
  QString why;  // it failed
  bool operator==(const TimelineRange&) const = default;
};

struct TimelineContent {
  double first_s = 0, last_s = 0;  // equal: empty
  std::vector<TimelineRange> ranges;
  std::vector<replay::Event> events;      // in the order of time
  std::vector<replay::Silence> silences;  // nothing was recorded there
};

class TimelineView : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineView(QWidget* parent = nullptr);

  /// Keeps the visible range, unless that was everything.
  void setContent(TimelineContent content);
  const TimelineContent& content() const { return content_; }
  /// Which events to mark, hover and step to; initially all.
  void setHiddenGroups(std::set<replay::EventGroup> hidden);
  const std::set<replay::EventGroup>& hiddenGroups() const { return hidden_; }
  /// Those that are not hidden, in order of time.
  const std::vector<replay::Event>& shownEvents() const { return shown_; }
  void setAt(double at_s);
  void setLoop(std::optional<replay::Player::Loop> loop);
  /// Shown instead of the axis; empty = the axis.
  void setNotice(const QString& sentence);
  QString notice() const { return notice_; }

  TimelineAxis axis() const;
  void showAll();
  void zoomBy(double factor, double at_s);
  /// The events within a few pixels, and other information about a position; empty = nothing.
  QString wordsAt(const QPointF& px) const;

  QSize sizeHint() const override { return {640, 84}; }
  QSize minimumSizeHint() const override { return {240, 64}; }

 Q_SIGNALS:
  void seekWanted(double at_s);
  void loopWanted(const std::optional<mapwright::replay::Player::Loop>& loop);
  void playWanted();
  void stepWanted(double by_s);
  void messageWanted(int direction);
  void eventWanted(int direction);
  void speedWanted(int direction);  // faster or slower
  void menuWanted(const QPoint& global_pos, double at_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { None, Seek, Loop, Pan };
  struct Rows;
  Rows rows() const;
  void chooseEvents();
  ClusterSizes clusterSizes() const;
  void paintTicks(QPainter& painter, const Rows& rows) const;
  void paintRanges(QPainter& painter, const Rows& rows) const;
  void paintEvents(QPainter& painter, const Rows& rows) const;
  void paintLoop(QPainter& painter, const Rows& rows) const;
  void paintCursor(QPainter& painter, const Rows& rows) const;
  void setAxis(const TimelineAxis& axis);
  bool isEmpty() const { return !(content_.last_s > content_.first_s); }
  double timeAt(double px) const;
  void describe();

  TimelineContent content_;
  std::vector<Stretch> poor_;
  std::set<replay::EventGroup> hidden_;
  std::vector<replay::Event> shown_;
  QString notice_;
  double from_s_ = 0, until_s_ = 0;  // visible; equal = all
  double at_s_ = 0;
  std::optional<replay::Player::Loop> loop_;
  std::optional<double> hovered_px_;
  Drag drag_ = Drag::None;
  double drag_from_s_ = 0, drag_px_ = 0;
};

}  // namespace mapwright::ui
