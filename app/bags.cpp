// Bags as files: list, download, delete, record.
#include "app/bags.h"

#include <cstdio>
#include <unistd.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_json.h"
#include "app/bag_reading.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/table.h"
#include "app/waypoint_list.h"
#include "robot/axbot/faults.h"
#include "ui/kit/status_text.h"
#include "words/file_name.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class BagsText {
  Q_DECLARE_TR_FUNCTIONS(Bags)
};

using words::text;

int runBags(const BagsWords& words, int& argc, char** argv,
            const std::function<CommandResult<int>(MapsCommand&, BagReading&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report))
      .run(argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
        auto opened = BagReading::open(command, words);
        if (!opened) return tl::make_unexpected(opened.error());
        return work(command, *opened);
      });
}

QStringList rowOf(const robot::BagEntry& entry) {
  const QString size =
      entry.size_bytes ? window::bytesText(*entry.size_bytes) : words::plainName(entry.size_text);
  const QString end = entry.end_s ? timeText(*entry.end_s).chopped(4) : words::plainName(entry.end_text);
  return {entry.key.kind == robot::BagKind::Recording ? BagsText::tr("recording") : BagsText::tr("bag"),
          size.isEmpty() ? QStringLiteral("-") : size, end.isEmpty() ? QStringLiteral("-") : end,
          words::plainName(entry.key.name)};
}

/// The default file name of a download. The bag's name comes from the robot, and must not lead to another
/// folder.
QString fileFor(const BagsWords& words) {
  if (!words.output.empty()) return text(words.output);
  return words::fileName(QFileInfo(text(words.name)).fileName(), {});
}

void tellProgress(robot::Progress progress) {
  const QString bytes = window::bytesText(progress.bytes);
  const QString of = progress.of_bytes ? window::bytesText(*progress.of_bytes) : QStringLiteral("?");
  std::fprintf(stderr, "\r%-40s", qUtf8Printable(BagsText::tr("%1 of %2").arg(bytes, of)));
}

}  // namespace

int bagsList(const BagsWords& words, int& argc, char** argv) {
  return runBags(words, argc, argv, [&](MapsCommand&, BagReading& bags) -> CommandResult<int> {
    const auto rows = bags.robot().ask<std::vector<robot::BagEntry>>(
        [&](robot::OutcomeTo<std::vector<robot::BagEntry>> reply) {
          return bags.library().list(std::move(reply));
        });
    if (!rows) return tl::make_unexpected(bags.failure(rows.error()));
    bags.robot().insistOnAll();  // one of the two lists is incomplete
    if (words.json) {
      QJsonArray all;
      for (const robot::BagEntry& entry : *rows) all.append(bagJson(entry));
      printJson(all);
      return kDone;
    }
    if (rows->empty()) {
      std::printf("%s\n", qUtf8Printable(BagsText::tr("There are no bags.")));
      return kDone;
    }
    std::vector<QStringList> table{
        {BagsText::tr("KIND"), BagsText::tr("SIZE"), BagsText::tr("END (UTC)"), BagsText::tr("NAME")}};
    for (const robot::BagEntry& entry : *rows) table.push_back(rowOf(entry));
    printTable(table);
    return kDone;
  });
}

int bagsInfo(const BagsWords& words, int& argc, char** argv) {
  return runBags(words, argc, argv, [&](MapsCommand&, BagReading& bags) -> CommandResult<int> {
    const robot::BagKey key = bags.keyOf(words.name);
    const auto info = bags.robot().ask<robot::BagInfo>(
        [&](robot::OutcomeTo<robot::BagInfo> reply) { return bags.library().info(key, std::move(reply)); });
    if (!info) return tl::make_unexpected(bags.failure(info.error()));
    if (words.json) {
      printJson(infoJson(words.name, *info));
      return kDone;
    }
    printTable(infoRows(words.name, *info));
    if (const auto topics = topicRows(*info); !topics.empty()) {
      std::printf("\n");
      printTable(topics);
    }
    return kDone;
  });
}

int bagsDownload(const BagsWords& words, int& argc, char** argv) {
  return runBags(words, argc, argv, [&](MapsCommand&, BagReading& bags) -> CommandResult<int> {
    const QString path = fileFor(words);
    if (path.isEmpty()) return wrong(BagsText::tr("Where should it be saved? Pass -o FILE."));
    if (isStandardOutput(path))
      return wrong(BagsText::tr("A download can be resumed, so it must go to a regular file (-o FILE)."));
    if (const auto why = whyNotWritable(path)) return wrong(*why);
    if (QFileInfo::exists(path) && !words.force)
      return wrong(BagsText::tr("%1 already exists. Pass --force to replace it.").arg(path));
    const robot::BagKey key = bags.keyOf(words.name);
    const bool terminal = isatty(STDERR_FILENO) != 0;
    const auto done = bags.robot().ask<robot::BagDownload>([&](robot::OutcomeTo<robot::BagDownload> reply) {
      robot::Call call = bags.library().download(key, path, std::move(reply));
      if (terminal) call.onProgress(tellProgress);
      return call;
    });
    if (terminal) std::fprintf(stderr, "\r%-40s\r", "");
    if (!done) {
      CommandFailure failure = bags.failure(done.error());
      if (done.error().cause.code == robot::axbot::fault::BagFileNotWritten) failure.exit_code = kUsage;
      return tl::make_unexpected(failure);
    }
    if (words.json) {
      printJson(QJsonObject{{QStringLiteral("name"), text(words.name)},
                            {QStringLiteral("file"), done->path},
                            {QStringLiteral("bytes"), qint64(done->bytes)},
                            {QStringLiteral("resumed"), done->resumed}});
    } else {
      std::printf("%s: %s\n", qUtf8Printable(oneLine(done->path)),
                  qUtf8Printable(window::bytesText(done->bytes)));
    }
    return kDone;
  });
}

int bagsDelete(const BagsWords& words, int& argc, char** argv) {
  return runBags(words, argc, argv, [&](MapsCommand&, BagReading& bags) -> CommandResult<int> {
    if (!words.yes)
      return wrong(BagsText::tr("Deleting a bag cannot be undone. Pass --yes to delete %1.")
                       .arg(words::plainName(words.name)));
    const robot::BagKey key = bags.keyOf(words.name);
    const auto done = bags.robot().ask<robot::BagKey>(
        [&](robot::OutcomeTo<robot::BagKey> reply) { return bags.library().remove(key, std::move(reply)); });
    if (!done) return tl::make_unexpected(bags.failure(done.error()));
    if (words.json) printJson(QJsonObject{{QStringLiteral("name"), text(words.name)}});
    return kDone;
  });
}

int bagsRecord(const BagsWords& words, int& argc, char** argv) {
  return runBags(words, argc, argv, [&](MapsCommand&, BagReading& bags) -> CommandResult<int> {
    const robot::BagOrder order{words.suffix, words.duration, words.category};
    const auto entry = bags.robot().ask<robot::BagEntry>([&](robot::OutcomeTo<robot::BagEntry> reply) {
      return bags.library().record(order, std::move(reply));
    });
    if (!entry) return tl::make_unexpected(bags.failure(entry.error()));
    if (words.json) {
      printJson(bagJson(*entry));
    } else if (!entry->key.name.empty()) {
      std::printf("%s\n", qUtf8Printable(words::plainName(entry->key.name)));
    }
    return kDone;
  });
}

}  // namespace mapwright::app
