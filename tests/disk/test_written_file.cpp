#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "disk/read_file.h"
#include "disk/written_file.h"
#include "test_program.h"

namespace test_written_file {

using namespace mapwright::disk;

namespace {

mode_t modeOf(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 ? about.st_mode : 0;
}

/// No file may grow beyond `bytes` while this lives: a full disk for whoever may not make one.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

}  // namespace

class WrittenFileTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;

  std::string at(const char* name) const { return folder_->filePath(QLatin1String(name)).toStdString(); }
  static std::string read(const std::string& path) { return readFile(path, 1 << 24).value_or("(nothing)"); }
  void put(const std::string& path, const QByteArray& bytes) {
    QFile file(QString::fromStdString(path));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
  }
  QStringList names() const {
    return QDir(folder_->path())
        .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
  }

 private Q_SLOTS:
  void aPointerOfGitLfsIsNotReadAsTheFile() {
    QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("places.csv")).toStdString();
    for (const char* begin :
         {"version https://git-lfs.github.com/spec/v1\n", "version https://hawser.github.com/spec/v1\n"}) {
      QVERIFY(!writeFile(path, std::string(begin) + "oid sha256:4d7a\nsize 12345\n"));
      const auto read = readFile(path, 1'000);
      QVERIFY(!read && read.error().cause == mapwright::Fault(mapwright::disk::fault::GitLfsPointer));
    }
    QVERIFY(!writeFile(path, "version https://example.org\n"));
    QVERIFY(readFile(path, 1'000).has_value());
  }

  void initTestCase() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
  }
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aFileIsThereOnlyOnceItIsWhole() {
    {
      WrittenFile file(at("a"));
      file.write("one");
      QVERIFY(file.finish());
      QVERIFY(!QFile::exists(QString::fromStdString(at("a"))));
      QVERIFY(!file.place());
    }
    QCOMPARE(read(at("a")), std::string("one"));
    {
      WrittenFile file(at("a"));
      file.write("never placed");
    }
    QCOMPARE(read(at("a")), std::string("one"));
    QCOMPARE(names(), QStringList{QStringLiteral("a")});
  }

  void whoIsKilledLeavesNothing() {
    const int unnamed = ::open(folder_->path().toLocal8Bit().constData(), O_TMPFILE | O_RDWR, 0600);
    if (unnamed < 0) QSKIP("this file system has no files without names");
    ::close(unnamed);
    put(at("there"), "before");
    const pid_t child = ::fork();
    QVERIFY(child >= 0);
    if (child == 0) {
      WrittenFile fresh(at("fresh")), there(at("there"));
      const std::string much(std::size_t(1) << 20, 'x');
      for (WrittenFile* const file : {&fresh, &there}) file->write(much);
      if (fresh.finish()) ::kill(::getpid(), SIGKILL);
      ::_exit(1);
    }
    int status = 0;
    QCOMPARE(::waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status));
    QCOMPARE(names(), QStringList{QStringLiteral("there")});
    QCOMPARE(read(at("there")), std::string("before"));
  }

  void whatHasComeThereMeanwhileIsReplacedToo() {
    WrittenFile file(at("a"));
    file.write("mine");
    put(at("a"), "another's");
    QVERIFY(!file.place());
    QCOMPARE(read(at("a")), std::string("mine"));
    QCOMPARE(names(), QStringList{QStringLiteral("a")});
  }

  void whatMayReplaceNothingIsKeptBesideIt_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("kept");
    QTest::addRow("extension") << QStringLiteral("a.csv") << QStringLiteral("a-1.csv");
    QTest::addRow("none") << QStringLiteral("a") << QStringLiteral("a-1");
    QTest::addRow("two") << QStringLiteral("a.b.csv") << QStringLiteral("a.b-1.csv");
    QTest::addRow("hidden") << QStringLiteral(".a") << QStringLiteral(".a-1");
  }
  void whatMayReplaceNothingIsKeptBesideIt() {
    QFETCH(QString, name);
    QFETCH(QString, kept);
    for (const bool finished_before : {false, true}) {
      init();
      const std::string here = at(qPrintable(name)), beside = at(qPrintable(kept));
      WrittenFile file(here, Existing::Refuse);
      file.write("mine");
      if (finished_before) {
        QVERIFY(file.finish());
        QCOMPARE(read(file.whereNow()), std::string("mine"));
      }
      put(here, "another's");
      const auto problem = file.place();
      QVERIFY(problem && problem->path == here);
      QVERIFY((problem->cause == mapwright::Fault{mapwright::disk::fault::NameTaken, {beside}}));
      QCOMPARE(file.whereNow(), beside);
      QCOMPARE(read(here), std::string("another's"));
      QCOMPARE(read(beside), std::string("mine"));
      QCOMPARE(names().size(), 2);
    }
  }

  void whatIsKeptReplacesNothingEither() {
    put(at("a-1.csv"), "older");
    WrittenFile file(at("a.csv"), Existing::Refuse);
    file.write("mine");
    put(at("a.csv"), "another's");
    QVERIFY(file.place());
    QCOMPARE(read(at("a-1.csv")), std::string("older"));
    QCOMPARE(read(at("a-2.csv")), std::string("mine"));
  }

  void whatMayReplaceNothingIsWrittenWhereNothingIs() {
    QCOMPARE(existingNow(at("a")), Existing::Refuse);
    QVERIFY(!writeFile(at("a"), "one", Existing::Refuse));
    QCOMPARE(existingNow(at("a")), Existing::Replace);
    QVERIFY(writeFile(at("a"), "two", Existing::Refuse));
    QCOMPARE(read(at("a")), std::string("one"));
    QCOMPARE(read(at("a-1")), std::string("two"));
    QCOMPARE(names().size(), 2);
    QVERIFY(!writeFile("/dev/null", "gone", Existing::Refuse));
  }

  void whatDoesNotFitLeavesTheOldFile_data() {
    QTest::addColumn<int>("bytes");
    // Smaller than any buffer, as large as one, and larger than several.
    for (const int bytes : {65, 4'096, 65'536, 1 << 18, (1 << 18) + 1, 3'000'000}) {
      QTest::addRow("%d bytes", bytes) << bytes;
    }
  }
  void whatDoesNotFitLeavesTheOldFile() {
    QFETCH(int, bytes);
    put(at("a"), "the old one");
    std::optional<FileError> problem;
    {
      const SmallDisk full(64);
      problem = writeFile(at("a"), std::string(std::size_t(bytes), 'x'));
    }
    QVERIFY(problem.has_value());
    QCOMPARE(problem->cause.code, mapwright::fault::Said);
    QCOMPARE(problem->path, at("a"));
    QVERIFY(!std::get<std::string>(problem->cause.arguments.at(0)).empty());
    QCOMPARE(read(at("a")), std::string("the old one"));
    QCOMPARE(names(), QStringList{QStringLiteral("a")});
  }

  void aFullDiskIsTold_data() {
    QTest::addColumn<int>("bytes");
    for (const int bytes : {1, 4'096, 3'000'000}) QTest::addRow("%d bytes", bytes) << bytes;
  }
  void aFullDiskIsTold() {
    QFETCH(int, bytes);
    const auto problem = writeFile("/dev/full", std::string(std::size_t(bytes), 'x'));
    QVERIFY(problem && problem->cause == mapwright::fault::said("No space left on device"));
    QVERIFY(S_ISCHR(modeOf("/dev/full")));
  }

  void permissionsAreKeptAndTheUmaskHolds() {
    const mode_t mask = ::umask(027);
    const auto fresh = writeFile(at("fresh"), "x");
    put(at("kept"), "x");
    QVERIFY(::chmod(at("kept").c_str(), 0604) == 0);
    const auto again = writeFile(at("kept"), "y");
    ::umask(mask);
    QVERIFY(!fresh && !again);
    QCOMPARE(modeOf(at("fresh")) & 07777, mode_t(0640));
    QCOMPARE(modeOf(at("kept")) & 07777, mode_t(0604));
    QCOMPARE(read(at("kept")), std::string("y"));
  }

  void linksAreFollowed() {
    QVERIFY(QDir(folder_->path()).mkdir(QStringLiteral("far")));
    put(at("far/a"), "old");
    QVERIFY(::symlink("far/a", at("link").c_str()) == 0);
    QVERIFY(::symlink("link", at("link-to-link").c_str()) == 0);
    QVERIFY(::symlink("far/not-yet", at("dangling").c_str()) == 0);
    QVERIFY(::symlink("round", at("round").c_str()) == 0);
    QVERIFY(!writeFile(at("link-to-link"), "new"));
    QCOMPARE(read(at("far/a")), std::string("new"));
    QVERIFY(QFileInfo(QString::fromStdString(at("link"))).isSymLink());
    QVERIFY(!writeFile(at("dangling"), "made"));
    QCOMPARE(read(at("far/not-yet")), std::string("made"));
    QVERIFY(writeFile(at("round"), "x").has_value());
  }

  void devicesStayDevices() {
    const mode_t before = modeOf("/dev/null");
    QVERIFY(!writeFile("/dev/null", "gone"));
    QCOMPARE(modeOf("/dev/null"), before);
    QVERIFY(::symlink("/dev/null", at("null").c_str()) == 0);
    QVERIFY(!writeFile(at("null"), "gone"));
    QCOMPARE(modeOf("/dev/null"), before);
  }

  void aNamedPipeIsWrittenInto() {
    QVERIFY(::mkfifo(at("pipe").c_str(), 0600) == 0);
    const std::string sent(1'000'000, 'p');  // more than a pipe holds
    std::string came;
    std::thread reader([&] {
      const int fd = ::open(at("pipe").c_str(), O_RDONLY | O_CLOEXEC);
      std::string part(65'536, '\0');
      for (ssize_t got = 0; (got = ::read(fd, part.data(), part.size())) > 0;)
        came.append(part, 0, std::size_t(got));
      ::close(fd);
    });
    const auto problem = writeFile(at("pipe"), sent);
    reader.join();
    QVERIFY(!problem);
    QVERIFY(came == sent);
    QVERIFY(S_ISFIFO(modeOf(at("pipe"))));
  }

  void aReaderThatLeavesIsTold() {
    int ends[2];
    QVERIFY(::pipe2(ends, O_CLOEXEC) == 0);
    const std::string path = "/proc/self/fd/" + std::to_string(ends[1]);
    {
      WrittenFile file(path);
      ::close(ends[0]);
      file.write("x");
      QVERIFY(file.place().has_value());
    }
    ::close(ends[1]);
  }

  void foldersAndPlacesThatAreNotThereAreRefused() {
    QCOMPARE(writeFile(folder_->path().toStdString(), "x")->cause.code, mapwright::disk::fault::IsAFolder);
    QVERIFY(writeFile(at("none/a"), "x").has_value());
    QVERIFY(writeFile("/proc/mapwright", "x").has_value());
    QVERIFY(writeFile("", "x").has_value());
    QVERIFY(names().isEmpty());
  }

  void oneFileIsKnownByAllItsNames() {
    put(at("a"), "x");
    put(at("b"), "x");
    QVERIFY(::symlink("a", at("link").c_str()) == 0);
    QVERIFY(::link(at("a").c_str(), at("hard").c_str()) == 0);
    for (const char* name : {"a", "./a", "link", "hard"}) QVERIFY2(sameFile(at("a"), at(name)), name);
    QVERIFY(!sameFile(at("a"), at("b")));
    QVERIFY(!sameFile(at("none"), at("none")));
  }

  void readingNeverWaitsForAPipe() {
    QVERIFY(::mkfifo(at("pipe").c_str(), 0600) == 0);
    QVERIFY(!readFile(at("pipe"), 10));
    QVERIFY(!readFile("/dev/zero", 10));
    QVERIFY(!readFile(folder_->path().toStdString(), 10));
    QVERIFY(!readFile(at("none"), 10));
    put(at("a"), "0123456789");
    QCOMPARE(*readFile(at("a"), 4), std::string("0123"));
    QCOMPARE(*readFile(at("a"), 400), std::string("0123456789"));
  }
};

}  // namespace test_written_file

MAPWRIGHT_TEST(test_written_file, WrittenFileTest, Core)
#include "test_written_file.moc"
