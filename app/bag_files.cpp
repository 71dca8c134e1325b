// Files made of bags: parts of them and the robot's path for other programs; recordings repaired, split and
// merged.
#include <algorithm>
#include <cmath>
#include <limits>

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "disk/file_error.h"
#include "excerpt/excerpt.h"
#include "excerpt/recording_merge.h"
#include "excerpt/recording_slice.h"
#include "recording/source.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

tl::unexpected<CommandFailure> fileFailure(const disk::FileError& fault) {
  return wrong(sentences::wordsOf(disk::notWritten(fault)));
}

/// What to export, and where.
struct ExportOrder {
  QString path, format;
  excerpt::TimeSpan span = {};
};

/// The requested format, otherwise by the extension.
CommandResult<ExportOrder> orderFrom(const BagsArguments& args, const QStringList& formats) {
  ExportOrder order{text(args.output), text(args.format).toLower()};
  const QString known = words::listed(formats);
  if (order.format.isEmpty()) {
    order.format = QFileInfo(order.path).suffix().toLower();
    if (!formats.contains(order.format))
      return wrong(Text::tr("%1: the name must end in one of %2, or pass --format.").arg(order.path, known));
  } else if (!formats.contains(order.format)) {
    return wrong(Text::tr("--format %1: must be one of %2.").arg(text(args.format), known));
  }
  if (const auto why = notCreatedReason(order.path, args.force)) return wrong(*why);
  return order;
}

/// Reports what was written, for scripts and for people.
void reportExported(const BagsArguments& args, const ExportOrder& order, RobotCommand& command,
                    QJsonObject done, const QString& sentence) {
  done[QStringLiteral("name")] = text(args.name);
  done[QStringLiteral("file")] = order.path;
  command.report(QStringLiteral("bag"), done);
  if (isStandardOutput(order.path)) return;
  if (args.json) {
    printJson(done);
  } else {
    printLine(words::about(oneLine(order.path), sentence));
  }
}

/// The file, if it is a recording on this computer.
std::optional<std::string> recordingOf(const BagsArguments& args) {
  const auto parsed = knownAddresses().parse(text(args.robot));
  if (!parsed || parsed->path.isEmpty() || !isRecording(parsed->path)) return std::nullopt;
  return parsed->path.toStdString();
}

excerpt::Order excerptOf(const BagsArguments& args, const BagReading& bags, const ExportOrder& order) {
  excerpt::Order wanted;
  wanted.kind = order.format == QLatin1String("mcap")      ? excerpt::Kind::Mcap
                : order.format == QLatin1String("jsonl")   ? excerpt::Kind::Lines
                : order.format == QLatin1String("csv")     ? excerpt::Kind::TrackCsv
                : order.format == QLatin1String("geojson") ? excerpt::Kind::TrackGeoJson
                                                           : excerpt::Kind::TrackTum;
  wanted.path = args.output;
  wanted.existing = existingBy(args.force);
  wanted.span = order.span;
  wanted.topics = args.topics;
  const QString address = bags.robot().session().robot().address();
  wanted.address = address.toStdString();
  wanted.robot_kind = knownAddresses().kindOf(address);
  wanted.bag = args.name;
  return wanted;
}

/// A part of a recording is copied byte for byte.
CommandResult<int> exportSlice(const BagsArguments& args, RobotCommand& command, BagReading& bags,
                               const std::string& path, const ExportOrder& order) {
  const auto sliced = excerpt::sliceRecording(path, excerptOf(args, bags, order));
  if (!sliced) return wrong(sentences::sentenceOf(sliced.error()));
  const excerpt::Written& done = **sliced;  // nobody cancels it
  bags.reportNotFound(args.topics, order.span, done.messages, done.topics);
  const map::Subject bag{map::SubjectKind::Bag, args.name};
  for (const Fault& loss : done.losses)
    bags.robot().lack(words::about(sentences::nameOf(bag), sentences::wordsOf(loss)));
  reportExported(args, order, command,
                 {{QStringLiteral("messages"), qint64(done.messages)},
                  {QStringLiteral("said_before"), qint64(done.said_before)},
                  {QStringLiteral("attachments"), qint64(done.attachments)}},
                 Text::tr("%1 messages, %2 from before the range").arg(done.messages).arg(done.said_before));
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
              Text::tr("%1 messages, %2 from before the range").arg(done.messages).arg(done.said_before)};
    case excerpt::Kind::Lines:
      return {{{QStringLiteral("messages"), qint64(done.messages)}},
              Text::tr("%1 messages").arg(done.messages)};
    default:
      return {{{QStringLiteral("samples"), qint64(done.samples)},
               {QStringLiteral("pieces"), qint64(done.pieces)}},
              Text::tr("%1 samples in %2 segments").arg(done.samples).arg(done.pieces)};
  }
}

CommandResult<int> exportExcerpt(RobotCommand& command, const BagsArguments& args,
                                 const QStringList& formats) {
  auto order = orderFrom(args, formats);
  if (!order) return passOn(order);
  const auto recording = recordingOf(args);
  if (recording) {
    if (const auto why = notCreatedReason(order->path, true, {*recording})) return wrong(*why);
  }
  auto opened = BagReading::open(command);
  if (!opened) return passOn(opened);
  BagReading& bags = *opened;
  const bool lines = order->format == QLatin1String("jsonl");
  const auto replayed =
      bags.readThrough(args.name, lines ? BagReading::Texts::Whole : BagReading::Texts::Short);
  if (!replayed) return passOn(replayed);
  const auto span = timeSpanFrom(args, *(*replayed)->info());
  if (!span) return passOn(span);
  order->span = *span;
  const excerpt::Order wanted = excerptOf(args, bags, *order);
  const bool mcap = wanted.kind == excerpt::Kind::Mcap;
  if (mcap && isStandardOutput(order->path))
    return wrong(Text::tr("An MCAP file must be a regular file (-o FILE)."));
  if (mcap && recording) return exportSlice(args, command, bags, *recording, *order);
  const auto writing = excerpt::begin(wanted);
  if (!writing) return fileFailure(writing.error());
  const auto read = bags.readRanges(excerpt::readsFrom(wanted), order->span.to_s,
                                    [&](const replay::Chunk& chunk) -> CommandResult<void> {
                                      if (const auto fault = (*writing)->add(chunk))
                                        return fileFailure(*fault);
                                      return {};
                                    });
  if (!read) return passOn(read);
  const auto done = (*writing)->place();
  if (!done) return fileFailure(done.error());
  if (mcap || lines) {
    bags.reportNotFound(args.topics, order->span, done->messages, done->topics);
  } else if (done->samples == 0 && order->span.limited()) {
    bags.robot().lack(Text::tr("No position of the robot was found."));
  }
  bags.reportUnreadable(order->span.to_s.value_or(HUGE_VAL), excerpt::readsFrom(wanted));
  const Told told = toldOf(*done, wanted.kind);
  reportExported(args, *order, command, told.json, told.sentence);
  return kDone;
}

constexpr std::int64_t kMostParts = 10'000;

auto notOpened(const Fault& why) { return wrong(sentences::sentenceOf(why)); }

CommandResult<std::string> recordingFrom(const BagsArguments& args) {
  const auto parsed = knownAddresses().parse(text(args.robot));
  if (!parsed || parsed->path.isEmpty())
    return wrong(Text::tr("%1 is not a recording on this computer. Pass a file (.mcap, .bag, .db3).")
                     .arg(text(args.name)));
  return parsed->path.toStdString();
}

/// From the first to the last message of all of them; those that cannot be opened are told of later.
robot::BagInfo lastingFrom(const std::vector<std::string>& files) {
  robot::BagInfo all;
  for (const std::string& file : files) {
    const auto opened = recording::openRecording(file);
    const recording::Summary summary = opened ? (*opened)->summary() : recording::Summary();
    if (!summary.start_ns || !summary.end_ns) continue;
    const double start_s = double(*summary.start_ns) / 1e9, end_s = double(*summary.end_ns) / 1e9;
    all.start_s = all.end_s > 0 ? std::min(all.start_s, start_s) : start_s;
    all.end_s = std::max(all.end_s, end_s);
  }
  return all;
}

std::optional<QString> notIntoReason(const QString& path, const std::vector<std::string>& sources,
                                     bool force) {
  if (isStream(path)) return Text::tr("An MCAP file must be a regular file (-o FILE).");
  return notCreatedReason(path, force, sources);
}

void reportWritten(const BagsArguments& args, const QStringList& files, const excerpt::Written& done,
                   const QStringList& not_found = {}) {
  QStringList losses;
  for (const Fault& loss : done.losses) losses << sentences::sentenceOf(loss);
  losses += not_found;
  for (const QString& sentence : losses) say(sentence);
  if (args.json) {
    printJson(QJsonObject{{QStringLiteral("files"), QJsonArray::fromStringList(files)},
                          {QStringLiteral("messages"), qint64(done.messages)},
                          {QStringLiteral("attachments"), qint64(done.attachments)},
                          {QStringLiteral("losses"), QJsonArray::fromStringList(losses)}});
    return;
  }
  for (const QString& file : files) printLine(oneLine(file));
  printLine(Text::tr("messages: %1, files: %2").arg(done.messages).arg(done.attachments));
}

}  // namespace

CommandResult<int> bagsExport(RobotCommand& command, const BagsArguments& args) {
  return exportExcerpt(command, args, {QStringLiteral("mcap"), QStringLiteral("jsonl")});
}

CommandResult<int> bagsTrack(RobotCommand& command, const BagsArguments& args) {
  return exportExcerpt(command, args,
                       {QStringLiteral("csv"), QStringLiteral("geojson"), QStringLiteral("tum")});
}

CommandResult<int> bagsRepair(RobotCommand&, const BagsArguments& args) {
  const auto path = recordingFrom(args);
  if (!path) return passOn(path);
  if (const auto why = notIntoReason(text(args.output), {*path}, args.force)) return wrong(*why);
  excerpt::Order order;
  order.path = args.output;
  order.existing = existingBy(args.force);
  order.repair = true;
  const auto made = excerpt::sliceRecording(*path, order);
  if (!made) return notOpened(made.error());
  reportWritten(args, {text(args.output)}, **made);
  return int((*made)->damaged ? kIncomplete : kDone);
}

CommandResult<int> bagsSplit(RobotCommand&, const BagsArguments& args) {
  const auto path = recordingFrom(args);
  if (!path) return passOn(path);
  if (!(args.every_s > 0)) return wrong(Text::tr("--every must be greater than 0 seconds."));
  const QString pattern = text(args.output);
  if (numbered(pattern, 0).isEmpty())
    return wrong(
        Text::tr("-o %1: the parts need a number in their name, for example part-%03d.mcap.").arg(pattern));
  auto slicing = excerpt::Slicing::open(*path);
  if (!slicing) return notOpened(slicing.error());
  const recording::Summary summary = slicing->source().summary();
  if (!summary.start_ns) return wrong(Text::tr("It contains no messages."));
  const double every_ns = args.every_s * 1e9;
  // A clock that was set may leave fifty years between two messages; parts without any are left out.
  std::vector<std::int64_t> parts;
  const auto startOf = [&](std::int64_t part) {
    const double after_ns = std::round(double(part) * every_ns);
    constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
    return after_ns >= double(kNever - *summary.start_ns) ? kNever
                                                          : *summary.start_ns + std::int64_t(after_ns);
  };
  for (std::optional<std::int64_t> at_ns = summary.start_ns; at_ns;) {
    std::int64_t part = std::int64_t(std::floor(double(*at_ns - *summary.start_ns) / every_ns));
    if (startOf(part + 1) <= *at_ns) ++part;  // rounded
    if (startOf(part) > *at_ns) --part;
    parts.push_back(part);
    if (std::int64_t(parts.size()) > kMostParts)
      return wrong(Text::tr("That would be more than %1 parts. Choose a longer --every.").arg(kMostParts));
    recording::Query later;
    later.first_ns = startOf(part + 1);
    if (later.first_ns <= *at_ns) break;
    const auto next = slicing->source().messages(later)->next();
    at_ns = next ? std::optional(next->log_time_ns) : std::nullopt;
  }
  QStringList files;
  for (std::size_t number = 0; number < parts.size(); ++number) {
    files << numbered(pattern, int(number));
    if (const auto why = notIntoReason(files.back(), {*path}, args.force)) return wrong(*why);
  }
  excerpt::Written all;
  for (std::size_t number = 0; number < parts.size(); ++number) {
    excerpt::Order order;
    order.path = files[qsizetype(number)].toStdString();
    order.existing = existingBy(args.force);
    order.topics = args.topics;
    // The first and the last part include everything up to the ends, in spite of rounding.
    if (number > 0) order.first_ns = startOf(parts[number]);
    if (number + 1 < parts.size()) order.last_ns = startOf(parts[number] + 1) - 1;
    const auto made = slicing->slice(order);
    if (!made) return notOpened(made.error());
    all.messages += (*made)->messages;
    all.topics.insert((*made)->topics.begin(), (*made)->topics.end());
    all.attachments = std::max(all.attachments, (*made)->attachments);
    all.losses = (*made)->losses;  // they concern the whole
  }
  const QStringList not_found = notFound(args.topics, {}, all.messages, all.topics);
  reportWritten(args, files, all, not_found);
  return int(all.losses.empty() && not_found.isEmpty() ? kDone : kIncomplete);
}

CommandResult<int> bagsMerge(RobotCommand&, const BagsArguments& args) {
  if (const auto why = notIntoReason(text(args.output), args.files, args.force)) return wrong(*why);
  const auto span = timeSpanFrom(args, lastingFrom(args.files));
  if (!span) return passOn(span);
  excerpt::Order order;
  order.path = args.output;
  order.existing = existingBy(args.force);
  order.span = *span;
  order.topics = args.topics;
  const auto made = excerpt::mergeRecordings(args.files, order);
  if (!made) return notOpened(made.error());
  const QStringList not_found = notFound(args.topics, *span, made->messages, made->topics);
  reportWritten(args, {text(args.output)}, *made, not_found);
  return int(made->losses.empty() && not_found.isEmpty() ? kDone : kIncomplete);
}

}  // namespace mapwright::app
