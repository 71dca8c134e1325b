// What the manual says of commands, JSON and menus is so, and what --help says agrees with itself.
#include <algorithm>

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include "../pbstream/state_bytes.h"
#include "program.h"
#include "shown_window.h"
#include "test_program.h"

namespace test_manual {

using mapwright::tests::Ended;
using mapwright::tests::Program;

namespace {

QString pageOf(const QString& path) {
  QFile file(QStringLiteral(MAPWRIGHT_SOURCES "/") + path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}
QString pageOf(const char* path) { return pageOf(QString::fromLatin1(path)); }

/// These pages and those of docs/tasks.
QStringList withTasks(std::initializer_list<const char*> pages) {
  QStringList all;
  for (const char* page : pages) all << QString::fromLatin1(page);
  const QString folder = QStringLiteral("docs/tasks/");
  for (const QString& name : QDir(QStringLiteral(MAPWRIGHT_SOURCES "/") + folder).entryList(QDir::Files))
    all << folder + name;
  return all;
}

QStringList matchesOf(const char* pattern, const QString& text) {
  QStringList all;
  const QRegularExpression wanted(QString::fromLatin1(pattern), QRegularExpression::MultilineOption);
  for (auto it = wanted.globalMatch(text); it.hasNext();) all << it.next().captured(1);
  return all;
}

struct Option {
  QStringList names;
  QString type, about;  // the type is empty of a switch
};

struct Help {
  QString text;
  QStringList subcommands;
  QList<Option> options;
  bool has(const QString& name) const {
    return std::any_of(options.begin(), options.end(),
                       [&](const Option& option) { return option.names.contains(name); });
  }
};

Help helpFrom(const QString& text) {
  Help help{text, {}, {}};
  QString within;
  for (const QString& line : text.split(QLatin1Char('\n'))) {
    static const QRegularExpression heading(QStringLiteral("^([A-Z][^:]+):$"));
    static const QStringList other{QString(), QStringLiteral("Subcommands"), QStringLiteral("Positionals"),
                                   QStringLiteral("Example"), QStringLiteral("Examples")};
    static const QRegularExpression row(QStringLiteral("^  (\\S+)(.*)$"));
    if (const auto match = heading.match(line); match.hasMatch()) within = match.captured(1);
    const auto match = row.match(line);
    const bool begins = match.hasMatch() && !line.startsWith(QLatin1String("   "));
    if (within == QLatin1String("Subcommands") && begins) help.subcommands << match.captured(1);
    if (other.contains(within)) continue;  // options may have groups with headings of their own
    if (begins) {
      Option option;
      option.names = match.captured(1).section(QLatin1Char('{'), 0, 0).split(QLatin1Char(','));
      option.type = line.mid(0, 30).trimmed().section(QLatin1Char(' '), 1);
      option.about = line.mid(30);
      if (line.size() > 30 && line[29] != QLatin1Char(' ')) {
        option.type = line.trimmed().section(QLatin1Char(' '), 1);
        option.about.clear();
      }
      help.options << option;
    } else if (!help.options.isEmpty() && line.startsWith(QString(30, QLatin1Char(' ')))) {
      help.options.back().about += line.mid(30);
    }
  }
  return help;
}

/// The command lines of a page: "mapwright maps list --robot demo:", without remarks behind them.
QStringList commandLines(const QString& page) {
  QStringList lines;
  bool goes_on = false;
  for (const QString& line : page.split(QLatin1Char('\n'))) {
    static const QRegularExpression begin(QStringLiteral("^ {2,}(?:\\./run|mapwright) (.*)$"));
    static const QRegularExpression remark(QStringLiteral("\\s{3,}.*$|\\s+#.*$"));
    const auto match = begin.match(line);
    if (match.hasMatch()) {
      lines << match.captured(1).remove(remark);
    } else if (goes_on && line.startsWith(QLatin1String("        "))) {
      lines.back() += QLatin1Char(' ') + line.trimmed().remove(remark);
    }
    goes_on = match.hasMatch() || (goes_on && line.startsWith(QLatin1String("        ")));
  }
  return lines;
}

}  // namespace

class ManualTest : public QObject {
  Q_OBJECT
  Program program_;
  QMap<QString, Help> helps_;  // by the command: "", "maps", "maps list"

  void look(const QStringList& command) {
    const Ended ended = program_.run(command + QStringList{QStringLiteral("--help")});
    QCOMPARE(ended.code, 0);
    const Help help = helpFrom(ended.out);
    helps_[command.join(QLatin1Char(' '))] = help;
    for (const QString& subcommand : help.subcommands) {
      if (subcommand != QLatin1String("bench")) look(command + QStringList{subcommand});
    }
  }
  /// The commands that a line calls ("archive|unarchive" are two), and what is wrong with its options.
  QStringList commandsOf(const QString& line) const {
    QStringList commands{QString()};
    for (const QString& word : line.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
      QStringList next;
      for (const QString& command : commands) {
        for (const QString& either : word.split(QLatin1Char('|'))) {
          if (helps_[command].subcommands.contains(either))
            next << (command.isEmpty() ? either : command + QLatin1Char(' ') + either);
        }
      }
      if (next.isEmpty()) break;
      commands = next;
    }
    return commands;
  }
  QStringList unknownIn(const QString& line) const {
    QStringList unknown;
    for (const QString& command : commandsOf(line)) {
      if (command.startsWith(QLatin1String("bench"))) continue;
      for (const QString& option : matchesOf("(?:^|[ \\[(|])(--?[a-z][a-z0-9-]*)", line)) {
        if (!helps_[command].has(option) && !helps_[QString()].has(option))
          unknown << QStringLiteral("%1: no %2 (%3)").arg(command, option, line);
      }
    }
    return unknown;
  }

 private Q_SLOTS:
  void cleanupTestCase() {
    robot_.terminate();
    if (robot_.state() != QProcess::NotRunning) robot_.waitForFinished();
  }
  void initTestCase() {
    look({});
    QVERIFY(helps_.size() > 60);
    QVERIFY(helps_[QStringLiteral("maps list")].has(QStringLiteral("--json")));
  }

  void whatPagesCallIsThere() {
    QStringList unknown;
    int lines = 0;
    for (const QString& page :
         withTasks({"README.md", "README.zh-CN.md", "CONTRIBUTING.md", "docs/command-line.md",
                    "docs/files.md", "docs/getting-started.md", "docs/getting-started.zh-CN.md",
                    "docs/json.md", "docs/maps-in-ci.md", "docs/same-bytes.md", "docs/simulator.md",
                    "docs/troubleshooting.md", "docs/window.md"})) {
      const QString text = pageOf(page);
      QVERIFY2(!text.isEmpty(), qPrintable(page));
      for (const QString& line : commandLines(text) + matchesOf("`mapwright ([^`\n]+)`", text)) {
        unknown << unknownIn(line);
        ++lines;
      }
    }
    QVERIFY(lines > 100);
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QLatin1Char('\n'))));
  }

  void everyLayerIsInTheManual() {
    const QStringList listed =
        matchesOf("separated by commas:([a-z,\\s-]+); or all", helps_[QStringLiteral("snapshot")].text);
    QCOMPARE(listed.size(), 1);
    const QStringList names = listed[0].simplified().remove(QLatin1Char(' ')).split(QLatin1Char(','));
    QVERIFY(names.size() > 30);
    const QString manual = pageOf("docs/command-line.md");
    for (const QString& name : names)
      QVERIFY2(manual.contains(QStringLiteral("`%1`").arg(name)), qPrintable(name));
  }

  void everyCommandAndOptionIsInTheManual() {
    const QString manual = pageOf("docs/command-line.md");
    const QStringList known = matchesOf("(--[a-z][a-z0-9-]*)", manual);
    const QStringList simulated = matchesOf("(--[a-z][a-z0-9-]*)", pageOf("docs/simulator.md"));
    QStringList called;
    for (const QString& line : commandLines(manual)) called << commandsOf(line);
    QStringList lacking;
    for (auto it = helps_.begin(); it != helps_.end(); ++it) {
      if (it->subcommands.isEmpty() && !called.contains(it.key()) &&
          !manual.contains(QStringLiteral("`mapwright %1").arg(it.key())) &&
          !manual.contains(QStringLiteral("## mapwright %1").arg(it.key())))
        lacking << it.key();
      const QStringList& named = it.key() == QLatin1String("simulate") ? simulated : known;
      for (const Option& option : it->options) {
        const QString name = option.names.back();
        if (name.startsWith(QLatin1String("--")) && !name.startsWith(QLatin1String("--help")) &&
            name != QLatin1String("--output") && !named.contains(name))
          lacking << it.key() + QLatin1Char(' ') + name;
      }
    }
    QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join(QLatin1Char('\n'))));
  }

  void everyCommandHasAnExampleOfItself() {
    QStringList wrong;
    for (auto it = helps_.begin(); it != helps_.end(); ++it) {
      if (!it.key().isEmpty() && !it->subcommands.isEmpty()) continue;
      const QString examples = it->text.section(QStringLiteral("\nExample"), 1);
      const QStringList lines = commandLines(examples);
      if (lines.isEmpty()) wrong << it.key() + QStringLiteral(" has none");
      for (const QString& line : lines) {
        wrong << unknownIn(line);
        if (commandsOf(line) != QStringList{it.key()}) wrong << it.key() + QStringLiteral(": ") + line;
        // Everything that is required is there.
        for (const Option& option : it->options) {
          if (!option.type.contains(QLatin1String("REQUIRED"))) continue;
          const bool given = std::any_of(option.names.begin(), option.names.end(), [&](const QString& name) {
            return line.split(QLatin1Char(' ')).contains(name);
          });
          if (!given) wrong << line + QStringLiteral(" lacks ") + option.names.back();
        }
      }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
  }

  void theTypeOfAnOptionIsWhatItsTextSays() {
    static const QRegularExpression seconds(
        QStringLiteral("\\b(seconds|[Mm]etres per|degrees\\b(?! or)|closer than this|Radius of)"));
    static const QRegularExpression file(
        QStringLiteral("^(GeoJSON file|PEM file|File with|Output file|The (PNG|HTML file|MCAP file))"));
    QStringList wrong;
    for (auto it = helps_.begin(); it != helps_.end(); ++it) {
      for (const Option& option : it->options) {
        const auto says = [&](const char* word) { return option.type.startsWith(QLatin1String(word)); };
        const QString row =
            QStringLiteral("%1 %2 %3: %4").arg(it.key(), option.names.back(), option.type, option.about);
        if (option.type.isEmpty()) continue;
        if (option.about.contains(file) && !says("FILE") && !says("ADDRESS FILE")) wrong << row;
        if (option.about.contains(QLatin1String("separated by commas")) && !says("TEXT")) wrong << row;
        if (option.about.contains(QLatin1String("X,Y")) && !says("TEXT")) wrong << row;
        const QString kind = option.type.section(QLatin1Char(':'), 0, 0);
        const QString kept_in =
            option.type.section(QLatin1Char(':'), 1).section(QLatin1String(" in ["), 0, 0);
        if (option.type.contains(QLatin1String(" in [")) && kind != kept_in) wrong << row;
        if (option.about.contains(seconds) && !says("FLOAT") && !says("INT") && !says("UINT") &&
            !says("TIME") && !option.about.contains(QLatin1String("X,Y")) &&
            !option.about.contains(QLatin1String(", or ")))
          wrong << row;
      }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
  }

  /// By its whole name, or by its last word below a heading of its group.
  void allJsonIsInTheManual() {
    const QStringList parts = pageOf("docs/json.md").split(QStringLiteral("\n#"));
    QStringList lacking;
    for (auto it = helps_.begin(); it != helps_.end(); ++it) {
      if (!it->has(QStringLiteral("--json"))) continue;
      const QString whole =
          QStringLiteral("`%1`").arg(it.key().isEmpty() ? QStringLiteral("--version") : it.key());
      const QString group = QLatin1Char('`') + it.key().section(QLatin1Char(' '), 0, -2) + QLatin1Char(' ');
      const QString last = QStringLiteral("`%1`").arg(it.key().section(QLatin1Char(' '), -1));
      if (std::none_of(parts.begin(), parts.end(), [&](const QString& part) {
            const QString heading = part.section(QLatin1Char('\n'), 0, 0);
            return part.contains(whole) || (heading.contains(group) && part.contains(last));
          }))
        lacking << it.key();
    }
    QVERIFY2(lacking.isEmpty(), qPrintable(lacking.join(QLatin1Char('\n'))));
  }

  /// docs/json.md has a table for each command: every member that is printed is in it, with its type, and
  /// what is not optional is printed.
  void jsonIsAsTheManualSays_data() {
    QTest::addColumn<QString>("heading");
    QTest::addColumn<QString>("line");
    const auto row = [](const char* heading, const char* line) {
      QTest::newRow(line) << QString::fromLatin1(heading) << QString::fromLatin1(line);
    };
    row("--version", "--version --json");
    row("maps list", "maps list --robot AXBOT --json");
    row("maps list", "maps list --robot map.yaml --json");
    row("maps current", "maps current --robot AXBOT --json");
    row("maps show", "maps show 1 --robot AXBOT --json");
    row("maps show", "maps show --robot AXBOT --json");
    row("maps diff", "maps diff map.yaml map.yaml --json");
    row("maps align", "maps align map.yaml map.yaml --json");
    row("maps set-pose", "maps set-pose --at 1,1,0 --robot AXBOT --json");
    row("maps locate", "maps locate --robot AXBOT --json");
    row("maps download", "maps download 1 -o folder --force --robot AXBOT --json");
    row("maps upload", "maps upload folder --as-new --robot AXBOT --json");
    row("snapshot", "snapshot -o submaps.png --robot AXBOT --json");
    row("snapshot", "snapshot --mode whole -o whole.png --robot AXBOT --json");
    row("snapshot", "snapshot --region 0,0,5,5 -o region.png --robot REP130 --json");
    row("compare", "compare one.png one.png --json");
    row("compare", "compare one.png map.pgm --json");
    row("waypoints list", "waypoints list --warnings --robot map.yaml --json");
    row("waypoints get", "waypoints get Dock --robot map.yaml --json");
    row("waypoints plan", "waypoints plan places.csv --robot map.yaml --json");
    row("waypoints plan", "waypoints move Dock --at 2,2,0 --dry-run --robot map.yaml --json");
    row("waypoints import", "waypoints import places.csv --robot map.yaml --json");
    row("waypoints carry",
        "waypoints carry --from map.yaml --to map.yaml --transform 0,0,0 --dry-run --json");
    row("overlays plan", "overlays plan walls.geojson --base flawed.geojson --robot map.yaml --json");
    row("overlays set", "overlays set walls.geojson --base walls.geojson --robot map.yaml --json");
    row("overlays validate", "overlays validate flawed.geojson --json");
    row("overlays history list", "overlays history list --json");
    row("overlays history show", "overlays history show 1 --json");
    row("bags list", "bags list --robot AXBOT --json");
    row("record", "record --robot AXBOT --duration 1 -o run.mcap --force --json");
    row("maps rehearse", "maps rehearse map.yaml run.mcap --json");
    row("bags info", "bags info run.mcap --json");
    row("bags state", "bags state run.mcap --at -0 --json");
    row("bags events", "bags events run.mcap --json");
    row("bags report", "bags report run.mcap --at -0 --against run.mcap@+0 -o report.html --json");
    row("bags export", "bags export run.mcap -o part.mcap --force --json");
    row("bags export", "bags export run.mcap -o part.jsonl --force --json");
    row("bags track", "bags track run.mcap -o track.csv --force --json");
    row("bags split", "bags split run.mcap -o part-%d.mcap --force --json");
    row("bags merge", "bags merge run.mcap -o merged.mcap --force --json");
    row("bags repair", "bags repair run.mcap -o repaired.mcap --force --json");
    row("bags film", "bags film run.mcap --from +0 --to +0 -o film-%d.png --json");
    row("topics list", "topics list --robot KABAM --json");
    row("topics hz", "topics hz /odom /nothing --seconds 1 --robot KABAM --json");
    row("probe", "probe ROSHOST --json");
    row("projections list", "projections list --robot REP130 --json");
    row("clouds export", "clouds export --all -o cloud.pcd --force --robot REP130 --json");
    row("slam info", "slam info --robot map.pbstream --json");
    row("slam closures", "slam closures --robot map.pbstream --json");
    row("slam closures", "slam closures --robot AXBOT --json");
    row("slam drop", "slam drop --robot map.pbstream --submap 0-1 -o less.pbstream --json");
    row("slam disagreement", "slam disagreement --robot AXBOT --json");
    row("slam coverage", "slam coverage --robot AXBOT --json");
    row("report", "slam coverage --robot AXBOT --report -");
    row("report", "maps show 1 --robot AXBOT --report -");
    row("report", "maps list --robot AXBOT --json --report -");
    row("report", "maps diff map.yaml map.yaml --report -");
    row("report", "waypoints plan places.csv --robot map.yaml --report -");
    row("report", "maps show nothing --robot map.yaml --report -");
  }
  void jsonIsAsTheManualSays() {
    QFETCH(QString, heading);
    QFETCH(QString, line);
    const Table table = tableOf(heading);
    QVERIFY2(!table.isEmpty(), qPrintable(heading));
    QVERIFY(makeSources());
    for (auto it = addresses_.begin(); it != addresses_.end(); ++it) line.replace(it.key(), it.value());
    const Ended ended = program_.run(line.split(QLatin1Char(' ')));
    const QJsonDocument document = QJsonDocument::fromJson(ended.out.toUtf8());
    QVERIFY2(!document.isNull(), qPrintable(ended.out + ended.err));
    const QJsonArray rows = document.isArray() ? document.array() : QJsonArray{document.object()};
    if (!line.startsWith(QLatin1String("bags events")))
      QVERIFY2(!rows.isEmpty(), qPrintable(ended.out + ended.err));
    QStringList wrong;
    for (const QJsonValue& row : rows) compare(table, row.toObject(), {}, wrong);
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n')) + QLatin1Char('\n') + ended.out));
  }

  /// The first table of docs/dependencies.md: what the program is made of.
  void librariesAreThoseOfTheDocuments() {
    QStringList documented;
    const QString table = pageOf("docs/dependencies.md").section(QLatin1String("\n## "), 0, 0);
    static const QRegularExpression row(QStringLiteral("^\\| ([^|]+) \\(([^()]+)\\) \\|"),
                                        QRegularExpression::MultilineOption);
    for (auto it = row.globalMatch(table); it.hasNext();) {
      const auto match = it.next();
      documented << match.captured(1) + QLatin1Char(' ') + match.captured(2);
    }
    const Ended ended = program_.run({QStringLiteral("--version"), QStringLiteral("--json")});
    QStringList said, unknown;
    for (const QJsonValue& library : ended.object()[QLatin1String("libraries")].toArray()) {
      said << library[QLatin1String("name")].toString() + QLatin1Char(' ') +
                  library[QLatin1String("licence")].toString();
      if (!library[QLatin1String("version")].isString()) unknown << said.back();
    }
    QCOMPARE(said, documented);
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QLatin1Char('\n'))));
  }

  /// docs/troubleshooting.md says what sentences mean: they are those that the program says.
  void sentencesAreThoseOfTheProgram() {
    const QString said = allTexts();
    QStringList unknown;
    int sentences = 0;
    QStringList cells = matchesOf("^\\| ([^|]+) \\|", pageOf("docs/troubleshooting.md"));
    for (const QString& cell : cells) {
      // Tables of other things begin otherwise; a symptom stands in italics.
      if (cell.startsWith(QLatin1Char('`')) || cell.startsWith(QLatin1Char('*')) || cell.size() < 12)
        continue;
      static const QRegularExpression filled_in(
          QStringLiteral("\\b(?:[A-Z_]{2,}|[ABN])\\b|\\d+|…|[()\";:.]"));
      for (const QString& part : cell.split(filled_in)) {
        const QString words = part.trimmed();
        if (words.size() >= 10 && !said.contains(words)) unknown << words;
      }
      ++sentences;
    }
    QVERIFY(sentences >= 30);
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QLatin1Char('\n'))));
  }

  void menusAreWhereTheManualSays() {
    mapwright::test::ShownWindow shown({});
    QStringList paths;
    listMenus(*shown.window().menuBar(), {}, paths);
    QVERIFY(paths.size() > 50);
    QStringList lacking;
    for (const QString& page :
         withTasks({"docs/window.md", "docs/command-line.md", "docs/files.md", "docs/getting-started.md",
                    "docs/maps-in-ci.md", "docs/troubleshooting.md", "CONTRIBUTING.md"})) {
      for (QString path : matchesOf("\\*((?:File|Edit|View|Map|Robot|Help) > [^*]+)\\*",
                                    pageOf(page).replace(QLatin1Char('\n'), QLatin1Char(' ')))) {
        path.remove(QStringLiteral("…"));
        if (!paths.contains(path)) lacking << path;
      }
    }
    QVERIFY2(lacking.isEmpty(),
             qPrintable(lacking.join(QLatin1Char('\n')) + QStringLiteral("\n\nThere are:\n") +
                        paths.join(QLatin1Char('\n'))));
  }

 private:
  using Table = QMap<QString, QString>;  // types, by the path of the member: "grid.size", "topics[].hz"

  QProcess robot_;
  QMap<QString, QString> addresses_;  // of the simulated robots, by the word that stands for each

  /// "report" is the one of commands that print something else.
  static Table tableOf(const QString& command) {
    static const QRegularExpression row(QStringLiteral("^\\| `([^`]+)` \\| ([^|]+) \\|"));
    Table table;
    bool within = false;
    for (const QString& line : pageOf("docs/json.md").split(QLatin1Char('\n'))) {
      if (line.startsWith(QLatin1Char('#')))
        within = command == QLatin1String("report")
                     ? line == QLatin1String("## Reports of other commands")
                     : line.contains(QLatin1Char('`') + command + QLatin1Char('`'));
      if (const auto match = row.match(line); within && match.hasMatch())
        table[match.captured(1)] = match.captured(2).trimmed();
    }
    return table;
  }
  static QString typeOf(const QJsonValue& value) {
    if (value.isNull()) return QStringLiteral("null");
    if (value.isBool()) return QStringLiteral("boolean");
    if (value.isString()) return QStringLiteral("text");
    if (value.isArray()) return QStringLiteral("list");
    if (value.isObject()) return QStringLiteral("object");
    const double number = value.toDouble();
    return number == std::floor(number) ? QStringLiteral("integer") : QStringLiteral("number");
  }
  static bool fits(const QString& type, const QString& wanted) {
    if (type == QLatin1String("null") && wanted.contains(QLatin1String(" or null"))) return true;
    const QString base = wanted.section(QLatin1Char(','), 0, 0).section(QLatin1Char(' '), 0, 0);
    return base == QLatin1String("any") || base == type ||
           (base == QLatin1String("number") && type == QLatin1String("integer"));
  }
  static void compare(const Table& table, const QJsonObject& object, const QString& above,
                      QStringList& wrong) {
    for (auto it = object.begin(); it != object.end(); ++it) {
      const QString path = above + it.key(), wanted = table.value(path);
      if (wanted.isEmpty()) {
        wrong << path + QStringLiteral(" is not in the table");
        continue;
      }
      if (!fits(typeOf(*it), wanted))
        wrong << QStringLiteral("%1 is %2, not %3").arg(path, typeOf(*it), wanted);
      if (wanted.startsWith(QLatin1String("any"))) continue;
      if (it->isObject()) compare(table, it->toObject(), path + QLatin1Char('.'), wrong);
      for (const QJsonValue& entry : it->toArray()) {
        if (entry.isObject()) compare(table, entry.toObject(), path + QStringLiteral("[]."), wrong);
      }
    }
    for (auto it = table.begin(); it != table.end(); ++it) {
      const QString member = it.key().mid(above.size());
      const bool here = it.key().startsWith(above) && !member.contains(QLatin1Char('.'));
      if (here && !it->contains(QLatin1String("optional")) && !object.contains(member))
        wrong << it.key() + QStringLiteral(" is missing");
    }
  }
  /// All texts in the sources, those over several lines as one, without quotation marks.
  static QString allTexts() {
    QString texts = pageOf("packaging/setup.sh");
    for (const char* top : {"app", "src", "ui"}) {
      QDirIterator it(QStringLiteral(MAPWRIGHT_SOURCES "/") + QLatin1String(top),
                      {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                      QDirIterator::Subdirectories);
      while (it.hasNext()) {
        QFile file(it.next());
        if (file.open(QIODevice::ReadOnly)) texts += QString::fromUtf8(file.readAll());
      }
    }
    static const QRegularExpression joint(QStringLiteral("\"\\s*\\n\\s*\""));
    return texts.remove(joint);
  }
  bool startRobots() {
    if (!addresses_.isEmpty()) return true;
    robot_.setProcessEnvironment(program_.environment());
    robot_.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                 {QStringLiteral("simulate"), QStringLiteral("--dispatcher"),
                  QStringLiteral("--dispatcher-edge"), QStringLiteral("20")});
    if (!QTest::qWaitFor([&] { return robot_.canReadLine(); }, 60'000)) return false;
    const QJsonObject said = QJsonDocument::fromJson(robot_.readLine()).object();
    const auto address = [&](const char* kind) { return said[QLatin1String(kind)].toString(); };
    addresses_ = {{QStringLiteral("AXBOT"), address("axbot")},
                  {QStringLiteral("KABAM"), address("kabam")},
                  {QStringLiteral("REP130"), address("rep130")},
                  {QStringLiteral("ROSHOST"), address("ros").section(QStringLiteral("//"), 1)}};
    return true;
  }
  bool makeSources() {
    program_.put("map.pgm", QByteArray("P5\n64 64\n255\n") + QByteArray(64 * 64, '\xfe'));
    program_.put("map.yaml",
                 "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
    program_.put("map.pbstream", QByteArray::fromStdString(mapwright::pbstream::tests::wholeFile()));
    program_.put("places.csv", "id,name,x,y,yaw_rad\nw1,Dock,1,1,0\nw2,Door,2,1,\n");
    program_.put(
        "map.waypoints.geojson",
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"id\":\"w1\",\"geometry\":"
        "{\"type\":\"Point\",\"coordinates\":[1,2]},\"properties\":{\"name\":\"Dock\"}}]}");
    const QByteArray wall =
        "{\"type\":\"Feature\",\"id\":\"a\",\"geometry\":{\"type\":\"LineString\",\"coordinates\":"
        "[[0,0],[1,1]]},\"properties\":{\"lineType\":\"2\"}}";
    program_.put("walls.geojson", "{\"type\":\"FeatureCollection\",\"features\":[" + wall + "]}");
    program_.put("map.overlays.geojson", "{\"type\":\"FeatureCollection\",\"features\":[" + wall + "]}");
    program_.put("flawed.geojson",
                 "{\"type\":\"FeatureCollection\",\"features\":[" + wall + "," + wall + "]}");
    program_.run({QStringLiteral("overlays"), QStringLiteral("get"), QStringLiteral("--robot"),
                  QStringLiteral("map.yaml"), QStringLiteral("--force"), QStringLiteral("-o"),
                  QStringLiteral("kept.geojson")});
    program_.run({QStringLiteral("snapshot"), QStringLiteral("--robot"), QStringLiteral("map.yaml"),
                  QStringLiteral("-o"), QStringLiteral("one.png")});
    return startRobots();
  }
  static void listMenus(const QWidget& menu, const QStringList& above, QStringList& paths) {
    for (const QAction* action : menu.actions()) {
      QString text = action->text().section(QLatin1Char('\t'), 0, 0);
      text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
      const QStringList path = above + QStringList{text};
      paths << path.join(QStringLiteral(" > "));
      if (const QMenu* sub = action->menu()) {
        Q_EMIT const_cast<QMenu*>(sub)->aboutToShow();
        listMenus(*sub, path, paths);
      }
    }
  }
};

}  // namespace test_manual

MAPWRIGHT_TEST(test_manual, ManualTest, Widgets)
#include "test_manual.moc"
