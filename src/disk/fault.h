// Why a file could not be written or read, as a value. What people read of it is made elsewhere
// (reasons::reasonOf).
#pragma once

#include <string>
#include <utility>

namespace mapwright::disk {

enum class FaultCode {
  System,  // `system` says it
  IsAFolder,
  IsADisk,
  IsASocket,
  NotRegular,      // no regular file
  NoFileInFolder,  // none can be made in `folder`: `system` says why
  NobodyReads,     // the pipe
  NothingTaken,    // whoever reads from it takes nothing
};

/// Texts are UTF-8 as the system has it, and untrusted.
struct Fault {
  FaultCode code = FaultCode::System;
  std::string path;    // as it was given; "-" (or what means the same) = the standard output
  std::string system;  // the system's words, without a stop
  std::string folder;
  bool operator==(const Fault&) const = default;
};

/// What the system says of an errno.
Fault systemFault(std::string path, int error);

}  // namespace mapwright::disk
