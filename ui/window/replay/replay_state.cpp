#include "window/replay/replay_state.h"

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::window {

const replay::ReplayRobot* replayOf(const session::Session* session) {
  return session ? qobject_cast<const replay::ReplayRobot*>(&session->robot()) : nullptr;
}

replay::Reading::Options followedReading() {
  constexpr int kLookAgainMs = 2'000;
  replay::Reading::Options options;
  options.look_again_ms = kLookAgainMs;
  return options;
}

QString bagCalled(const replay::ReplayRobot& robot, int limit) { return plainWords(robot.bag(), limit); }

std::optional<StateText> replayText(const session::Session* session) {
  const replay::ReplayRobot* const robot = replayOf(session);
  if (!robot || robot->connection().phase != robot::ConnectionPhase::Online) return std::nullopt;
  return StateText{Mark::Busy, QCoreApplication::translate("window", "replay, not live")};
}

}  // namespace mapwright::window
