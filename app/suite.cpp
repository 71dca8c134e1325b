// `mapwright suite`: many views of maps against the pictures that are expected of them.
#include <algorithm>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/display.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "app/suite_drawing.h"
#include "compare/difference_picture.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "suite/judgement.h"
#include "suite/junit.h"
#include "suite/outcome.h"
#include "suite/suite_page.h"
#include "ui/shot/view_facts.h"
#include "words/listed.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using suite::Judgement;
using suite::Verdict;
using suite::ViewOutcome;
using words::text;

constexpr int kMostJobs = 64, kMostVariants = 99;
constexpr std::size_t kMostPictureFileBytes = std::size_t(1) << 30;

struct SuiteArguments : RobotArguments {
  std::string suite, expected;  // `report`: the folder
  std::vector<std::string> only;
  int jobs = int(std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
};

/// A suite that is ready to be drawn.
struct PlannedSuite {
  QString name, expected, report;
  std::vector<suite::View> views;
  std::vector<SnapshotOptions> options;  // of each
  QStringList strays;                    // expected pictures that no view makes, also none outside of --only

  QString expectedPicture(std::size_t view, int variant = 0) const {
    const QString number = variant == 0 ? QString() : QStringLiteral(".%1").arg(variant);
    return QStringLiteral("%1/%2%3.png").arg(expected, views[view].name, number);
  }
  QString expectedFacts(std::size_t view) const { return suite::factsBeside(expectedPicture(view)); }
  /// "actual" or "difference".
  QString made(const char* kind, std::size_t view) const {
    return QStringLiteral("%1/%2/%3.png").arg(report, QLatin1String(kind), views[view].name);
  }
  /// All accepted pictures of a view.
  QStringList expectedPictures(std::size_t view) const {
    QStringList pictures;
    for (int variant = 0; variant <= kMostVariants; ++variant) {
      const QString picture = expectedPicture(view, variant);
      if (!QFileInfo::exists(picture)) break;
      pictures << picture;
    }
    return pictures;
  }
};

tl::expected<suite::Suite, QString> suiteIn(const std::string& path) {
  const auto yaml = disk::readFile(path, suite::kMostSuiteBytes + 1);
  if (!yaml)
    return tl::make_unexpected(
        Text::tr("%1 cannot be read: %2").arg(text(path), sentences::sentenceOf(yaml.error().cause)));
  auto read = suite::readSuite(*yaml, viewOptions());
  if (!read) return tl::make_unexpected(words::about(text(path), read.error()));
  return std::move(*read);
}

/// A sentence if nothing can be written into this folder, which is made where it is missing.
std::optional<QString> noFolderReason(const QString& folder) {
  if (QDir().mkpath(folder) && QFileInfo(folder).isWritable()) return std::nullopt;
  return Text::tr("The folder %1 cannot be written.").arg(folder);
}

/// Where it is, or would be made, with links followed.
QString placeOf(const QString& folder, int links = 0) {
  constexpr int kMostLinks = 40;
  if (const QString there = QFileInfo(folder).canonicalFilePath(); !there.isEmpty()) return there;
  const QFileInfo info(QDir::cleanPath(QFileInfo(folder).absoluteFilePath()));
  if (info.isSymLink() && links < kMostLinks) return placeOf(info.symLinkTarget(), links + 1);
  return info.isRoot() ? info.filePath() : QDir(placeOf(info.path(), links)).filePath(info.fileName());
}

/// Pictures in `folder` that are expected of none of `views`: their views were renamed or taken out.
QStringList straysIn(const QString& folder, const std::vector<suite::View>& views) {
  static const QRegularExpression kVariant(QStringLiteral("\\.[1-9]\\d?$"));
  QStringList strays;
  if (folder.isEmpty()) return strays;
  for (const QString& file : QDir(folder).entryList({QStringLiteral("*.png")}, QDir::Files)) {
    const QString name = file.chopped(4);
    QString plain = name;
    plain.remove(kVariant);
    const bool known = std::any_of(views.begin(), views.end(), [&](const suite::View& view) {
      return view.name == name || view.name == plain;
    });
    if (!known) strays << QStringLiteral("%1/%2").arg(folder, file);
  }
  return strays;
}

void sayStrays(const QStringList& strays) {
  for (const QString& picture : strays)
    say(Text::tr("%1: no view of this suite makes this picture. Delete it, or restore its view.")
            .arg(picture));
}

/// `draws`: pictures will be made.
tl::expected<PlannedSuite, QString> planned(const SuiteArguments& args, bool draws) {
  auto read = suiteIn(args.suite);
  if (!read) return passOn(read);
  const QFileInfo file(text(args.suite));
  PlannedSuite plan;
  plan.name = file.completeBaseName();
  plan.expected = text(args.expected);
  plan.report = text(args.report);
  plan.strays = straysIn(plan.expected, read->views);
  const auto wanted = [&args](const suite::View& view) {
    return args.only.empty() ||
           std::find(args.only.begin(), args.only.end(), view.name.toStdString()) != args.only.end();
  };
  for (const std::string& name : args.only) {
    if (std::none_of(read->views.begin(), read->views.end(),
                     [&](const suite::View& view) { return view.name.toStdString() == name; }))
      return tl::make_unexpected(
          Text::tr("--only: there is no view \"%1\" in %2.").arg(text(name), text(args.suite)));
  }
  if (draws) {
    if (placeOf(plan.report) == placeOf(plan.expected))
      return tl::make_unexpected(
          Text::tr("--expected and --report are the same folder. Choose two different ones."));
    for (const char* const kind : {"", "/actual", "/difference"}) {
      if (const auto why = noFolderReason(plan.report + QLatin1String(kind)))
        return tl::make_unexpected(*why);
    }
  }
  for (suite::View& view : read->views) {
    if (!wanted(view)) continue;
    const auto wrong_view = [&](const QString& sentence) {
      return tl::make_unexpected(words::about(text(args.suite), sentence));
    };
    if (!view.mask.isEmpty()) {
      view.mask = file.dir().absoluteFilePath(view.mask);
      if (!QFileInfo(view.mask).isFile())
        return wrong_view(
            suite::atPosition(view.at, Text::tr("%1: there is no mask %2.").arg(view.name, view.mask)));
    }
    plan.views.push_back(view);
    const QString output = draws ? plan.made("actual", plan.views.size() - 1) : QStringLiteral("/dev/null");
    auto options = snapshotOptionsOf(view, file.absolutePath(), args.robot, output);
    if (!options) return wrong_view(options.error());
    if (const auto address = knownAddresses().parse(options->robot); !address)
      return wrong_view(suite::atPosition(view.at, words::about(view.name, address.error())));
    plan.options.push_back(std::move(*options));
  }
  return plan;
}

compare::Allowed allowedIn(const suite::View& view) {
  return {view.tolerance, view.max_differing_percent, view.mask.toStdString()};
}

Judgement judged(const PlannedSuite& plan, std::size_t view) {
  const QStringList accepted = plan.expectedPictures(view);
  if (!accepted.isEmpty())
    return suite::judge(accepted, plan.made("actual", view), allowedIn(plan.views[view]));
  return {Verdict::NotExpectedYet,
          Text::tr("There is no expected picture %1. mapwright suite accept makes one.")
              .arg(plan.expectedPicture(view)),
          {},
          {}};
}

/// Prints what there is to say of views in their order, as they come.
class OrderedLines {
 public:
  explicit OrderedLines(std::size_t count) : lines_(count), there_(count, false) {}
  void put(std::size_t at, const QStringList& lines, ProgressLine& progress) {
    lines_[at] = lines;
    there_[at] = true;
    ++came_;
    if (next_ < there_.size() && there_[next_]) progress.clear();
    for (; next_ < there_.size() && there_[next_]; ++next_) {
      for (const QString& line : lines_[next_]) printLine(oneLine(line));
      lines_[next_].clear();
    }
    progress.tell(Text::tr("%1 of %2 views").arg(came_).arg(there_.size()));
  }

 private:
  std::vector<QStringList> lines_;
  std::vector<bool> there_;
  std::size_t next_ = 0, came_ = 0;
};

/// Draws all views; `take` says what came of each, in lines.
void drawPlanned(const PlannedSuite& plan, const RobotAccess& access, int jobs,
                 const std::function<QStringList(std::size_t, const DrawnView&)>& take) {
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    for (const char* const kind : {"actual", "difference"}) QFile::remove(plan.made(kind, view));
    QFile::remove(suite::factsBeside(plan.made("actual", view)));
  }
  ProgressLine progress;
  OrderedLines lines(plan.views.size());
  drawViews(plan.options, access, jobs,
            [&](std::size_t view, const DrawnView& drawn) { lines.put(view, take(view, drawn), progress); });
}

std::optional<QString> writeFacts(const QString& path, const suite::Facts& facts) {
  const auto fault = disk::writeFile(path.toStdString(), suite::factsBytes(facts).toStdString());
  return fault ? std::optional(sentences::sentenceOf(disk::notWritten(*fault))) : std::nullopt;
}

/// What is behind a picture, with the figures that its view asks for.
suite::Facts factsOf(const DrawnView& drawn) {
  suite::Facts facts = ui::shot::factsOf(drawn.run->shown(), drawn.run->session());
  suite::addFigures(drawn.examined, facts);
  return facts;
}

ViewOutcome outcomeOf(const PlannedSuite& plan, std::size_t view, const DrawnView& drawn, bool& unreadable) {
  ViewOutcome outcome;
  outcome.name = plan.views[view].name;
  outcome.seconds = drawn.seconds;
  const QString actual = plan.made("actual", view), difference = plan.made("difference", view);
  if (drawn.exit_code != kDone || !drawn.run) {
    outcome.sentence = drawn.sentence;
    QFile::remove(actual);
    return outcome;
  }
  const Judgement verdict = judged(plan, view);
  outcome.verdict = verdict.verdict;
  outcome.sentence = verdict.sentence;
  unreadable = unreadable || verdict.unreadable();
  const suite::Quality& quality = plan.views[view].quality;
  if (outcome.verdict == Verdict::AsExpected && !quality.asked()) {
    QFile::remove(actual);
    return outcome;
  }
  outcome.actual = actual;
  suite::Facts facts = factsOf(drawn);
  facts.picture = suite::sumOf(actual);
  const auto not_kept = writeFacts(suite::factsBeside(actual), facts);
  if (verdict.verdict == Verdict::Differs) {
    outcome.expected = verdict.expected;
    suite::explain(verdict, facts, outcome);
    if (const auto fault = compare::writeDifference(*verdict.comparison, verdict.expected.toStdString(),
                                                    actual.toStdString(), difference.toStdString())) {
      outcome.sentence = words::paragraph({outcome.sentence, sentences::sentenceOf(*fault)});
    } else {
      outcome.difference = difference;
    }
  }
  if (quality.asked()) suite::judgeQuality(quality, drawn.examined, suite::expectedFacts(verdict), outcome);
  if (outcome.verdict == Verdict::AsExpected) {  // its facts stay: they show how the figures change
    QFile::remove(actual);
    outcome.actual.clear();
  }
  if (not_kept) outcome.sentence += QLatin1Char('\n') + *not_kept;
  return outcome;
}

/// A file that is written whole or not at all, as a device.
class WrittenDevice : public QIODevice {
 public:
  explicit WrittenDevice(const QString& path) : file_(path.toStdString()) { open(QIODevice::WriteOnly); }
  /// nullopt = it is in its place.
  std::optional<QString> place() {
    const auto fault = file_.place();
    return fault ? std::optional(sentences::sentenceOf(disk::notWritten(*fault))) : std::nullopt;
  }

 protected:
  qint64 readData(char*, qint64) override { return -1; }
  qint64 writeData(const char* bytes, qint64 count) override {
    file_.write(bytes, std::size_t(count));
    return file_.good() ? count : -1;
  }

 private:
  disk::WrittenFile file_;
};

std::optional<QString> writeReports(const PlannedSuite& plan, const std::vector<ViewOutcome>& outcomes) {
  struct Report {
    const char* name;
    bool (*write)(const QString&, const std::vector<ViewOutcome>&, QIODevice&);
  };
  for (const Report& report : {Report{"junit.xml", suite::writeJunit}, {"report.html", suite::writePage}}) {
    WrittenDevice file(plan.report + QLatin1Char('/') + QLatin1String(report.name));
    report.write(plan.name, outcomes, file);
    if (const auto why = file.place()) return why;
  }
  return std::nullopt;
}

int suiteRun(const PlannedSuite& plan, const RobotAccess& access, int jobs) {
  std::vector<ViewOutcome> outcomes(plan.views.size());
  bool unreadable = false;
  drawPlanned(plan, access, jobs, [&](std::size_t view, const DrawnView& drawn) {
    outcomes[view] = outcomeOf(plan, view, drawn, unreadable);
    const ViewOutcome& outcome = outcomes[view];
    return suite::linesOf(words::about(outcome.name, suite::verdictText(outcome.verdict)), outcome);
  });
  if (const auto why = writeReports(plan, outcomes)) return refuse(kUsage, *why);
  const suite::Tally tally = suite::tallyOf(outcomes);
  printLine(suite::tallyText(tally));
  sayStrays(plan.strays);
  return unreadable ? kUsage : tally.good() ? kDone : kIncomplete;
}

/// The picture that was drawn and its facts become what is expected: both or neither. Facts that name another
/// picture are left where the program ends in between.
std::optional<QString> replaceExpected(const PlannedSuite& plan, std::size_t view,
                                       const suite::Facts& facts) {
  const auto bytes = disk::readFile(plan.made("actual", view).toStdString(), kMostPictureFileBytes);
  if (!bytes) return sentences::sentenceOf(bytes.error().cause);
  disk::WrittenFile picture(plan.expectedPicture(view).toStdString());
  disk::WrittenFile kept(plan.expectedFacts(view).toStdString());
  picture.write(*bytes);
  kept.write(suite::factsBytes(facts).toStdString());
  picture.finish();
  kept.finish();
  // place() says what is wrong; it replaces nothing where something is.
  auto fault = kept.good() ? std::nullopt : kept.place();
  if (!fault) fault = picture.place();
  if (!fault) fault = kept.place();
  return fault ? std::optional(sentences::sentenceOf(disk::notWritten(*fault))) : std::nullopt;
}

/// What was accepted besides is of the look before: it would let that pass from now on. A sentence about it.
QString endVariants(const PlannedSuite& plan, std::size_t view) {
  QStringList ended;
  for (const QString& variant : plan.expectedPictures(view).mid(1)) {
    if (!QFile::remove(variant)) continue;
    QFile::remove(suite::factsBeside(variant));
    ended << QFileInfo(variant).fileName();
  }
  return ended.isEmpty() ? QString() : Text::tr("No longer accepted: %1. ").arg(words::listed(ended));
}

int suiteAccept(const PlannedSuite& plan, const RobotAccess& access, int jobs) {
  if (const auto why = noFolderReason(plan.expected)) return refuse(kUsage, *why);
  int code = kDone;
  drawPlanned(plan, access, jobs, [&](std::size_t view, const DrawnView& drawn) -> QStringList {
    const QString& name = plan.views[view].name;
    const auto fail = [&](int with, const QString& sentence) {
      code = std::max(code, with);
      return QStringList(Text::tr("%1: nothing accepted. %2").arg(name, sentence));
    };
    if (drawn.exit_code != kDone || !drawn.run) return fail(kIncomplete, drawn.sentence);
    if (!drawn.examined.lacks.isEmpty()) return fail(kIncomplete, words::paragraph(drawn.examined.lacks));
    suite::Facts facts = factsOf(drawn);
    const QString picture = plan.expectedPicture(view);
    const Judgement verdict = judged(plan, view);
    ViewOutcome of_session;
    suite::judgeQuality(plan.views[view].quality, drawn.examined, suite::expectedFacts(verdict), of_session);
    const auto told = [&of_session](const QString& line) { return suite::linesOf(line, of_session); };
    if (verdict.verdict == Verdict::AsExpected) {
      facts.picture = suite::sumOf(verdict.expected);
      const QString beside = suite::factsBeside(verdict.expected);
      if (const auto kept = suite::factsIn(beside); kept && kept->picture == facts.picture &&
                                                    kept->closures == facts.closures &&
                                                    kept->disagreement == facts.disagreement)
        return told(Text::tr("%1: as expected, nothing is replaced").arg(name));
      if (const auto why = writeFacts(beside, facts)) return fail(kUsage, *why);
      return told(Text::tr("%1: as expected, the facts beside it are new: %2").arg(name, beside));
    }
    const QString actual = plan.made("actual", view);
    // Its mask must fit.
    const std::string made = actual.toStdString();
    if (const auto fits = compare::comparePictures(made, made, allowedIn(plan.views[view])); !fits)
      return fail(kUsage, sentences::sentenceOf(fits.error()));
    facts.picture = suite::sumOf(actual);
    const bool replaces = QFileInfo::exists(picture);
    ViewOutcome outcome;
    if (verdict.verdict == Verdict::Differs) suite::explain(verdict, facts, outcome);
    if (verdict.unreadable()) outcome.sentence = verdict.sentence;
    if (const auto why = replaceExpected(plan, view, facts)) return fail(kUsage, *why);
    const QString ended = endVariants(plan, view);
    if (!replaces) return told(Text::tr("%1: new, %2").arg(name, picture));
    of_session.sentence = (ended + outcome.sentence).trimmed() + QLatin1Char('\n') + of_session.sentence;
    return told(Text::tr("%1: replaced %2").arg(name, picture));
  });
  sayStrays(plan.strays);
  return code;
}

int suiteList(const PlannedSuite& plan) {
  std::vector<QStringList> rows;
  for (std::size_t view = 0; view < plan.views.size(); ++view) {
    const qsizetype accepted = plan.expected.isEmpty() ? 0 : plan.expectedPictures(view).size();
    const QString expected =
        plan.expected.isEmpty() ? QStringLiteral("-")
        : accepted == 0
            ? Text::tr("not expected yet")
            : sentences::counted(Text::tr("%1 accepted pictures", nullptr, sentences::formOf(accepted)),
                                 accepted);
    rows.push_back({expected, plan.options[view].robot, plan.views[view].name});
  }
  printTable(rows);
  sayStrays(plan.strays);
  return kDone;
}

enum class SuiteDeed { Run, Accept, List };

int suiteCommand(SuiteDeed deed, SuiteArguments& args, const Invocation& before) {
  inherit(args, before);
  if (deed == SuiteDeed::Accept && !qEnvironmentVariableIsEmpty("CI")) {
    return refuse(
        kUsage,
        Text::tr(
            "Expected pictures are accepted by people: accept does nothing where the variable CI is set."));
  }
  if (args.jobs < 1 || args.jobs > kMostJobs)
    return refuse(kUsage, Text::tr("--jobs must be a number from 1 to %1.").arg(kMostJobs));
  // accept needs a place for what it draws, and nobody looks at it afterwards.
  std::unique_ptr<QTemporaryDir> aside;
  if (deed == SuiteDeed::Accept && args.report.empty()) {
    aside = std::make_unique<QTemporaryDir>();
    if (!aside->isValid())
      return refuse(kUsage,
                    Text::tr("There is no folder for temporary files: %1. Set TMPDIR, or pass --report.")
                        .arg(aside->errorString()));
    args.report = aside->path().toStdString();
  }
  OffscreenApplication application(before.argc, before.argv);
  const auto plan = planned(args, deed != SuiteDeed::List);
  if (!plan) return refuse(kUsage, plan.error());
  if (deed == SuiteDeed::List) return suiteList(*plan);
  const auto access = RobotAccess::read(args.access, text(args.robot));
  if (!access) return refuse(kUsage, access.error());
  return deed == SuiteDeed::Run ? suiteRun(*plan, *access, args.jobs)
                                : suiteAccept(*plan, *access, args.jobs);
}

}  // namespace

void addSuite(Commands& commands) {
  CLI::App* const suite = commands.program().add_subcommand(
      "suite", help(Text::tr("Compare many views with their expected pictures")));
  suite->require_subcommand(1);
  struct Deed {
    const char* name;
    SuiteDeed deed;
    QString about;
  };
  for (const Deed& one :
       {Deed{"run", SuiteDeed::Run,
             Text::tr("Draw all views, compare them, write junit.xml and report.html")},
        Deed{"accept", SuiteDeed::Accept, Text::tr("Draw all views and store them as the expected pictures")},
        Deed{"list", SuiteDeed::List, Text::tr("List the views and their expected pictures")}}) {
    const auto args = std::make_shared<SuiteArguments>();
    CLI::App* const command = suite->add_subcommand(one.name, help(one.about));
    command->add_option("suite", args->suite, help(Text::tr("The list of views (YAML)")))->required();
    auto* const expected = command->add_option(
        "--expected", args->expected, help(Text::tr("Folder with the expected pictures and their facts")));
    auto* const report = command->add_option(
        "--report", args->report, help(Text::tr("Folder for the report and the pictures that differ")));
    for (CLI::Option* const folder : {expected, report}) folder->type_name("DIR");
    if (one.deed != SuiteDeed::List) expected->required();
    if (one.deed == SuiteDeed::Run) report->required();
    command->add_option("--only", args->only, help(Text::tr("Only this view; may be repeated")))
        ->allow_extra_args(false);
    command->add_option("--jobs", args->jobs, help(Text::tr("Number of views drawn at the same time")))
        ->capture_default_str();
    addRobot(*command, *args, Text::tr("Robot for views that name none (or MAPWRIGHT_ROBOT)"));
    commands.add(command, [args, deed = one.deed](const Invocation& before) {
      return suiteCommand(deed, *args, before);
    });
  }
}

}  // namespace mapwright::app
