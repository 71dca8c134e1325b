// Which time of a bag the window shows: plays, seeks, steps and loops, and updates the session. Everything
// that follows the time of a replay (timeline, plots) depends only on this. GUI-thread object.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "geometry/pose.h"
#include "replay/player.h"
#include "replay/replay_robot.h"
#include "session/session.h"

namespace mapwright::ui {

class ReplayClock : public QObject {
  Q_OBJECT
 public:
  /// `now`: a monotonic clock in milliseconds; none = the system's.
  explicit ReplayClock(std::function<replay::Millis()> now = {}, QObject* parent = nullptr);
  ~ReplayClock() override;

  /// Follows this replay, in this session, until detach(). Neither is owned; both outlive that.
  void attach(replay::ReplayRobot& robot, session::Session& session);
  void detach();

  /// The bag is open, and everything below is about it. Otherwise times are 0 and reading() is null.
  bool isOpen() const { return player_.has_value(); }
  /// Seconds since the epoch.
  double at() const;
  double start() const { return player_ ? player_->start_s() : 0; }
  double end() const { return player_ ? player_->end_s() : 0; }
  replay::Reading* reading() const;
  /// How much of the state at at() is known.
  replay::Knowledge knowledge() const;
  /// The share of the data before at() that has been read, 0..1.
  double lookedBack() const;
  /// The share of the whole bag that has been read, 0..1; 1 exactly if nothing is missing, including data
  /// beyond its stated times.
  double readShare() const;

  bool playing() const;
  double speed() const { return player_ ? player_->speed() : 1; }
  std::optional<replay::Player::Loop> loop() const;
  /// The interpolated pose between two samples; nullopt: use the session's.
  std::optional<geometry::Pose2> poseBetween() const;

  void play();
  void pause();
  void togglePlaying() { playing() ? pause() : play(); }
  /// Below 0: backwards.
  void setSpeed(double speed);
  void setLoop(std::optional<replay::Player::Loop> loop);
  void playUntil(double until_s);
  void step(double by_s);
  /// To the next message after this time, or the last before it (-1).
  void stepMessage(int direction);
  void retry();

 public Q_SLOTS:
  /// The last call counts. timeChanged() is emitted at once, the world follows as soon as possible.
  void seek(double at_s);

 Q_SIGNALS:
  void timeChanged(double at_s);
  void opened();
  void closed();
  /// Ranges of the bag were read, failed or were dropped; end() may have grown.
  void rangesChanged();
  /// Playing, speed, loop or knowledge.
  void stateChanged();

 private:
  /// Of the ranges that begin until then.
  double readShareUntil(double until_s) const;
  void open();
  void proceed();
  void goSoon();
  void updateState();
  void onRead();
  /// A bag is shown from its first map on, or where its first range has none, from its first message on:
  /// before that there is nothing to see. True where it went there.
  bool goToFirstMap();
  replay::Millis now() const { return now_ ? now_() : clock_.elapsed(); }

  std::function<replay::Millis()> now_;
  QElapsedTimer clock_;
  QPointer<replay::ReplayRobot> robot_;
  QPointer<session::Session> session_;
  std::optional<replay::Player> player_;
  std::optional<double> gone_to_;
  bool untouched_ = false;  // the user has not chosen another time since it was opened
  QTimer timer_;
  replay::Millis went_ = 0, pause_ms_ = 0;  // after the last move, so that the window stays responsive
  struct State {
    bool playing = false, waiting = false;
    replay::Knowledge knowledge = replay::Knowledge::Buffering;
    bool operator==(const State&) const = default;
  };
  State told_;
};

}  // namespace mapwright::ui
