// Recordings of every kind of robot, and parts of them, in the hands of other programs.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "simulator/simulator.h"
#include "test_program.h"

namespace test_recordings_elsewhere {

using namespace mapwright;

class RecordingsElsewhereTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  const QString packages_ = QStringLiteral(MAPWRIGHT_NODE_PACKAGES);
  QString node_;

  static int run(const QString& program, const QStringList& words, QByteArray* out = nullptr) {
    QProcess process;
    process.start(program, words);
    const auto ended = [&] { return process.state() == QProcess::NotRunning; };
    if (!QTest::qWaitFor(ended, 120'000)) return -1;
    if (out) *out = process.readAllStandardOutput();
    const QByteArray errors = process.readAllStandardError();
    if (!errors.isEmpty()) qInfo("%s", errors.constData());
    return process.exitCode();
  }
  QJsonObject shown(const QString& file) const {
    QByteArray out;
    run(node_, {QStringLiteral(MAPWRIGHT_SHOWN_SCRIPT), packages_, file}, &out);
    return QJsonDocument::fromJson(out).object();
  }

 private Q_SLOTS:
  void initTestCase() {
    node_ = QStandardPaths::findExecutable(QStringLiteral("node"));
    const QString npm = QStandardPaths::findExecutable(QStringLiteral("npm"));
    if (node_.isEmpty() || npm.isEmpty()) QSKIP("node and npm are not installed: nothing to show them with");
    const QString last = packages_ + QStringLiteral("/node_modules/protobufjs/package.json");
    if (!QFile::exists(last)) {
      QDir().mkpath(packages_);
      run(npm,
          {QStringLiteral("install"), QStringLiteral("--prefix"), packages_, QStringLiteral("--no-save"),
           QStringLiteral("--no-audit"), QStringLiteral("--no-fund"), QStringLiteral("--ignore-scripts"),
           QStringLiteral("@mcap/core@2.2.2"), QStringLiteral("fzstd@0.1.1"),
           QStringLiteral("@foxglove/rosmsg@5.0.5"), QStringLiteral("@foxglove/rosmsg-serialization@2.0.4"),
           QStringLiteral("@foxglove/rosmsg2-serialization@3.1.0"), QStringLiteral("protobufjs@7.6.6")});
    }
    if (!QFile::exists(last)) QSKIP("npm could not fetch the programs: nothing to show them with");
  }

  void everyChannelOfARecordingCanBeShown_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<bool>("ros2");
    QTest::addColumn<bool>("rosapi");
    QTest::addColumn<QStringList>("encodings");
    const auto list = [](const char* words) { return QString::fromLatin1(words).split(QLatin1Char(' ')); };
    QTest::newRow("Autoxing") << QStringLiteral("axbot") << false << true << list("json protobuf");
    QTest::newRow("Agibot") << QStringLiteral("aimdk") << false << true << list("json ros1");
    QTest::newRow("ROS 1") << QStringLiteral("ros") << false << true << list("ros1");
    QTest::newRow("ROS 2") << QStringLiteral("ros") << true << true << list("cdr");
    QTest::newRow("ROS without rosapi") << QStringLiteral("ros") << false << false << list("json");
  }
  void everyChannelOfARecordingCanBeShown() {
    QFETCH(QString, kind);
    QFETCH(bool, ros2);
    QFETCH(bool, rosapi);
    QFETCH(QStringList, encodings);
    simulator::Options options;
    options.ros.dialect = ros2 ? simulator::RosDialect::Ros2 : simulator::RosDialect::Ros1;
    options.ros.rosapi = rosapi;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const quint16 port = kind == QLatin1String("axbot")   ? robot.port()
                         : kind == QLatin1String("aimdk") ? robot.aimdkPort()
                                                          : robot.rosPort();
    QString address =
        QStringLiteral("%1+%2://127.0.0.1:%3")
            .arg(kind, kind == QLatin1String("ros") ? QStringLiteral("ws") : QStringLiteral("http"))
            .arg(port);
    if (kind == QLatin1String("aimdk"))
      address += QStringLiteral("?tf=ws://127.0.0.1:%1").arg(robot.rosPort());
    const QStringList words{
        QStringLiteral("record"),     QStringLiteral("--robot"), address,
        QStringLiteral("--duration"), QStringLiteral("6"),       QStringLiteral("--force"),
        QStringLiteral("-o")};
    const QString file = folder_.filePath(QStringLiteral("robot.mcap"));
    QVERIFY(run(QStringLiteral(MAPWRIGHT_PROGRAM), words + QStringList{file}) >= 0);
    const QString part = folder_.filePath(QStringLiteral("part.mcap"));
    run(QStringLiteral(MAPWRIGHT_PROGRAM), {QStringLiteral("bags"), QStringLiteral("export"), file,
                                            QStringLiteral("-o"), part, QStringLiteral("--force")});
    for (const QString& one : {file, part}) {
      const QJsonObject told = shown(one);
      QStringList wrong;
      for (const QJsonValue& sentence : told[QStringLiteral("wrong")].toArray()) wrong << sentence.toString();
      QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
      QSet<QString> seen;
      for (const QJsonValue& channel : told[QStringLiteral("channels")].toArray()) {
        if (channel[QStringLiteral("messages")].toInt() > 0)
          seen.insert(channel[QStringLiteral("encoding")].toString());
        if (channel[QStringLiteral("topic")].toString() != QLatin1String("/tf") ||
            kind == QLatin1String("axbot"))
          continue;
        const QJsonValue first = channel[QStringLiteral("sample")][QStringLiteral("transforms")][0];
        QCOMPARE(first[QStringLiteral("child_frame_id")].toString(), QStringLiteral("odom"));
      }
      QCOMPARE(seen, QSet<QString>(encodings.begin(), encodings.end()));
    }
  }
};

}  // namespace test_recordings_elsewhere

MAPWRIGHT_TEST(test_recordings_elsewhere, RecordingsElsewhereTest, Core)
#include "test_recordings_elsewhere.moc"
