// How many submaps are asked for before the first of them is there.
#pragma once

namespace mapwright::app {

/// The adapter keeps to what a robot can bear (four at a time); those on disk, and the next ones, it has at
/// hand then without a turn of the main thread in between, which may be painting. Few enough that a view that
/// has moved is not kept waiting.
inline constexpr int kFetchAhead = 32;

}  // namespace mapwright::app
