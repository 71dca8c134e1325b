// Recordings: what it costs to write one, how soon a large one is open, how soon the state at a time is
// known. The baselines write the same bytes to the same disk as they are, and make the same CBOR with Qt.
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

#include <QEventLoop>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>

#include "recording/mcap_writer.h"
#include "recording/ros_cbor.h"
#include "recording/source.h"
#include "robot/recorded/recorded_robot.h"
#include "robots_words.h"

namespace {

using namespace mapwright::recording;
using mapwright::bench::folderOnDisk;
using mapwright::bench::robotsWords;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Channel channelOf(const std::string& topic) {
  Channel channel;
  channel.topic = topic;
  channel.message_encoding = "json";
  return channel;
}

/// `compression` < 0: the bytes as they are, by write().
void writeRecording(benchmark::State& state, int compression) {
  constexpr std::size_t kBytes = std::size_t(64) << 20;
  const std::vector<std::string>& words = robotsWords();
  std::uint64_t stored = 0;
  for (auto _ : state) {
    QTemporaryDir folder(folderOnDisk());
    const std::string path = folder.filePath(QStringLiteral("a.mcap")).toStdString();
    std::size_t written = 0;
    if (compression < 0) {
      const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
      for (std::size_t i = 0; written < kBytes; ++i) {
        const std::string& word = words[i % words.size()];
        if (::write(fd, word.data(), word.size()) != ssize_t(word.size()))
          state.SkipWithError("the disk is full");
        written += word.size();
      }
      ::fdatasync(fd);
      ::close(fd);
      stored = written;
      continue;
    }
    WriterOptions options;
    options.compression =
        compression == 0 ? WriterOptions::Compression::None : WriterOptions::Compression::Zstd;
    auto target = appendFile(path, Existing::Refuse);
    auto writer = McapWriter::create(std::move(*target), options);
    const ChannelId scan = *(*writer)->addChannel(channelOf("/scan")),
                    pose = *(*writer)->addChannel(channelOf("/pose"));
    for (std::uint32_t i = 0; written < kBytes; ++i) {
      const std::string& word = words[i % words.size()];
      const std::int64_t now = std::int64_t(i) * 10'000'000;
      if ((*writer)->write(i % 6 == 0 ? scan : pose, {now, now, i}, bytesOf(word)))
        state.SkipWithError("not written");
      written += word.size();
    }
    if ((*writer)->close()) state.SkipWithError("not closed");
    stored = (*writer)->progress().bytes;
  }
  state.SetBytesProcessed(state.iterations() * std::int64_t(kBytes));
  state.counters["stored_share"] = double(stored) / double(kBytes);
  // Seconds of CPU for a second of recording at 10 MB/s: CPU time / bytes * 10e6.
  state.counters["cpu_at_10MB_s"] = benchmark::Counter(
      double(kBytes) / 10e6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void RecordingWriteZstd(benchmark::State& state) { writeRecording(state, 1); }
void RecordingWriteStored(benchmark::State& state) { writeRecording(state, 0); }
void RecordingWriteBareBytes(benchmark::State& state) { writeRecording(state, -1); }

/// Leaves holes where zeros would be.
class SparseFile final : public AppendTarget {
 public:
  explicit SparseFile(const std::string& path)
      : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
  ~SparseFile() override { ::close(fd_); }
  std::optional<mapwright::disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    constexpr std::size_t kBlock = 65'536;
    static const std::vector<std::uint8_t> zeros(kBlock);
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
      const auto block = bytes.subspan(at, std::min(kBlock, bytes.size() - at));
      if (std::memcmp(block.data(), zeros.data(), block.size()) == 0 && at + block.size() < bytes.size())
        continue;
      if (::pwrite(fd_, block.data(), block.size(), off_t(size_ + at)) < 0) {
        return mapwright::disk::systemError("sparse", errno);
      }
    }
    size_ += bytes.size();
    return std::nullopt;
  }
  std::optional<mapwright::disk::FileError> settle() override { return std::nullopt; }

 private:
  int fd_;
  std::uint64_t size_ = 0;
};

/// 4 GiB in chunks of a MiB, 20 topics, 400,000 small messages; most of its bytes are one picture of zeros a
/// chunk.
const std::string& largeRecording() {
  static QTemporaryDir folder(folderOnDisk());
  static const std::string path = [] {
    const std::string made = folder.filePath(QStringLiteral("large.mcap")).toStdString();
    WriterOptions options;
    options.compression = WriterOptions::Compression::None;
    auto writer = McapWriter::create(std::make_unique<SparseFile>(made), options);
    std::vector<ChannelId> ids;
    for (int i = 0; i < 20; ++i)
      ids.push_back(*(*writer)->addChannel(channelOf("/topic" + std::to_string(i))));
    const ChannelId picture = *(*writer)->addChannel(channelOf("/picture"));
    const std::string zeros((std::size_t(1) << 20) - 20'000, '\0');
    std::mt19937 random(3);
    std::int64_t now = 0;
    for (int chunk = 0; chunk < 4096; ++chunk) {
      for (std::uint32_t i = 0; i < 100; ++i) {
        const std::size_t of = random() % 19;  // the 20th is heard of once
        (*writer)->write(ids[of], {now += 10'000'000, 0, i}, bytesOf(std::string(100, char('a' + of))));
      }
      if (chunk == 5) (*writer)->write(ids[19], {now, 0, 0}, bytesOf("once"));
      (*writer)->write(picture, {now, 0, 0}, bytesOf(zeros));
    }
    (*writer)->close();
    return made;
  }();
  return path;
}

void RecordingOpen4GiB(benchmark::State& state) {
  const std::string& path = largeRecording();
  for (auto _ : state) {
    const Opened opened = openRecording(path);
    if (!opened || !(*opened)->summary().notes.empty() || (*opened)->summary().chunks < 4096) {
      state.SkipWithError("not open");
      return;
    }
    state.counters["file_bytes"] = double((*opened)->summary().bytes);
  }
}

/// The last message of each of 20 topics before a random time.
void RecordingSeek4GiB(benchmark::State& state) {
  const Opened opened = openRecording(largeRecording());
  std::vector<std::string> topics;
  for (int i = 0; i < 20; ++i) topics.push_back("/topic" + std::to_string(i));
  std::mt19937_64 random(5);
  const Summary summary = (*opened)->summary();
  for (auto _ : state) {
    const std::int64_t at = std::int64_t(random() % std::uint64_t(*summary.end_ns));
    benchmark::DoNotOptimize((*opened)->lastBefore(at, topics).size());
  }
}

/// As a robot: until its bag has said its times, and a range in its middle is here.
void RecordingPlay4GiB(benchmark::State& state) {
  namespace recorded = mapwright::robot::recorded;
  const QString path = QString::fromStdString(largeRecording());
  for (auto _ : state) {
    recorded::RecordedOptions options;
    options.path = path;
    recorded::RecordedRobot robot(QStringLiteral("file:") + path, options);
    const mapwright::robot::BagKey key{mapwright::robot::BagKind::File, recorded::bagNameOf(path)};
    QEventLoop loop;
    std::size_t messages = 0;
    robot.bagLibrary()->info(key, [&](const mapwright::robot::Outcome<mapwright::robot::BagInfo>& info) {
      const double middle_s = info ? (info->start_s + info->end_s) / 2 : 0;
      robot.bagLibrary()->messages(
          key, {middle_s, middle_s + 8},
          [&](const mapwright::robot::Outcome<mapwright::robot::BagChunkPtr>& chunk) {
            if (chunk) messages = (*chunk)->messages.size();
            loop.quit();
          });
    });
    loop.exec();
    if (messages == 0) state.SkipWithError("nothing was read");
  }
}

void RecordingReadZstd(benchmark::State& state) {
  QTemporaryDir folder(folderOnDisk());
  const std::string path = folder.filePath(QStringLiteral("a.mcap")).toStdString();
  const std::vector<std::string>& words = robotsWords();
  auto writer = McapWriter::create(std::move(*appendFile(path, Existing::Refuse)), {});
  const ChannelId id = *(*writer)->addChannel(channelOf("/a"));
  std::int64_t bytes = 0;
  for (std::uint32_t i = 0; bytes < (64 << 20); ++i) {
    (*writer)->write(id, {std::int64_t(i) * 1'000'000, 0, i}, bytesOf(words[i % words.size()]));
    bytes += std::int64_t(words[i % words.size()].size());
  }
  (*writer)->close();
  for (auto _ : state) {
    const Opened opened = openRecording(path);
    const auto cursor = (*opened)->messages({});
    std::size_t read = 0;
    while (const auto message = cursor->next()) read += message->bytes.size();
    if (std::int64_t(read) != bytes) state.SkipWithError("not all was read");
  }
  state.SetBytesProcessed(state.iterations() * bytes);
}

constexpr std::uint32_t kPoses = 10'000;

void RecordingRosToCbor(benchmark::State& state) {
  const auto schema = parseRosSchema(
      "a/Path", "Pose[] poses\n================\nMSG: a/Pose\nfloat64 x\nfloat64 y\nfloat64 yaw",
      RosDialect::Ros1);
  std::string bytes(reinterpret_cast<const char*>(&kPoses), 4);
  for (std::uint32_t i = 0; i < kPoses * 3; ++i) {
    const double value = i * 0.1;
    bytes.append(reinterpret_cast<const char*>(&value), 8);
  }
  for (auto _ : state) benchmark::DoNotOptimize(rosToCbor(*schema, RosWire::Ros1, bytesOf(bytes))->size());
  state.SetItemsProcessed(state.iterations() * kPoses);
}

BENCHMARK(RecordingWriteZstd)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingWriteStored)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingWriteBareBytes)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingReadZstd)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingOpen4GiB)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingPlay4GiB)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingSeek4GiB)->Unit(benchmark::kMillisecond);
BENCHMARK(RecordingRosToCbor)->Unit(benchmark::kMicrosecond);

}  // namespace
