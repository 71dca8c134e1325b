// Lowers the priority of background work so that it does not cost frames.
#pragma once

namespace mapwright::work {

/// Lowers the priority of the calling thread: the window is drawn first, cells are decoded next. Only for
/// threads that do nothing but background work, since it cannot be undone. Calling it again is free.
void standBack();

}  // namespace mapwright::work
