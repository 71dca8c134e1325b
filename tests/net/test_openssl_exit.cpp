// A program with encrypted connections exits while threads are still ending: OpenSSL keeps its memory then.
#include <cstdint>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

#include <QLibrary>
#include <QtTest>

#include "net/http_client.h"
#include "test_program.h"

namespace test_openssl_exit {

using namespace mapwright;

namespace {

constexpr int kTidied = 77;
constexpr std::uint64_t kLoadErrors = 0x00000002;  // anything that makes OpenSSL start
void onTidying() { ::_exit(kTidied); }

/// Runs in a process of its own: its exit code, kTidied if OpenSSL tidied up, 2 without OpenSSL 3, which Qt
/// needs.
int exitCodeOf(void (*work)()) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::atexit([] { ::_exit(0); });  // after OpenSSL's, which is registered later
    work();
    QLibrary crypto(QStringLiteral("crypto"), 3);
    const auto init =
        reinterpret_cast<int (*)(std::uint64_t, const void*)>(crypto.resolve("OPENSSL_init_crypto"));
    // OpenSSL calls this when it tidies up.
    const auto at_exit = reinterpret_cast<int (*)(void (*)())>(crypto.resolve("OPENSSL_atexit"));
    if (!init || !at_exit || init(kLoadErrors, nullptr) != 1 || at_exit(onTidying) != 1) ::_exit(2);
    std::exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void doNothing() {}
void makeClient() { const net::HttpClient client(QUrl(QStringLiteral("http://127.0.0.1:1")), {}, nullptr); }

}  // namespace

class TestOpensslExit : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void opensslTidiesUpByItself() { QCOMPARE(exitCodeOf(doNothing), kTidied); }

  void afterAConnectionItKeepsItsMemory() { QCOMPARE(exitCodeOf(makeClient), 0); }
};

}  // namespace test_openssl_exit

MAPWRIGHT_TEST(test_openssl_exit, TestOpensslExit, Core)
#include "test_openssl_exit.moc"
