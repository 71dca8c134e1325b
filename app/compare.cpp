// `mapwright compare`: two pictures, pixel by pixel.
#include <memory>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/language.h"
#include "app/output.h"
#include "compare/comparison.h"
#include "compare/comparison_sentence.h"
#include "compare/difference_picture.h"
#include "compare/picture_view.h"
#include "sentences/fault_sentence.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

struct CompareArguments {
  std::string expected, actual, diff, report;
  compare::Allowed allowed;
  bool json = false;
};

QJsonObject comparisonJson(const compare::Comparison& made,
                           const std::optional<geometry::ViewTransform>& view) {
  QJsonObject json{{QStringLiteral("equal"), made.equal},
                   {QStringLiteral("differing"), qint64(made.differing)},
                   {QStringLiteral("max"), made.max},
                   {QStringLiteral("clusters"), compare::clustersJson(made, view)}};
  if (made.sameSize()) return json;
  QJsonArray sizes;
  for (const compare::PictureSize& size : {made.expected, made.actual})
    sizes << QJsonArray{size.width, size.height};
  json[QStringLiteral("sizes")] = sizes;
  return json;
}

std::optional<QString> notComparedReason(const CompareArguments& args) {
  if (args.allowed.tolerance < 0 || args.allowed.tolerance > 255)
    return Text::tr("--tolerance must be a number from 0 to 255.");
  if (!(args.allowed.max_differing_percent >= 0 && args.allowed.max_differing_percent <= 100))
    return Text::tr("--max-differing must be a percentage from 0 to 100.");
  if (args.diff.empty()) return std::nullopt;
  if (const auto why = pngNotWritableReason(text(args.diff))) return why;
  for (const std::string& read : {args.expected, args.actual, args.allowed.mask}) {
    if (const auto why = notTogetherReason({text(args.diff), text(read)})) return why;
  }
  return notTogetherReason({text(args.diff), args.json ? QStringLiteral("-") : QString()});
}

int comparePictureFiles(const CompareArguments& args, const Invocation& before) {
  const InPlaceOfSpeaker own;
  const QCoreApplication application(before.argc, before.argv);
  if (const auto why = notComparedReason(args)) return refuse(kUsage, *why);
  const auto made = compare::comparePictures(args.expected, args.actual, args.allowed);
  if (!made) return refuse(kUsage, sentences::sentenceOf(made.error()));
  std::optional<geometry::ViewTransform> view;
  if (!args.report.empty()) {
    view = compare::viewIn(text(args.report));
    if (!view) return refuse(kUsage, Text::tr("%1 is not the report of a snapshot.").arg(text(args.report)));
    if (!compare::isOf(*view, made->actual) && !compare::isOf(*view, made->expected)) {
      return refuse(kUsage, Text::tr("%1 is the report of a picture of %2 x %3: not of one of these.")
                                .arg(text(args.report))
                                .arg(view->width_px)
                                .arg(view->height_px));
    }
  } else {
    view = compare::viewBeside(text(args.actual), made->actual);
    if (!view) view = compare::viewBeside(text(args.expected), made->expected);
  }
  if (!args.diff.empty()) {
    if (const auto fault = compare::writeDifference(*made, args.expected, args.actual, args.diff))
      return refuse(kUsage, sentences::sentenceOf(*fault));
  }
  if (args.json) {
    printJson(comparisonJson(*made, view));
  } else if (!isStandardOutput(text(args.diff))) {
    printLine(oneLine(compare::comparisonText(*made, view)));
  }
  return made->equal ? kDone : kIncomplete;
}

}  // namespace

void addCompare(Commands& commands) {
  const auto args = std::make_shared<CompareArguments>();
  CLI::App* const command =
      commands.program().add_subcommand("compare", help(Text::tr("Compare two pictures pixel by pixel")));
  command->add_option("expected", args->expected, help(Text::tr("The expected picture")))->required();
  command->add_option("actual", args->actual, help(Text::tr("The picture to compare with it")))->required();
  command
      ->add_option("--tolerance", args->allowed.tolerance,
                   help(Text::tr("Difference allowed for a channel of a pixel: 0 to 255")))
      ->capture_default_str();
  command
      ->add_option("--max-differing", args->allowed.max_differing_percent,
                   help(Text::tr("Share of pixels that may differ by more, in percent; dense clusters, such "
                                 "as a lost marker, never may")))
      ->capture_default_str();
  command->add_option(
      "--mask", args->allowed.mask,
      help(Text::tr("A picture of the same size whose gray says by how much each pixel may differ")));
  command->add_option("--diff", args->diff, help(Text::tr("Write a picture of the differences (PNG)")));
  command->add_option(
      "--report", args->report,
      help(
          Text::tr("The report of the snapshot, for places in metres; by default the one beside a picture")));
  addJson(*command, args->json);
  commands.add(command, [args](const Invocation& before) { return comparePictureFiles(*args, before); });
}

}  // namespace mapwright::app
