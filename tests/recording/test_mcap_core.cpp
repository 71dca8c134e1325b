#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "recordings.h"
#include "test_program.h"

namespace test_mcap_core {

using namespace recordings;

/// Our recordings in the hands of others, and theirs in ours: the public @mcap/core of npm.
class TestMcapCore : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase();
  void othersReadWhatWeWrite();
  void weReadWhatOthersWrite();

 private:
  QByteArray run(const QString& mode, const QString& file);
  const QString packages_ = QStringLiteral(MAPWRIGHT_NODE_PACKAGES);
  QString node_;
};

void TestMcapCore::initTestCase() {
  node_ = QStandardPaths::findExecutable(QStringLiteral("node"));
  const QString npm = QStandardPaths::findExecutable(QStringLiteral("npm"));
  if (node_.isEmpty() || npm.isEmpty()) QSKIP("node and npm are not installed: nothing to compare with");
  const QString wanted = packages_ + QStringLiteral("/node_modules/@mcap/core/package.json");
  if (!QFile::exists(wanted)) {
    QDir().mkpath(packages_);
    QProcess install;
    install.start(
        npm, {QStringLiteral("install"), QStringLiteral("--prefix"), packages_, QStringLiteral("--no-save"),
              QStringLiteral("--no-audit"), QStringLiteral("--no-fund"), QStringLiteral("--ignore-scripts"),
              QStringLiteral("@mcap/core@2.2.2"), QStringLiteral("fzstd@0.1.1")});
    install.waitForFinished(120'000);
  }
  if (!QFile::exists(wanted)) QSKIP("npm could not fetch @mcap/core: nothing to compare with");
}

QByteArray TestMcapCore::run(const QString& mode, const QString& file) {
  QProcess process;
  process.start(node_, {QStringLiteral(MAPWRIGHT_MCAP_CORE_SCRIPT), mode, packages_, file});
  process.waitForFinished(60'000);
  const QByteArray errors = process.readAllStandardError();
  if (process.exitCode() != 0 || process.exitStatus() != QProcess::NormalExit)
    qWarning("%s", errors.constData());
  return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
}

void TestMcapCore::othersReadWhatWeWrite() {
  QTemporaryDir folder;
  for (const auto compression : {WriterOptions::Compression::Zstd, WriterOptions::Compression::None}) {
    WriterOptions options;
    options.compression = compression;
    options.profile = "ros2";
    Made made = makeRecording(6, 40, 30'000, 2, options);
    const QString path = folder.filePath(QStringLiteral("ours.mcap"));
    auto file = appendFile(path.toStdString(), Existing::Replace);
    QVERIFY(file);
    // The same rows once more, with files and words beside them.
    auto writer = McapWriter::create(std::move(*file), options);
    QVERIFY(writer);
    for (const Row& row : made.rows) {
      const ChannelId id = *(*writer)->addChannel(channelOf(row.topic));
      (*writer)->write(id, {row.log_ns, row.log_ns, row.sequence}, bytesOf(row.bytes));
      if (row.sequence == 50) (*writer)->attach({"a.png", "image/png", 1, 2, "picture"});
      if (row.sequence == 60) (*writer)->addMetadata({"robot", {{"sn", "42"}}});
      if (row.sequence % 30 == 0) (*writer)->flush();
    }
    (*writer)->addChannel(channelOf("/silent"));
    QVERIFY(!(*writer)->close());

    const QJsonObject read = QJsonDocument::fromJson(run(QStringLiteral("read"), path)).object();
    QCOMPARE(read[QStringLiteral("profile")].toString(), QStringLiteral("ros2"));
    QCOMPARE(read[QStringLiteral("counted")].toString(), QStringLiteral("240"));
    QCOMPARE(read[QStringLiteral("streamed")].toInt(), 240);
    QVERIFY(read[QStringLiteral("done")].toBool());
    const QJsonArray messages = read[QStringLiteral("messages")].toArray();
    std::vector<Row> rows;
    for (const QJsonValue& value : messages) {
      const QJsonObject message = value.toObject();
      QCOMPARE(message[QStringLiteral("encoding")].toString(), QStringLiteral("json"));
      rows.push_back(
          {message[QStringLiteral("topic")].toString().toStdString(),
           message[QStringLiteral("log")].toString().toLongLong(),
           std::uint32_t(message[QStringLiteral("sequence")].toInt()),
           QByteArray::fromBase64(message[QStringLiteral("data")].toString().toLatin1()).toStdString()});
    }
    // Those of the same time come in an order of its own.
    const auto key = [](const Row& a, const Row& b) {
      return std::tie(a.log_ns, a.sequence) < std::tie(b.log_ns, b.sequence);
    };
    QVERIFY(std::is_sorted(rows.begin(), rows.end(),
                           [](const Row& a, const Row& b) { return a.log_ns < b.log_ns; }));
    std::sort(rows.begin(), rows.end(), key);
    std::sort(made.rows.begin(), made.rows.end(), key);
    QCOMPARE(rows == made.rows, true);
    const QJsonObject attachment = read[QStringLiteral("attachments")].toArray().first().toObject();
    QCOMPARE(attachment[QStringLiteral("name")].toString(), QStringLiteral("a.png"));
    QCOMPARE(attachment[QStringLiteral("size")].toInt(), 7);
    const QJsonObject metadata = read[QStringLiteral("metadata")].toArray().first().toObject();
    QCOMPARE(metadata[QStringLiteral("words")].toObject()[QStringLiteral("sn")].toString(),
             QStringLiteral("42"));
  }
}

void TestMcapCore::weReadWhatOthersWrite() {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("theirs.mcap"));
  run(QStringLiteral("write"), path);
  const Opened opened = openRecording(path.toStdString());
  QVERIFY(opened);
  const Summary summary = (*opened)->summary();
  QVERIFY(summary.notes.empty() && summary.indexed && summary.finished);
  QCOMPARE(summary.messages, std::uint64_t(200));
  QVERIFY(summary.chunks > 5);
  const std::vector<Row> rows = rowsOf(**opened);
  QCOMPARE(rows.size(), std::size_t(200));
  QVERIFY(std::is_sorted(rows.begin(), rows.end(),
                         [](const Row& a, const Row& b) { return a.log_ns < b.log_ns; }));
  for (const Row& row : rows) {
    QCOMPARE(row.bytes, "{\"i\":" + std::to_string(row.sequence) + "}");
    QCOMPARE(row.topic, std::string(row.sequence % 2 == 0 ? "/one" : "/two"));
  }
  QCOMPARE((*opened)->channels()[0]->metadata.at("k"), std::string("v"));
  QCOMPARE((*opened)->attachment((*opened)->attachments().at(0))->bytes, std::string("hello"));
  QCOMPARE((*opened)->metadata().at(0).values.at("a"), std::string("b"));
}

}  // namespace test_mcap_core

MAPWRIGHT_TEST(test_mcap_core, TestMcapCore, Core)
#include "test_mcap_core.moc"
