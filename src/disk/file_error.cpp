#include "disk/file_error.h"

#include <cstring>

#include "disk/written_file.h"

namespace mapwright::disk {

FileError systemError(std::string path, int error) {
  return {std::move(path), fault::said(std::strerror(error))};
}

Fault notWritten(const FileError& error) {
  if (isStandardOutput(error.path))
    return {faultText("disk", "The standard output cannot be written"), {}, {error.cause}};
  return {fault::FileNotWritten, {error.path}, {error.cause}};
}

}  // namespace mapwright::disk
