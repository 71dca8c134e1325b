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
constexpr std::size_t kWindowBytes = 64 << 10;
constexpr std::size_t kBufferBytes = 64 << 10;
constexpr std::size_t kFirstBufferBytes = 256;  // most records are skipped after a few bytes

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

std::span<const std::uint8_t> FileWindow::at(std::uint64_t offset, std::size_t least) {
  const std::uint64_t end = from_ + bytes_.size();
  if (offset < from_ || offset + least > end) {
    const std::uint64_t there = offset < file_.size() ? file_.size() - offset : 0;
    bytes_.resize(std::size_t(std::min<std::uint64_t>(there, kWindowBytes)));
    from_ = offset;
    if (!file_.read(bytes_, offset)) bytes_.clear();
    return bytes_;
  }
  return std::span<const std::uint8_t>(bytes_).subspan(std::size_t(offset - from_));
}

std::uint64_t sizeAt(FileWindow& window, std::uint64_t offset) {
  const auto bytes = window.at(offset, kSizeBytes);
  std::uint64_t value = 0;
  for (std::size_t i = std::min<std::size_t>(bytes.size(), kSizeBytes); i-- > 0;)
    value = value << 8 | bytes[i];
  return value;
}

RecordStream::RecordStream(FileWindow& window) : window_(window), gunzip_({}) {}

packed::GunzipStream::More RecordStream::source() {
  return [this]() -> std::span<const std::uint8_t> {
    if (at_ >= end_) return {};
    const auto here = window_.at(at_, 1);
    const auto piece = here.first(std::size_t(std::min<std::uint64_t>(here.size(), end_ - at_)));
    at_ += piece.size();
    return piece;
  };
}

void RecordStream::start(const Record& record) {
  at_ = record.begin();
  end_ = record.end();
  gunzip_.restart(source());
  filled_ = 0;
  unpacked_ = behind_ = 0;
  too_long_ = false;
}

bool RecordStream::Next(const void** data, int* size) {
  if (behind_ > 0) {
    *data = buffer_.data() + filled_ - std::size_t(behind_);
    *size = int(std::exchange(behind_, 0));
    return true;
  }
  if (unpacked_ > kMostUnpacked - std::int64_t(kBufferBytes)) {
    too_long_ = true;
    return false;
  }
  const std::size_t most = unpacked_ == 0 ? kFirstBufferBytes : kBufferBytes;
  if (buffer_.size() < most) buffer_.resize(most);
  filled_ = gunzip_.read({buffer_.data(), most});
  unpacked_ += std::int64_t(filled_);
  *data = buffer_.data();
  *size = int(filled_);
  return filled_ > 0;
}

void RecordStream::BackUp(int count) { behind_ += count; }

bool RecordStream::Skip(int count) {
  const void* data = nullptr;
  int size = 0;
  while (count > 0) {
    if (!Next(&data, &size)) return false;
    if (size > count) BackUp(size - count);
    count -= std::min(size, count);
  }
  return true;
}

Fault RecordStream::fault() const {
  using State = packed::GunzipStream::State;
  if (too_long_) return faultText("pbstream", "it unpacks to more than 2 GB");
  if (gunzip_.state() == State::Corrupt) return faultText("pbstream", "its gzip stream is damaged");
  if (gunzip_.state() == State::Cut) return faultText("pbstream", "its gzip stream ends too early");
  return {};
}

void RecordStream::finish() {
  const void* data = nullptr;
  int size = 0;
  while (Next(&data, &size)) {
  }
}

}  // namespace mapwright::pbstream
