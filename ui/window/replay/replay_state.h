// How it stands with a replay, in words.
#pragma once

#include <optional>

#include <QString>

#include "replay/replay_robot.h"
#include "session/session.h"
#include "window/map/empty_state.h"
#include "window/status/status_text.h"

namespace mapwright::window {

/// What is replayed in this session; null: it shows a robot as it is.
const replay::ReplayRobot* replayOf(const session::Session* session);
/// How the window reads bags: a file that is still being written is played as far as it goes.
replay::Reading::Options followedReading();
/// What the bag is called: one line of plain text.
QString bagCalled(const replay::ReplayRobot& robot, int limit = 60);
/// All of its time is known, and until then the bag has told none of the maps that are to be seen.
bool hasToldNoMap(session::Session* session, const MapsInView& in_view);
/// Instead of how the link stands; nullopt: it is no replay, or the bag is not opened.
std::optional<StateText> replayText(const session::Session* session);

}  // namespace mapwright::window
