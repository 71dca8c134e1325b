// Why a file could not be written or read.
#pragma once

#include <string>

#include "disk/faults.h"

namespace mapwright::disk {

struct FileError {
  std::string path;  // as it was given; "-" (or what means the same) = the standard output
  Fault cause;       // without the file's name: follows "… cannot be read"
  bool operator==(const FileError&) const = default;
};

/// The system's text for an errno.
FileError systemError(std::string path, int error);
/// "/a.png cannot be written: …", "The standard output cannot be written: …".
Fault notWritten(const FileError& error);

}  // namespace mapwright::disk
