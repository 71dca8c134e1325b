// What a path leads to: a file of one of the formats, one that is compressed as a whole, or a folder of them.
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <utility>
#include <zstd.h>

#include "disk/read_file.h"
#include "recording/opening.h"

namespace mapwright::recording {
namespace {

constexpr std::uint64_t kLeftFree = std::uint64_t(256) << 20;  // of the disk for temporary files

Failure fileFailure(const std::string& path, int error) {
  return {Failure::Code::File, disk::systemError(path, error)};
}

class StoppableBytes final : public Bytes {
 public:
  StoppableBytes(std::unique_ptr<Bytes> bytes, Stop stop)
      : bytes_(std::move(bytes)), stop_(std::move(stop)) {}
  std::uint64_t size() const override { return bytes_->size(); }
  bool read(std::span<std::uint8_t> out, std::uint64_t at) const override {
    return !stop_() && bytes_->read(out, at);
  }

 private:
  std::unique_ptr<Bytes> bytes_;
  Stop stop_;
};

/// A packed recording inside of a packed one is none.
Opened openFile(const std::string& path, const Limits& limits, const Stop& stop, bool may_be_packed) {
  auto bytes = fileBytes(path);
  if (!bytes) return tl::unexpected(Failure{Failure::Code::File, std::move(bytes.error())});
  std::array<std::uint8_t, kLookedAt> start{};
  const auto there =
      std::span(start).first(std::size_t(std::min<std::uint64_t>(start.size(), (*bytes)->size())));
  const bool read = (*bytes)->read(there, 0);
  if (read && looksLikeSqlite(there)) return openSqliteBag(path, limits, stop);
  if (read && may_be_packed && looksLikeZstd(there)) {
    const auto unpacked = unpackedFile(path, limits, stop);
    if (!unpacked) return tl::unexpected(unpacked.error());
    // Opened it needs no name.
    Opened opened = openFile(unpacked->path(), limits, stop, false);
    if (!opened) return opened;
    return noted(std::move(*opened), {NoteCode::Unpacked, 0, unpacked->size(), "zstd"});
  }
  if (!stop) return openRecording(std::move(*bytes), limits);
  return openRecording(std::make_unique<StoppableBytes>(std::move(*bytes), stop), limits);
}

Opened openFolder(const std::string& folder, const Limits& limits, const Stop& stop) {
  std::vector<std::unique_ptr<Source>> parts;
  std::vector<Note> notes;
  std::optional<Failure> first;
  const RosbagFolder said = rosbagFolder(folder);
  for (const std::string& name : said.files) {
    Opened part = openFile(folder + '/' + name, limits, stop, true);
    if (part) {
      parts.push_back(std::move(*part));
      continue;
    }
    notes.push_back({NoteCode::FileMissing, 0, 1, name});
    if (!first) first = part.error();
  }
  if (parts.empty()) return tl::unexpected(first.value_or(Failure{Failure::Code::NotOne, {}}));
  if (!said.described) notes.push_back({NoteCode::NoMetadata, 0, said.files.size(), {}});
  if (said.left_out > 0) notes.push_back({NoteCode::FilesLeftOut, 0, said.left_out, {}});
  // Where a file is missing, so are its messages.
  std::uint64_t found = notes.empty() ? 0 : said.messages;
  for (const auto& part : parts) {
    const Summary summary = part->summary();
    found += summary.messages;
    if (!summary.counted || !summary.notes.empty()) found = said.messages;  // they say what is lost
  }
  if (found < said.messages) notes.push_back({NoteCode::MessagesMissing, 0, said.messages - found, {}});
  return joined(std::move(parts), std::move(notes));
}

}  // namespace

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : path_(std::exchange(other.path_, {})), size_(other.size_) {}

tl::expected<TemporaryFile, Failure> unpackedFile(const std::string& path, const Limits& limits,
                                                  const Stop& stop) {
  const Failure not_unpacked{Failure::Code::NotUnpacked, {}};
  const auto packed = fileBytes(path);
  if (!packed) return tl::unexpected(Failure{Failure::Code::File, packed.error()});
  // Not /tmp, which may be in memory.
  const char* const folder = std::getenv("TMPDIR");
  TemporaryFile file;
  std::string name = std::string(folder && *folder ? folder : "/var/tmp") + "/mapwright-XXXXXX";
  const int fd = ::mkostemp(name.data(), O_CLOEXEC);
  if (fd < 0) return tl::unexpected(fileFailure(name, errno));
  file.path_ = name;
  const std::unique_ptr<const int, void (*)(const int*)> closed(&fd, [](const int* one) { ::close(*one); });
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) return tl::unexpected(not_unpacked);
  std::vector<std::uint8_t> in(ZSTD_DStreamInSize()), out(ZSTD_DStreamOutSize());
  std::size_t wanted = 1;
  for (std::uint64_t at = 0; at < (*packed)->size();) {
    const std::size_t count = std::size_t(std::min<std::uint64_t>(in.size(), (*packed)->size() - at));
    if ((stop && stop()) || !(*packed)->read(std::span(in).first(count), at))
      return tl::unexpected(fileFailure(path, EIO));
    at += count;
    ZSTD_inBuffer from{in.data(), count, 0};
    struct statvfs disk {};
    while (from.pos < from.size) {
      ZSTD_outBuffer to{out.data(), out.size(), 0};
      wanted = ZSTD_decompressStream(context.get(), &to, &from);
      if (ZSTD_isError(wanted)) return tl::unexpected(not_unpacked);
      if (to.pos > limits.most_unpacked_bytes - file.size_) return tl::unexpected(not_unpacked);
      for (std::size_t done = 0; done < to.pos;) {
        const ssize_t written = ::write(fd, out.data() + done, to.pos - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return tl::unexpected(fileFailure(name, written < 0 ? errno : ENOSPC));
        done += std::size_t(written);
      }
      file.size_ += to.pos;
    }
    if (::fstatvfs(fd, &disk) == 0 && std::uint64_t(disk.f_bavail) * disk.f_frsize < kLeftFree)
      return tl::unexpected(fileFailure(name, ENOSPC));
  }
  // What was cut off is played as far as it goes, as a recording that was not compressed.
  if (wanted != 0 && file.size_ == 0) return tl::unexpected(not_unpacked);
  return file;
}

bool looksLikeZstd(std::span<const std::uint8_t> start) {
  constexpr std::array<std::uint8_t, 4> kMagic{0x28, 0xB5, 0x2F, 0xFD};
  return start.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), start.begin());
}

Opened openRecording(const std::string& path, const Limits& limits, Stop stop) {
  if (isRosbagFolder(path)) return openFolder(*rosbagFolderAt(path), limits, stop);
  return openFile(path, limits, stop, true);
}

}  // namespace mapwright::recording
