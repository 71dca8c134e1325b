// `mapwright maps align OLD NEW`: where the same site lies on two maps of it (docs/tasks/new-map.md).
#include "app/maps_align.h"

#include <algorithm>
#include <optional>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonObject>

#include "align/align_placed.h"
#include "align/alignment_sentence.h"
#include "align/plan_of.h"
#include "app/command_text.h"
#include "app/map_diff.h"
#include "app/map_operand.h"
#include "app/output.h"
#include "words/decimal.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

/// The options as typed; empty = not given.
struct AlignArguments : RobotArguments {
  std::string first, second;  // the old map and the new one
  std::string resolution, origin;
  std::vector<std::string> pairs;  // "X,Y:X,Y"
  std::string diff_picture;
  bool force = false;
};

tl::expected<placing::PointPair, QString> pairFrom(const std::string& typed) {
  const QStringList points = text(typed).split(QLatin1Char(':'));
  std::vector<double> numbers;
  for (const QString& point : points) {
    const auto of_point = numbersFrom(point.toStdString());
    if (of_point && of_point->size() == 2) numbers.insert(numbers.end(), of_point->begin(), of_point->end());
  }
  if (points.size() != 2 || numbers.size() != 4) {
    return tl::make_unexpected(
        Text::tr("--pair %1: give a point of the old map and the same point of the new "
                 "one in metres, X,Y:X,Y.")
            .arg(text(typed)));
  }
  return placing::PointPair{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

void addDistances(QJsonObject& json, const align::WallDistances& distances) {
  json[QStringLiteral("walls_within_10cm")] = distances.within_10cm;
  json[QStringLiteral("median_m")] = distances.median_m;
  json[QStringLiteral("p95_m")] = distances.p95_m;
  json[QStringLiteral("max_m")] = distances.max_m;
  json[QStringLiteral("walls_compared")] = distances.seen_share;
}

/// docs/json.md, "maps align".
QJsonObject alignmentJson(const align::Alignment& found, double cell_m) {
  QJsonObject json{{QStringLiteral("sure"), found.sure()},
                   {QStringLiteral("sentence"), align::alignmentText(found)},
                   {QStringLiteral("cell_m"), cell_m},
                   {QStringLiteral("transform"), QJsonValue()},
                   {QStringLiteral("second"), QJsonValue()}};
  if (found.best) {
    // Nothing is chosen unless it is sure: the best candidate has a name of its own then.
    json[found.sure() ? QStringLiteral("transform") : QStringLiteral("best")] =
        transformJson(found.best->transform);
    json[QStringLiteral("score")] = found.best->score;
    json[QStringLiteral("overlap")] = found.agreement.overlap;
    addDistances(json, found.agreement.forward);
    QJsonObject backwards;
    addDistances(backwards, found.agreement.backward);
    json[QStringLiteral("backwards")] = backwards;
    QJsonArray places;
    for (const align::OffSquare& square : found.agreement.off) {
      places << QJsonObject{{QStringLiteral("x"), square.middle_m.x()},
                            {QStringLiteral("y"), square.middle_m.y()},
                            {QStringLiteral("off_m"), square.off_m},
                            {QStringLiteral("walls"), qint64(square.walls)}};
    }
    json[QStringLiteral("places")] = places;
  }
  if (found.second) {
    json[QStringLiteral("second")] =
        QJsonObject{{QStringLiteral("transform"), transformJson(found.second->transform)},
                    {QStringLiteral("score"), found.second->score}};
  }
  QJsonArray pairs;
  for (const double residual : found.pair_residuals_m)
    pairs << QJsonObject{{QStringLiteral("residual_m"), residual}};
  json[QStringLiteral("pairs")] = pairs;
  return json;
}

/// `coarse_m`: the cells that were compared, if larger than those of both maps.
void printAlignment(const align::Alignment& found, std::optional<double> coarse_m) {
  std::vector<QStringList> table;
  if (found.best) {
    const auto place = [](const align::Candidate& candidate) {
      return Text::tr("%1 (score %2)")
          .arg(align::transformText(candidate.transform), align::scoreText(candidate));
    };
    table.push_back({found.sure() ? Text::tr("old to new") : Text::tr("best candidate"), place(*found.best)});
    if (found.second) table.push_back({Text::tr("second best"), place(*found.second)});
    table.push_back({Text::tr("overlap"), align::overlapText(found.agreement)});
    table.push_back({Text::tr("walls of the old map"), align::distancesText(found.agreement.forward)});
    table.push_back({Text::tr("walls of the new map"), align::distancesText(found.agreement.backward)});
  }
  for (std::size_t i = 0; i < found.pair_residuals_m.size(); ++i) {
    table.push_back({Text::tr("pair %1").arg(i + 1),
                     Text::tr("off by %1 m").arg(words::decimal(found.pair_residuals_m[i], 3))});
  }
  if (coarse_m)
    table.push_back(
        {Text::tr("cells"), Text::tr("%1 m: the maps are too large to be compared in cells of their own")
                                .arg(words::decimal(*coarse_m, 3))});
  printTable(table);
  printLine(align::alignmentText(found));
  if (const QString off = align::offText(found.agreement); found.best && !off.isEmpty()) printLine(off);
}

CommandResult<int> mapsAlign(RobotCommand& command, const AlignArguments& args) {
  command.answerByCode();
  const QString picture = text(args.diff_picture), printed = args.json ? QStringLiteral("-") : QString();
  if (const auto why = picture.isEmpty() ? std::nullopt : pngNotWritableReason(picture)) return wrong(*why);
  if (const auto why = notTogetherReason({picture, text(args.report), printed})) return sharedOutput(*why);
  align::Options options;
  const auto pairs = pairsFrom(args.pairs);
  if (!pairs) return wrong(pairs.error());
  options.pairs = *pairs;
  if (const auto why = robotWithoutEffectReason({args.first, args.second}, text(args.robot)))
    return wrong(*why);
  const auto pair =
      openMaps(command, {args.first, args.second}, text(args.robot), {args.resolution, args.origin});
  if (!pair) return passOn(pair);
  if (const auto why = overOwnSource({picture}, pair->source_files); why && !args.force) return wrong(*why);
  const align::Alignment found = *align::alignPlaced(pair->maps[0], pair->maps[1], options);
  if (!picture.isEmpty() && found.best) {
    const auto diff = diffMaps(align::moved(pair->maps[0], found.best->transform), pair->maps[1], picture);
    if (!diff) return wrong(diff.error());
  }
  if (isStandardOutput(picture)) return found.sure() ? kDone : kIncomplete;
  const double cell_m = align::cellsFor(pair->maps[0], pair->maps[1]);
  const bool coarse = cell_m > 1.001 * std::max({align::kFinestCell_m, pair->maps[0].reference.resolution_m,
                                                 pair->maps[1].reference.resolution_m});
  if (args.json) {
    printJson(alignmentJson(found, cell_m));
  } else {
    printAlignment(found, coarse ? std::optional(cell_m) : std::nullopt);
  }
  return found.sure() ? kDone : kIncomplete;
}

}  // namespace

tl::expected<std::vector<placing::PointPair>, QString> pairsFrom(const std::vector<std::string>& typed) {
  std::vector<placing::PointPair> pairs;
  for (const std::string& one : typed) {
    const auto pair = pairFrom(one);
    if (!pair) return tl::make_unexpected(pair.error());
    pairs.push_back(*pair);
  }
  return pairs;
}

tl::expected<std::optional<geometry::Pose2>, QString> transformFrom(const std::string& typed, bool paired) {
  if (typed.empty()) return std::nullopt;
  const auto numbers = numbersFrom(typed);
  if (!numbers || numbers->size() != 3)
    return tl::make_unexpected(
        Text::tr("--transform %1: give X,Y,YAW in metres and degrees, as maps align prints it.")
            .arg(text(typed)));
  if (paired) return tl::make_unexpected(Text::tr("Pass either --transform or --pair."));
  return geometry::Pose2{(*numbers)[0], (*numbers)[1],
                         geometry::normalizeAngle(geometry::radiansFromDegrees((*numbers)[2]))};
}

QJsonObject transformJson(const geometry::Pose2& transform) {
  return {{QStringLiteral("x"), transform.x_m},
          {QStringLiteral("y"), transform.y_m},
          {QStringLiteral("yaw_rad"), transform.yaw_rad}};
}

void addMapAlign(Commands& commands, CLI::App& maps) {
  const auto args = std::make_shared<AlignArguments>();
  CLI::App* const command = addReading(
      commands, maps, "align", Text::tr("Find out where an old map of a site lies on a new one"),
      Text::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"), args, mapsAlign);
  command
      ->add_option("old", args->first,
                   help(Text::tr("The old map: a map of --robot, a file or address, or ID@ADDRESS")))
      ->required();
  command->add_option("new", args->second, help(Text::tr("The same for the new map")))->required();
  command
      ->add_option("--pair", args->pairs,
                   help(Text::tr("X,Y:X,Y: a point of the old map and the same point of the new one. One "
                                 "decides between candidates; two or more align the maps by themselves")))
      ->allow_extra_args(false);
  command->add_option(
      "--resolution", args->resolution,
      help(Text::tr("Metres per cell of a plain picture file or of submaps (default: 0.05)")));
  command->add_option("--origin", args->origin,
                      help(Text::tr("Lower left corner of a plain picture file: X,Y or X,Y,YAW")));
  command->add_option(
      "--diff", args->diff_picture,
      help(Text::tr("Write the old map above the new one as a PNG, with their differences; - is "
                    "the standard output")));
  command->add_flag("--force", args->force,
                    help(Text::tr("Overwrite a file even if a map was read from it")));
  addJson(*command, args->json);
}

}  // namespace mapwright::app
