// Exports a part of a bag for other programs: its messages, and the robot's path.
#include <cmath>
#include <cstdio>

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonObject>

#include "app/bag_reading.h"
#include "app/bags.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "app/waypoint_list.h"
#include "disk/file_error.h"
#include "excerpt/excerpt.h"
#include "excerpt/recording_slice.h"
#include "robot/recorded/recorded_robot.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class BagsExportText {
  Q_DECLARE_TR_FUNCTIONS(Bags)
};

using words::text;

CommandFailure exportFailed(const disk::FileError& fault) {
  return {kUsage, sentences::wordsOf(disk::notWritten(fault))};
}

/// What to export, and where.
struct ExportOrder {
  excerpt::TimeSpan span;
  QString path, format;
};

/// The requested format, otherwise by the extension.
CommandResult<ExportOrder> orderFrom(const BagsWords& words, const QStringList& formats) {
  const auto span = timeSpanFrom(words);
  if (!span) return tl::make_unexpected(span.error());
  ExportOrder order{*span, text(words.output), text(words.format).toLower()};
  const QString known = formats.join(QStringLiteral(", "));
  if (order.format.isEmpty()) {
    order.format = QFileInfo(order.path).suffix().toLower();
    if (!formats.contains(order.format))
      return wrong(
          BagsExportText::tr("%1: the name must end in one of %2, or pass --format.").arg(order.path, known));
  } else if (!formats.contains(order.format)) {
    return wrong(BagsExportText::tr("--format %1: must be one of %2.").arg(text(words.format), known));
  }
  if (const auto why = whyNotWritable(order.path)) return wrong(*why);
  if (QFileInfo(order.path).isFile() && !words.force)
    return wrong(BagsExportText::tr("%1 already exists. Pass --force to replace it.").arg(order.path));
  return order;
}

int runExport(const BagsWords& words, int& argc, char** argv, const QStringList& formats,
              const std::function<CommandResult<int>(const BagsWords&, MapsCommand&, BagReading&,
                                                     const ExportOrder&)>& work) {
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
        return work(words, command, *opened, *order);
      });
}

/// Reports what was written, for scripts and for people.
void tell(const BagsWords& words, const ExportOrder& order, MapsCommand& command, QJsonObject done,
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

/// The file, if it is a recording on this computer.
std::optional<std::string> recordingOf(const BagsWords& words) {
  const auto parsed = knownAddresses().parse(text(words.robot));
  if (!parsed || parsed->path.isEmpty() || !robot::recorded::isRecording(parsed->path)) return std::nullopt;
  return parsed->path.toStdString();
}

excerpt::Order excerptOf(const BagsWords& words, const BagReading& bags, const ExportOrder& order) {
  excerpt::Order wanted;
  wanted.kind = order.format == QLatin1String("mcap")      ? excerpt::Kind::Mcap
                : order.format == QLatin1String("jsonl")   ? excerpt::Kind::Lines
                : order.format == QLatin1String("csv")     ? excerpt::Kind::TrackCsv
                : order.format == QLatin1String("geojson") ? excerpt::Kind::TrackGeoJson
                                                           : excerpt::Kind::TrackTum;
  wanted.path = words.output;
  wanted.span = order.span;
  wanted.topics = words.topics;
  wanted.address = bags.robot().session().robot().address().toStdString();
  wanted.bag = words.name;
  return wanted;
}

/// A part of a recording is copied byte for byte.
CommandResult<int> exportSlice(const BagsWords& words, MapsCommand& command, BagReading& bags,
                               const std::string& path, const ExportOrder& order) {
  if (const auto why = overOwnSource({order.path}, {path})) return wrong(*why);
  const auto sliced = excerpt::sliceRecording(path, excerptOf(words, bags, order));
  if (!sliced) return wrong(sentences::sentenceOf(sliced.error()));
  const excerpt::Written& done = **sliced;  // nobody cancels it
  bags.noteUnknown(words.topics);
  const map::Subject bag =
      subjectOf(robot::BagKey{robot::BagKind::File, robot::recorded::bagNameOf(text(path))});
  for (const Fault& loss : done.losses)
    bags.robot().lack(QStringLiteral("%1: %2").arg(sentences::nameOf(bag), sentences::wordsOf(loss)));
  tell(words, order, command,
       {{QStringLiteral("messages"), qint64(done.messages)},
        {QStringLiteral("said_before"), qint64(done.said_before)},
        {QStringLiteral("attachments"), qint64(done.attachments)}},
       BagsExportText::tr("%1 messages, %2 from before the range").arg(done.messages).arg(done.said_before));
  return kDone;
}

/// What was written, as figures and as text.
struct Told {
  QJsonObject json;
  QString sentence;
};
Told toldOf(const excerpt::Written& done, excerpt::Kind kind) {
  switch (kind) {
    case excerpt::Kind::Mcap:
      return {{{QStringLiteral("messages"), qint64(done.messages)},
               {QStringLiteral("said_before"), qint64(done.said_before)}},
              BagsExportText::tr("%1 messages, %2 from before the range")
                  .arg(done.messages)
                  .arg(done.said_before)};
    case excerpt::Kind::Lines:
      return {{{QStringLiteral("messages"), qint64(done.messages)}},
              BagsExportText::tr("%1 messages").arg(done.messages)};
    default:
      return {{{QStringLiteral("samples"), qint64(done.samples)},
               {QStringLiteral("pieces"), qint64(done.pieces)}},
              BagsExportText::tr("%1 samples in %2 segments").arg(done.samples).arg(done.pieces)};
  }
}

CommandResult<int> exportExcerpt(const BagsWords& words, MapsCommand& command, BagReading& bags,
                                 const ExportOrder& order) {
  const excerpt::Order wanted = excerptOf(words, bags, order);
  const bool mcap = wanted.kind == excerpt::Kind::Mcap;
  if (mcap && isStandardOutput(order.path))
    return wrong(BagsExportText::tr("An MCAP file must be a regular file (-o FILE)."));
  if (const auto recording = mcap ? recordingOf(words) : std::nullopt)
    return exportSlice(words, command, bags, *recording, order);
  const auto writing = excerpt::begin(wanted);
  if (!writing) return tl::make_unexpected(exportFailed(writing.error()));
  const auto failed = bags.readRanges(excerpt::readsFrom(wanted), order.span.to_s,
                                      [&](const replay::Chunk& chunk) -> std::optional<CommandFailure> {
                                        if (const auto fault = (*writing)->take(chunk))
                                          return exportFailed(*fault);
                                        return std::nullopt;
                                      });
  if (failed) return tl::make_unexpected(*failed);
  const auto done = (*writing)->place();
  if (!done) return tl::make_unexpected(exportFailed(done.error()));
  bags.noteUnknown(words.topics);
  bags.noteUnreadable(HUGE_VAL);
  const Told told = toldOf(*done, wanted.kind);
  tell(words, order, command, told.json, told.sentence);
  return kDone;
}

}  // namespace

int bagsExport(const BagsWords& words, int& argc, char** argv) {
  return runExport(words, argc, argv, {QStringLiteral("mcap"), QStringLiteral("jsonl")}, exportExcerpt);
}

int bagsTrack(const BagsWords& words, int& argc, char** argv) {
  return runExport(words, argc, argv,
                   {QStringLiteral("csv"), QStringLiteral("geojson"), QStringLiteral("tum")}, exportExcerpt);
}

}  // namespace mapwright::app
