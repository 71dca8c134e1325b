// Reading files that anybody may have put there: never waits for a named pipe. Any thread.
#pragma once

#include <cstddef>
#include <string>

#include <tl/expected.hpp>

#include "disk/file_error.h"

namespace mapwright::disk {

/// A regular file, opened for reading: a descriptor that the caller closes, or -1 and errno. What is no
/// regular file (a pipe, a device, a folder) is refused at once, with EISDIR or EINVAL.
int openToRead(const std::string& path);

/// Its first `most` bytes, or why it cannot be read.
tl::expected<std::string, FileError> readFile(const std::string& path, std::size_t most);

/// What comes by the standard input until its end, at most `most` bytes. Waits for whoever writes into it.
tl::expected<std::string, FileError> readStandardInput(std::size_t most);

/// Both are there and are one and the same file, whatever links lead to it.
bool sameFile(const std::string& one, const std::string& other);

}  // namespace mapwright::disk
