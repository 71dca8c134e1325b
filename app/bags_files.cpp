// Turns recordings on this computer into other files: repair, split, merge.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_reading.h"
#include "app/bags.h"
#include "app/bags_film.h"
#include "app/exit_code.h"
#include "app/maps_command.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "app/waypoint_list.h"
#include "excerpt/recording_merge.h"
#include "excerpt/recording_slice.h"
#include "recording/source.h"
#include "robot/recorded/faults.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/recorded/recording_reasons.h"
#include "sentences/fault_sentence.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class BagsFilesText {
  Q_DECLARE_TR_FUNCTIONS(Bags)
};

constexpr std::int64_t kMostParts = 10'000;

using words::text;

auto notOpened(const Fault& why) { return wrong(sentences::sentenceOf(why)); }

CommandResult<std::string> recordingFrom(const BagsWords& words) {
  const auto parsed = knownAddresses().parse(text(words.robot));
  if (!parsed || parsed->path.isEmpty())
    return wrong(BagsFilesText::tr("%1 is not a recording on this computer. Pass a file (.mcap, .bag).")
                     .arg(text(words.name)));
  return parsed->path.toStdString();
}

std::optional<CommandFailure> whyNotInto(const QString& path, const std::vector<std::string>& sources,
                                         bool force) {
  if (isStandardOutput(path))
    return CommandFailure{kUsage, BagsFilesText::tr("An MCAP file must be a regular file (-o FILE).")};
  if (const auto why = whyNotWritable(path)) return CommandFailure{kUsage, *why};
  if (const auto why = overOwnSource({path}, sources)) return CommandFailure{kUsage, *why};
  if (QFileInfo::exists(path) && !force)
    return CommandFailure{kUsage,
                          BagsFilesText::tr("%1 already exists. Pass --force to replace it.").arg(path)};
  return std::nullopt;
}

/// Its end is missing, and maybe the data being written at that time.
bool isOfItsEnd(const Fault& loss) {
  return loss.code == robot::recorded::fault::RecordingNotFinished ||
         loss.code == robot::recorded::fault::RecordingNotBegun ||
         loss.code == robot::recorded::fault::RecordingCutOff;
}

void tell(const BagsWords& words, const QStringList& files, const excerpt::Written& done) {
  QJsonArray losses;
  for (const Fault& loss : done.losses) {
    const QString sentence = sentences::sentenceOf(loss);
    losses.append(sentence);
    std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(sentence)));
  }
  if (words.json) {
    printJson(QJsonObject{{QStringLiteral("files"), QJsonArray::fromStringList(files)},
                          {QStringLiteral("messages"), qint64(done.messages)},
                          {QStringLiteral("attachments"), qint64(done.attachments)},
                          {QStringLiteral("losses"), losses}});
    return;
  }
  for (const QString& file : files) std::printf("%s\n", qUtf8Printable(oneLine(file)));
  std::printf(
      "%s\n",
      qUtf8Printable(BagsFilesText::tr("messages: %1, files: %2").arg(done.messages).arg(done.attachments)));
}

int run(const BagsWords& words, int& argc, char** argv,
        const std::function<CommandResult<int>(MapsCommand&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

}  // namespace

int bagsRepair(const BagsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand&) -> CommandResult<int> {
    const auto path = recordingFrom(words);
    if (!path) return tl::make_unexpected(path.error());
    if (const auto why = whyNotInto(text(words.output), {*path}, words.force))
      return tl::make_unexpected(*why);
    excerpt::Order order;
    order.path = words.output;
    order.repair = true;
    const auto made = excerpt::sliceRecording(*path, order);
    if (!made) return notOpened(made.error());
    tell(words, {text(words.output)}, **made);
    const bool all = std::all_of((*made)->losses.begin(), (*made)->losses.end(), isOfItsEnd);
    return int(all ? kDone : kIncomplete);
  });
}

int bagsSplit(const BagsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand&) -> CommandResult<int> {
    const auto path = recordingFrom(words);
    if (!path) return tl::make_unexpected(path.error());
    if (!(words.every_s > 0)) return wrong(BagsFilesText::tr("--every must be greater than 0 seconds."));
    const QString pattern = text(words.output);
    if (numbered(pattern, 0).isEmpty())
      return wrong(
          BagsFilesText::tr("-o %1: the parts need a number in their name, for example part-%03d.mcap.")
              .arg(pattern));
    const auto opened = recording::openRecording(*path);
    if (!opened) return notOpened(robot::recorded::reasonOf(opened.error()));
    const recording::Summary summary = (*opened)->summary();
    if (!summary.start_ns) return wrong(BagsFilesText::tr("It contains no messages."));
    const double every_ns = words.every_s * 1e9;
    const double parts = std::floor(double(summary.durationNs()) / every_ns) + 1;
    if (parts > double(kMostParts))
      return wrong(
          BagsFilesText::tr("That would be more than %1 parts. Choose a longer --every.").arg(kMostParts));
    excerpt::Written all;
    QStringList files;
    for (std::int64_t part = 0; part < std::int64_t(parts); ++part) {
      excerpt::Order order;
      const QString file = numbered(pattern, int(part));
      if (const auto why = whyNotInto(file, {*path}, words.force)) return tl::make_unexpected(*why);
      order.path = file.toStdString();
      order.topics = words.topics;
      // The first and the last part include everything up to the ends, in spite of rounding.
      if (part > 0) order.first_ns = *summary.start_ns + std::llround(double(part) * every_ns);
      if (part + 1 < std::int64_t(parts))
        order.last_ns = *summary.start_ns + std::llround(double(part + 1) * every_ns) - 1;
      const auto made = excerpt::sliceRecording(*path, order);
      if (!made) return notOpened(made.error());
      all.messages += (*made)->messages;
      all.attachments = std::max(all.attachments, (*made)->attachments);
      all.losses = (*made)->losses;  // they concern the whole
      files << file;
    }
    tell(words, files, all);
    return int(all.losses.empty() ? kDone : kIncomplete);
  });
}

int bagsMerge(const BagsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand&) -> CommandResult<int> {
    if (const auto why = whyNotInto(text(words.output), words.files, words.force))
      return tl::make_unexpected(*why);
    const auto span = timeSpanFrom(words);
    if (!span) return tl::make_unexpected(span.error());
    excerpt::Order order;
    order.path = words.output;
    order.span = *span;
    order.topics = words.topics;
    const auto made = excerpt::mergeRecordings(words.files, order);
    if (!made) return notOpened(made.error());
    tell(words, {text(words.output)}, *made);
    return int(made->losses.empty() ? kDone : kIncomplete);
  });
}

}  // namespace mapwright::app
