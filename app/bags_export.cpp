// A part of a bag for other programs: its messages, and where the robot was.
#include <cmath>
#include <cstdio>
#include <map>

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonObject>

#include "app/bag_json.h"
#include "app/bag_mcap.h"
#include "app/bag_reading.h"
#include "app/bags.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/recording_slice.h"
#include "app/robot_factory.h"
#include "app/waypoint_list.h"
#include "disk/written_file.h"
#include "reasons/file_reason.h"
#include "replay/track.h"
#include "robot/recorded/recorded_robot.h"
#include "sentences/reason_sentence.h"
#include "sentences/subject_name.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(Bags)
};

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

auto wrong(const QString& sentence) { return tl::make_unexpected(CommandFailure{kUsage, sentence}); }

CommandFailure notWritten(const disk::Fault& fault) {
  return {kUsage, sentences::wordsOf(reasons::notWritten(fault))};
}

/// What of a bag goes where, as it was asked for.
struct Order {
  TimeSpan span;
  QString path, format;
};

/// The format that was asked for, else as the name ends.
CommandResult<Order> orderFrom(const BagsWords& words, const QStringList& formats) {
  const auto span = timeSpanFrom(words);
  if (!span) return tl::make_unexpected(span.error());
  Order order{*span, text(words.output), text(words.format).toLower()};
  const QString known = formats.join(QStringLiteral(", "));
  if (order.format.isEmpty()) {
    order.format = QFileInfo(order.path).suffix().toLower();
    if (!formats.contains(order.format))
      return wrong(
          Words::tr("%1: its name does not end in one of %2. Say which by --format.").arg(order.path, known));
  } else if (!formats.contains(order.format)) {
    return wrong(Words::tr("--format %1: give one of %2.").arg(text(words.format), known));
  }
  if (const auto why = whyNotWritable(order.path)) return wrong(*why);
  if (QFileInfo(order.path).isFile() && !words.force)
    return wrong(Words::tr("%1 is there already. --force replaces it.").arg(order.path));
  return order;
}

int runExport(const BagsWords& words, int& argc, char** argv, const QStringList& formats,
              const std::function<CommandResult<int>(MapsCommand&, BagReading&, const Order&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report))
      .run(argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
        const auto order = orderFrom(words, formats);
        if (!order) return tl::make_unexpected(order.error());
        auto opened = BagReading::open(command, words);
        if (!opened) return tl::make_unexpected(opened.error());
        const bool lines = order->format == QLatin1String("jsonl");
        const auto replayed =
            opened->readThrough(words.name, lines ? BagReading::Texts::Whole : BagReading::Texts::Short);
        if (!replayed) return tl::make_unexpected(replayed.error());
        return work(command, *opened, *order);
      });
}

void noteOdd(BagReading& bags, std::int64_t odd) {
  if (odd > 0)
    bags.robot().lack(
        Words::tr("Messages that cannot be read, or have no stamp, were left out: %1.").arg(odd));
}

/// What was written, for scripts and for people.
void tell(const BagsWords& words, const Order& order, MapsCommand& command, QJsonObject done,
          const QString& sentence) {
  done[QStringLiteral("name")] = text(words.name);
  done[QStringLiteral("file")] = order.path;
  command.report(QStringLiteral("bag"), done);
  if (isStandardOutput(order.path)) return;
  if (words.json) {
    printJson(done);
  } else {
    std::printf("%s: %s\n", qUtf8Printable(oneLine(order.path)), qUtf8Printable(sentence));
  }
}

CommandResult<int> exportLines(const BagsWords& words, MapsCommand& command, BagReading& bags,
                               const Order& order) {
  disk::WrittenFile file(words.output);
  std::int64_t messages = 0, odd = 0;
  const auto failed = bags.readRanges(
      order.span.from_s, order.span.to_s, [&](const replay::Chunk& chunk) -> std::optional<CommandFailure> {
        odd += std::int64_t(chunk.source->without_stamp + chunk.source->unreadable);
        for (std::size_t place = 0; place < chunk.order.size(); ++place) {
          const robot::BagMessage& message = chunk.at(place);
          if (!order.span.holds(message.message.received_s)) continue;
          if (!words.topic.empty() && message.message.topic != words.topic) continue;
          file.write(jsonLine(chunk.source->textOf(message)));
          file.write("\n");
          ++messages;
        }
        if (!file.good()) return notWritten(*file.place());
        return std::nullopt;
      });
  if (failed) return tl::make_unexpected(*failed);
  if (const auto fault = file.place()) return tl::make_unexpected(notWritten(*fault));
  noteOdd(bags, odd);
  tell(words, order, command, {{QStringLiteral("messages"), qint64(messages)}},
       Words::tr("%1 messages").arg(messages));
  return kDone;
}

/// An export that was killed leaves what it had written; the next one writes over it.
class PartOfBefore {
 public:
  explicit PartOfBefore(const Order& order)
      : part_(order.path + QStringLiteral(".part")), was_there_(QFileInfo(part_).isFile()) {}
  void tell(BagReading& bags) const {
    if (was_there_)
      bags.robot().note(
          Words::tr("%1 was left by an export that did not end: it has been replaced.").arg(part_));
  }

 private:
  QString part_;
  bool was_there_;
};

/// The file that is meant, where it is a recording on this computer.
std::optional<std::string> recordingOf(const BagsWords& words) {
  const auto parsed = knownAddresses().parse(text(words.robot));
  if (!parsed || parsed->path.isEmpty() || !robot::recorded::isRecording(parsed->path)) return std::nullopt;
  return parsed->path.toStdString();
}

/// A part of a recording is what it is there, byte for byte.
CommandResult<int> exportSlice(const BagsWords& words, MapsCommand& command, BagReading& bags,
                               const std::string& path, const Order& order) {
  if (const auto why = overOwnSource({order.path}, {path})) return wrong(*why);
  const PartOfBefore before(order);
  const auto sliced = sliceRecording(path, words.output, order.span, words.topic);
  if (!sliced) return wrong(sentences::sentenceOf(sliced.error()));
  before.tell(bags);
  const map::Subject bag =
      subjectOf(robot::BagKey{robot::BagKind::File, robot::recorded::bagNameOf(text(path))});
  for (const map::Reason& loss : sliced->losses)
    bags.robot().lack(QStringLiteral("%1: %2").arg(sentences::nameOf(bag), sentences::wordsOf(loss)));
  tell(words, order, command,
       {{QStringLiteral("messages"), qint64(sliced->messages)},
        {QStringLiteral("said_before"), qint64(sliced->said_before)},
        {QStringLiteral("attachments"), qint64(sliced->attachments)}},
       Words::tr("%1 messages, %2 that had been said before").arg(sliced->messages).arg(sliced->said_before));
  return kDone;
}

CommandResult<int> exportMcap(const BagsWords& words, MapsCommand& command, BagReading& bags,
                              const Order& order) {
  if (isStandardOutput(order.path))
    return wrong(Words::tr("An MCAP file needs a file of its own (-o FILE)."));
  if (const auto recording = recordingOf(words)) return exportSlice(words, command, bags, *recording, order);
  const PartOfBefore before(order);
  auto begun =
      BagMcap::create(words.output, bags.robot().session().robot().address(), words.name, order.span);
  if (!begun) return tl::make_unexpected(notWritten(begun.error()));
  before.tell(bags);
  BagMcap& file = **begun;
  std::int64_t odd = 0;
  // What was said before is a part of what was so in that time: it is read as well.
  const auto failed = bags.readRanges(
      std::nullopt, order.span.to_s, [&](const replay::Chunk& chunk) -> std::optional<CommandFailure> {
        odd += std::int64_t(chunk.source->without_stamp + chunk.source->unreadable);
        for (std::size_t place = 0; place < chunk.order.size(); ++place) {
          const robot::BagMessage& message = chunk.at(place);
          if (!words.topic.empty() && message.message.topic != words.topic) continue;
          if (const auto fault = file.take(message, chunk.source->textOf(message))) return notWritten(*fault);
        }
        return std::nullopt;
      });
  if (failed) return tl::make_unexpected(*failed);
  if (const auto fault = file.finish()) return tl::make_unexpected(notWritten(*fault));
  noteOdd(bags, odd);
  tell(words, order, command,
       {{QStringLiteral("messages"), qint64(file.messages())},
        {QStringLiteral("said_before"), qint64(file.saidBefore())}},
       Words::tr("%1 messages, %2 that had been said before").arg(file.messages()).arg(file.saidBefore()));
  return kDone;
}

}  // namespace

int bagsExport(const BagsWords& words, int& argc, char** argv) {
  return runExport(words, argc, argv, {QStringLiteral("mcap"), QStringLiteral("jsonl")},
                   [&](MapsCommand& command, BagReading& bags, const Order& order) {
                     return order.format == QLatin1String("mcap") ? exportMcap(words, command, bags, order)
                                                                  : exportLines(words, command, bags, order);
                   });
}

int bagsTrack(const BagsWords& words, int& argc, char** argv) {
  return runExport(
      words, argc, argv, {QStringLiteral("csv"), QStringLiteral("geojson"), QStringLiteral("tum")},
      [&](MapsCommand& command, BagReading& bags, const Order& order) -> CommandResult<int> {
        replay::PrefixIndex index;
        std::int64_t odd = 0;
        const auto failed =
            bags.readRanges(order.span.from_s, order.span.to_s, [&](const replay::Chunk& chunk) {
              odd += std::int64_t(chunk.source->without_stamp + chunk.source->unreadable);
              index.add(replay::tickOf(chunk.from_s), replay::digestOf(chunk));
              return std::nullopt;
            });
        if (failed) return tl::make_unexpected(*failed);
        const std::vector<replay::TrackPoint> track =
            replay::within(replay::trackOf(index.digests()), order.span.from_s.value_or(-HUGE_VAL),
                           order.span.to_s.value_or(HUGE_VAL));
        const std::string written = order.format == QLatin1String("csv")   ? replay::csvOf(track)
                                    : order.format == QLatin1String("tum") ? replay::tumOf(track)
                                                                           : replay::geoJsonOf(track);
        disk::WrittenFile file(words.output);
        file.write(written);
        if (const auto fault = file.place()) return tl::make_unexpected(notWritten(*fault));
        noteOdd(bags, odd);
        const std::size_t pieces = track.empty() ? 0 : track.back().piece - track.front().piece + 1;
        tell(words, order, command,
             {{QStringLiteral("samples"), qint64(track.size())}, {QStringLiteral("pieces"), qint64(pieces)}},
             Words::tr("%1 samples in %2 pieces").arg(track.size()).arg(pieces));
        return kDone;
      });
}

}  // namespace mapwright::app
