#include <cmath>
#include <cstdio>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "robot/faults.h"
#include "robot/files/faults.h"
#include "robot/files/file_robot.h"
#include "robot/files/local_maps.h"
#include "robot/files/read_map_yaml.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_file_robot {

using namespace mapwright;
using namespace mapwright::robot;
using namespace mapwright::robot::files;

namespace {

constexpr int kPatienceMs = 20'000;
const QByteArray kYaml =
    "image: office.pgm\nresolution: 0.05\norigin: [-10.0, -7.5, 0.3]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.25\n";

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  ask([&](Outcome<T> given) { answer = std::move(given); });
  if (answer || !QTest::qWaitFor([&] { return answer.has_value(); }, kPatienceMs)) {
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "not answered later"});
  }
  return *answer;
}

}  // namespace

class FileRobotTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;

  QString path(const QString& name) const { return folder_->filePath(name); }
  void write(const QString& name, const QByteArray& bytes) {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  std::unique_ptr<FileRobot> open(const QString& name, PicturePlace place = {}) {
    FileOptions options;
    options.path = name.isEmpty() ? folder_->path() : path(name);
    options.place = place;
    options.settle = std::chrono::milliseconds(1);
    auto robot = std::make_unique<FileRobot>(QStringLiteral("file:test"), options);
    robot->connectToRobot();
    // Connecting takes as long as the disk does, but never on this thread.
    if (robot->connection().phase != ConnectionPhase::Connecting) return nullptr;
    const auto looked = [&] { return robot->connection().phase != ConnectionPhase::Connecting; };
    return QTest::qWaitFor(looked, kPatienceMs) ? std::move(robot) : nullptr;
  }
  static Outcome<map::WholeMap> fetch(FileRobot& robot, const std::string& id = {}) {
    return answerTo<map::WholeMap>([&](auto reply) {
      robot.wholeMapSource()->fetch({map::MapKind::File, id}, reply);
    });
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aRosMapIsRead() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5 1 1 255 x");
    const auto robot = open(QStringLiteral("office.yaml"));
    QCOMPARE(robot->connection().phase, ConnectionPhase::Online);
    const auto map = fetch(*robot);
    QVERIFY2(map.has_value(), map ? "" : sentences::sentenceOf(map.error()).c_str());
    QCOMPARE(QString::fromStdString(map->path), path(QStringLiteral("office.pgm")));
    QVERIFY(!map->bytes);
    QCOMPARE(map->grid, (map::GridReference{0, 0, 0.05, {-10, -7.5, 0.3}}));
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Trinary);
    QCOMPARE(map->reading.free_thresh, 0.25);
    QVERIFY(map->notes.empty() && !map->fingerprint.empty());
    const auto list =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot->mapCatalogue()->list(reply); });
    QCOMPARE(list->size(), std::size_t(1));
    QCOMPARE(list->at(0).key, (map::MapKey{map::MapKind::File, {}}));
    QVERIFY(list->at(0).grid.has_value());
  }

  void mapsHaveThumbnailsThatAreMadeHere() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), QByteArray("P5 4 2 255\n") + QByteArray(8, char(254)));
    write(QStringLiteral("broken.png"), "no picture");
    const auto robot = open({});
    const auto thumbnail = [&](const char* id) {
      return answerTo<std::string>([&](auto reply) {
        robot->mapCatalogue()->thumbnail({map::MapKind::File, id}, reply);
      });
    };
    const auto list =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot->mapCatalogue()->list(reply); });
    for (const map::CatalogueEntry& entry : *list) QVERIFY2(entry.has_thumbnail, entry.name.c_str());
    const auto picture = thumbnail("office.yaml");
    QVERIFY2(picture && picture->starts_with("P5\n4 2\n"), picture ? picture->c_str() : "none");
    const auto none = thumbnail("broken.png");
    QVERIFY(!none);
    QVERIFY2(sentences::sentenceOf(none.error()).ends_with('.'), sentences::sentenceOf(none.error()).c_str());
    QVERIFY(!thumbnail("gone.png"));
  }

  void aPictureIsListedUnderTheYamlThatNamesIt() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office-2.yaml"), kYaml);  // the same picture, read otherwise
    write(QStringLiteral("office.pgm"), QByteArray("P5 4 2 255\n") + QByteArray(8, char(254)));
    write(QStringLiteral("plan.png"), "no picture");
    write(QStringLiteral("plan.yaml"), "no map");
    const auto robot = open({});
    const auto list =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot->mapCatalogue()->list(reply); });
    QStringList names;
    for (const map::CatalogueEntry& entry : *list) {
      QCOMPARE(entry.index, names.size());
      names << QString::fromStdString(entry.name);
    }
    QCOMPARE(names, (QStringList{QStringLiteral("office-2.yaml"), QStringLiteral("office.yaml"),
                                 QStringLiteral("plan.png"), QStringLiteral("plan.yaml")}));
    QVERIFY(fetch(*robot, "office.pgm"));  // who names it still gets it
  }

  void filesComeInTheOrderOfTheirNamesAndNumbers() {
    for (const char* name : {"floor10.png", "Floor2.png", "annex.png", "floor1.png"})
      write(QLatin1String(name), "no picture");
    QCOMPARE(mapFilesIn(folder_->path()),
             (QStringList{QStringLiteral("annex.png"), QStringLiteral("floor1.png"),
                          QStringLiteral("Floor2.png"), QStringLiteral("floor10.png")}));
  }

  void modesNegateAndSpellingsAreUnderstood() {
    const std::string base = "image: a.png\nresolution: '5e-2'\norigin: [0, 0]\n";
    QCOMPARE(parseMapYaml(base + "mode: scale\nnegate: true\n")->reading.mode, map::CellReading::Mode::Scale);
    QVERIFY(parseMapYaml(base + "negate: 1\n")->reading.negate);
    QVERIFY(!parseMapYaml(base + "negate: false\n")->reading.negate);
    QCOMPARE(parseMapYaml(base + "mode: raw\n")->reading.mode, map::CellReading::Mode::Raw);
  }

  void aYawThatIsNoNumberIsZeroWithANote() {
    for (const char* yaw : {"nan", ".nan", "NaN", ".inf", "north"}) {
      const auto yaml = parseMapYaml(
          "image: a\nresolution: 0.05\nmode: raw\nnegate: 0\noccupied_thresh: 0.65\n"
          "free_thresh: 0.196\norigin: [1, 2, " +
          std::string(yaw) + "]\n");
      QVERIFY2(yaml.has_value(), yaw);
      QCOMPARE(yaml->grid.origin, (geometry::Pose2{1, 2, 0}));
      QCOMPARE(yaml->notes.size(), std::size_t(1));
    }
  }

  void whatMapServerRefusesIsReadWithANoteOrRefused_data() {
    QTest::addColumn<QByteArray>("yaml");
    QTest::addColumn<double>("yaw");  // NaN: refused
    QTest::addColumn<QString>("says");
    const auto row = [](QByteArray take, QByteArray put, double yaw, const char* says) {
      QByteArray yaml = kYaml;
      QTest::newRow(put.isEmpty() ? take.constData() : put.constData())
          << yaml.replace(take, put) << yaw << QString::fromLatin1(says);
    };
    const QByteArray origin = "[-10.0, -7.5, 0.3]";
    row(origin, origin, 0.3, "");
    row(origin, "[-10, -7.5]", 0, "two numbers");
    row(origin, "[-10, -7.5, 0, 0]", 0, "4 numbers");
    row(origin, "[-10, -7.5, 0, 0.5]", NAN, "4 numbers");
    row(origin, "[-10, -7.5, 1.5, 0]", NAN, "4 numbers");
    row(origin, "[-10, -7.5, 1.5, 0, 0, 0.5]", 0.5, "roll, pitch, yaw");
    row(origin, "[-10, -7.5, 1.5, 0.5, 0, 0]", NAN, "6 numbers");
    row(origin, "[-10, -7.5, 1.5, 0, 0, 0.70710678, 0.70710678]", 1.5707963, "qz, qw");
    row(origin, "[-10, -7.5, 0, 1, 0, 0, 0]", NAN, "7 numbers");
    row(origin, "[-10, -7.5, 0, 0, 0, 0, 0]", NAN, "7 numbers");
    row(origin, "[-10]", NAN, "not a list");
    row(origin, "[-10, -7.5, 0, 0, 0]", NAN, "5 numbers");
    row(origin, "[-10, -7.5, 0, 0, 0, 0, 0, 1]", NAN, "8 numbers");
    row(origin, "[-10, -7.5, 0, 0, 0, north]", NAN, "not a number");
    row("negate: 0\n", "", 0.3, "negate is missing");
    row("negate: 0\nocc", "negate: 0\nmode: raw\nnot_occ", 0.3, "occupied_thresh is missing");
    row("free_thresh: 0.25\n", "", 0.3, "free_thresh is missing");
    // What others may read differently.
    row(origin, "[-10, -7.5, 90]", 90, "more than a full turn");
    row(origin, "[-10, -7.5, 6.28318531]", 6.28318531, "");
    row("free_thresh: 0.25\n", "free_thresh: 0.25\nresolution: 0.1\n", 0.3, "resolution is written twice");
    row("free_thresh: 0.25\n", "free_thresh: 0.25\n---\nimage: b.pgm\n", 0.3, "more than one document");
    row("free_thresh: 0.25\n", "free_thresh: 0.25\n---\n", 0.3, "");
  }
  void whatMapServerRefusesIsReadWithANoteOrRefused() {
    QFETCH(QByteArray, yaml);
    QFETCH(double, yaw);
    QFETCH(QString, says);
    const auto read = parseMapYaml(yaml.toStdString());
    if (std::isnan(yaw)) {
      QVERIFY(!read);
      QVERIFY2(sentences::wordsOf(read.error()).contains(says), qPrintable(sentences::wordsOf(read.error())));
      return;
    }
    QVERIFY(read.has_value());
    QCOMPARE(read->grid.origin.x_m, -10.0);
    QCOMPARE(read->grid.origin.y_m, -7.5);
    QVERIFY(std::abs(read->grid.origin.yaw_rad - yaw) < 1e-6);
    QStringList notes;
    for (const Fault& note : read->notes) notes << sentences::wordsOf(note);
    QCOMPARE(notes.size(), says.isEmpty() ? 0 : 1);
    QVERIFY2(notes.join(QLatin1Char(' ')).contains(says), qPrintable(notes.join(QLatin1Char(' '))));
  }

  void whatCannotBePlacedIsRefused_data() {
    QTest::addColumn<QByteArray>("yaml");
    const auto row = [](const char* yaml) { QTest::newRow(yaml) << QByteArray(yaml); };
    row("image: a\norigin: [0,0,0]\n");
    row("image: a\nresolution: 0\norigin: [0,0,0]\n");
    row("image: a\nresolution: -0.05\norigin: [0,0,0]\n");
    row("image: a\nresolution: .nan\norigin: [0,0,0]\n");
    row("image: a\nresolution: five\norigin: [0,0,0]\n");
    row("image: a\nresolution: 0.05\n");
    row("image: a\nresolution: 0.05\norigin: [0]\n");
    row("image: a\nresolution: 0.05\norigin: [nan,0,0]\n");
    row("image: a\nresolution: 0.05\norigin: [x,0,0]\n");
    row("resolution: 0.05\norigin: [0,0,0]\n");
    row("image: a\nresolution: 0.05\norigin: [0,0,0]\nmode: colour\n");
    row("image: a\nresolution: 0.05\norigin: [0,0,0]\nnegate: maybe\n");
    row("image: a\nresolution: 0.05\norigin: [0,0,0]\nfree_thresh: 7\n");
    row("image: [a]\nresolution: 0.05\norigin: [0,0,0]\n");
    row("[1, 2");
    row("just text");
    row("");
  }
  void whatCannotBePlacedIsRefused() {
    QFETCH(QByteArray, yaml);
    const auto read = parseMapYaml(yaml.toStdString());
    QVERIFY(!read.has_value());
    QVERIFY(read.error().any());
    write(QStringLiteral("a.yaml"), yaml);
    const auto robot = open(QStringLiteral("a.yaml"));
    QCOMPARE(robot->connection().phase, ConnectionPhase::Refused);
    QVERIFY(robot->connection().reason.any());
  }

  void deepNestingAndLongTextsAreRefused() {
    QVERIFY(!parseMapYaml(std::string(200'000, '[')).has_value());
    QVERIFY(!parseMapYaml(std::string(kMaxYamlBytes + 1, ' ')).has_value());
  }

  void aPictureOutsideOfTheFolderIsNoted() {
    QDir(folder_->path()).mkdir(QStringLiteral("maps"));
    write(QStringLiteral("office.pgm"), "P5");
    write(QStringLiteral("maps/a.yaml"), QByteArray(kYaml).replace("office.pgm", "../office.pgm"));
    const auto robot = open(QStringLiteral("maps/a.yaml"));
    const auto map = fetch(*robot);
    QVERIFY(map.has_value());
    QCOMPARE(map->notes.size(), std::size_t(1));
  }

  void aMissingPictureIsTold() {
    write(QStringLiteral("a.yaml"), kYaml);
    const auto map = fetch(*open(QStringLiteral("a.yaml")));
    QVERIFY(!map.has_value());
    QVERIFY(sentences::sentenceOf(map.error()).find("office.pgm") != std::string::npos);
    QCOMPARE(open(QStringLiteral("none.yaml"))->connection().phase, ConnectionPhase::Refused);
  }

  void aBarePictureIsPlacedByItsAddress() {
    write(QStringLiteral("a.png"), "x");
    const auto map = fetch(*open(QStringLiteral("a.png"), {0.02, geometry::Pose2{1, 2, 0.5}}));
    QCOMPARE(map->grid, (map::GridReference{0, 0, 0.02, {1, 2, 0.5}}));
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Picture);
    QVERIFY(map->notes.empty());
    QCOMPARE(fetch(*open(QStringLiteral("a.png")))->notes.size(), std::size_t(1));
  }

  void aPictureLiesWhereItsYamlSays_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QByteArray>("image");
    QTest::newRow("of the same name") << QStringLiteral("office.yaml") << QByteArray("office.pgm");
    QTest::newRow("of another name") << QStringLiteral("first floor.yml") << QByteArray("office.pgm");
    QTest::newRow("the long way") << QStringLiteral("office.yaml") << QByteArray("./../{folder}/office.pgm");
    QTest::newRow("absolute") << QStringLiteral("office.yaml") << QByteArray("{path}/office.pgm");
  }
  void aPictureLiesWhereItsYamlSays() {
    QFETCH(QString, yaml);
    QFETCH(QByteArray, image);
    image.replace("{folder}", QFileInfo(folder_->path()).fileName().toUtf8());
    image.replace("{path}", folder_->path().toUtf8());
    write(QStringLiteral("office.pgm"), "P5 1 1 255 x");
    write(yaml, QByteArray(kYaml).replace("office.pgm", image));
    write(QStringLiteral("other.yaml"), QByteArray(kYaml).replace("office.pgm", "other.pgm"));
    write(QStringLiteral("broken.yaml"), "[1, 2");
    QCOMPARE(yamlsNaming(path(QStringLiteral("office.pgm"))), QStringList{path(yaml)});
    for (const bool in_folder : {false, true}) {
      const auto robot = open(in_folder ? QString() : QStringLiteral("office.pgm"));
      const auto map = fetch(*robot, in_folder ? "office.pgm" : "");
      QVERIFY2(map.has_value(), map ? "" : sentences::sentenceOf(map.error()).c_str());
      QCOMPARE(map->grid, (map::GridReference{0, 0, 0.05, {-10, -7.5, 0.3}}));
      QCOMPARE(map->reading.mode, map::CellReading::Mode::Trinary);
      QCOMPARE(QFileInfo(QString::fromStdString(map->path)).canonicalFilePath(),
               QFileInfo(path(QStringLiteral("office.pgm"))).canonicalFilePath());
    }
    // What the address says comes first.
    const auto placed = fetch(*open(QStringLiteral("office.pgm"), {0.02, geometry::Pose2{1, 2, 0.5}}));
    QCOMPARE(placed->grid, (map::GridReference{0, 0, 0.02, {1, 2, 0.5}}));
  }

  void aPictureOfSeveralYamlsIsLeftToPeople() {
    write(QStringLiteral("office.pgm"), "P5 1 1 255 x");
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("older.yaml"), QByteArray(kYaml).replace("0.05", "0.10"));
    const auto map = fetch(*open(QStringLiteral("office.pgm")));
    QCOMPARE(map->reading.mode, map::CellReading::Mode::Picture);
    QVERIFY(map->notes.at(1).reason == Fault(robot::files::fault::SeveralYamls, {"office.yaml, older.yaml"}));
  }

  void aPictureFollowsItsYaml() {
    write(QStringLiteral("office.pgm"), "P5 1 1 255 x");
    const auto robot = open(QStringLiteral("office.pgm"));
    QSignalSpy changed(robot.get(), &Robot::mapsChanged);
    QCOMPARE(fetch(*robot)->grid.origin, geometry::Pose2{});
    write(QStringLiteral("office.yaml"), kYaml);
    QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatienceMs);
    QCOMPARE(fetch(*robot)->grid.origin, (geometry::Pose2{-10, -7.5, 0.3}));
    const auto told = changed.size();
    write(QStringLiteral("office.yaml"), QByteArray(kYaml).replace("-10.0", "-11.25"));
    QTRY_VERIFY_WITH_TIMEOUT(changed.size() > told, kPatienceMs);
    QCOMPARE(fetch(*robot)->grid.origin.x_m, -11.25);
  }

  void longAndSpecialFilesBesideAPictureAreLeftAlone() {
    write(QStringLiteral("office.pgm"), "P5 1 1 255 x");
    write(QStringLiteral("long.yaml"), kYaml + "# " + QByteArray(int(PictureYamls::kLongest), 'x'));
    QCOMPARE(::mkfifo(path(QStringLiteral("pipe.yaml")).toLocal8Bit().constData(), 0600), 0);
    QCOMPARE(yamlsNaming(path(QStringLiteral("office.pgm"))), QStringList());
  }

  void aFolderHoldsItsMapFiles() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5");
    write(QStringLiteral("notes.txt"), "x");
    const auto robot = open({});
    QCOMPARE(robot->connection().phase, ConnectionPhase::Online);
    const auto list =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { robot->mapCatalogue()->list(reply); });
    QCOMPARE(list->size(), std::size_t(1));
    QVERIFY(fetch(*robot, "office.yaml").has_value());
    for (const char* id : {"", "notes.txt", "../office.yaml", "/etc/passwd"})
      QVERIFY2(!fetch(*robot, id), id);
  }

  void aNamedPipeIsRefusedAndHoldsNobodyUp() {
    for (const char* name : {"pipe.yaml", "pipe.png", "pipe.pgm"}) {
      QCOMPARE(::mkfifo(QFile::encodeName(path(QLatin1String(name))).constData(), 0600), 0);
      const auto robot = open(QLatin1String(name));
      QCOMPARE(robot->connection().phase, ConnectionPhase::Refused);
      QVERIFY(sentences::wordsOf(robot->connection().reason).contains(QLatin1String(name)));
      QVERIFY(!fetch(*robot));
    }
    write(QStringLiteral("office.yaml"), QByteArray(kYaml).replace("office.pgm", "pipe.pgm"));
    QCOMPARE(open(QStringLiteral("office.yaml"))->connection().phase, ConnectionPhase::Refused);
    const auto folder = open({});
    const auto list =
        answerTo<std::vector<map::CatalogueEntry>>([&](auto reply) { folder->mapCatalogue()->list(reply); });
    QCOMPARE(list->size(), std::size_t(1));  // office.yaml
    QVERIFY(!fetch(*folder, "pipe.yaml"));
    QVERIFY(!YamlShelf().read(path(QStringLiteral("pipe.yaml")).toStdString()));
  }

  void onlyWhatChangedIsReadAgain() {
    std::int64_t later_ns = 0;
    timespec now{};
    YamlShelf shelf([&] {
      ::clock_gettime(CLOCK_REALTIME, &now);
      return std::int64_t(now.tv_sec) * 1'000'000'000 + now.tv_nsec + later_ns;
    });
    write(QStringLiteral("a.yaml"), kYaml);
    const std::string a = path(QStringLiteral("a.yaml")).toStdString();
    for (int times = 1; times <= 2; ++times) {
      QVERIFY(shelf.read(a).has_value());
      QCOMPARE(shelf.reads(), times);  // so fresh that another change might bear the same time
    }
    later_ns = std::int64_t(60) * 1'000'000'000;
    for (int times = 0; times < 3; ++times) QVERIFY(shelf.read(a).has_value());
    QCOMPARE(shelf.reads(), 3);
    write(QStringLiteral("b.yaml"), QByteArray(kYaml).replace("0.05", "0.10"));
    QCOMPARE(::rename(QFile::encodeName(path(QStringLiteral("b.yaml"))).constData(), a.c_str()), 0);
    QCOMPARE(shelf.read(a)->grid.resolution_m, 0.10);
    QVERIFY(QFile::remove(path(QStringLiteral("a.yaml"))));
    QVERIFY(!shelf.read(a));
  }

  void manyQuestionsAreAnsweredOnceEachAndNoneAfterTheRobotIsGone() {
    for (int i = 0; i < 300; ++i) write(QStringLiteral("%1.yaml").arg(i), kYaml);
    auto robot = open({});
    std::vector<int> answered(20);
    for (std::size_t i = 0; i < answered.size(); ++i) {
      robot->mapCatalogue()->list([&, i](const Outcome<std::vector<map::CatalogueEntry>>& list) {
        answered[i] += list && list->size() == 300 ? 1 : 1000;
      });
    }
    QVERIFY(answered == std::vector<int>(20));  // later, never from within
    QTRY_VERIFY_WITH_TIMEOUT(answered.back() > 0, kPatienceMs);
    QVERIFY(answered == std::vector<int>(20, 1));
    for (int i = 0; i < 20; ++i) {
      robot->mapCatalogue()->list([&](const auto&) { answered.clear(); });
      robot->wholeMapSource()->fetch({map::MapKind::File, "1.yaml"}, [&](const auto&) { answered.clear(); });
    }
    robot.reset();
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    QVERIFY(answered == std::vector<int>(20, 1));
  }

  void aRobotThatWasLeftStaysOffline() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5");
    const auto robot = open(QStringLiteral("office.yaml"));
    robot->connectToRobot();
    robot->disconnectFromRobot();
    QVERIFY(fetch(*robot).has_value());  // asked after the look that was in progress
    QCOMPARE(robot->connection().phase, ConnectionPhase::Offline);
  }

  void changesAreTold() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5");
    const auto robot = open(QStringLiteral("office.yaml"));
    QSignalSpy changed(robot.get(), &Robot::mapsChanged);
    const std::string before = fetch(*robot)->fingerprint;
    write(QStringLiteral("office.pgm"), "P5 more");
    QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(fetch(*robot)->fingerprint != before, kPatienceMs);
    for (int times = 1; times <= 2; ++times) {  // replaced by renaming, twice
      const std::string last = fetch(*robot)->fingerprint;
      const auto told = changed.size();
      write(QStringLiteral("new"), QByteArray("P5 longer ") + QByteArray(times, 'x'));
      QCOMPARE(::rename(path(QStringLiteral("new")).toLocal8Bit().constData(),
                        path(QStringLiteral("office.pgm")).toLocal8Bit().constData()),
               0);
      QTRY_VERIFY_WITH_TIMEOUT(changed.size() > told, kPatienceMs);
      QVERIFY(fetch(*robot)->fingerprint != last);
    }
  }

  void aMendedFileIsOpened() {
    write(QStringLiteral("office.pgm"), "P5");
    write(QStringLiteral("office.yaml"), "broken");
    const auto robot = open(QStringLiteral("office.yaml"));
    QCOMPARE(robot->connection().phase, ConnectionPhase::Refused);
    write(QStringLiteral("office.yaml"), kYaml);
    QTRY_COMPARE_WITH_TIMEOUT(robot->connection().phase, ConnectionPhase::Online, kPatienceMs);
  }

  void overlaysLieBesideTheirMap() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5\n2 2\n255\n" + QByteArray(4, char(254)));
    const QByteArray text = R"({"type":"FeatureCollection", "features":[] , "n": 1.50})";
    write(QStringLiteral("office.geojson"), text);
    const auto robot = open(QStringLiteral("office.yaml"));
    QVERIFY(robot);
    const map::MapKey key{map::MapKind::File, {}};
    const auto read = [&] {
      return answerTo<OverlayText>([&](auto reply) { robot->overlayStore()->read(key, reply); });
    };
    const auto stored = [&](const std::string& wanted) {
      return answerTo<std::monostate>([&](auto reply) { robot->overlayStore()->write(key, wanted, reply); });
    };
    const auto there = read();
    QVERIFY(there);
    QCOMPARE(there->text, text.toStdString());
    QCOMPARE(there->map_name, std::string("office.geojson"));
    QVERIFY(stored("{}"));
    QCOMPARE(read()->version, std::optional(*there->version + 1));
    QFile file(path(QStringLiteral("office.geojson")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("{}"));
    // Somebody else writes it between the look and the request.
    write(QStringLiteral("office.geojson"), "[]");
    const auto clash = stored("null");
    QVERIFY(!clash && clash.error().kind == map::FailureKind::Conflict);
    QVERIFY(clash.error().applied == map::Applied::No);
    QCOMPARE(read()->text, std::string("[]"));
    QVERIFY(stored("null"));
    // As a file is while it is being written, or after the disk was full: not "no overlays".
    write(QStringLiteral("office.geojson"), "");
    const auto emptied = read();
    QVERIFY(!emptied && emptied.error().kind == map::FailureKind::MalformedAnswer);
    QVERIFY(!stored("{}"));
  }

  void overlaysComeWithTheirMap() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), QByteArray("P5\n2 1\n255\n") + QByteArray(2, char(254)));
    write(
        QStringLiteral("office.overlays.geojson"),
        R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"w","properties":{"name":"W17","lineType":2},
              "geometry":{"type":"LineString","coordinates":[[1,2],[3,4]]}}]})");
    const auto robot = open(QStringLiteral("office.yaml"));
    const auto whole = fetch(*robot);
    QVERIFY(whole);
    QCOMPARE(whole->overlays.size(), std::size_t(1));
    QCOMPARE(whole->overlays[0].name, std::string("W17"));
    QCOMPARE(whole->overlays[0].type, 2);
    QCOMPARE(whole->overlays[0].parts[0].size(), std::size_t(2));
    write(QStringLiteral("office.overlays.geojson"), "{");
    QVERIFY(fetch(*robot) && fetch(*robot)->overlays.empty());
  }

  void overlaysThatCannotBeDrawnAreCounted() {
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), QByteArray("P5\n2 1\n255\n") + QByteArray(2, char(254)));
    const QByteArray feature = R"({"type":"Feature","properties":{},"geometry":)";
    const QByteArray sound = feature + R"({"type":"LineString","coordinates":[[1,2],[3,4]]}})";
    const QList<QByteArray> broken{feature + R"({"type":"Circle","coordinates":[1,2]}})",
                                   feature + R"({"type":"LineString","coordinates":[[1,2],["x",4],[5,6]]}})",
                                   feature + R"({"type":"Polygon","coordinates":[]}})",
                                   R"({"type":"FeatureCollection","features":[]})", "5"};
    const auto robot = open(QStringLiteral("office.yaml"));
    for (qsizetype count = 0; count <= broken.size(); ++count) {
      QByteArray features = sound + "," + feature + "null},null";  // no place, and what robots keep
      for (const QByteArray& one : broken.first(count)) features += "," + one;
      write(QStringLiteral("office.overlays.geojson"),
            R"({"type":"FeatureCollection","features":[)" + features + "]}");
      const auto whole = fetch(*robot);
      QVERIFY(whole);
      QCOMPARE(qsizetype(whole->broken_overlays.size()), count);
      QCOMPARE(whole->overlays.size(), std::size_t(count < 2 ? 1 : 2));
      QCOMPARE(whole->notes.size(), std::size_t(count == 0 ? 0 : 1));
      if (count == 0) continue;
      QCOMPARE(whole->notes[0].code, map::ProblemCode::Unreadable);
      QCOMPARE(whole->notes[0].reason.code, robot::fault::FeaturesUnreadable);
    }
  }

  void overlaysAreOpenedByThemselves() {
    write(QStringLiteral("hall.geojson"),
          R"({"type":"FeatureCollection","features":[
{"type":"Feature","geometry":{"type":"LineString","coordinates":[[-4,2],[6,12]]},"properties":{"lineType":2}}]})");
    auto robot = open(QStringLiteral("hall.geojson"));
    QVERIFY(robot && robot->connection().phase == ConnectionPhase::Online);
    const auto empty = fetch(*robot);
    QVERIFY(empty && empty->cells && empty->path.empty());
    QVERIFY(empty->grid.origin.x_m < -4 && empty->grid.origin.y_m < 2);
    QVERIFY(empty->grid.origin.x_m + empty->grid.width * empty->grid.resolution_m > 6);
    // The map of that name is below them, where there is one.
    write(QStringLiteral("office.yaml"), kYaml);
    write(QStringLiteral("office.pgm"), "P5\n2 2\n255\n" + QByteArray(4, char(254)));
    write(QStringLiteral("office.overlays.geojson"), R"({"type":"FeatureCollection","features":[]})");
    robot = open(QStringLiteral("office.overlays.geojson"));
    QVERIFY(robot && robot->connection().phase == ConnectionPhase::Online);
    const auto office = fetch(*robot);
    QVERIFY(office && !office->path.empty());
    QCOMPARE(office->grid.origin.x_m, -10.0);
    // They are no map of their folder.
    QCOMPARE(mapFilesIn(folder_->path()),
             (QStringList{QStringLiteral("office.pgm"), QStringLiteral("office.yaml")}));
  }

  void brokenOverlaysAreRefusedWithTheirPlace() {
    write(QStringLiteral("a.geojson"), "{\"type\":\"FeatureCollection\",\n \"features\":[}");
    auto robot = open(QStringLiteral("a.geojson"));
    QVERIFY(robot && robot->connection().phase == ConnectionPhase::Refused);
    const QString why = sentences::sentenceOf(robot->connection().reason);
    QVERIFY2(why.contains(QStringLiteral("line 2, column 14"), Qt::CaseInsensitive), qPrintable(why));
    for (const char* text : {"{}", ""}) {
      write(QStringLiteral("b.geojson"), text);
      robot = open(QStringLiteral("b.geojson"));
      QVERIFY(robot && robot->connection().phase == ConnectionPhase::Refused);
    }
  }
};

}  // namespace test_file_robot

MAPWRIGHT_TEST(test_file_robot, FileRobotTest, Core)
#include "test_file_robot.moc"
