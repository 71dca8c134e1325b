#include <cerrno>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <QtTest>

#include "recorder/fetches.h"
#include "recorder/layout.h"
#include "recorder/tape.h"
#include "recording/bytes.h"
#include "recording/source.h"
#include "test_program.h"

namespace test_recorder_parts {

using namespace mapwright;
using namespace mapwright::recorder;
using std::chrono::milliseconds;

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// A disk in memory that may be full.
class Disk final : public recording::AppendTarget {
 public:
  struct Storage {
    std::string bytes;
    std::size_t room = std::size_t(1) << 40;
  };
  explicit Disk(std::shared_ptr<Storage> storage) : storage_(std::move(storage)) {}
  std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    if (storage_->bytes.size() + bytes.size() > storage_->room) return disk::systemError("disk", ENOSPC);
    storage_->bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return std::nullopt;
  }
  std::optional<disk::FileError> settle() override { return std::nullopt; }

 private:
  std::shared_ptr<Storage> storage_;
};

Entry message(const std::string& topic, std::int64_t log_ns, const std::string& bytes = "{}") {
  Entry entry;
  entry.name = topic;
  entry.encoding = "json";
  entry.log_ns = entry.publish_ns = log_ns;
  entry.bytes = bytes;
  return entry;
}

Entry file(const std::string& name, const std::string& bytes, std::int64_t log_ns = 1) {
  Entry entry;
  entry.kind = Entry::Kind::File;
  entry.name = name;
  entry.encoding = "image/png";
  entry.log_ns = log_ns;
  entry.bytes = bytes;
  return entry;
}

/// Different everywhere, so that it cannot be packed.
std::string noise(std::size_t bytes, std::uint32_t seed) {
  std::string text(bytes, 0);
  for (char& c : text) c = char((seed = seed * 1664525 + 1013904223) >> 24);
  return text;
}

map::SubmapList listOf(const std::string& uuid, std::vector<std::int32_t> versions) {
  map::SubmapList list;
  list.uuid = uuid;
  for (std::size_t i = 0; i < versions.size(); ++i) {
    map::SubmapEntry entry;
    entry.id = {0, std::int32_t(i)};
    entry.version = versions[i];
    list.entries.push_back(entry);
  }
  return list;
}

using Outcome = map::SubmapAnswer::Outcome;

}  // namespace

class RecorderPartsTest : public QObject {
  Q_OBJECT
  std::shared_ptr<Disk::Storage> storage_;
  std::unique_ptr<Tape> tape_;

  std::unique_ptr<recording::Source> read() const {
    auto opened =
        recording::openRecording(recording::heldBytes(std::make_shared<const std::string>(storage_->bytes)));
    return opened ? std::move(*opened) : nullptr;
  }
  static std::vector<recording::Message> all(recording::Source& source) {
    std::vector<recording::Message> messages;
    const auto cursor = source.messages({});
    while (auto next = cursor->next()) messages.push_back(*next);
    return messages;
  }

 private Q_SLOTS:
  void init() {
    storage_ = std::make_shared<Disk::Storage>();
    recording::WriterOptions options;
    options.chunk_bytes = 10'000;
    auto writer = recording::McapWriter::create(std::make_unique<Disk>(storage_), options);
    QVERIFY(writer);
    tape_ = std::make_unique<Tape>(std::move(*writer));
  }

  void namesOfAttachmentsCanBeReadBackWhateverTheIdsAre() {
    for (const std::string& id : {std::string("12"), std::string(), std::string("-"), std::string("a/b %"),
                                  std::string("caf\xc3\xa9.json")}) {
      const map::SubmapKey submap{id, {3, -1}, 7};
      QVERIFY(submapFrom(submapName(submap)) == submap);
      for (const auto kind : {map::MapKind::Stored, map::MapKind::Mapping, map::MapKind::File}) {
        const map::MapKey key{kind, id};
        if (!id.ends_with(".json")) QVERIFY(mapFrom(mapName(key)) == key);
        QVERIFY(!mapFrom(mapFactsName(key)));
      }
    }
    QCOMPARE(submapName({"u-1", {0, 2}, 9}), std::string("submaps/u-1/0/2/9"));
    QCOMPARE(mapName({map::MapKind::Stored, "12"}), std::string("maps/stored/12"));
    QCOMPARE(waypointsName({map::MapKind::Stored, "a/b"}), std::string("waypoints/stored/a%2Fb.json"));
    for (const char* wrong : {"submaps/u/0/2", "submaps/u/0/x/9", "submaps/u/0/2/9/1", "maps/odd/1",
                              "maps/stored/", "pictures/submaps/u/0/2/9"}) {
      QVERIFY2(!submapFrom(wrong) && !mapFrom(wrong), wrong);
    }
  }

  void whatFindsNoRoomIsLostCountedAndLeavesAGapInTheNumbers() {
    EntryQueue queue(2'000);
    QVERIFY(queue.put(message("/a", 1), std::string(600, 'x')));
    QVERIFY(queue.put(message("/a", 2), std::string(600, 'x')));
    QVERIFY(!queue.put(message("/a", 3), std::string(600, 'x')));
    QVERIFY(queue.put(message("/b", 3), "x"));
    std::vector<Entry> taken = queue.take(milliseconds(0));
    QCOMPARE(taken.size(), std::size_t(3));
    QVERIFY(queue.put(message("/a", 4), "x"));
    taken = queue.take(milliseconds(0));
    QCOMPARE(taken.front().sequence, 4U);
    QCOMPARE(queue.lost().entries, std::uint64_t(1));
    QCOMPARE(queue.lost().bytes, std::uint64_t(600));
  }

  void oneThatIsLargerThanAllRoomIsTakenAlone() {
    EntryQueue queue(1'000);
    QVERIFY(queue.put(message("/map", 1), std::string(100'000, 'x')));
    QVERIFY(!queue.put(message("/map", 2), "x"));
    QCOMPARE(queue.take(milliseconds(0)).size(), std::size_t(1));
    QVERIFY(queue.put(message("/map", 3), "x"));
  }

  void aQueueGivesAllThatWasPutBeforeItWasClosedAndTakesNothingAfterwards() {
    EntryQueue queue(std::size_t(1) << 30);
    std::vector<std::thread> putting;
    for (int thread = 0; thread < 4; ++thread) {
      putting.emplace_back([&queue, thread] {
        for (int i = 0; i < 500; ++i) queue.put(message("/" + std::to_string(thread), i), "{}");
      });
    }
    std::size_t count = 0;
    std::map<std::string, std::uint32_t> last;
    const auto take = [&] {
      for (const Entry& entry : queue.take(milliseconds(20))) {
        ++count;
        QCOMPARE(entry.sequence, ++last[entry.name]);
      }
    };
    while (count < 1'000) take();
    for (std::thread& thread : putting) thread.join();
    queue.close();
    QVERIFY(!queue.put(message("/late", 1), "{}"));
    while (!queue.over()) take();
    QCOMPARE(count, std::size_t(2'000));
  }

  void channelsTellWhatWasSaidBefore() {
    Entry before = message("/map", 100, "old");
    before.before = true;
    tape_->write(before);
    tape_->write(message("/map", 200, "new"));
    QVERIFY(!tape_->finish(300, {}));
    const auto source = read();
    const auto messages = all(*source);
    QCOMPARE(messages.size(), std::size_t(2));
    QCOMPARE(messages[0].channel->metadata.at(kSaid), std::string(kBefore));
    QVERIFY(messages[1].channel->metadata.empty());
    QCOMPARE(messages[0].channel->topic, messages[1].channel->topic);
  }

  void theEndTellsWhatWasLost() {
    tape_->write(message("/a", 1));
    EntryQueue::Losses lost;
    lost.entries = 3;
    lost.bytes = 99;
    QVERIFY(!tape_->finish(5 * kSecond, lost));
    const auto source = read();
    QVERIFY(source->summary().finished);
    QCOMPARE(source->metadata().back().name, std::string(kEnd));
    QCOMPARE(source->metadata().back().values.at("lost"), std::string("3"));
    QCOMPARE(source->metadata().back().values.at("messages"), std::string("1"));
  }

  void aFileIsKeptOnceAndAgainWhenItIsAnotherOne() {
    tape_->write(file("maps/stored/1", "one"));
    tape_->write(file("maps/stored/1", "one"));
    tape_->write(file("maps/stored/1", "two", 2));
    tape_->write(file("maps/stored/2", "one"));
    QVERIFY(!tape_->finish(3, {}));
    const auto source = read();
    QCOMPARE(source->attachments().size(), std::size_t(3));
    QCOMPARE(tape_->written().files, std::uint64_t(3));
    QCOMPARE(source->attachment(source->attachments()[1])->bytes, std::string("two"));
  }

  void aFullDiskIsToldAndRecordingGoesOnOnceThereIsRoom() {
    std::int64_t now = kSecond;
    const auto say = [&](int count) {
      for (int i = 0; i < count; ++i) {
        tape_->write(message("/noise", now, noise(4'000, std::uint32_t(now + i))));
        now += kSecond / 10;
      }
      tape_->tick(now);
    };
    say(20);
    QVERIFY(!tape_->written().fault);
    const std::uint64_t sound = tape_->written().messages;
    storage_->room = storage_->bytes.size();
    say(50);
    tape_->write(file("maps/stored/1", "waits"));
    const Written full = tape_->written();
    QVERIFY(full.fault);
    QVERIFY(full.lost > 0);
    QVERIFY2(full.lost + full.messages == 70, "each message is in the file or counted as lost");
    QVERIFY(full.messages >= sound);
    storage_->room = std::size_t(1) << 40;
    now += 2 * kSecond;
    say(20);
    QVERIFY(!tape_->written().fault);
    QVERIFY(!tape_->finish(now, {}));
    const Written done = tape_->written();
    QCOMPARE(done.lost, full.lost);
    const auto source = read();
    QCOMPARE(all(*source).size(), std::size_t(90 - done.lost));
    QCOMPARE(source->attachments().size(), std::size_t(1));
    QVERIFY(source->summary().notes.empty());
  }

  void aDiskThatStaysFullLeavesASoundFileWithoutAnEnd() {
    std::int64_t now = kSecond;
    for (int i = 0; i < 20; ++i, now += kSecond)
      tape_->write(message("/a", now, noise(4'000, std::uint32_t(i))));
    tape_->tick(now);
    storage_->room = storage_->bytes.size();
    tape_->write(message("/a", now, noise(4'000, 77)));
    QVERIFY(tape_->finish(now + kSecond, {}));
    QCOMPARE(tape_->written().messages, std::uint64_t(20));
    QCOMPARE(tape_->written().lost, std::uint64_t(1));
    tape_.reset();
    const auto source = read();
    QVERIFY(source);
    QVERIFY(!source->summary().finished);
    QCOMPARE(all(*source).size(), std::size_t(20));
  }

  // What a program that is killed leaves.
  void whatIsOnTheDiskAtAnyMomentHoldsAllButTheOpenChunk() {
    std::int64_t now = kSecond;
    std::size_t said = 0;
    for (int i = 0; i < 60; ++i, now += kSecond / 5) {
      tape_->write(message("/a", now, noise(1'000, std::uint32_t(i))));
      tape_->tick(now);
      ++said;
      const auto source = read();
      QVERIFY(source);
      // Within a second, or ten thousand bytes: five messages here, and the one that closes the chunk.
      QVERIFY2(all(*source).size() + 6 >= said, qPrintable(QString::number(i)));
    }
  }

  void everyListedSubmapIsAskedForAFewAtOnce() {
    SubmapRequests wishes(SubmapRequests::Which::Listed);
    wishes.onList(listOf("u", {1, 1, 1, 1, 1, 1}), 0);
    auto asked = wishes.next();
    QCOMPARE(asked.size(), SubmapRequests::kAtOnce);
    QVERIFY(wishes.next().empty());
    wishes.answered(asked[0], Outcome::Ok, 1);
    QCOMPARE(wishes.next().size(), std::size_t(1));
    QCOMPARE(wishes.missing(), std::size_t(5));
    wishes.onList(listOf("u", {1, 1, 1, 1, 1, 1}), 2);
    QVERIFY(wishes.next().empty());
  }

  void listedOnesAreAskedForAgainAfterAWhileAndAllOnesAtOnce() {
    for (const bool every : {false, true}) {
      SubmapRequests wishes(every ? SubmapRequests::Which::All : SubmapRequests::Which::Listed);
      wishes.onList(listOf("u", {1}), 0);
      wishes.answered(wishes.next().front(), Outcome::Ok, 0);
      wishes.onList(listOf("u", {2}), kSecond);
      QCOMPARE(wishes.next().size(), std::size_t(every ? 1 : 0));
      wishes.look(SubmapRequests::kAgainNs);
      QCOMPARE(wishes.next().size(), std::size_t(every ? 0 : 1));
    }
  }

  void oneThatFailsIsTriedAgainAFewTimesAndAnotherSessionBeginsAnew() {
    SubmapRequests wishes(SubmapRequests::Which::Listed);
    std::int64_t now = 0;
    wishes.onList(listOf("u", {1}), now);
    int tries = 0;
    for (int i = 0; i < 20; ++i) {
      for (const auto& key : wishes.next()) {
        ++tries;
        wishes.answered(key, Outcome::Failed, now);
      }
      QVERIFY(wishes.next().empty());  // not at once
      now += SubmapRequests::kRetryNs;
      wishes.look(now);
    }
    QCOMPARE(tries, SubmapRequests::kTries);
    wishes.onList(listOf("v", {1, 1}), now);
    const auto keys = wishes.next();
    QCOMPARE(keys.size(), std::size_t(2));
    QCOMPARE(keys.front().uuid, std::string("v"));
    wishes.answered({"u", {0, 0}, 1}, Outcome::Ok, now);  // late
    QCOMPARE(wishes.missing(), std::size_t(2));
  }

  void noneIsNone() {
    SubmapRequests wishes(SubmapRequests::Which::None);
    wishes.onList(listOf("u", {1, 2}), 0);
    QVERIFY(wishes.next().empty());
  }
};

}  // namespace test_recorder_parts

MAPWRIGHT_TEST(test_recorder_parts, RecorderPartsTest, Core)
#include "test_recorder_parts.moc"
