// What the program was doing when it crashed, on the standard error.
#pragma once

namespace mapwright::app {

/// From now on. The exit status stays that of the signal, and so does the core file. Calls that are not
/// exported are printed as offsets, for addr2line.
void reportCrashes();

}  // namespace mapwright::app
