// XDG base directories. Source: XDG Base Directory Specification 0.8.
#pragma once

namespace mapwright::app {

/// "All paths set in these environment variables must be absolute. If an implementation encounters a relative
/// path it should consider the path invalid and ignore it": they are taken out of the environment, so that
/// Qt, fontconfig and we agree. Before any thread is started.
void ignoreRelativeFolders();

}  // namespace mapwright::app
