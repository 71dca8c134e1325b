#include "work/stand_back.h"

#include <algorithm>
#include <cerrno>
#include <sys/resource.h>

namespace mapwright::work {

void standBack() {
  constexpr int kBack = 8, kLeast = 19;
  thread_local bool done = false;
  if (done) return;
  done = true;
  // On Linux the process of id 0 is the calling thread. A refusal leaves the thread as it is, which is no
  // loss.
  errno = 0;
  const int now = getpriority(PRIO_PROCESS, 0);
  if (errno == 0) setpriority(PRIO_PROCESS, 0, std::min(now + kBack, kLeast));
}

}  // namespace mapwright::work
