// mapwright simulate: what its options do, seen from outside.
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>

#include "test_program.h"

namespace test_simulate {

namespace {

/// A running `mapwright simulate`; ends with this object.
class Simulated {
 public:
  explicit Simulated(const QStringList& options) {
    process_.start(QStringLiteral(MAPWRIGHT_PROGRAM), QStringList{QStringLiteral("simulate")} + options);
    if (!process_.waitForStarted()) return;
    while (!process_.canReadLine() && process_.waitForReadyRead(30'000)) {
    }
    const QJsonObject line = QJsonDocument::fromJson(process_.readLine()).object();
    url_ = QUrl(line[QLatin1String("axbot")].toString().mid(6));
  }
  ~Simulated() {
    process_.terminate();
    if (!process_.waitForFinished()) process_.kill();
  }
  Simulated(const Simulated&) = delete;
  Simulated& operator=(const Simulated&) = delete;

  bool isRunning() const { return url_.isValid() && process_.state() == QProcess::Running; }
  /// The HTTP status; 0 when the connection ended without an answer.
  int status(const QByteArray& method, const char* path, const QByteArray& secret = {}) {
    QUrl url = url_;
    url.setPath(QLatin1String(path));
    QNetworkRequest request(url);
    request.setHeader(QNetworkRequest::ContentTypeHeader, QByteArrayLiteral("application/json"));
    if (!secret.isEmpty()) request.setRawHeader("Secret", secret);
    QScopedPointer<QNetworkReply> reply(network_.sendCustomRequest(request, method, R"({"map_name":"New"})"));
    if (!QTest::qWaitFor([&] { return reply->isFinished(); }, 30'000)) return -1;
    return reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
  }

 private:
  QProcess process_;
  QUrl url_;
  QNetworkAccessManager network_;
};

}  // namespace

class TestSimulate : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aSecretFileMakesTheRobotAskForItsSecret() {
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("secret")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("open sesame\n") > 0);
    file.close();
    Simulated robot({QStringLiteral("--paused"), QStringLiteral("--secret-file"), file.fileName()});
    QVERIFY(robot.isRunning());
    QCOMPARE(robot.status("GET", "/device/info"), 401);
    QCOMPARE(robot.status("GET", "/device/info", "guess"), 401);
    QCOMPARE(robot.status("GET", "/device/info", "open sesame"), 200);
    QCOMPARE(robot.status("PATCH", "/maps/1"), 401);
  }

  void aSecretFileThatHoldsNoneIsRefused_data() {
    QTest::addColumn<bool>("exists");
    QTest::newRow("missing") << false;
    QTest::newRow("empty") << true;
  }
  void aSecretFileThatHoldsNoneIsRefused() {
    QFETCH(bool, exists);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("secret")));
    if (exists) QVERIFY(file.open(QIODevice::WriteOnly));
    QProcess process;
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                  {QStringLiteral("simulate"), QStringLiteral("--secret-file"), file.fileName()});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardError().contains("secret"));
  }

  void writesGoWrongAsAskedFor_data() {
    QTest::addColumn<QString>("option");
    QTest::addColumn<bool>("answered");
    QTest::newRow("error") << QStringLiteral("--write-error-rate") << true;
    QTest::newRow("dropped") << QStringLiteral("--drop-writes") << false;
    QTest::newRow("answer lost") << QStringLiteral("--lose-write-answers") << false;
  }
  void writesGoWrongAsAskedFor() {
    QFETCH(QString, option);
    QFETCH(bool, answered);
    Simulated robot({QStringLiteral("--paused"), option, QStringLiteral("1")});
    QVERIFY(robot.isRunning());
    const int status = robot.status("PATCH", "/maps/1");
    QCOMPARE(status >= 500, answered);
    QCOMPARE(status == 0, !answered);
    QCOMPARE(robot.status("GET", "/maps/"), 200);
  }
};

}  // namespace test_simulate

MAPWRIGHT_TEST(test_simulate, TestSimulate, Core)
#include "test_simulate.moc"
