#include "app/bags_film.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/bag_reading.h"
#include "app/display.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/robot_access.h"
#include "app/robot_factory.h"
#include "app/say.h"
#include "app/snapshot_run.h"
#include "replay/replay_robot.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class FilmText {
  Q_DECLARE_TR_FUNCTIONS(Film)
};

constexpr std::size_t kMostPictures = 100'000;
constexpr double kFastestFps = 240;

using words::text;

bool isFilm(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("mp4") || suffix == QLatin1String("mkv") || suffix == QLatin1String("webm");
}

/// Where the pictures go, and how to make a video of them.
struct Place {
  QString pattern, film, ffmpeg;
  QTemporaryDir folder;  // for the frames of a video
};

tl::expected<std::unique_ptr<Place>, QString> placeFor(const FilmWords& words) {
  auto place = std::make_unique<Place>();
  const QString output = text(words.picture.output);
  if (!isFilm(output)) {
    place->pattern = output;
    if (numbered(output, 0).isEmpty() || !output.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
      return tl::make_unexpected(FilmText::tr("-o %1: number the pictures, for example frames/%05d.png, or "
                                              "name a video: .mp4, .mkv or .webm.")
                                     .arg(output));
    return place;
  }
  place->film = output;
  place->ffmpeg = QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
  if (place->ffmpeg.isEmpty())
    return tl::make_unexpected(
        FilmText::tr("Making a video needs ffmpeg, which is not installed. Pictures work without it: -o "
                     "frames/%05d.png."));
  if (const auto why = whyNotWritable(output)) return tl::make_unexpected(*why);
  if (!place->folder.isValid())
    return tl::make_unexpected(FilmText::tr("There is not enough disk space for the frames of the video: %1")
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
    return FilmText::tr("%1: ffmpeg failed. %2").arg(place.film, said);
  }
  if (std::rename(aside.toLocal8Bit().constData(), place.film.toLocal8Bit().constData()) != 0) {
    const QString why = qt_error_string(errno);
    QFile::remove(aside);
    return FilmText::tr("%1 cannot be written: %2").arg(place.film, why);
  }
  return std::nullopt;
}

struct Shot {
  int code = kDone;
  QString sentence;
  QJsonObject report;
};

Shot shoot(const SnapshotOptions& options, const Access& access, geometry::ViewTransform* view) {
  auto robot = makeRobot(options.robot, access, DemoTime::Frozen);
  if (!robot) return {kUsage, robot.error(), {}};
  SnapshotRun run(options, std::make_unique<replay::ReplayRobot>(std::move(*robot), options.bag),
                  {std::chrono::steady_clock::now(), {}});
  Shot shot;
  QEventLoop loop;
  QObject::connect(
      &run, &SnapshotRun::finished, &loop,
      [&](int code) {
        shot.code = code;
        loop.quit();
      },
      Qt::QueuedConnection);
  run.start();
  loop.exec();
  const QStringList warnings = run.warnings();
  shot.sentence = !run.error().isEmpty() ? run.error() : warnings.isEmpty() ? QString() : warnings.front();
  shot.report = run.report();
  if (view) *view = run.view();
  return shot;
}

tl::expected<std::vector<double>, QString> timesFrom(const FilmWords& words) {
  const auto from_s = timeFrom(words.from, QStringLiteral("--from"));
  if (!from_s) return tl::make_unexpected(from_s.error().sentence);
  const auto to_s = timeFrom(words.to, QStringLiteral("--to"));
  if (!to_s) return tl::make_unexpected(to_s.error().sentence);
  if (*to_s < *from_s) return tl::make_unexpected(FilmText::tr("--to is earlier than --from."));
  if (!(words.every_s > 0))
    return tl::make_unexpected(FilmText::tr("--every must be greater than 0 seconds."));
  if (!(words.fps > 0 && words.fps <= kFastestFps))
    return tl::make_unexpected(FilmText::tr("--fps must be greater than 0 and at most %1.").arg(kFastestFps));
  if ((*to_s - *from_s) / words.every_s >= double(kMostPictures))
    return tl::make_unexpected(
        FilmText::tr("That would be more than %1 pictures. Choose a longer --every.").arg(kMostPictures));
  return filmTimes(*from_s, *to_s, words.every_s);
}

}  // namespace

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

QString numbered(const QString& pattern, int number) {
  static const QRegularExpression place(QStringLiteral("%(?:0(\\d{1,2}))?d"));
  const QRegularExpressionMatch match = place.match(pattern);
  if (!match.hasMatch() || pattern.indexOf(place, match.capturedEnd()) >= 0) return {};
  const QString digits = QStringLiteral("%1").arg(number, match.captured(1).toInt(), 10, QLatin1Char('0'));
  return pattern.left(match.capturedStart()) + digits + pattern.mid(match.capturedEnd());
}

void addFilm(CLI::App& command, FilmWords& words) {
  const std::string time = FilmText::tr("Seconds since 1970, or 2024-06-03T09:00:00Z").toStdString();
  command
      .add_option("name", words.name,
                  FilmText::tr("Name of the bag (see mapwright bags list), or a file").toStdString())
      ->required();
  command.add_option("--from", words.from, time)->required();
  command.add_option("--to", words.to, time)->required();
  command
      .add_option("--every", words.every_s,
                  FilmText::tr("Seconds of the recording between two pictures").toStdString())
      ->capture_default_str();
  command.add_option("--fps", words.fps, FilmText::tr("Frames per second of the video").toStdString())
      ->capture_default_str();
}

int bagsFilm(const FilmWords& words, int& argc, char** argv) {
  const auto times = timesFrom(words);
  if (!times) return refuse(kUsage, times.error());
  const auto place = placeFor(words);
  if (!place) return refuse(kUsage, place.error());
  SnapshotWords picture = words.picture;
  picture.bag = words.name;
  picture.at = words.from;
  picture.output = numbered((*place)->pattern, 0).toStdString();
  picture.report.clear();
  picture.json = false;
  auto options = parseSnapshotOptions(picture);
  if (!options) return refuse(kUsage, options.error());
  const auto fonts = chooseOffscreenPlatform();
  QApplication application(argc, argv);
  const auto access = RobotAccess::read(words.picture.access, options->robot);
  if (!access) return refuse(kUsage, access.error());

  // The last picture comes first: it shows everything, and its view is used for all of them.
  std::vector<std::size_t> order(times->size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::rotate(order.begin(), std::prev(order.end()), order.end());
  const bool terminal = isatty(STDERR_FILENO) != 0;
  int incomplete = 0, done = 0;
  QString first_trouble;
  for (const std::size_t number : order) {
    options->at_s = (*times)[number];
    options->output = numbered((*place)->pattern, int(number));
    geometry::ViewTransform view;
    const Shot shot = shoot(*options, access->forAddress(options->robot), &view);
    if (shot.code != kDone && shot.code != kIncomplete) {
      if (terminal) std::fprintf(stderr, "\r%-40s\r", "");
      return refuse(shot.code, shot.sentence);
    }
    if (shot.code == kIncomplete && incomplete++ == 0) first_trouble = shot.sentence;
    if (!options->center_m) {
      options->center_m = view.center_m;
      options->scale_m_per_px = view.scale_m_per_px;
    }
    ++done;
    if (terminal)
      std::fprintf(stderr, "\r%-40s",
                   qUtf8Printable(FilmText::tr("%1 of %2 pictures").arg(done).arg(order.size())));
  }
  if (terminal) std::fprintf(stderr, "\r%-40s\r", "");
  if (!(*place)->film.isEmpty()) {
    if (const auto why = makeFilm(**place, words.fps)) return refuse(kUsage, *why);
  }
  const QString output = text(words.picture.output);
  if (words.picture.json) {
    const QJsonObject report{{QStringLiteral("file"), output},
                             {QStringLiteral("pictures"), done},
                             {QStringLiteral("incomplete"), incomplete}};
    std::printf("%s", QJsonDocument(report).toJson().constData());
  } else {
    std::printf("%s\n",
                qUtf8Printable(oneLine(FilmText::tr("%1: %2 pictures").arg(output, QString::number(done)))));
  }
  if (incomplete == 0) return kDone;
  return refuse(
      kIncomplete,
      FilmText::tr("%1 of %2 pictures are incomplete. %3").arg(incomplete).arg(done).arg(first_trouble));
}

}  // namespace mapwright::app
