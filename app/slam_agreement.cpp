// `mapwright slam disagreement` and `mapwright slam coverage` (docs/command-line.md).
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonObject>

#include "agreement/heat.h"
#include "agreement/survey.h"
#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "app/robot_factory.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "jobs/export_map.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/decimal.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/text.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

using agreement::Coverage;
using agreement::Disagreement;
using words::text;

/// The options as typed; empty = not given.
struct AgreementArguments : RobotArguments {
  int tolerance_cells = agreement::Rules{}.tolerance_cells;
  double cell_m = agreement::Rules{}.cell_m;
  std::string bag, at;
  std::string output, csv;
  std::optional<double> fail_over;
  bool world_file = false;
};

constexpr std::size_t kRowsShown = 20;
constexpr qint64 kMostHeatPixels = 200'000'000;
constexpr int kMostHeatEdge = 32'000;

QString cellsText(std::uint64_t cells) { return QString::fromStdString(words::grouped(std::int64_t(cells))); }

QString percent(std::uint64_t part, std::uint64_t whole) {
  return Text::tr("%1 %").arg(whole == 0 ? 0.0 : 100.0 * double(part) / double(whole), 0, 'f', 2);
}

QStringList namesOf(const std::vector<map::SubmapId>& submaps) {
  QStringList names;
  for (const map::SubmapId id : submaps) names << QString::fromStdString(map::toText(id));
  return names;
}

/// Nothing but data goes to the standard output.
bool printsFile(const AgreementArguments& args) {
  return isStandardOutput(text(args.output)) || isStandardOutput(text(args.csv));
}

std::optional<QString> notAskedWellReason(const AgreementArguments& args) {
  if (!(args.cell_m >= agreement::kFinestCellM && args.cell_m <= agreement::kCoarsestCellM))
    return Text::tr("--cell must be from %1 to %2 metres.")
        .arg(agreement::kFinestCellM)
        .arg(agreement::kCoarsestCellM);
  if (args.tolerance_cells < 0 || args.tolerance_cells > agreement::kMostTolerance)
    return Text::tr("--tolerance must be a number of cells from 0 to %1.").arg(agreement::kMostTolerance);
  if (args.fail_over && !(*args.fail_over >= 0 && *args.fail_over <= 1))
    return Text::tr("--fail-over must be a share from 0 to 1, for example 0.05 for 5 %.");
  if (args.bag.empty() != args.at.empty()) return Text::tr("--bag and --at belong together.");
  const QString output = text(args.output);
  const bool printed = isStandardOutput(output);
  if (!output.isEmpty() && !printed && QFileInfo(output).suffix().toLower() != QLatin1String("png"))
    return Text::tr("--output %1: the name must end in .png.").arg(output);
  if (args.world_file && (output.isEmpty() || printed))
    return Text::tr("--world-file needs the file of a picture (--output).");
  const std::vector<std::string> sources = sourceFilesOf(text(args.robot), {}, {});
  for (const QString& file : {output, text(args.csv)}) {
    if (file.isEmpty()) continue;
    if (const auto why = notCreatedReason(file, true, sources)) return why;
  }
  return std::nullopt;
}

/// Connected, or at the time of a bag.
CommandResult<RobotReading*> openFor(RobotCommand& command, const AgreementArguments& args) {
  if (const auto why = notAskedWellReason(args)) return wrong(*why);
  if (const auto why = notTogetherReason({text(args.output), text(args.csv), text(args.report),
                                          args.json ? QStringLiteral("-") : QString()}))
    return sharedOutput(*why);
  const auto reading = command.open(RobotReading::Purpose::Submaps, {}, args.bag);
  if (!reading || args.bag.empty()) return reading;
  if (const auto failed = (*reading)->recall(args.at)) return tl::make_unexpected(*failed);
  if (!(*reading)->session().world().submaps)
    return (*reading)->failure(kRobotError, Text::tr("The bag contains no submap list up to this time."));
  return reading;
}

/// All submaps of the robot, compared.
CommandResult<agreement::Survey> surveyOf(RobotReading& reading, const AgreementArguments& args) {
  const auto textures = reading.submapTextures();
  if (!textures) return passOn(textures);
  agreement::Survey survey({args.cell_m, args.tolerance_cells});
  if (const auto fault = survey.setSubmaps(*textures))
    return reading.failure(
        kUsage, sentences::sentenceOf(*fault) + QLatin1Char(' ') + Text::tr("Choose a larger --cell."));
  if (!survey.unplaceable().empty()) {
    const auto count = qsizetype(survey.unplaceable().size());
    reading.lack(
        Text::tr("%1 submaps lie too far away to be compared: %2.", nullptr, sentences::formOf(count))
            .arg(count)
            .arg(words::listed(namesOf(survey.unplaceable()).mid(0, 5))));
  }
  render::DenseCache cache(work::budgetsFrom().dense);
  ProgressLine progress;
  const bool in_time = survey.makeAll(reading.workers(), cache, [&](std::size_t made, std::size_t all) {
    progress.tell(Text::tr("%1 of %2 tiles compared").arg(made).arg(all));
    return !reading.time().over(reading.time().start.grace.draw_s);
  });
  progress.clear();
  if (!in_time)
    return reading.failure(
        kIncomplete,
        Text::tr("Comparing the submaps took longer than %1 s (--timeout).").arg(args.timeout_s));
  return survey;
}

struct HeatPicture {
  QImage image;
  map::GridReference reference;
};

/// One pixel a cell, as large as what submaps saw. The error is a sentence.
tl::expected<HeatPicture, QString> heatPicture(
    const agreement::Tiles& tiles, double cell_m, std::span<const agreement::Argb> colors,
    const std::function<agreement::Shades(agreement::TileKey, const agreement::Tile&)>& shadesOf) {
  constexpr int kEdge = agreement::kTileCells;
  constexpr qint64 kNone = std::numeric_limits<qint64>::max();
  qint64 left = kNone, low = kNone, right = -kNone, high = -kNone;  // cells, the last ones included
  for (const auto& [key, tile] : tiles) {
    for (int row = 0; row < kEdge; ++row) {
      for (int column = 0; column < kEdge; ++column) {
        if (tile->seenBy(column, row) == 0) continue;
        left = std::min(left, qint64(key.column) * kEdge + column);
        right = std::max(right, qint64(key.column) * kEdge + column);
        low = std::min(low, qint64(key.row) * kEdge + row);
        high = std::max(high, qint64(key.row) * kEdge + row);
      }
    }
  }
  if (left > right) return tl::make_unexpected(Text::tr("There is nothing to draw: no submap saw anything."));
  const qint64 width = right - left + 1, height = high - low + 1;
  if (width > kMostHeatEdge || height > kMostHeatEdge || width * height > kMostHeatPixels) {
    return tl::make_unexpected(
        Text::tr("The picture would have %1 x %2 pixels, one for each cell. At most %3 a side and %4 million "
                 "in all are possible: choose a larger --cell.")
            .arg(width)
            .arg(height)
            .arg(kMostHeatEdge)
            .arg(kMostHeatPixels / 1'000'000));
  }
  HeatPicture picture{QImage(int(width), int(height), QImage::Format_Indexed8),
                      {int(width), int(height), cell_m, {double(left) * cell_m, double(low) * cell_m, 0}}};
  if (picture.image.isNull())
    return tl::make_unexpected(Text::tr("There is not enough memory for the picture."));
  picture.image.setColorTable(QList<QRgb>(colors.begin(), colors.end()));
  picture.image.fill(0);
  for (const auto& [key, tile] : tiles) {
    const agreement::Shades shades = shadesOf(key, *tile);
    const qint64 first = std::max(left, qint64(key.column) * kEdge);
    const qint64 last = std::min(right, qint64(key.column) * kEdge + kEdge - 1);
    for (int row = 0; row < kEdge; ++row) {
      const qint64 y = high - (qint64(key.row) * kEdge + row);
      if (y < 0 || y >= height) continue;
      const auto* const from = shades.data() + row * kEdge + (first - qint64(key.column) * kEdge);
      std::copy_n(from, last - first + 1, picture.image.scanLine(int(y)) + (first - left));
    }
  }
  const geometry::Pose2& origin = picture.reference.origin;
  picture.image.setText(QStringLiteral("resolution"), QString::number(cell_m));
  picture.image.setText(QStringLiteral("origin"),
                        QStringLiteral("[%1, %2, 0]").arg(origin.x_m).arg(origin.y_m));
  return picture;
}

/// nullopt = written.
std::optional<QString> writeHeat(const AgreementArguments& args,
                                 const tl::expected<HeatPicture, QString>& picture) {
  if (!picture) return picture.error();
  const jobs::ExportResult written =
      jobs::exportMap({jobs::ViewExport{picture->image, picture->reference}, jobs::ExportFormat::ViewPicture,
                       text(args.output), args.world_file},
                      nullptr);
  return written.error.isEmpty() ? std::nullopt : std::optional(written.error);
}

std::optional<QString> writeCsv(const AgreementArguments& args, const QString& rows) {
  const auto fault = disk::writeFile(args.csv, rows.toStdString());
  return fault ? std::optional(sentences::sentenceOf(disk::notWritten(*fault))) : std::nullopt;
}

/// What every one of these says of itself.
QJsonObject withCompleteness(QJsonObject json, const RobotReading& reading) {
  json[QStringLiteral("complete")] = reading.complete();
  json[QStringLiteral("warnings")] = QJsonArray::fromStringList(reading.warnings());
  return json;
}

QJsonObject jsonOf(const Disagreement& found) {
  QJsonArray places;
  for (const agreement::Place& place : found.places) {
    QJsonArray parts;
    for (const agreement::Part& part : place.submaps) {
      parts << QJsonObject{{QStringLiteral("submap"), QString::fromStdString(map::toText(part.id))},
                           {QStringLiteral("occupied_cells"), part.occupied},
                           {QStringLiteral("free_cells"), part.free}};
    }
    places << QJsonObject{
        {QStringLiteral("x"), place.x},
        {QStringLiteral("y"), place.y},
        {QStringLiteral("cells"), qint64(place.cells)},
        {QStringLiteral("submaps"), QJsonArray::fromStringList(namesOf(agreement::idsOf(place.submaps)))},
        {QStringLiteral("parts"), parts}};
  }
  return {{QStringLiteral("tolerance_cells"), found.tolerance_cells},
          {QStringLiteral("cell_m"), found.cell_m},
          {QStringLiteral("occupied_cells"), qint64(found.occupied_cells)},
          {QStringLiteral("contradicted_cells"), qint64(found.contradicted_cells)},
          {QStringLiteral("share"), found.share()},
          {QStringLiteral("places"), places}};
}

QString csvOf(const Disagreement& found) {
  QString rows = QStringLiteral("x,y,cells,submaps\n");
  for (const agreement::Place& place : found.places) {
    rows += QStringLiteral("%1,%2,%3,%4\n")
                .arg(place.x)
                .arg(place.y)
                .arg(place.cells)
                .arg(namesOf(agreement::idsOf(place.submaps)).join(QLatin1Char(' ')));
  }
  return rows;
}

void print(const Disagreement& found) {
  printLine(Text::tr("%1 of the %2 occupied cells contradict: %3 cells of %4 m (tolerance: %5 cells).")
                .arg(percent(found.contradicted_cells, found.occupied_cells), cellsText(found.occupied_cells),
                     cellsText(found.contradicted_cells), words::decimal(found.cell_m),
                     QString::number(found.tolerance_cells)));
  if (found.places.empty()) return;
  std::vector<QStringList> table{
      {Text::tr("CELLS"), Text::tr("X"), Text::tr("Y"), Text::tr("SUBMAPS (occupied/free)")}};
  for (const agreement::Place& place : found.places) {
    if (table.size() > kRowsShown) break;
    QStringList submaps;
    for (const agreement::Part& part : place.submaps)
      submaps << QStringLiteral("%1 (%2/%3)")
                     .arg(QString::fromStdString(map::toText(part.id)))
                     .arg(part.occupied)
                     .arg(part.free);
    table.push_back({QString::number(place.cells), words::decimal(place.x), words::decimal(place.y),
                     submaps.join(QLatin1Char(' '))});
  }
  printTable(table);
  if (const qsizetype more = qsizetype(found.places.size()) - qsizetype(kRowsShown); more > 0)
    printLine(Text::tr("… and %1 more places (--csv or --json for all)", nullptr, sentences::formOf(more))
                  .arg(more));
}

QJsonObject jsonOf(const Coverage& found) {
  QJsonArray counts;
  for (int submaps = 1; submaps <= found.most(); ++submaps) {
    counts << QJsonObject{{QStringLiteral("submaps"), submaps},
                          {QStringLiteral("cells"), qint64(found.cells_seen_by[std::size_t(submaps)])}};
  }
  return {{QStringLiteral("cell_m"), found.cell_m},
          {QStringLiteral("seen_cells"), qint64(found.seen_cells)},
          {QStringLiteral("seen_once_cells"), qint64(found.seenOnce())},
          {QStringLiteral("seen_once_share"),
           found.seen_cells == 0 ? 0.0 : double(found.seenOnce()) / double(found.seen_cells)},
          {QStringLiteral("seen_by"), counts}};
}

QString csvOf(const Coverage& found) {
  QString rows = QStringLiteral("x,y,seen_cells,seen_once_cells\n");
  for (const agreement::SeenPlace& place : agreement::seenPlaces(found)) {
    rows +=
        QStringLiteral("%1,%2,%3,%4\n").arg(place.x).arg(place.y).arg(place.seen_cells).arg(place.seen_once);
  }
  return rows;
}

void print(const Coverage& found) {
  printLine(Text::tr("%1 cells of %2 m were seen, %3 of them by one submap alone.")
                .arg(cellsText(found.seen_cells), words::decimal(found.cell_m),
                     percent(found.seenOnce(), found.seen_cells)));
  std::vector<QStringList> table{{Text::tr("SUBMAPS"), Text::tr("CELLS"), Text::tr("SHARE")}};
  const int most = found.most();
  for (int low = 1; low <= most; low *= 2) {
    const int high = std::min(2 * low - 1, most);
    std::uint64_t cells = 0;
    for (int submaps = low; submaps <= high; ++submaps) cells += found.cells_seen_by[std::size_t(submaps)];
    table.push_back({low == high ? QString::number(low) : QStringLiteral("%1-%2").arg(low).arg(high),
                     cellsText(cells), percent(cells, found.seen_cells)});
  }
  if (most > 0) printTable(table);
}

/// Files, then what is printed. The error is a sentence.
template <typename Found>
std::optional<QString> tell(RobotCommand& command, const QString& name, const RobotReading& reading,
                            const AgreementArguments& args, const Found& found,
                            const std::function<tl::expected<HeatPicture, QString>()>& draw) {
  if (!args.output.empty()) {
    if (const auto why = writeHeat(args, draw())) return why;
  }
  if (!args.csv.empty()) {
    if (const auto why = writeCsv(args, csvOf(found))) return why;
  }
  const QJsonObject json = jsonOf(found);
  command.report(name, json);
  if (args.json) {
    printJson(withCompleteness(json, reading));
  } else if (!printsFile(args)) {
    print(found);
  }
  return std::nullopt;
}

CommandResult<int> slamDisagreement(RobotCommand& command, const AgreementArguments& args) {
  const auto reading = openFor(command, args);
  if (!reading) return passOn(reading);
  const auto survey = surveyOf(**reading, args);
  if (!survey) return passOn(survey);
  const Disagreement found = survey->disagreement();
  const bool failed = args.fail_over && found.share() > *args.fail_over;
  if (failed) {
    (*reading)->addRemark(Text::tr("%1 of the occupied cells contradict: more than the %2 % of --fail-over.")
                              .arg(percent(found.contradicted_cells, found.occupied_cells))
                              .arg(*args.fail_over * 100));
  }
  const auto why = tell(command, QStringLiteral("disagreement"), **reading, args, found, [&] {
    const agreement::DisagreementHeat heat(found);
    return heatPicture(
        found.tiles, found.cell_m, heat.colors(),
        [&](agreement::TileKey key, const agreement::Tile& tile) { return heat.shades(key, tile); });
  });
  if (why) return wrong(*why);
  return failed ? kIncomplete : kDone;
}

CommandResult<int> slamCoverage(RobotCommand& command, const AgreementArguments& args) {
  const auto reading = openFor(command, args);
  if (!reading) return passOn(reading);
  const auto survey = surveyOf(**reading, args);
  if (!survey) return passOn(survey);
  const Coverage found = survey->coverage();
  const auto why = tell(command, QStringLiteral("coverage"), **reading, args, found, [&] {
    return heatPicture(found.tiles, found.cell_m, agreement::CoverageHeat::colors(),
                       [](agreement::TileKey, const agreement::Tile& tile) {
                         return agreement::CoverageHeat::shades(tile);
                       });
  });
  if (why) return wrong(*why);
  return kDone;
}

/// --bag may be a recording, which then is the robot.
void takeRecording(AgreementArguments& args, const Invocation& before) {
  if (!args.bag.empty()) onRecording(args.robot, args.bag, before.robot);
}

void addOutputs(CLI::App& command, AgreementArguments& args, const QString& picture, const QString& csv) {
  command.add_option("--bag", args.bag,
                     help(Text::tr("Read recorded submaps: the name of a bag, or a file, with --at; "
                                   "FILE?ns=/NAMESPACE is one robot of several")));
  addTime(command, "--at", args.at);
  command
      .add_option("--cell", args.cell_m,
                  help(Text::tr("Metres per cell of the world, on which the submaps are compared")))
      ->capture_default_str();
  command.add_option("-o,--output", args.output, help(picture));
  command.add_option("--csv", args.csv, help(csv));
  command.add_flag("--world-file", args.world_file,
                   help(Text::tr("Also write a world file (.pgw): where the picture lies")));
  addJson(command, args.json);
}

}  // namespace

void addSlamAgreement(Commands& commands, CLI::App& slam) {
  const QString robots = Text::tr("Robot address or state file (or MAPWRIGHT_ROBOT)");
  const auto disagreement = std::make_shared<AgreementArguments>();
  CLI::App* const contradicting =
      addReading(commands, slam, "disagreement", Text::tr("Find where submaps contradict each other"), robots,
                 disagreement, slamDisagreement, takeRecording);
  contradicting
      ->add_option("--tolerance", disagreement->tolerance_cells,
                   help(Text::tr("Walls that lie apart by so many cells are the same wall")))
      ->capture_default_str();
  contradicting->add_option(
      "--fail-over", disagreement->fail_over,
      help(Text::tr("Exit with 1 if a larger share of the occupied cells contradicts, for example 0.05")));
  addOutputs(*contradicting, *disagreement,
             Text::tr("Write a picture (PNG): what contradicts is yellow to red, one pixel a cell"),
             Text::tr("Write all places where submaps contradict each other, as squares of 1 m (CSV)"));
  const auto coverage = std::make_shared<AgreementArguments>();
  CLI::App* const seen =
      addReading(commands, slam, "coverage", Text::tr("Count how many submaps saw each cell"), robots,
                 coverage, slamCoverage, takeRecording);
  addOutputs(*seen, *coverage,
             Text::tr("Write a picture (PNG): what was seen once is hatched, one pixel a cell"),
             Text::tr("Write what was seen, and seen once, in each square of 1 m (CSV)"));
}

}  // namespace mapwright::app
