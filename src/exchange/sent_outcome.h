// What has become of a change that was sent: by its answer, and by a look at what is kept afterwards. The
// same for the command line and the window. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "edit/submission.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::exchange {

enum class SentState {
  Applied,
  Failed,   // it has not been made
  Unknown,  // it was asked for, and neither an answer nor a look tells
  NotSent,
};

struct SentOutcome {
  SentState state = SentState::NotSent;
  std::optional<map::Failure> failure = {};  // of one that is Applied: only its answer was lost
};

using SentRequest = edit::SubmittedRequest<robot::WaypointRequest>;

/// By the answer alone; a request under way is Unknown.
SentOutcome answered(const SentRequest& sent);
/// By a look afterwards; `is_so`: what is kept now is as it was asked for.
SentOutcome judged(SentOutcome by_answer, bool is_so);
/// Both. `looked`: what has been read since; null = nothing yet.
SentOutcome outcomeOf(const SentRequest& sent, const edit::WaypointDocument* looked);

/// How many requests stand so.
struct SentCounts {
  std::size_t applied = 0, failed = 0, unknown = 0, not_sent = 0;
};
SentCounts countsOf(const std::vector<SentRequest>& sent, const edit::WaypointDocument* looked);

/// Why it Failed or is Unknown; else empty.
QString sentenceOf(const SentOutcome& outcome);

}  // namespace mapwright::exchange
