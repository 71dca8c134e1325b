// The walls of the house: what a room cannot include, and that docs/architecture.md says the same.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QtTest>

#include "test_program.h"

namespace test_walls {

namespace {

struct Room {
  QString name, folder, prefix;
  QStringList uses, include_folders;
};

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QList<Room> roomsOfTheBuild() {
  QList<Room> rooms;
  const auto words = [](const QString& text) { return text.split(QLatin1Char(','), Qt::SkipEmptyParts); };
  for (const QString& line :
       QString::fromUtf8(contentOf(QStringLiteral(MAPWRIGHT_WALLS))).split(QLatin1Char('\n'))) {
    const QStringList parts = line.split(QLatin1Char('|'));
    if (parts.size() == 5) rooms << Room{parts[0], parts[1], parts[2], words(parts[3]), words(parts[4])};
  }
  return rooms;
}

/// The room's own headers, as others would write them.
QStringList headersOf(const Room& room, const QList<Room>& rooms) {
  QStringList headers;
  const QDir folder(QStringLiteral(MAPWRIGHT_SOURCES "/") + room.folder);
  QDirIterator it(folder.path(), {QStringLiteral("*.h")}, QDir::Files, QDirIterator::Subdirectories);
  while (it.hasNext()) {
    const QString inside = folder.relativeFilePath(it.next());
    const QString path = room.folder + QLatin1Char('/') + inside;
    const bool of_inner_room = std::any_of(rooms.begin(), rooms.end(), [&](const Room& other) {
      return other.folder.startsWith(room.folder + QLatin1Char('/')) &&
             path.startsWith(other.folder + QLatin1Char('/'));
    });
    // A program of its own, as the benchmarks are, keeps its headers to itself.
    const QString below = inside.section(QLatin1Char('/'), 0, 0);
    const bool of_program = below != inside && folder.exists(below + QStringLiteral("/CMakeLists.txt"));
    if (!of_inner_room && !of_program) headers << room.prefix + QLatin1Char('/') + inside;
  }
  return headers;
}

/// What the compiler says to `source` with the include folders of the room.
struct Compiled {
  int code = -1;
  QByteArray out, errors;
};
Compiled compile(const Room& room, const QByteArray& source, const QStringList& options) {
  QStringList arguments{QStringLiteral("-std=c++20"), QStringLiteral("-x"), QStringLiteral("c++")};
  arguments << options;
  for (const QString& folder : room.include_folders) arguments << QStringLiteral("-I") + folder;
  QProcess compiler;
  // An include in quotes is looked for beside the source first, and this source is wherever the compiler is.
  compiler.setWorkingDirectory(QFileInfo(QStringLiteral(MAPWRIGHT_WALLS)).absolutePath());
  compiler.start(QStringLiteral(MAPWRIGHT_COMPILER), arguments << QStringLiteral("-"));
  compiler.write(source);
  compiler.closeWriteChannel();
  if (!compiler.waitForFinished(120'000)) return {};
  return {compiler.exitCode(), compiler.readAllStandardOutput(), compiler.readAllStandardError()};
}

QStringList sorted(QStringList words) {
  words.sort();
  return words;
}

class TestWalls : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { QVERIFY(roomsOfTheBuild().size() >= 20); }
  void aRoomReachesEveryHeaderOfTheRoomsThatItNamesAndNoOther();
  void aForbiddenIncludeDoesNotCompile();
  void noFileStepsAroundTheWalls();
  void noTopicIsNamedWhereRobotsAreAlike();
  void aBackEndIsNamedOnlyWhereRobotsAreMade();
  void theDocumentTellsTheSameWalls();
  void thePictureShowsTheSameRooms();
  void noFeatureOfTheWindowKnowsAnother();
  void noControllerOfTheWindowKnowsAnother();
  void everyNumberIsTypedInOurOwnFields();
};

void TestWalls::aRoomReachesEveryHeaderOfTheRoomsThatItNamesAndNoOther() {
  const QList<Room> rooms = roomsOfTheBuild();
  for (const Room& room : rooms) {
    QByteArray source;
    for (const Room& other : rooms) {
      for (const QString& header : headersOf(other, rooms)) {
        source += "#if __has_include(\"" + header.toUtf8() + "\")\nreaches " + other.name.toUtf8() + ' ' +
                  header.toUtf8() + "\n#else\nmisses " + other.name.toUtf8() + ' ' + header.toUtf8() +
                  "\n#endif\n";
      }
    }
    const Compiled compiled = compile(room, source, {QStringLiteral("-E"), QStringLiteral("-P")});
    QVERIFY2(compiled.code == 0, compiled.errors.constData());
    for (const QByteArray& line : compiled.out.split('\n')) {
      const QList<QByteArray> words = line.split(' ');
      if (words.size() < 3) continue;
      const QString other = QString::fromUtf8(words[1]);
      const bool may = other == room.name || room.uses.contains(other);
      const bool does = words[0] == "reaches";
      QVERIFY2(may == does,
               qPrintable(QStringLiteral("%1 %2 %3")
                              .arg(room.name,
                                   may ? QStringLiteral("cannot include") : QStringLiteral("may not include"),
                                   QString::fromUtf8(line))));
    }
  }
}

void TestWalls::aForbiddenIncludeDoesNotCompile() {
  const QList<Room> rooms = roomsOfTheBuild();
  const auto named = [&](const char* name) {
    return *std::find_if(rooms.begin(), rooms.end(),
                         [&](const Room& room) { return room.name == QLatin1String(name); });
  };
  const QStringList check{QStringLiteral("-fsyntax-only")};
  // Through a neighbour, into a folder inside a neighbour's, and upwards.
  for (const auto& [room, header] :
       {std::pair{"aimdk", "disk/written_file.h"}, std::pair{"submap", "packed/unpack.h"},
        std::pair{"map", "robot/axbot/robot_urls.h"}, std::pair{"words", "map/problem.h"}}) {
    const Compiled refused = compile(named(room), QByteArray("#include \"") + header + "\"\n", check);
    QVERIFY2(refused.code != 0 && refused.errors.contains("No such file"), header);
  }
  const Compiled allowed = compile(named("words"), "#include \"words/figures.h\"\n", check);
  QVERIFY2(allowed.code == 0, allowed.errors.constData());
}

void TestWalls::noFileStepsAroundTheWalls() {
  static const QRegularExpression upwards(QStringLiteral(R"(#\s*include\s*["<][^">]*\.\./)"));
  for (const char* top : {"src", "ui", "app"}) {
    QDirIterator it(QStringLiteral(MAPWRIGHT_SOURCES "/") + QLatin1String(top),
                    {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) {
      const QString path = it.next();
      QVERIFY2(!QString::fromUtf8(contentOf(path)).contains(upwards), qPrintable(path));
    }
  }
}

void TestWalls::noFeatureOfTheWindowKnowsAnother() {
  const QSet<QString> below{QStringLiteral("ui_scene"),     QStringLiteral("ui_shot"),
                            QStringLiteral("ui_reporting"), QStringLiteral("ui_kit"),
                            QStringLiteral("ui_view"),      QStringLiteral("ui_shell"),
                            QStringLiteral("ui_carry")};
  int features = 0;
  for (const Room& room : roomsOfTheBuild()) {
    if (!room.name.startsWith(QLatin1String("ui_")) || room.name == QLatin1String("ui_window")) continue;
    if (!below.contains(room.name)) ++features;
    for (const QString& used : room.uses) {
      QVERIFY2(!used.startsWith(QLatin1String("ui_")) || below.contains(used),
               qPrintable(room.name + QStringLiteral(" uses ") + used));
    }
  }
  QVERIFY(features >= 12);
}

void TestWalls::noControllerOfTheWindowKnowsAnother() {
  const QDir ui(QStringLiteral(MAPWRIGHT_SOURCES "/ui"));
  // In the rooms below all features there are bases of controllers (the editors').
  static const QRegularExpression kOfOne(
      QStringLiteral("#include \"ui/(?!kit/|view/|shell/)\\w+/(\\w+)_controller\\.h\""));
  QDirIterator it(ui.path(), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                  QDirIterator::Subdirectories);
  QSet<QString> controllers;
  while (it.hasNext()) {
    const QString path = it.next();
    const QFileInfo file(path);
    auto matches = kOfOne.globalMatch(QString::fromUtf8(contentOf(path)));
    while (matches.hasNext()) {
      const QString name = matches.next().captured(1);
      controllers << name;
      const bool knows_all = file.fileName() == QLatin1String("main_window.cpp");
      QVERIFY2(knows_all || !file.baseName().endsWith(QLatin1String("_controller")) ||
                   file.baseName() == name + QLatin1String("_controller"),
               qPrintable(path + QStringLiteral(" knows ") + name));
    }
  }
  QVERIFY(controllers.size() >= 12);
}

void TestWalls::everyNumberIsTypedInOurOwnFields() {
  static const QRegularExpression kMade(
      QStringLiteral("new Q(Double)?SpinBox|Q(Double)?SpinBox \\w+[;({]|QInputDialog::get(Int|Double)"));
  QDirIterator it(QStringLiteral(MAPWRIGHT_SOURCES "/ui"), {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                  QDir::Files, QDirIterator::Subdirectories);
  while (it.hasNext()) {
    const QString path = it.next();
    QVERIFY2(!QString::fromUtf8(contentOf(path)).contains(kMade), qPrintable(path));
  }
}

void TestWalls::noTopicIsNamedWhereRobotsAreAlike() {
  const QString sources = QStringLiteral(MAPWRIGHT_SOURCES "/");
  static const QRegularExpression literal(QStringLiteral("\"(/[a-z0-9_/]+)\""));
  QSet<QString> topics;
  const QString table =
      QString::fromUtf8(contentOf(sources + QStringLiteral("src/robot/axbot/topic_table.cpp")));
  for (auto it = literal.globalMatch(table); it.hasNext();) topics << it.next().captured(1);
  QVERIFY(topics.contains(QStringLiteral("/map_v2")) && topics.size() > 30);
  for (const char* top : {"ui", "src/session", "src/sentences", "app"}) {
    QDirIterator it(sources + QLatin1String(top), {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                    QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
      const QString path = it.next();
      if (path.contains(QLatin1String("/app/bench/"))) continue;  // plays a robot
      const QString text = QString::fromUtf8(contentOf(path));
      for (auto found = literal.globalMatch(text); found.hasNext();) {
        const QString name = found.next().captured(1);
        QVERIFY2(!topics.contains(name), qPrintable(path + QLatin1String(": ") + name));
      }
    }
  }
}

void TestWalls::aBackEndIsNamedOnlyWhereRobotsAreMade() {
  const QString kRobots = QStringLiteral("src/robot/");
  QStringList back_ends, users;
  for (const Room& room : roomsOfTheBuild()) {
    if (room.folder.startsWith(kRobots)) back_ends << room.name;
  }
  QCOMPARE(sorted(back_ends).join(QLatin1Char(' ')),
           QStringLiteral("aimdk axbot files recorded ros state_file wire"));
  back_ends << QStringLiteral("simulator");
  for (const Room& room : roomsOfTheBuild()) {
    for (const QString& used : room.uses) {
      if (back_ends.contains(used) && !room.folder.startsWith(kRobots))
        users << room.folder + QLatin1Char('/') + used;
    }
  }
  // Excerpts of a recording are written as it is read.
  QCOMPARE(sorted(users).join(QLatin1Char(' ')),
           QStringLiteral("app/aimdk app/axbot app/files app/recorded app/ros app/simulator app/state_file "
                          "app/wire src/excerpt/recorded"));
  // In `app` one file makes all of them, and one command runs the simulator.
  const QRegularExpression named(
      QStringLiteral("\\brobot(/|::)(%1)\\b").arg(back_ends.join(QLatin1Char('|'))));
  const QRegularExpression simulator(QStringLiteral("#include \"simulator/"));
  const QDir app(QStringLiteral(MAPWRIGHT_SOURCES "/app"));
  for (const QString& file : app.entryList({QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files)) {
    const QString text = QString::fromUtf8(contentOf(app.filePath(file)));
    const bool makes_robots = file.startsWith(QLatin1String("robot_factory."));
    const bool simulates = makes_robots || file == QLatin1String("simulate.cpp");
    QVERIFY2(makes_robots || !text.contains(named), qPrintable(file));
    QVERIFY2(simulates || !text.contains(simulator), qPrintable(file));
  }
}

/// The first sentence of a room's README.md.
QString heldBy(const QString& folder) {
  const QByteArray text =
      contentOf(QStringLiteral(MAPWRIGHT_SOURCES "/") + folder + QStringLiteral("/README.md"));
  const QString paragraph = QString::fromUtf8(text).section(QStringLiteral("\n\n"), 1, 1).simplified();
  return paragraph.section(QStringLiteral(". "), 0, 0).remove(QRegularExpression(QStringLiteral("\\.$")));
}

void TestWalls::theDocumentTellsTheSameWalls() {
  QMap<QString, QPair<QString, QStringList>> told;
  const QByteArray document = contentOf(QStringLiteral(MAPWRIGHT_SOURCES "/docs/architecture.md"));
  for (const QString& line : QString::fromUtf8(document).split(QLatin1Char('\n'))) {
    static const QRegularExpression row(QStringLiteral(R"(^\| `([a-z/]+)` \| (.*) \| ([a-z_, -]+) \|$)"));
    const auto match = row.match(line);
    if (!match.hasMatch()) continue;
    QStringList uses = match.captured(3).split(QStringLiteral(", "));
    uses.removeAll(QStringLiteral("-"));
    told[match.captured(1)] = {match.captured(2), uses};
  }
  for (const Room& room : roomsOfTheBuild()) {
    QVERIFY2(told.contains(room.folder), qPrintable(room.folder + QLatin1String(": run docs/draw-rooms")));
    const auto [holds, uses] = told.take(room.folder);
    QCOMPARE(room.folder + QLatin1Char(' ') + holds, room.folder + QLatin1Char(' ') + heldBy(room.folder));
    QCOMPARE(room.folder + QLatin1Char(' ') + sorted(uses).join(QLatin1Char(' ')),
             room.folder + QLatin1Char(' ') + sorted(room.uses).join(QLatin1Char(' ')));
  }
  QCOMPARE(told.keys(), QStringList{QStringLiteral("proto")});  // made otherwise
}

void TestWalls::thePictureShowsTheSameRooms() {
  QMap<QString, QString> drawn;
  const QByteArray picture = contentOf(QStringLiteral(MAPWRIGHT_SOURCES "/docs/rooms.svg"));
  static const QRegularExpression drawn_room(QStringLiteral("data-room=\"(\\w+)\" data-uses=\"([a-z_ ]*)\""));
  for (auto it = drawn_room.globalMatch(QString::fromUtf8(picture)); it.hasNext();) {
    const auto match = it.next();
    drawn[match.captured(1)] = match.captured(2);
  }
  QStringList used;
  for (const Room& room : roomsOfTheBuild()) {
    QVERIFY2(drawn.contains(room.name), qPrintable(room.name + QLatin1String(": run docs/draw-rooms")));
    used << room.uses;
    QCOMPARE(room.name + QLatin1Char(' ') + drawn.take(room.name),
             room.name + QLatin1Char(' ') + sorted(room.uses).join(QLatin1Char(' ')));
  }
  for (const QString& name : std::as_const(used))
    drawn.remove(name);  // made otherwise: the messages of proto
  QCOMPARE(drawn.keys().join(QLatin1Char(' ')), QString());
}

}  // namespace

}  // namespace test_walls

MAPWRIGHT_TEST(test_walls, TestWalls, Nothing)
#include "test_walls.moc"
