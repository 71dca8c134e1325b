// XDG base directories. Source: XDG Base Directory Specification 0.8.
#pragma once

namespace mapwright::app {

/// "All paths set in these environment variables must be absolute. If an implementation encounters a relative
/// path it should consider the path invalid and ignore it": removes relative paths from the environment, so
/// that Qt, fontconfig and we agree. Call it before any thread starts.
void ignoreRelativeFolders();

}  // namespace mapwright::app
