// Secrets in the key ring, names and colours of robots, and what is kept of a connection: on a key ring of
// the test's own.
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>

#include "keyring/faults.h"
#include "keyring/key_ring.h"
#include "test_program.h"
#include "ui/robot/connection_chip.h"
#include "ui/robot/connection_controller.h"
#include "ui/robot/kept_secrets.h"
#include "ui/robot/recent_robots.h"
#include "ui/robot/robot_look.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"

namespace test_window_secrets {

using namespace mapwright;
using test::kAddress;
using ui::ConnectionChip;
using ui::part;
using ui::RecentRobots;

namespace {

const QString kServer = QStringLiteral("http://192.0.2.7:8090");

class FakeKeyRing : public keyring::KeyRing {
 public:
  void read(const QString& name, Reply reply) override {
    later(std::move(reply), {trouble.any() ? QByteArray() : secrets.value(name), trouble});
  }
  void write(const QString& name, const QByteArray& secret, Reply reply) override {
    if (!trouble.any()) secrets[name] = secret;
    later(std::move(reply), {{}, trouble});
  }
  void remove(const QString& name, Reply reply) override {
    if (!trouble.any()) secrets.remove(name);
    later(std::move(reply), {{}, trouble});
  }
  QMap<QString, QByteArray> secrets;
  Fault trouble;

 private:
  void later(Reply reply, keyring::KeyRingAnswer answer) {
    QTimer::singleShot(0, &context_, [reply = std::move(reply), answer] { reply(answer); });
  }
  QObject context_;
};

struct SecretsBench : test::Bench {
  SecretsBench() { keys = &ring; }
  QMessageBox* question() { return window->findChild<QMessageBox*>(QStringLiteral("keepSecret")); }
  void answer(const char* text) {
    for (QAbstractButton* one : question()->buttons()) {
      if (one->text() == QLatin1String(text)) return one->click();
    }
  }
  QByteArray stored() {
    settings.sync();
    QFile file(settings.fileName());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  /// Whether any message says so.
  bool told(const char* words) {
    return !part<ui::MapOverlay>(*window)->toasts()->texts().filter(QLatin1String(words)).isEmpty();
  }
  FakeKeyRing ring;
};

}  // namespace

class TestWindowSecrets : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSecretIsKeptInTheKeyRingAndNowhereElse() {
    SecretsBench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress, "hunter2"));
    QTRY_VERIFY(bench.question());
    QVERIFY(bench.ring.secrets.isEmpty());  // not before it is allowed
    bench.answer("Keep");
    QTRY_COMPARE(bench.ring.secrets.value(kServer), QByteArray("hunter2"));
    QTRY_VERIFY(bench.told("in the key ring"));
    QVERIFY(!bench.stored().contains("hunter2"));
    // The next time nobody types it, and nobody asks.
    bench.secret.clear();
    QVERIFY(!bench.window->connectTo(kAddress));
    QTRY_COMPARE(bench.secret, QByteArray("hunter2"));
    QTRY_VERIFY(!bench.question());
    // It goes with the robot.
    QAction* const connect = bench.action("connect");
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      dialog->findChild<QListWidget*>(QStringLiteral("recents"))->findChild<QToolButton*>()->click();
      dialog->reject();
    });
    connect->trigger();
    QTRY_VERIFY(bench.ring.secrets.isEmpty());
    QVERIFY(!bench.stored().contains("8090"));
  }

  void neverIsNeverAndNotNowIsNotNow() {
    SecretsBench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress, "one"));
    QTRY_VERIFY(bench.question());
    bench.answer("Not now");
    QTRY_VERIFY(!bench.question());
    QVERIFY(!bench.window->connectTo(kAddress, "one"));
    QTRY_VERIFY(bench.question());
    bench.answer("Never for this robot");
    QTRY_VERIFY(!bench.question());
    QVERIFY(!bench.window->connectTo(kAddress, "one"));
    QCoreApplication::processEvents();
    QVERIFY(!bench.question());
    QVERIFY(bench.ring.secrets.isEmpty());
  }

  void aSecretThatDoesNotWorkIsNotKept() {
    SecretsBench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.auto_online = false; };
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress, "wrong"));
    robot::ConnectionState refused;
    refused.phase = robot::ConnectionPhase::Refused;
    refused.failure = map::FailureKind::Refused;
    bench.robot->setState(refused);
    QVERIFY(!bench.question());
    QVERIFY(RecentRobots(bench.settings, test::knownAddresses()).list().isEmpty());  // it never worked
  }

  void withoutAKeyRingEverythingElseWorks() {
    SecretsBench bench;
    bench.ring.trouble = Fault(keyring::fault::NoKeyRing);
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress, "hunter2"));
    QTRY_VERIFY(bench.question());
    bench.answer("Keep");
    QTRY_VERIFY(bench.told("no key ring"));
    QVERIFY(bench.window->session());
    // Kept once, and now the key ring is locked: the robot is connected to without it.
    bench.ring.trouble = {};
    QVERIFY(!bench.window->connectTo(kAddress, "hunter2"));
    QTRY_VERIFY(bench.question());
    bench.answer("Keep");
    QTRY_VERIFY(bench.ring.secrets.contains(kServer) && bench.told("in the key ring"));
    bench.ring.trouble = Fault(keyring::fault::KeyRingDenied);
    bench.secret = "not asked";
    QVERIFY(!bench.window->connectTo(kAddress));
    QTRY_COMPARE(bench.secret, QByteArray());
    QTRY_VERIFY(bench.told("locked"));
  }

  void aRobotHasTheNameAndColourOfItsUser() {
    SecretsBench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    bench.robot->identify({{}, {}, QStringLiteral("own name"), {}});
    auto* const chip = part<ConnectionChip>(*bench.window);
    QCOMPARE(chip->name(), QStringLiteral("own name"));
    QVERIFY(!chip->color().isValid());
    bench.action("robotLook")->trigger();
    auto* const dialog = part<ui::RobotLookDialog>(*bench.window);
    QVERIFY(dialog);
    dialog->findChild<QLineEdit*>(QStringLiteral("calledName"))->setText(QStringLiteral("Dock 3"));
    auto* const color = dialog->findChild<QComboBox*>(QStringLiteral("calledColor"));
    color->setCurrentIndex(color->findData(QStringLiteral("green")));
    dialog->findChild<QPushButton*>(QStringLiteral("primary"))->click();
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    QCOMPARE(chip->color(), ui::robotColor(QStringLiteral("green")));
    QVERIFY(bench.window->windowTitle().contains(QLatin1String("Dock 3")));
    const auto recent = RecentRobots(bench.settings, test::knownAddresses()).list().front();
    QCOMPARE(recent.look.called, QStringLiteral("Dock 3"));
    // It is there again the next time, and only for this robot.
    QVERIFY(!bench.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QVERIFY(chip->name() != QLatin1String("Dock 3") && !chip->color().isValid());
    QVERIFY(!bench.window->connectTo(kAddress));
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
  }

  void aRobotThatRefusesHasItsNameAtOnceAndIsNotKept() {
    SecretsBench bench;
    bench.prepare = [](test::FakeRobot& robot) { robot.auto_online = false; };
    bench.open();
    const auto inDialog = [&](const std::function<void(QDialog&)>& then) {
      QTimer::singleShot(0, [&] {
        auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        then(*dialog);
        dialog->reject();
      });
      bench.action("connect")->trigger();
    };
    inDialog([](QDialog& dialog) {
      dialog.findChild<QLineEdit*>(QStringLiteral("address"))->setText(kAddress);
      QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("calledName")), QStringLiteral("Dock 3"));
      dialog.findChild<QPushButton*>(QStringLiteral("primary"))->click();
    });
    robot::ConnectionState refused;
    refused.phase = robot::ConnectionPhase::Refused;
    refused.failure = map::FailureKind::Refused;
    auto* const chip = part<ConnectionChip>(*bench.window);
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    bench.robot->setState(refused);
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    const auto nameShown = [](QDialog& dialog) {
      return dialog.findChild<QLineEdit*>(QStringLiteral("calledName"))->text();
    };
    QString shown;
    inDialog([&](QDialog& dialog) { shown = nameShown(dialog); });
    QCOMPARE(shown, QStringLiteral("Dock 3"));
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    // Also once it was left, and not for another one.
    bench.window->leaveRobot();
    inDialog([&](QDialog& dialog) {
      auto* const address = dialog.findChild<QLineEdit*>(QStringLiteral("address"));
      QTest::keyClicks(address, kAddress);
      shown = nameShown(dialog);
      QTest::keyClick(address, Qt::Key_Backspace);
      QVERIFY(nameShown(dialog).isEmpty());
    });
    QCOMPARE(shown, QStringLiteral("Dock 3"));
    QVERIFY(RecentRobots(bench.settings, test::knownAddresses()).list().isEmpty());
    QVERIFY(!bench.stored().contains("Dock 3"));
    // It works: now it is kept.
    bench.prepare = {};
    QVERIFY(!bench.window->connectTo(kAddress));
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    QCOMPARE(RecentRobots(bench.settings, test::knownAddresses()).list().front().look.called,
             QStringLiteral("Dock 3"));
  }

  void aRobotKeepsItsNameWhenItIsConnectedToAgain() {
    SecretsBench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    auto* const chip = part<ConnectionChip>(*bench.window);
    QCOMPARE(chip->name(), QStringLiteral("192.0.2.7"));  // it tells no name
    RecentRobots(bench.settings, test::knownAddresses()).setLook(kAddress, {QStringLiteral("Dock 3"), {}});
    // By the dialog with the fields left as they are, and with the name left out.
    for (const bool emptied : {false, true}) {
      QTimer::singleShot(0, [&] {
        auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (emptied) dialog->findChild<QLineEdit*>(QStringLiteral("calledName"))->clear();
        dialog->findChild<QPushButton*>(QStringLiteral("primary"))->click();
        dialog->reject();
      });
      bench.action("connect")->trigger();
      QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
      QVERIFY(bench.window->windowTitle().contains(QLatin1String("Dock 3")));
    }
    bench.robot->goAway(QStringLiteral("gone"));
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    bench.robot->goOnline();
    QCOMPARE(chip->name(), QStringLiteral("Dock 3"));
    QCOMPARE(RecentRobots(bench.settings, test::knownAddresses()).look(kAddress).called,
             QStringLiteral("Dock 3"));
  }

  void everyColourHasAnIdANameAndALookOfItsOwn() {
    QSet<QString> ids, names;
    QSet<QRgb> looks;
    for (const ui::RobotColor& one : ui::robotColors()) {
      ids << one.id;
      names << one.name;
      looks << one.color.rgb();
    }
    const auto count = qsizetype(ui::robotColors().size());
    QVERIFY(ids.size() == count && names.size() == count && looks.size() == count);
    QVERIFY(!ui::robotColor(QStringLiteral("mauve")).isValid());
  }

  void aFileIsOpenAndNotConnected() {
    SecretsBench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(QStringLiteral("file:/maps/office.yaml")));
    auto* const chip = part<ConnectionChip>(*bench.window);
    QVERIFY2(!chip->toolTip().contains(QLatin1String("connected")), qPrintable(chip->toolTip()));
    QCOMPARE(chip->word(), QStringLiteral("file"));
    QVERIFY(bench.action("closeFile")->isEnabled() && !bench.action("disconnect")->isEnabled());
    QVERIFY(!bench.action("robotLook")->isVisible());
    for (const QLabel* label : bench.window->findChildren<QLabel*>())
      QVERIFY2(!label->isVisible() || !label->text().contains(QLatin1String("onnected")),
               qPrintable(label->text()));
  }
};

}  // namespace test_window_secrets

MAPWRIGHT_TEST(test_window_secrets, TestWindowSecrets, Widgets)
#include "test_window_secrets.moc"
