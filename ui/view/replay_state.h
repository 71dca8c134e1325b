// Texts about the state of a replay.
#pragma once

#include <optional>

#include <QString>

#include "replay/replay_robot.h"
#include "session/session.h"
#include "ui/kit/status_text.h"
#include "ui/view/empty_state.h"

namespace mapwright::ui {

/// The replay of this session; null: it shows a live robot.
const replay::ReplayRobot* replayOf(const session::Session* session);
/// How the window reads bags: follows a file that is still being written.
replay::Reading::Options followedReading();
/// The name of the bag: one line of plain text.
QString bagCalled(const replay::ReplayRobot& robot, int limit = 60);
/// All of the state is known, and the bag contains none of the maps to show up to this time.
bool hasToldNoMap(session::Session* session, const MapsInView& in_view);
/// Shown instead of the connection state; nullopt: it is not a replay, or the bag is not open.
std::optional<StateText> replayText(const session::Session* session);
/// The same for everything that is no connection: a replay, an open file. nullopt: a live robot.
std::optional<StateText> sourceText(const session::Session* session);

}  // namespace mapwright::ui
