// What the manual says of commands, JSON and menus is so, and what --help says agrees with itself.
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTest>

#include "program.h"
#include "shown_window.h"
#include "test_program.h"

namespace test_manual {

using mapwright::tests::Ended;
using mapwright::tests::Program;

namespace {

QString pageOf(const char* path) {
  QFile file(QStringLiteral(MAPWRIGHT_SOURCES "/") + QLatin1String(path));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
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
    static const QRegularExpression heading(QStringLiteral("^([A-Z][A-Za-z]+):$"));
    static const QRegularExpression row(QStringLiteral("^  (\\S+)(.*)$"));
    if (const auto match = heading.match(line); match.hasMatch()) within = match.captured(1);
    const auto match = row.match(line);
    const bool begins = match.hasMatch() && !line.startsWith(QLatin1String("   "));
    if (within == QLatin1String("Subcommands") && begins) help.subcommands << match.captured(1);
    if (within != QLatin1String("Options")) continue;
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
  void initTestCase() {
    look({});
    QVERIFY(helps_.size() > 60);
    QVERIFY(helps_[QStringLiteral("maps list")].has(QStringLiteral("--json")));
  }

  void whatPagesCallIsThere() {
    QStringList unknown;
    int lines = 0;
    for (const char* page : {"README.md", "CONTRIBUTING.md", "docs/command-line.md", "docs/maps-in-ci.md",
                             "docs/window.md", "docs/same-bytes.md"}) {
      for (const QString& line : commandLines(pageOf(page))) {
        unknown << unknownIn(line);
        ++lines;
      }
    }
    QVERIFY(lines > 100);
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QLatin1Char('\n'))));
  }

  void everyCommandAndOptionIsInTheManual() {
    const QString manual = pageOf("docs/command-line.md");
    QSet<QString> known{QStringLiteral("--help"), QStringLiteral("--help-all")};
    for (const QString& option : matchesOf("(--[a-z][a-z0-9-]*)", manual)) known << option;
    QStringList called;
    for (const QString& line : commandLines(manual)) called << commandsOf(line);
    QStringList lacking;
    for (auto it = helps_.begin(); it != helps_.end(); ++it) {
      if (it->subcommands.isEmpty() && !called.contains(it.key()) &&
          !manual.contains(QStringLiteral("`mapwright %1").arg(it.key())) &&
          !manual.contains(QStringLiteral("## mapwright %1").arg(it.key())))
        lacking << it.key();
      // Its faults are in its own help.
      if (it.key() == QLatin1String("simulate")) continue;
      for (const Option& option : it->options) {
        const bool has_long = option.names.back().startsWith(QLatin1String("--"));
        if (has_long && option.names.back() != QLatin1String("--output") &&
            !known.contains(option.names.back()))
          lacking << it.key() + QLatin1Char(' ') + option.names.back();
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

  void jsonHasTheMembersThatTheManualNames_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("before");  // in the manual, right before its members
    const auto row = [](const char* line, const char* before) {
      QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(before);
    };
    row("maps set-pose --at 1,1,0 --robot demo: --json", "distance from the one that was set; `--json`: ");
    row("waypoints list --robot map.yaml --json", "`--json` of `list`: ");
    row("waypoints plan places.csv --robot map.yaml --json", "In `--json` that is, as of `plan`,\n  ");
    row("overlays plan walls.geojson --base walls.geojson --robot map.yaml --json",
        "`--json` of `set` and `plan`: ");
    row("overlays validate flawed.geojson --json",
        "line and the column are named). What lies on the map is only "
        "checked with a robot or a map file (`--robot hall.yaml`).\n  ");
    row("overlays history list --json", "  `list --json`: ");
    row("bags list --robot demo: --json", "are refused (2).\n\n- `list --json`: ");
    row("compare one.png one.png --json", "2: a file cannot be read. `--json`:\n");
    row("topics list --robot demo: --json", "their types unknown. `--json`: ");
    row("maps list --robot demo: --json", "`list --json`: each map's ");
  }
  void jsonHasTheMembersThatTheManualNames() {
    QFETCH(QString, line);
    QFETCH(QString, before);
    const QString manual = pageOf("docs/command-line.md");
    const qsizetype at = manual.indexOf(before);
    QVERIFY(at >= 0);
    // Up to the next sentence; the members of members are left out.
    QString shape = manual.mid(at + before.size(), 700);
    const bool spans = shape.startsWith(QLatin1String("`{")) || shape.startsWith(QLatin1String("`["));
    QStringList members;
    if (spans) {
      shape = shape.mid(1).section(QLatin1Char('`'), 0, 0);
      int depth = shape.startsWith(QLatin1Char('[')) ? -1 : 0, list = 0;
      for (qsizetype i = shape.startsWith(QLatin1Char('[')) ? 1 : 0; i < shape.size(); ++i) {
        const QChar c = shape[i];
        if (c == QLatin1Char('{')) ++depth;
        if (c == QLatin1Char('}')) --depth;
        if (c == QLatin1Char('[')) ++list;
        if (c == QLatin1Char(']')) --list;
        const int top = shape.startsWith(QLatin1Char('[')) ? 0 : 1;
        if (c != QLatin1Char('"') || depth != top || list > 0) continue;
        const qsizetype end = shape.indexOf(QLatin1Char('"'), i + 1);
        const QString word = shape.mid(i + 1, end - i - 1);
        const QString behind = shape.mid(end + 1, 1);
        const bool is_value = i > 0 && shape[i - 1] == QLatin1Char(':');
        const bool optional = shape.mid(end + 1).section(QLatin1Char('"'), 0, 0).contains(QLatin1Char('?'));
        if (!is_value && !optional && !behind.isEmpty()) members << word;
        i = end;
      }
    } else {
      shape.remove(QRegularExpression(QStringLiteral("(?<=` )\\{[^{}]*\\}")));
      members = matchesOf("`([a-z_]+)`",
                          shape.section(QLatin1Char(';'), 0, 0).section(QStringLiteral(".\n"), 0, 0));
      if (line.startsWith(QLatin1String("maps list"))) members = QStringList{QStringLiteral("grid")};
    }
    QVERIFY2(!members.isEmpty(), qPrintable(shape));
    makeSources();
    const Ended ended = program_.run(line.split(QLatin1Char(' ')));
    const QJsonDocument document = QJsonDocument::fromJson(ended.out.toUtf8());
    QVERIFY2(!document.isNull(), qPrintable(ended.err));
    const QList<QJsonValue> rows =
        document.isArray() ? valuesOf(document.array()) : QList<QJsonValue>{document.object()};
    QVERIFY2(!rows.isEmpty(), qPrintable(ended.out + ended.err));
    for (const QJsonValue& row : rows) {
      for (const QString& member : members)
        QVERIFY2(row.toObject().contains(member), qPrintable(member + QLatin1Char('\n') + ended.out));
    }
  }

  void menusAreWhereTheManualSays() {
    mapwright::test::ShownWindow shown({});
    QStringList paths;
    listMenus(*shown.window().menuBar(), {}, paths);
    QVERIFY(paths.size() > 50);
    QStringList lacking;
    for (const char* page :
         {"docs/window.md", "docs/command-line.md", "docs/maps-in-ci.md", "CONTRIBUTING.md"}) {
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
  static QList<QJsonValue> valuesOf(const QJsonArray& array) {
    QList<QJsonValue> values;
    for (const QJsonValue& value : array) values << value;
    return values;
  }
  void makeSources() const {
    program_.put("map.pgm", QByteArray("P5\n64 64\n255\n") + QByteArray(64 * 64, '\xfe'));
    program_.put("map.yaml",
                 "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
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
