// Several recordings as one: the parts of a recording make that recording again, and files that are strangers
// to each other keep all they hold.
#include <algorithm>
#include <ostream>
#include <random>
#include <tuple>

#include <QTemporaryDir>
#include <QtTest>

#include "../recording/recordings.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "excerpt/recording_merge.h"
#include "excerpt/recording_slice.h"
#include "recording/message.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/recording_reasons.h"
#include "test_program.h"

namespace test_recording_merge {

using namespace mapwright;

namespace {

/// All that tells messages apart but the number of their channel.
struct Told {
  std::string topic, said, bytes;
  std::int64_t log_ns = 0, publish_ns = 0;
  std::uint32_t sequence = 0;
  auto operator<=>(const Told&) const = default;
};

struct Beside {
  std::string name, bytes;
  std::int64_t log_ns = 0, create_ns = 0;
  auto operator<=>(const Beside&) const = default;
};

struct Content {
  std::vector<Told> messages;
  std::vector<Beside> files;
  std::vector<recording::Metadata> metadata;
};

Content contentOf(const std::string& path) {
  Content content;
  const auto source = recording::openRecording(path);
  if (!source) return content;
  const auto cursor = (*source)->messages({});
  while (const auto message = cursor->next()) {
    const auto said = message->channel->metadata.find("said");
    content.messages.push_back({message->channel->topic,
                                said == message->channel->metadata.end() ? "" : said->second,
                                std::string(message->bytes.begin(), message->bytes.end()),
                                message->log_time_ns, message->publish_time_ns, message->sequence});
  }
  for (const recording::AttachmentLocation& location : (*source)->attachments()) {
    const auto attachment = (*source)->attachment(location);
    if (attachment)
      content.files.push_back(
          {attachment->name, attachment->bytes, attachment->log_time_ns, attachment->create_time_ns});
  }
  content.metadata = (*source)->metadata();
  const auto byName = [](const recording::Metadata& a, const recording::Metadata& b) {
    return std::tie(a.name, a.values) < std::tie(b.name, b.values);
  };
  std::sort(content.files.begin(), content.files.end());
  std::sort(content.metadata.begin(), content.metadata.end(), byName);
  return content;
}

QByteArray wordsOf(const Told& told) {
  return QByteArray::fromStdString(told.topic + " " + told.said + " " + std::to_string(told.log_ns) + " " +
                                   std::to_string(told.publish_ns) + " " + told.bytes);
}

/// Empty: they are the same.
QByteArray difference(const Content& made, const Content& wanted) {
  for (std::size_t i = 0; i < std::max(made.messages.size(), wanted.messages.size()); ++i) {
    if (i >= made.messages.size()) return "lost: " + wordsOf(wanted.messages[i]);
    if (i >= wanted.messages.size()) return "too many: " + wordsOf(made.messages[i]);
    if (made.messages[i] != wanted.messages[i])
      return wordsOf(made.messages[i]) + " instead of " + wordsOf(wanted.messages[i]);
  }
  if (made.files != wanted.files)
    return "files: " + QByteArray::number(qsizetype(made.files.size())) + " instead of " +
           QByteArray::number(qsizetype(wanted.files.size()));
  if (made.metadata != wanted.metadata)
    return "metadata: " + QByteArray::number(qsizetype(made.metadata.size())) + " instead of " +
           QByteArray::number(qsizetype(wanted.metadata.size()));
  return {};
}

class Writing {
 public:
  explicit Writing(const std::string& path) {
    recording::WriterOptions options;
    options.chunk_bytes = 700;
    writer_ = std::move(*recording::McapWriter::create(
        std::move(*recording::appendFile(path, recording::Existing::Replace)), options));
  }
  ~Writing() { (void)writer_->close(); }
  void say(const std::string& topic, std::int64_t log_ns, std::int64_t publish_ns, const std::string& bytes,
           std::uint32_t sequence = 0, bool before = false) {
    recording::Channel channel = recordings::channelOf(topic);
    if (before) channel.metadata["said"] = "before";
    (void)writer_->write(*writer_->addChannel(channel), {log_ns, publish_ns, sequence},
                         recordings::bytesOf(bytes));
  }
  recording::McapWriter& writer() { return *writer_; }

 private:
  std::unique_ptr<recording::McapWriter> writer_;
};

constexpr std::int64_t kStart = 1'000'000'000, kLength = 1'000;

/// As sessions with robots are: said before, latched, patches, equal messages, files that change.
void makeRecording(const std::string& path, std::mt19937& random) {
  Writing file(path);
  const auto upTo = [&](int most) { return int(random() % unsigned(most)); };
  (void)file.writer().addMetadata({"mapwright", {{"version", "2"}, {"name", ""}}});
  (void)file.writer().addMetadata({"mapwright", {{"version", "2"}, {"name", "Robbie"}}});
  for (int i = upTo(3); i > 0; --i) (void)file.writer().addMetadata({"other", {{"a", "b"}}});
  const std::vector<std::string> topics{"/pose", "/tf_static", "/map", "/map_updates", "/alerts"};
  for (const std::string& topic : topics) {
    for (int i = upTo(3); i > 0; --i)
      file.say(topic, kStart, kStart - upTo(3) * 100, std::to_string(upTo(2)), 0, true);
  }
  std::int64_t at = kStart;
  const int messages = 20 + upTo(200);
  for (int i = 0; i < messages; ++i) {
    at = std::min(kStart + kLength, at + (upTo(3) == 0 ? 0 : upTo(12)));
    const std::string& topic = topics[std::size_t(upTo(3) ? 0 : upTo(int(topics.size())))];
    // The same thing is said again and again, now and then also at the same time.
    file.say(topic, at, upTo(2) ? at : at - upTo(20), std::to_string(upTo(4)), std::uint32_t(upTo(3)));
  }
  for (int i = upTo(8); i > 0; --i)
    (void)file.writer().attach({"maps/" + std::to_string(upTo(2)), "image/png", kStart + upTo(int(kLength)),
                                upTo(2) ? 0 : 7, "picture " + std::to_string(upTo(2))});
  (void)file.writer().addMetadata({"mapwright.end", {{"lost", "0"}}});
}

}  // namespace

class RecordingMergeTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;

  std::string path(const std::string& name) const {
    return folder_.filePath(QString::fromStdString(name)).toStdString();
  }
  bool slice(const std::string& from, const std::string& to, std::optional<std::int64_t> first_ns,
             std::optional<std::int64_t> last_ns) const {
    excerpt::Order order;
    order.path = path(to);
    order.first_ns = first_ns;
    order.last_ns = last_ns;
    return excerpt::sliceRecording(path(from), order).has_value();
  }
  std::optional<excerpt::Written> merge(const std::vector<std::string>& names) const {
    std::vector<std::string> paths;
    for (const std::string& name : names) paths.push_back(path(name));
    excerpt::Order order;
    order.path = path("merged.mcap");
    const auto done = excerpt::mergeRecordings(paths, order);
    return done ? std::optional(*done) : std::nullopt;
  }

 private Q_SLOTS:
  void thePartsOfARecordingMakeIt_data() {
    QTest::addColumn<bool>("overlapping");
    QTest::newRow("split") << false;
    QTest::newRow("overlapping exports") << true;
  }
  void thePartsOfARecordingMakeIt() {
    QFETCH(bool, overlapping);
    for (unsigned seed = 0; seed < 300; ++seed) {
      std::mt19937 random(seed);
      makeRecording(path("whole.mcap"), random);
      std::vector<std::int64_t> cuts;
      for (int i = int(random() % 4); i >= 0; --i)
        cuts.push_back(kStart + std::int64_t(random() % unsigned(kLength)));
      std::sort(cuts.begin(), cuts.end());
      std::vector<std::string> parts;
      for (std::size_t i = 0; i <= cuts.size(); ++i) {
        parts.push_back("part" + std::to_string(i));
        std::optional<std::int64_t> first, last;
        if (i > 0) first = cuts[i - 1];
        if (i < cuts.size()) last = overlapping ? cuts[i] + std::int64_t(random() % 50) : cuts[i] - 1;
        QVERIFY(slice("whole.mcap", parts.back(), first, last));
      }
      // Nobody has to know their order, unless they hold things of the same time.
      if (!overlapping) std::shuffle(parts.begin(), parts.end(), random);
      const auto done = merge(parts);
      QVERIFY(done.has_value());
      const Content made = contentOf(path("merged.mcap"));
      const QByteArray other = difference(made, contentOf(path("whole.mcap")));
      QVERIFY2(other.isEmpty(), (QByteArray::number(seed) + ": " + other).constData());
      QCOMPARE(done->messages, std::int64_t(made.messages.size()));
      QCOMPARE(done->attachments, std::int64_t(made.files.size()));
    }
  }

  void partsOfPartsMakeItToo() {
    std::mt19937 random(7);
    makeRecording(path("whole.mcap"), random);
    QVERIFY(slice("whole.mcap", "a", std::nullopt, kStart + 299));
    QVERIFY(slice("whole.mcap", "b", kStart + 300, std::nullopt));
    QVERIFY(slice("b", "b1", std::nullopt, kStart + 349));
    QVERIFY(slice("b", "b2", kStart + 350, std::nullopt));
    QVERIFY(merge({"a", "b1", "b2"}));
    QCOMPARE(difference(contentOf(path("merged.mcap")), contentOf(path("whole.mcap"))), QByteArray());
  }

  void strangersKeepAllTheyHold() {
    {
      Writing file(path("one"));
      (void)file.writer().addMetadata({"mapwright", {{"name", "one"}}});
      file.say("/map", kStart, kStart - 50, "old", 0, true);
      file.say("/pose", kStart + 10, kStart + 10, "1");
      file.say("/pose", kStart + 20, kStart + 20, "2");
      file.say("/pose", kStart + 20, kStart + 20, "2");  // truly twice
      file.say("/pose", kStart + 30, kStart + 30, "3");
      (void)file.writer().attach({"maps/0", "image/png", kStart, 0, "A"});
      (void)file.writer().attach({"maps/0", "image/png", kStart + 20, 0, "B"});
      (void)file.writer().attach({"maps/0", "image/png", kStart + 40, 0, "A"});
    }
    {
      Writing file(path("two"));
      (void)file.writer().addMetadata({"mapwright", {{"name", "two"}}});
      file.say("/map", kStart + 15, kStart - 10, "newer", 0, true);
      file.say("/pose", kStart + 15, kStart + 10, "1", 0, true);                 // the first file holds it
      file.say("/pose", kStart + 20, kStart + 20, "other", 0);                   // of the same time
      file.say("/pose", kStart + 25, kStart + 20, "2", 0);                       // came here at another time
      file.say("/pose", kStart + 30, kStart + 30, "3", 9);                       // the same message
      file.say("/scan", kStart + 30, kStart + 30, "3");                          // of another topic
      (void)file.writer().attach({"maps/0", "image/png", kStart + 50, 0, "A"});  // stands already
      (void)file.writer().attach({"maps/0", "image/png", kStart + 60, 0, "C"});
    }
    QVERIFY(merge({"one", "two"}));
    const Content made = contentOf(path("merged.mcap"));
    const std::vector<Told> wanted{{"/map", "before", "old", kStart, kStart - 50, 0},
                                   {"/pose", "", "1", kStart + 10, kStart + 10, 0},
                                   {"/map", "before", "newer", kStart + 15, kStart - 10, 0},
                                   {"/pose", "", "2", kStart + 20, kStart + 20, 0},
                                   {"/pose", "", "2", kStart + 20, kStart + 20, 0},
                                   {"/pose", "", "other", kStart + 20, kStart + 20, 0},
                                   {"/pose", "", "2", kStart + 25, kStart + 20, 0},
                                   {"/pose", "", "3", kStart + 30, kStart + 30, 0},
                                   {"/scan", "", "3", kStart + 30, kStart + 30, 0}};
    for (std::size_t i = 0; i < std::min(made.messages.size(), wanted.size()); ++i)
      QCOMPARE(wordsOf(made.messages[i]), wordsOf(wanted[i]));
    QCOMPARE(made.messages.size(), wanted.size());
    QCOMPARE(made.files.size(), std::size_t(4));  // A, B, A, C
    QCOMPARE(made.metadata.size(), std::size_t(2));
  }

  // Times are typed in seconds, and stamps are finer than seconds can be told apart.
  void aSpanHoldsTheMessagesThatItsSecondsHold() {
    std::mt19937_64 random(3);
    std::vector<std::int64_t> stamps;
    for (int i = 0; i < 3'000; ++i)
      stamps.push_back(1'717'405'200'000'000'000 + std::int64_t(random() % 4'000));
    std::sort(stamps.begin(), stamps.end());
    {
      Writing file(path("fine"));
      for (const std::int64_t at_ns : stamps) file.say("/pose", at_ns, at_ns, "1");
    }
    for (int i = 0; i < 50; ++i) {
      excerpt::Order order;
      order.path = path("span");
      order.span.from_s = recording::secondsOf(stamps[random() % stamps.size()]);
      order.span.to_s = recording::secondsOf(stamps[random() % stamps.size()]);
      if (*order.span.to_s < *order.span.from_s) std::swap(order.span.from_s, order.span.to_s);
      const auto held = std::count_if(stamps.begin(), stamps.end(), [&](std::int64_t at_ns) {
        return order.span.holds(recording::secondsOf(at_ns));
      });
      const auto sliced = excerpt::sliceRecording(path("fine"), order);
      QVERIFY(sliced && *sliced);
      QCOMPARE((*sliced)->messages, std::int64_t(held));
      QVERIFY((*sliced)->said_before <= 1);
      order.path = path("merged span");
      const auto merged = excerpt::mergeRecordings({path("fine")}, order);
      QVERIFY(merged.has_value());
      QCOMPARE(merged->messages, std::int64_t(held));
    }
  }

  /// A clock that was set beyond all times: such messages are in no part, and that is said.
  void messagesWithoutAUsableTimeAreMissed() {
    recordings::RawMcap raw;
    recordings::RawMcap::channel(raw.out, 1, "/a");
    recordings::RawMcap::message(raw.out, 1, 5, "sound");
    recordings::RawMcap::message(raw.out, 1, std::uint64_t(1) << 63, "none");
    raw.end();
    QVERIFY(!disk::writeFile(path("untimed"), *raw.bytes()));
    excerpt::Order order;
    order.path = path("timed");
    const auto sliced = excerpt::sliceRecording(path("untimed"), order);
    const auto merged = excerpt::mergeRecordings({path("untimed")}, order);
    QVERIFY(sliced && *sliced && merged);
    for (const excerpt::Written& written : {**sliced, *merged}) {
      QCOMPARE(written.messages, std::int64_t(1));
      QCOMPARE(written.losses.size(), std::size_t(1));
      QCOMPARE(written.losses[0].code, robot::recorded::fault::RecordingMessagesUntimed);
      QVERIFY(written.damaged);
    }
  }

  void aPartIsKeptBesideWhatIsThere_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("MCAP") << int(excerpt::Kind::Mcap);
    QTest::newRow("lines") << int(excerpt::Kind::Lines);
    QTest::newRow("track") << int(excerpt::Kind::TrackCsv);
  }
  void aPartIsKeptBesideWhatIsThere() {
    QFETCH(int, kind);
    QTemporaryDir folder;
    excerpt::Order order;
    order.kind = excerpt::Kind(kind);
    order.path = folder.filePath(QStringLiteral("part.out")).toStdString();
    order.existing = disk::Existing::Refuse;
    const auto writing = excerpt::begin(order);
    QVERIFY(writing && !disk::writeFile(order.path, "another's"));
    const auto written = (*writing)->place();
    QVERIFY(!written);
    QCOMPARE(written.error().cause.code, disk::fault::NameTaken);
    QCOMPARE(*disk::readFile(order.path, 100), std::string("another's"));
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("part-1.out"))));
  }

  void aRepairedRecordingIsWholeAndSaysWhenItBrokeOff() {
    {
      Writing file(path("killed"));
      (void)file.writer().addMetadata({"mapwright", {{"version", "2"}}});
      file.say("/pose", kStart, kStart, "1");
      file.say("/pose", kStart + 500, kStart + 500, "2");
    }
    excerpt::Order order;
    order.path = path("repaired");
    order.repair = true;
    QVERIFY(excerpt::sliceRecording(path("killed"), order).has_value());
    const auto repaired = recording::openRecording(path("repaired"));
    QVERIFY(repaired && !robot::recorded::isInterrupted(**repaired));
    const auto repair = robot::recorded::repairOf(**repaired);
    QVERIFY(repair && repair->broke_off_s);
    QCOMPARE(*repair->broke_off_s, 1.0000005);
    // A part alone is no repair, and put together with one that is interrupted it has no end.
    QVERIFY(slice("killed", "copy", std::nullopt, std::nullopt));
    const auto copy = recording::openRecording(path("copy"));
    QVERIFY(copy && robot::recorded::isInterrupted(**copy));
    QVERIFY(merge({"repaired", "copy"}));
    const auto merged = recording::openRecording(path("merged.mcap"));
    QVERIFY(merged && robot::recorded::isInterrupted(**merged) && !robot::recorded::repairOf(**merged));
    QCOMPARE((*merged)->summary().messages, std::uint64_t(2));
  }
};

}  // namespace test_recording_merge

MAPWRIGHT_TEST(test_recording_merge, RecordingMergeTest, Core)
#include "test_recording_merge.moc"
