// The facts that made a snapshot.
#pragma once

#include "app/snapshot_run.h"
#include "suite/facts.h"

namespace mapwright::app {

/// Of one that has come.
suite::Facts factsOf(const SnapshotRun& run);

}  // namespace mapwright::app
