#include "pbstream/record_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "disk/read_file.h"
#include "pbstream/faults.h"
#include "words/figures.h"

namespace mapwright::pbstream {
namespace {

constexpr std::array<std::uint8_t, kSignatureBytes> kSignature{0xDB, 0x01, 0xF5, 0x5B,
                                                               0x7B, 0x1F, 0x1D, 0x7B};

}  // namespace

Fault inRecord(const Record& record, Fault why) {
  return {faultText("pbstream", "Record %1 at byte %2"),
          {words::grouped(std::int64_t(record.number)), words::grouped(std::int64_t(record.offset))},
          {std::move(why)}};
}

tl::expected<std::shared_ptr<const RecordFile>, Fault> RecordFile::open(const std::string& path) {
  const int fd = disk::openToRead(path);
  if (fd < 0) {
    const int why = errno;
    Fault cause = why == EINVAL ? Fault(disk::fault::NotARegularFile) : disk::systemError(path, why).cause;
    return tl::unexpected(Fault(faultText("pbstream", "%1 cannot be read"), {path}, {std::move(cause)}));
  }
  struct stat about {};
  ::fstat(fd, &about);
  std::shared_ptr<const RecordFile> file(new RecordFile(fd, std::uint64_t(about.st_size)));
  std::array<std::uint8_t, 60> begin{};
  const std::size_t some = std::min<std::size_t>(begin.size(), file->size());
  if (!file->read({begin.data(), some}, 0) ||
      !std::equal(kSignature.begin(), kSignature.end(), begin.begin())) {
    if (disk::isGitLfsPointer({reinterpret_cast<const char*>(begin.data()), some}))
      return tl::unexpected(Fault(disk::fault::GitLfsPointer));
    return tl::unexpected(Fault(fault::NoStateFile, {path}));
  }
  return file;
}

RecordFile::~RecordFile() { ::close(fd_); }

bool RecordFile::read(std::span<std::uint8_t> bytes, std::uint64_t at) const {
  return disk::readAt(fd_, bytes, at);
}

}  // namespace mapwright::pbstream
