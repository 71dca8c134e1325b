#include "grids/sidecar.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <isa-l/crc.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "disk/read_file.h"
#include "grids/faults.h"
#include "grids/growing_pyramid.h"

namespace mapwright::grids {

namespace {

namespace fs = std::filesystem;

// The file: this header, padded; the chunks of the tile store; the key; the index.
constexpr std::array<char, 8> kMagic{'M', 'W', 'G', 'R', 'I', 'D', '\r', '\n'};
constexpr std::uint32_t kVersion = 2;
constexpr std::int64_t kDataOffset = 4096;
constexpr const char* kSuffix = ".grid";
constexpr const char* kDraftMark = ".part-";
constexpr std::uint64_t kLongestKey = 1 << 16;
constexpr auto kAbandonedAfter = std::chrono::hours(24);

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t byte_order = 0x01020304;
  std::int32_t width = 0, height = 0;
  std::uint32_t code = 0, reduction = 0;
  std::uint64_t data_bytes = 0, key_bytes = 0, index_entries = 0;
  std::uint32_t tail_sum = 0;  // of key and index
  std::uint32_t sum = 0;       // of what is before it
};

std::uint32_t sumOf(const void* bytes, std::size_t size, std::uint32_t before = 0) {
  return crc32_gzip_refl(before, static_cast<const unsigned char*>(bytes), size);
}
std::uint32_t headerSum(const Header& header) { return sumOf(&header, offsetof(Header, sum)); }

bool readAll(int fd, void* out, std::size_t size, std::int64_t at) {
  return disk::readAt(fd, {static_cast<std::uint8_t*>(out), size}, std::uint64_t(at));
}
bool writeAll(int fd, const void* from, std::size_t size, std::int64_t at) {
  return disk::writeAt(fd, {static_cast<const std::uint8_t*>(from), size}, std::uint64_t(at));
}

/// 64-bit FNV-1a; the file contains the whole key, so a collision is a miss and never a wrong map.
std::uint64_t hashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char letter : text) hash = (hash ^ std::uint8_t(letter)) * 0x100000001b3u;
  return hash;
}

Fault notKept(const std::string& folder, Fault why) {
  return {faultText("grids", "Temporary files of large maps cannot be kept in %1"),
          {folder},
          {std::move(why)},
          Consequence::ReadAnewEachTime};
}

/// Null if anything in the file is invalid. Takes `fd`.
std::shared_ptr<const GridPyramid> restored(int fd, const SidecarKey& key,
                                            std::shared_ptr<TileCache> unpacked) {
  Header header;
  struct stat about {};
  bool good = readAll(fd, &header, sizeof(header), 0) && ::fstat(fd, &about) == 0;
  good = good && header.magic == kMagic && header.version == kVersion &&
         header.byte_order == Header{}.byte_order && header.sum == headerSum(header);
  good = good && header.width == key.width && header.height == key.height && header.code < kCellCodes &&
         isGray(CellCode(header.code)) == isGray(key.code) &&
         header.reduction == std::uint32_t(key.reduction) && header.key_bytes == key.content.size();
  std::shared_ptr<GrowingPyramid> pyramid;
  if (good) {
    const CellCode code = CellCode(header.code);
    pyramid = std::make_shared<GrowingPyramid>(key.width, key.height, code, key.reduction,
                                               GridReducer(code, key.reduction), std::move(unpacked));
  }
  good = good && header.index_entries == pyramid->store().levels().back().first + 1;
  const std::uint64_t size = good ? std::uint64_t(kDataOffset) + header.data_bytes + header.key_bytes +
                                        header.index_entries * sizeof(std::uint64_t)
                                  : 0;
  good = good && std::uint64_t(about.st_size) == size;
  std::string content(good ? std::size_t(header.key_bytes) : 0, '\0');
  std::vector<std::uint64_t> index(good ? std::size_t(header.index_entries) : 0);
  if (good) {
    const std::int64_t tail = kDataOffset + std::int64_t(header.data_bytes);
    const std::size_t index_bytes = index.size() * sizeof(std::uint64_t);
    good = readAll(fd, content.data(), content.size(), tail) && content == key.content &&
           readAll(fd, index.data(), index_bytes, tail + std::int64_t(content.size())) &&
           header.tail_sum == sumOf(index.data(), index_bytes, sumOf(content.data(), content.size()));
  }
  if (good && pyramid->store().restore(index, fd, kDataOffset, header.data_bytes, key.salt())) {
    pyramid->markComplete();
    return pyramid;
  }
  ::close(fd);
  return nullptr;
}

}  // namespace

SidecarKey::SidecarKey(const GridOptions& options, int picture_width, int picture_height)
    : folder(options.sidecar_folder),
      width(picture_width),
      height(picture_height),
      code(codeOf(options.reading)),
      reduction(options.reduction) {
  if (folder.empty() || options.fingerprint.empty() || options.fingerprint.size() > kLongestKey / 2) return;
  if (std::int64_t(width) * height < options.sidecar_from_cells) return;
  const map::CellReading& reading = options.reading;
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%dx%d mode %d negate %d occupied %a free %a reduction %d ", width,
                height, int(reading.mode), int(reading.negate), reading.occupied_thresh, reading.free_thresh,
                int(options.reduction));
  content = text.data() + options.fingerprint;
}

std::string SidecarKey::path() const {
  std::array<char, 24> name;
  std::snprintf(name.data(), name.size(), "%016llx", static_cast<unsigned long long>(hashOf(content)));
  return (fs::path(folder) / (std::string(name.data()) + kSuffix)).string();
}

std::uint32_t SidecarKey::salt() const {
  const std::uint64_t hash = hashOf(content);
  return std::uint32_t(hash ^ hash >> 32);
}

std::shared_ptr<const GridPyramid> openSidecar(const SidecarKey& key, std::shared_ptr<TileCache> unpacked) {
  if (!key.wanted()) return nullptr;
  const std::string path = key.path();
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return nullptr;
  ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0);  // marks it as used: the folder is pruned by last use
  auto pyramid = restored(fd, key, std::move(unpacked));
  if (pyramid == nullptr) ::unlink(path.c_str());
  return pyramid;
}

SidecarDraft::SidecarDraft(const SidecarKey& key) : key_(key) {}

SidecarDraft::~SidecarDraft() {
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void SidecarDraft::begin(TileStore& store) {
  if (!key_.wanted()) return;
  std::error_code failed;
  fs::create_directories(key_.folder, failed);
  std::string name = key_.path() + kDraftMark + "XXXXXX";
  const int fd = ::mkostemp(name.data(), O_CLOEXEC);
  if (fd < 0) {
    trouble_ = notKept(key_.folder, fault::said(failed ? failed.message() : std::strerror(errno)));
    return;
  }
  aside_ = name;
  begun_ = true;
  store.spillTo(fd, kDataOffset, key_.salt());
}

bool SidecarDraft::writeEnds(const TileStore& store) const {
  const std::vector<std::uint64_t> index = store.index();
  const std::size_t index_bytes = index.size() * sizeof(std::uint64_t);
  Header header;
  header.width = key_.width;
  header.height = key_.height;
  header.code = std::uint32_t(key_.code);
  header.reduction = std::uint32_t(key_.reduction);
  header.data_bytes = store.dataBytes();
  header.key_bytes = key_.content.size();
  header.index_entries = index.size();
  header.tail_sum = sumOf(index.data(), index_bytes, sumOf(key_.content.data(), key_.content.size()));
  header.sum = headerSum(header);
  const std::int64_t tail = kDataOffset + std::int64_t(header.data_bytes);
  return writeAll(store.fd(), key_.content.data(), key_.content.size(), tail) &&
         writeAll(store.fd(), index.data(), index_bytes, tail + std::int64_t(key_.content.size())) &&
         writeAll(store.fd(), &header, sizeof(header), 0);
}

void SidecarDraft::keep(TileStore& store) {
  if (aside_.empty()) return;
  if (store.flush() && writeEnds(store) && ::rename(aside_.c_str(), key_.path().c_str()) == 0) {
    aside_.clear();
    pruneSidecars(key_.folder, kSidecarBudget);
  } else {
    trouble_ = notKept(key_.folder, faultText("grids", "the disk may be full"));
  }
}

void pruneSidecars(const std::string& folder, std::uint64_t most_bytes) {
  struct Kept {
    fs::file_time_type used;
    std::uint64_t bytes;
    fs::path path;
  };
  std::vector<Kept> kept;
  std::uint64_t total = 0;
  std::error_code failed;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    std::error_code unknown;
    const std::string name = at->path().filename().string();
    const auto used = fs::last_write_time(at->path(), unknown);
    if (unknown) continue;
    if (name.find(std::string(kSuffix) + kDraftMark) != std::string::npos) {
      if (now - used > kAbandonedAfter) fs::remove(at->path(), unknown);
    } else if (at->path().extension() == kSuffix) {
      const std::uint64_t bytes = fs::file_size(at->path(), unknown);
      if (unknown) continue;
      kept.push_back({used, bytes, at->path()});
      total += bytes;
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& file : kept) {
    if (total <= most_bytes) return;
    std::error_code unknown;
    if (fs::remove(file.path, unknown)) total -= file.bytes;
  }
}

}  // namespace mapwright::grids
