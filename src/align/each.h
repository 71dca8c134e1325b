// A loop whose rounds run on the pool.
#pragma once

#include "work/workers.h"

namespace mapwright::align {

/// Calls job(0) .. job(count - 1), in no order, and returns when all are done.
template <typename Job>
void each(work::Tasks& tasks, int count, const Job& job) {
  for (int i = 0; i < count; ++i) tasks.start(work::Urgency::Wanted, [&job, i] { job(i); });
  tasks.waitForDone();
}

}  // namespace mapwright::align
