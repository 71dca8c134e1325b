// What the log tells of addresses and of what went wrong.
#include <QTest>

#include "net/faults.h"
#include "net/log.h"
#include "test_program.h"

namespace test_log {

using namespace mapwright;
using namespace mapwright::net;

class LogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anAddressIsToldWithoutSecrets_data() {
    QTest::addColumn<QString>("url");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* url, const char* told) {
      QTest::newRow(url) << QString::fromUtf8(url) << QString::fromUtf8(told);
    };
    row("http://h:8090/maps/1", "http://h:8090/maps/1");
    row("http://h/ros/slam/submaps/u/0/3?ver=12", "http://h/ros/slam/submaps/u/0/3?ver=12");
    row("ws://h:8090/ws/v2/topics?pb=1", "ws://h:8090/ws/v2/topics?pb=1");
    row("http://h/bags?from=1700000000.5&to=-3", "http://h/bags?from=…&to=-3");
    row("http://user:hush@h/maps/", "http://h/maps/");
    row("http://hush@h/maps/", "http://h/maps/");
    row("http://h/a.png?secret=hush&ver=2", "http://h/a.png?secret=…&ver=2");
    row("http://h/a.png?name=hush", "http://h/a.png?name=…");
    row("http://h/a.png?pin=1234&Token=5", "http://h/a.png?pin=…&Token=…");
    row("http://h/a.png?hush", "http://h/a.png?…");
    row("http://h/a.png?hush=", "http://h/a.png?…");
    row("http://h/a.png#hush", "http://h/a.png");
    row("", "");
  }
  void anAddressIsToldWithoutSecrets() {
    QFETCH(QString, url);
    QFETCH(QString, told);
    QCOMPARE(urlForLog(QUrl(url)), told);
  }

  void aFaultIsOneLineOfEnglish() {
    QCOMPARE(inEnglish({}), std::string());
    QCOMPARE(inEnglish({net::fault::AnsweredWithStatusSaying, {HttpStatus{404}, "100%1"}}),
             std::string("the robot answered 404: 100%1"));
    const Fault cause(mapwright::fault::said("why")), other(mapwright::fault::said("and why"));
    QCOMPARE(inEnglish({mapwright::fault::AnswerTooLong, {std::int64_t(7)}, {cause, other}}),
             std::string("the answer is longer than the 7 bytes allowed: why; and why"));
  }
};

}  // namespace test_log

MAPWRIGHT_TEST(test_log, LogTest, Core)
#include "test_log.moc"
