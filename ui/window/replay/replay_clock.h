// Which time of a bag the window shows: plays, seeks, steps and loops, and brings the session there. What
// follows the time of a replay (timeline, plots) holds on to this alone. GUI-thread object.
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

namespace mapwright::window {

class ReplayClock : public QObject {
  Q_OBJECT
 public:
  /// `now`: milliseconds that only go forward; none = the system's.
  explicit ReplayClock(std::function<replay::Millis()> now = {}, QObject* parent = nullptr);
  ~ReplayClock() override;

  /// Follows this replay, in this session, until detach(). Neither is owned; both outlive that.
  void attach(replay::ReplayRobot& robot, session::Session& session);
  void detach();

  /// The bag is opened: all below speaks of it. Else times are 0 and reading() is null.
  bool isOpen() const { return player_.has_value(); }
  /// Seconds since the epoch.
  double at() const;
  double start() const { return player_ ? player_->start_s() : 0; }
  double end() const { return player_ ? player_->end_s() : 0; }
  replay::Reading* reading() const;
  /// How much of the world of at() is known.
  replay::Knowledge knowledge() const;
  /// How much of what lies before at() has been read, 0..1.
  double lookedBack() const;
  /// How much of all of the bag has been read, 0..1; 1 exactly when nothing is missing, beyond its told times
  /// too.
  double readShare() const;

  bool playing() const;
  double speed() const { return player_ ? player_->speed() : 1; }
  std::optional<replay::Player::Loop> loop() const;
  /// Where the robot is between two samples; nullopt: where the session says.
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
  /// The last wish wins. timeChanged() comes at once, the world as soon as it can.
  void seek(double at_s);

 Q_SIGNALS:
  void timeChanged(double at_s);
  void opened();
  void closed();
  /// Something of the bag was read, failed or let go; end() may have grown.
  void rangesChanged();
  /// Playing, speed, loop or knowledge.
  void stateChanged();

 private:
  /// Of what begins until then.
  double readShareUntil(double until_s) const;
  void open();
  void proceed();
  void goSoon();
  void noteState();
  void noteRead();
  /// A bag is shown from its first message on: before it there is nothing to be seen.
  void goToFirstMessage();
  replay::Millis now() const { return now_ ? now_() : clock_.elapsed(); }

  std::function<replay::Millis()> now_;
  QElapsedTimer clock_;
  QPointer<replay::ReplayRobot> robot_;
  QPointer<session::Session> session_;
  std::optional<replay::Player> player_;
  std::optional<double> gone_to_;
  bool untouched_ = false;  // nobody has wanted another time than the one that it opened with
  QTimer timer_;
  replay::Millis went_ = 0, pause_ms_ = 0;  // after the last move, so that the window stays free
  struct State {
    bool playing = false, waiting = false;
    replay::Knowledge knowledge = replay::Knowledge::Buffering;
    bool operator==(const State&) const = default;
  };
  State told_;
};

}  // namespace mapwright::window
