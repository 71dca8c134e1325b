#include "app/site_options.h"

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/maps_align.h"
#include "app/output.h"

namespace mapwright::app {

void addSiteOptions(CLI::App& command, SiteArguments& args, const QString& output) {
  command.add_option(
      "--transform", args.transform,
      help(Text::tr("X,Y,YAW in metres and degrees, from the old map to the new one, instead of aligning "
                    "them as maps align does")));
  command
      .add_option("--pair", args.pairs,
                  help(Text::tr("X,Y:X,Y: a point of the old map and the same point of the new one")))
      ->allow_extra_args(false);
  command.add_option("--radius", args.radius,
                     help(Text::tr("Radius of the robot in metres (default: as it reports, else 0.3); 0: as "
                                   "if it had no size")));
  command.add_option("-o,--output", args.output, help(output));
  command.get_option("--report")
      ->description(help(
          Text::tr("Write a report: a page for people if it ends in .html, else JSON with all warnings")));
  addForce(command, args.force);
  command.add_option("--resolution", args.resolution,
                     help(Text::tr("Metres per cell of a plain picture file or of submaps (default: 0.05)")));
  command.add_option("--origin", args.origin,
                     help(Text::tr("Lower left corner of a plain picture file: X,Y or X,Y,YAW")));
  addJson(command, args.json);
}

CommandResult<SiteWishes> wishesFrom(const SiteArguments& args) {
  const auto pairs = pairsFrom(args.pairs);
  if (!pairs) return wrong(pairs.error());
  const auto radius = radiusFrom(args.radius);
  if (!radius) return wrong(radius.error());
  const auto transform = transformFrom(args.transform, !pairs->empty());
  if (!transform) return wrong(transform.error());
  return SiteWishes{*pairs, *radius, *transform};
}

}  // namespace mapwright::app
