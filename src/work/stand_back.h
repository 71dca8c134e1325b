// Background work that must not cost frames.
#pragma once

namespace mapwright::work {

/// Lets the calling thread stand back where another wants its processor: the window is drawn first, cells are
/// decoded next. For threads that do nothing but background work, since it cannot be taken back. Calling it
/// again is free.
void standBack();

}  // namespace mapwright::work
