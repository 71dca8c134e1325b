// The result of a change that was sent: from its answer and from reading the stored state afterwards. The
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
  Unknown,  // it was sent, but neither an answer nor the stored state tells
  NotSent,
};

struct SentOutcome {
  SentState state = SentState::NotSent;
  std::optional<map::Failure> failure = {};  // of one that is Applied: only its answer was lost
};

using SentRequest = edit::SubmittedRequest;

/// From the answer alone; a request in progress is Unknown.
SentOutcome answered(const SentRequest& sent);
/// From reading afterwards; `is_so`: the stored state is as requested.
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
