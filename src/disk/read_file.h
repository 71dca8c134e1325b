// Reading files that may come from anyone: never blocks on a named pipe. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "disk/file_error.h"

namespace mapwright::disk {

/// Opens a regular file for reading: returns a descriptor that the caller closes, or -1 and errno. Anything
/// else (a pipe, a device, a folder) is refused at once with EISDIR or EINVAL.
int openToRead(const std::string& path);

/// Reads or writes all of `bytes` at an offset in an open file; errno says why not (0: the file ends).
bool readAt(int fd, std::span<std::uint8_t> bytes, std::uint64_t at);
bool writeAt(int fd, std::span<const std::uint8_t> bytes, std::uint64_t at);

/// It is what Git leaves in place of a large file that was not fetched; the first 60 bytes are enough.
bool isGitLfsPointer(std::string_view begin);

/// Its first `most` bytes, or why it cannot be read: also that it is a pointer of Git LFS.
tl::expected<std::string, FileError> readFile(const std::string& path, std::size_t most);

/// Standard input until its end, at most `most` bytes. Blocks until the writer is done.
tl::expected<std::string, FileError> readStandardInput(std::size_t most);

/// Both exist and are the same file, through any links.
bool sameFile(const std::string& one, const std::string& other);

}  // namespace mapwright::disk
