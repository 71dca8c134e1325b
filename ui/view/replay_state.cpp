#include "ui/view/replay_state.h"

#include <QCoreApplication>

#include "robot/sends_map.h"
#include "sentences/fault_sentence.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

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

bool hasToldNoMap(session::Session* session, const MapsInView& in_view) {
  const replay::ReplayRobot* const robot = replayOf(session);
  if (!robot || robot->knowledge() != replay::Knowledge::Exact || robot->picturesUnderWay() > 0) return false;
  const session::MapSlot& slot = session->wholeMap();
  if (in_view.whole && slot.cells()) return false;
  if (in_view.submaps && session->robot().submapSource()) return !session->world().submaps;
  using Phase = session::MapSlot::Phase;
  const bool live = slot.phase() == Phase::Empty
                        ? robot::sendsItsMap(session->robot())
                        : slot.key().kind == map::MapKind::Live && slot.phase() != Phase::Failed;
  return in_view.whole && live && !session->live().grids.contains(map::GridKind::WholeMap);
}

std::optional<StateText> replayText(const session::Session* session) {
  const replay::ReplayRobot* const robot = replayOf(session);
  if (!robot || robot->connection().phase != robot::ConnectionPhase::Online) return std::nullopt;
  return StateText{Mark::Busy, QCoreApplication::translate("window", "replay, not live")};
}

std::optional<StateText> sourceText(const session::Session* session) {
  if (auto replay = replayText(session)) return replay;
  if (!session || !session->robot().isLocal()) return std::nullopt;
  const robot::ConnectionState state = session->connection();
  const QString why = state.reason.any() ? sentences::wordsOf(state.reason) : QString();
  switch (state.phase) {
    case robot::ConnectionPhase::Online:
      return StateText{Mark::Neutral, QCoreApplication::translate("window", "open")};
    case robot::ConnectionPhase::Connecting:
      return StateText{Mark::Busy, QCoreApplication::translate("window", "opening…")};
    case robot::ConnectionPhase::Offline:
      return StateText{Mark::Neutral, QCoreApplication::translate("window", "closed")};
    case robot::ConnectionPhase::Interrupted:
    case robot::ConnectionPhase::Refused:
      break;
  }
  return StateText{Mark::Bad, why.isEmpty()
                                  ? QCoreApplication::translate("window", "cannot be opened")
                                  : QCoreApplication::translate("window", "cannot be opened: %1").arg(why)};
}

}  // namespace mapwright::ui
