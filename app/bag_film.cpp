// `mapwright bags snapshot|film`: a bag as a picture, as a series of them, or as a video made with ffmpeg.
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>

#include <CLI/CLI.hpp>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/display.h"
#include "app/output.h"
#include "app/snapshot.h"
#include "app/suite_drawing.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

constexpr std::size_t kMostPictures = 100'000;
constexpr double kFastestFps = 240;

using words::text;

/// The options as typed; those of a single picture are in `picture`, whose bag, at and output are not used.
struct FilmArguments {
  SnapshotArguments picture;
  std::string name, from, to;
  double every_s = 1, fps = 10;
};

bool isFilm(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("mp4") || suffix == QLatin1String("mkv") || suffix == QLatin1String("webm");
}

/// Where the pictures go, and how to make a video of them.
struct Place {
  QString pattern, film, ffmpeg;
  QTemporaryDir folder;  // for the frames of a video
};

tl::expected<std::unique_ptr<Place>, QString> placeFor(const FilmArguments& args) {
  auto place = std::make_unique<Place>();
  const QString output = text(args.picture.output);
  if (isStream(output))
    return tl::make_unexpected(
        Text::tr("-o %1: a film must be a file (.mp4, .mkv or .webm), and its pictures "
                 "are several files, for example frames/%05d.png.")
            .arg(output));
  if (!isFilm(output)) {
    place->pattern = output;
    if (numbered(output, 0).isEmpty() || !output.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
      return tl::make_unexpected(Text::tr("-o %1: number the pictures, for example frames/%05d.png, or "
                                          "name a video: .mp4, .mkv or .webm.")
                                     .arg(output));
    return place;
  }
  place->film = output;
  place->ffmpeg = QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
  if (place->ffmpeg.isEmpty())
    return tl::make_unexpected(
        Text::tr("Making a video needs ffmpeg, which is not installed. Pictures work without it: -o "
                 "frames/%05d.png."));
  if (const auto why = notWritableReason(output)) return tl::make_unexpected(*why);
  if (!place->folder.isValid())
    return tl::make_unexpected(Text::tr("There is not enough disk space for the frames of the video: %1")
                                   .arg(place->folder.errorString()));
  place->pattern = place->folder.filePath(QStringLiteral("%06d.png"));
  return place;
}

/// nullopt = the video is in place; otherwise a sentence.
std::optional<QString> makeFilm(const Place& place, double fps) {
  const QFileInfo film(place.film);
  const QString aside = QStringLiteral("%1.part.%2").arg(place.film, film.suffix());
  QProcess ffmpeg;
  ffmpeg.setProgram(place.ffmpeg);
  // Most players only support even sizes and this pixel format.
  ffmpeg.setArguments({QStringLiteral("-hide_banner"), QStringLiteral("-loglevel"), QStringLiteral("error"),
                       QStringLiteral("-nostdin"), QStringLiteral("-y"), QStringLiteral("-framerate"),
                       QString::number(fps), QStringLiteral("-i"), place.pattern, QStringLiteral("-vf"),
                       QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"), QStringLiteral("-pix_fmt"),
                       QStringLiteral("yuv420p"), QFileInfo(aside).absoluteFilePath()});
  ffmpeg.start();
  ffmpeg.waitForFinished(-1);
  if (ffmpeg.exitStatus() != QProcess::NormalExit || ffmpeg.exitCode() != 0) {
    QFile::remove(aside);
    const QString said = QString::fromUtf8(ffmpeg.readAllStandardError()).trimmed();
    return Text::tr("%1: ffmpeg failed. %2").arg(place.film, said);
  }
  if (std::rename(aside.toLocal8Bit().constData(), place.film.toLocal8Bit().constData()) != 0) {
    const QString why = qt_error_string(errno);
    QFile::remove(aside);
    return Text::tr("%1 cannot be written: %2").arg(place.film, why);
  }
  return std::nullopt;
}

/// From `from_s` to `to_s` in steps of `every_s`.
std::vector<double> filmTimes(double from_s, double to_s, double every_s) {
  std::vector<double> times;
  for (std::size_t i = 0; times.size() < kMostPictures; ++i) {
    // Computed, not accumulated: even the hundred thousandth is exact to half a microsecond.
    const double at_s = from_s + double(i) * every_s;
    if (at_s > to_s + 5e-7) break;
    times.push_back(std::min(at_s, to_s));
  }
  return times;
}

CommandResult<std::vector<double>> timesFrom(const FilmArguments& args) {
  const QString robot = text(args.picture.robot);
  const auto from_s = timeIn(args.picture, robot, args.name, args.from, QStringLiteral("--from"));
  if (!from_s) return passOn(from_s);
  const auto to_s = timeIn(args.picture, robot, args.name, args.to, QStringLiteral("--to"));
  if (!to_s) return passOn(to_s);
  if (*to_s < *from_s) return wrong(Text::tr("--to is earlier than --from."));
  if ((*to_s - *from_s) / args.every_s >= double(kMostPictures))
    return wrong(
        Text::tr("That would be more than %1 pictures. Choose a longer --every.").arg(kMostPictures));
  return filmTimes(*from_s, *to_s, args.every_s);
}

/// Every picture is what `snapshot --bag NAME --at T` draws, all in the same view as the last one.
int bagsFilm(const FilmArguments& args, int& argc, char** argv) {
  if (!(args.every_s > 0)) return refuse(kUsage, Text::tr("--every must be greater than 0 seconds."));
  if (!(args.fps > 0 && args.fps <= kFastestFps))
    return refuse(kUsage, Text::tr("--fps must be greater than 0 and at most %1.").arg(kFastestFps));
  const auto place = placeFor(args);
  if (!place) return refuse(kUsage, place.error());
  SnapshotArguments picture = args.picture;
  picture.bag = args.name;
  picture.at = args.from;
  picture.output = numbered((*place)->pattern, 0).toStdString();
  picture.report.clear();
  picture.json = false;
  auto options = parseSnapshotOptions(picture);
  if (!options) return refuse(kUsage, options.error());
  OffscreenApplication application(argc, argv);
  const auto access = RobotAccess::read(args.picture.access, options->robot);
  if (!access) return refuse(kUsage, access.error());
  const auto times = timesFrom(args);
  if (!times) return refuse(times.error().exit_code, times.error().sentence);

  // The last picture comes first: it shows everything, and its view is used for all of them.
  std::vector<std::size_t> order(times->size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::rotate(order.begin(), std::prev(order.end()), order.end());
  ProgressLine progress;
  int incomplete = 0, done = 0;
  QString first_trouble;
  for (const std::size_t number : order) {
    options->at_s = (*times)[number];
    options->output = numbered((*place)->pattern, int(number));
    int code = kDone;
    QString trouble;
    drawViews({*options}, *access, 1, [&](std::size_t, const DrawnView& drawn) {
      code = drawn.exit_code;
      trouble = drawn.run && drawn.run->error().isEmpty() ? drawn.run->warnings().value(0) : drawn.sentence;
      if (!drawn.run || options->center_m) return;
      options->center_m = drawn.run->view().center_m;
      options->scale_m_per_px = drawn.run->view().scale_m_per_px;
    });
    if (code != kDone && code != kIncomplete) {
      progress.clear();
      return refuse(code, trouble);
    }
    if (code == kIncomplete && incomplete++ == 0) first_trouble = trouble;
    ++done;
    progress.tell(Text::tr("%1 of %2 pictures").arg(done).arg(order.size()));
  }
  progress.clear();
  if (!(*place)->film.isEmpty()) {
    if (const auto why = makeFilm(**place, args.fps)) return refuse(kUsage, *why);
  }
  const QString output = text(args.picture.output);
  if (args.picture.json) {
    const QJsonObject report{{QStringLiteral("file"), output},
                             {QStringLiteral("pictures"), done},
                             {QStringLiteral("incomplete"), incomplete}};
    std::printf("%s", QJsonDocument(report).toJson().constData());
  } else {
    printLine(oneLine(Text::tr("%1: %2 pictures").arg(output, QString::number(done))));
  }
  if (incomplete == 0) return kDone;
  return refuse(
      kIncomplete,
      Text::tr("%1 of %2 pictures are incomplete. %3").arg(incomplete).arg(done).arg(first_trouble));
}

}  // namespace

void addBagPictures(Commands& commands, CLI::App& bags) {
  const auto args = std::make_shared<SnapshotArguments>();
  CLI::App* const one =
      bags.add_subcommand("snapshot", help(Text::tr("Draw the state of a bag at a given time to a PNG")));
  one->add_option("name", args->bag,
                  help(Text::tr("Name of the bag (see mapwright bags list), or a file; FILE?ns=/NAMESPACE is "
                                "one robot of several")))
      ->required();
  addTime(*one, "--at", args->at, Needed::Yes);
  addSnapshotOptions(one, *args);
  commands.add(one, [args](const Invocation& before) { return snapshotOf(*args, before); });

  const auto film = std::make_shared<FilmArguments>();
  CLI::App* const many =
      bags.add_subcommand("film", help(Text::tr("Draw a bag at regular times, to PNG files or a video")));
  many->add_option("name", film->name,
                   help(Text::tr("Name of the bag (see mapwright bags list), or a file; FILE?ns=/NAMESPACE "
                                 "is one robot of several")))
      ->required();
  addTime(*many, "--from", film->from, Needed::Yes);
  addTime(*many, "--to", film->to, Needed::Yes);
  many->add_option("--every", film->every_s, help(Text::tr("Seconds of the recording between two pictures")))
      ->capture_default_str();
  many->add_option("--fps", film->fps, help(Text::tr("Frames per second of the video")))
      ->capture_default_str();
  addSnapshotOptions(many, film->picture);
  many->get_option("--output")
      ->description(
          help(Text::tr("The pictures, numbered: frames/%05d.png; or a video: .mp4, .mkv or .webm")));
  many->remove_option(many->get_option("--report"));
  commands.add(many, [film](const Invocation& before) {
    onRecording(film->picture.robot, film->name, before.robot);
    inherit(film->picture, before);
    return bagsFilm(*film, before.argc, before.argv);
  });
}

}  // namespace mapwright::app
