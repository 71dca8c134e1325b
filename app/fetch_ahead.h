// How many submaps are requested before the first one has arrived.
#pragma once

namespace mapwright::app {

/// The adapter limits the number of parallel requests (four). With a few more queued it can continue from
/// disk, or with the next request, without waiting for the main thread, which may be painting. Small enough
/// to react quickly when the view moves.
inline constexpr int kFetchAhead = 32;

}  // namespace mapwright::app
