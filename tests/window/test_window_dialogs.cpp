// Connect dialog, recent robots, command palette, shortcut sheet.
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "known_addresses.h"
#include "test_program.h"
#include "ui/kit/actions.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/robot/connect_dialog.h"
#include "ui/window/command_palette.h"
#include "ui/window/go_to_dialog.h"
#include "ui/window/shortcut_sheet.h"

namespace test_window_dialogs {

using namespace mapwright::ui;
namespace robot = mapwright::robot;

namespace {

QPushButton* button(QWidget& dialog, const char* text) {
  for (QPushButton* found : dialog.findChildren<QPushButton*>()) {
    if (found->text() == QLatin1String(text)) return found;
  }
  return nullptr;
}

struct Bench {
  Bench()
      : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat),
        recents(settings, mapwright::test::knownAddresses()) {
    loadResources();
  }
  QByteArray stored() {
    settings.sync();
    QFile file(settings.fileName());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QTemporaryDir folder;
  QSettings settings;
  RecentRobots recents;
};

/// A dialog that looks for robots: the test answers.
struct Looking {
  Bench bench;
  std::vector<robot::Host> hosts;
  std::vector<robot::Probe::Reply> replies;
  ConnectDialog::Wish wish;
  std::unique_ptr<ConnectDialog> dialog = std::make_unique<ConnectDialog>(
      bench.recents,
      [this](const ConnectDialog::Wish& made) {
        wish = made;
        return std::optional<QString>();
      },
      [this](const robot::Host& host) {
        hosts.push_back(host);
        const auto probe = [&](const char* title) {
          return robot::Probe{QLatin1String(title), QUrl(QStringLiteral("http://") + host.name),
                              [this](QObject*, std::chrono::milliseconds, robot::Probe::Reply reply) {
                                replies.push_back(std::move(reply));
                              }};
        };
        return std::vector{probe("Autoxing"), probe("Agibot")};
      });
  QPushButton* main() { return dialog->findChild<QPushButton*>(QStringLiteral("primary")); }
  QString state() { return dialog->findChild<QLabel*>(QStringLiteral("foundState"))->text(); }
  QListWidget* found() { return dialog->findChild<QListWidget*>(QStringLiteral("found")); }
  void type(const char* host) {
    dialog->show();
    QTest::keyClicks(dialog->findChild<QLineEdit*>(QStringLiteral("address")), QLatin1String(host));
  }
};

}  // namespace

class TestWindowDialogs : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void refusesABadAddressInPlace() {
    Bench bench;
    int attempts = 0;
    ConnectDialog dialog(bench.recents, [&](const ConnectDialog::Wish&) {
      ++attempts;
      return std::optional<QString>();
    });
    QVERIFY(!button(dialog, "Connect")->isEnabled());  // nothing typed yet
    dialog.show();
    auto* address = dialog.findChild<QLineEdit*>(QStringLiteral("address"));
    QTest::keyClicks(address, QStringLiteral("kabam+ws://192.0.2.7"));
    QTest::keyClick(address, Qt::Key_Return);
    QCOMPARE(attempts, 0);
    QVERIFY(!dialog.errorText().isEmpty());
    QVERIFY(dialog.isVisible());
    QTest::keyClick(address, Qt::Key_End);
    QTest::keyClicks(address, QStringLiteral("x"));
    QVERIFY(dialog.errorText().isEmpty());  // no complaint while it is being mended
  }

  void showsWhyItCouldNotStart() {
    Bench bench;
    ConnectDialog dialog(bench.recents, [](const ConnectDialog::Wish&) {
      return std::optional(QStringLiteral("<b>No</b> port is free."));
    });
    dialog.show();
    QTest::mouseClick(button(dialog, "Try the demo robot"), Qt::LeftButton);
    QCOMPARE(dialog.errorText(), QStringLiteral("<b>No</b> port is free."));
    QVERIFY(dialog.isVisible());
  }

  void handsOverTheSecretAndStoresNone() {
    Bench bench;
    QString got_address;
    QByteArray got_secret;
    ConnectDialog dialog(bench.recents, [&](const ConnectDialog::Wish& wish) {
      got_address = wish.address;
      got_secret = wish.secret;
      bench.recents.add(wish.address, QDateTime::currentDateTime());
      return std::optional<QString>();
    });
    dialog.show();
    auto* secret = dialog.findChild<QLineEdit*>(QStringLiteral("secret"));
    QCOMPARE(secret->echoMode(), QLineEdit::Password);
    QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("address")), QStringLiteral("192.0.2.7"));
    QTest::keyClicks(secret, QStringLiteral("hunter2"));
    QTest::mouseClick(button(dialog, "Connect"), Qt::LeftButton);
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QCOMPARE(got_address, QStringLiteral("axbot+http://192.0.2.7:8090"));
    QCOMPARE(got_secret, QByteArray("hunter2"));
    QVERIFY(bench.stored().contains("192.0.2.7"));
    QVERIFY(!bench.stored().contains("hunter2"));
  }

  void remembersRobotsNewestFirstAndForgets() {
    Bench bench;
    const QDateTime now(QDate(2024, 5, 1), QTime(12, 0));
    for (int i = 0; i < 20; ++i) bench.recents.add(QStringLiteral("192.0.2.%1").arg(i + 1), now.addSecs(i));
    bench.recents.add(QStringLiteral("192.0.2.15"), now.addSecs(99));
    auto list = bench.recents.list();
    QCOMPARE(list.size(), qsizetype(RecentRobots::kLimit));
    QCOMPARE(list[0].address, QStringLiteral("axbot+http://192.0.2.15:8090"));
    QCOMPARE(list[1].address, QStringLiteral("axbot+http://192.0.2.20:8090"));
    bench.recents.setName(list[1].address, QStringLiteral("dock-3"));
    RecentRobots again(bench.settings, mapwright::test::knownAddresses());
    QCOMPARE(again.list()[1].name, QStringLiteral("dock-3"));
    again.remove(list[0].address);
    QCOMPARE(again.list()[0].name, QStringLiteral("dock-3"));
    // A name of the user's leads, and outlasts robots without one.
    const QString oldest = again.list().back().address;
    again.setLook(oldest, {QStringLiteral("Old friend"), QStringLiteral("green")});
    for (int i = 0; i < 20; ++i) again.add(QStringLiteral("198.51.100.%1").arg(i + 1), now.addDays(i + 1));
    QCOMPARE(again.look(oldest).called, QStringLiteral("Old friend"));
    const RecentWords words = wordsOf(again.list().back(), again.addresses());
    QCOMPARE(words.title, QStringLiteral("Old friend"));
    QVERIFY2(words.detail.startsWith(QLatin1String("Autoxing, 192.0.2.")), qPrintable(words.detail));
    QVERIFY(wordsOf(again.list().front(), again.addresses()).title.startsWith(QLatin1String("198.51.100.")));
    bench.recents.add(QStringLiteral("http://user:pw@192.0.2.99"), now);  // never with a password
    QVERIFY(!bench.stored().contains("pw@"));
  }

  void offersRecentsAndLetsThemGo() {
    Bench bench;
    const QDateTime now(QDate(2024, 5, 1), QTime(12, 0));
    bench.recents.add(QStringLiteral("192.0.2.1"), now);
    bench.recents.setName(QStringLiteral("axbot+http://192.0.2.1:8090"), QStringLiteral("<i>evil</i>"));
    QString got;
    ConnectDialog dialog(bench.recents, [&](const ConnectDialog::Wish& wish) {
      got = wish.address;
      return std::optional<QString>();
    });
    dialog.show();
    auto* list = dialog.findChild<QListWidget*>(QStringLiteral("recents"));
    QCOMPARE(list->count(), 1);
    bool literal = false;
    for (const PlainLabel* label : list->findChildren<PlainLabel*>())
      literal |= label->text() == QLatin1String("<i>evil</i>");
    QVERIFY(literal);
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(got, QStringLiteral("axbot+http://192.0.2.1:8090"));
    QTest::mouseClick(list->findChild<QToolButton*>(), Qt::LeftButton);
    QTRY_VERIFY(bench.recents.list().isEmpty());
  }

  void aSecretIsNotHandedToAnotherRobot() {
    Bench bench;
    const QDateTime now(QDate(2024, 5, 1), QTime(12, 0));
    bench.recents.add(QStringLiteral("192.0.2.1"), now);
    ConnectDialog dialog(bench.recents, [](const ConnectDialog::Wish&) { return std::optional<QString>(); });
    dialog.show();
    dialog.askForSecret(QStringLiteral("axbot+http://192.0.2.7:8090"), {}, {});
    auto* secret = dialog.findChild<QLineEdit*>(QStringLiteral("secret"));
    QTest::keyClicks(secret, QStringLiteral("hunter2"));
    dialog.findChild<QListWidget*>(QStringLiteral("recents"))->setCurrentRow(0);
    QVERIFY(secret->text().isEmpty());
  }

  void anAddressIsMadeOfTheKindHostAndPort() {
    Bench bench;
    QString got;
    ConnectDialog dialog(bench.recents, [&](const ConnectDialog::Wish& wish) {
      got = wish.address;
      return std::optional<QString>();
    });
    dialog.show();
    auto* kind = dialog.findChild<QComboBox*>(QStringLiteral("kind"));
    auto* port = dialog.findChild<QSpinBox*>(QStringLiteral("port"));
    auto* made = dialog.findChild<QLabel*>(QStringLiteral("made"));
    QVERIFY(port->isHidden());
    kind->setCurrentIndex(kind->findText(QStringLiteral("Agibot")));
    QVERIFY(port->isVisible());
    QCOMPARE(port->value(), 50807);
    QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("address")), QStringLiteral("dock-3.local"));
    QVERIFY2(made->text().contains(QLatin1String("aimdk+http://dock-3.local:50807")),
             qPrintable(made->text()));
    port->setValue(443);
    dialog.findChild<QCheckBox*>(QStringLiteral("encrypted"))->setChecked(true);
    QTest::mouseClick(button(dialog, "Connect"), Qt::LeftButton);
    QCOMPARE(got, QStringLiteral("aimdk+https://dock-3.local:443"));
  }

  void looksForRobotsAtAHostAndConnectsToTheChosenOne() {
    Looking test;
    test.type("192.0.2.7:9000");
    QCOMPARE(test.main()->text(), QStringLiteral("Search"));
    QTest::keyClick(test.dialog->findChild<QLineEdit*>(QStringLiteral("address")), Qt::Key_Return);
    QCOMPARE(test.hosts.size(), std::size_t(1));
    QCOMPARE(test.hosts[0].port, std::optional(9000));
    QCOMPARE(test.main()->text(), QStringLiteral("Stop"));
    QVERIFY(test.wish.address.isEmpty());  // nothing is connected to before somebody has chosen
    test.replies[0]({{{.address = QStringLiteral("axbot+http://192.0.2.7:9000"), .wants_secret = true}}, {}});
    test.replies[1]({{}, mapwright::fault::said("not here")});
    QCOMPARE(test.found()->count(), 1);
    QCOMPARE(test.main()->text(), QStringLiteral("Connect"));
    QVERIFY(test.dialog->findChild<QLineEdit*>(QStringLiteral("secret"))
                ->placeholderText()
                .contains(QLatin1String("asks")));
    auto* reasons = test.dialog->findChild<QPlainTextEdit*>(QStringLiteral("foundReasons"));
    QVERIFY(reasons->isHidden());
    QTest::mouseClick(test.dialog->findChild<QToolButton*>(QStringLiteral("foundDetails")), Qt::LeftButton);
    QVERIFY(reasons->isVisible() && reasons->toPlainText().contains(QLatin1String("not here")));
    test.dialog->findChild<QLineEdit*>(QStringLiteral("calledName"))->setText(QStringLiteral("Dock 3"));
    QTest::mouseClick(test.main(), Qt::LeftButton);
    QCOMPARE(test.wish.address, QStringLiteral("axbot+http://192.0.2.7:9000"));
    QCOMPARE(test.wish.look.called, QStringLiteral("Dock 3"));
  }

  void theNameOfARobotDoesNotGoAlongToAnother() {
    Looking test;
    const QString known = QStringLiteral("axbot+http://192.0.2.7:8090");
    test.bench.recents.add(known, QDateTime(QDate(2024, 5, 1), QTime(12, 0)));
    test.bench.recents.setLook(known, {QStringLiteral("Dock 3"), QStringLiteral("green")});
    auto* name = test.dialog->findChild<QLineEdit*>(QStringLiteral("calledName"));
    test.dialog->setAddress(known);
    QCOMPARE(name->text(), QStringLiteral("Dock 3"));
    test.type("192.0.2.8");  // over the selected one
    QVERIFY(name->text().isEmpty());
    QCOMPARE(test.bench.recents.look(known).called, QStringLiteral("Dock 3"));
  }

  void theRecentRobotsStayWhereTheyAreWhateverIsSaidAbove() {
    Looking test;
    test.dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(test.dialog.get()));
    auto* const kind = test.dialog->findChild<QComboBox*>(QStringLiteral("kind"));
    auto* const address = test.dialog->findChild<QLineEdit*>(QStringLiteral("address"));
    const auto* const list = test.dialog->findChild<QListWidget*>(QStringLiteral("recents"));
    const auto where = [&] {
      QCoreApplication::processEvents();
      return list->mapTo(test.dialog.get(), QPoint());
    };
    for (const QString& prefix : {QString(), QStringLiteral("Autoxing"), QStringLiteral("Agibot")}) {
      kind->setCurrentIndex(prefix.isEmpty() ? 0 : kind->findText(prefix));
      const QPoint before = where();
      for (const char* typed : {"", "192.0.2.7", "axbot+http://192.0.2.9:9000/robots/7", "/maps/office.yaml",
                                "aimdk+https://a-robot-with-a-long-name.example.org:50807"}) {
        address->setText(QLatin1String(typed));
        QCOMPARE(where(), before);
      }
    }
  }

  void whatIsLookedForIsSaidAsItWasTyped() {
    Looking test;
    auto* const made = test.dialog->findChild<QLabel*>(QStringLiteral("made"));
    test.type("127.0.0.1:1234");
    QVERIFY2(made->text().contains(QLatin1String("kind of robot at 127.0.0.1:1234.")),
             qPrintable(made->text()));
    // A path makes no kind of it: it is looked for, too.
    test.dialog->findChild<QLineEdit*>(QStringLiteral("address"))->clear();
    test.type("127.0.0.1/x");
    QCOMPARE(test.main()->text(), QStringLiteral("Search"));
    test.main()->click();
    QVERIFY(test.wish.address.isEmpty());
    QCOMPARE(test.hosts.at(0).name, QStringLiteral("127.0.0.1"));
    QCOMPARE(test.hosts.at(0).path, QStringLiteral("/x"));
  }

  void saysThatThereIsNoRobot() {
    Looking test;
    test.type("192.0.2.7");
    test.main()->click();
    for (auto& reply : test.replies) reply({{}, mapwright::fault::said("it is not here")});
    QVERIFY2(test.state().contains(QLatin1String("it is not here")), qPrintable(test.state()));
    QVERIFY2(test.state().contains(QLatin1String("No robot answers at 192.0.2.7")), qPrintable(test.state()));
    QCOMPARE(test.main()->text(), QStringLiteral("Search"));
    test.main()->click();  // once more
    QCOMPARE(test.hosts.size(), std::size_t(2));
  }

  void saysWhatElseAnswers() {
    Looking test;
    test.type("http://192.0.2.7/dashboard");
    QCOMPARE(test.main()->text(), QStringLiteral("Search"));
    test.main()->click();
    QCOMPARE(test.hosts.at(0).name, QStringLiteral("192.0.2.7"));
    test.replies[0]({{}, mapwright::fault::said("refused")});
    test.replies[1]({{}, mapwright::fault::said("<b>a printer</b>"), true});
    QVERIFY2(test.state().contains(QLatin1String("http://192.0.2.7: <b>a printer</b>")),
             qPrintable(test.state()));
  }

  void aKindThatIsChosenChangesAWholeAddress() {
    Looking test;
    test.dialog->setAddress(QStringLiteral("axbot+https://192.0.2.7:8090"));
    test.dialog->show();
    auto* const kind = test.dialog->findChild<QComboBox*>(QStringLiteral("kind"));
    auto* const made = test.dialog->findChild<QLabel*>(QStringLiteral("made"));
    auto* const address = test.dialog->findChild<QLineEdit*>(QStringLiteral("address"));
    QTest::keyClick(kind, Qt::Key_Down);  // Autoxing, as the address says
    QCOMPARE(address->text(), QStringLiteral("axbot+https://192.0.2.7:8090"));
    QTest::keyClick(kind, Qt::Key_Down);
    QCOMPARE(address->text(), QStringLiteral("192.0.2.7"));
    QVERIFY2(made->text().contains(QLatin1String("aimdk+https://192.0.2.7:50807")), qPrintable(made->text()));
    // What is typed afterwards counts, and that is said.
    address->selectAll();
    test.type("axbot+http://192.0.2.9:9000/robots/7");
    QVERIFY2(made->text().contains(QLatin1String("The address overrides")), qPrintable(made->text()));
    QVERIFY(!test.dialog->findChild<QSpinBox*>(QStringLiteral("port"))->isEnabled());
    // Back to looking for any kind.
    QTest::keyClick(kind, Qt::Key_Home);
    QCOMPARE(address->text(), QStringLiteral("http://192.0.2.9:9000/robots/7"));
    QCOMPARE(test.main()->text(), QStringLiteral("Search"));
    address->selectAll();
    test.type("/maps/office.yaml");
    QTest::keyClick(kind, Qt::Key_Down);
    QVERIFY2(made->text().contains(QLatin1String("The address overrides")), qPrintable(made->text()));
  }

  void aPortThatIsNoneIsNamed() {
    Looking test;
    test.type("192.0.2.7:99999");
    test.main()->click();
    QVERIFY2(test.dialog->errorText().contains(QLatin1String("from 1 to 65535")),
             qPrintable(test.dialog->errorText()));
    QVERIFY(test.hosts.empty() && test.wish.address.isEmpty());
  }

  void aPortBeyondTheRangeIsMarkedAndNotTaken() {
    Looking test;
    test.dialog->show();
    QVERIFY(QTest::qWaitForWindowActive(test.dialog.get()));
    auto* const kind = test.dialog->findChild<QComboBox*>(QStringLiteral("kind"));
    kind->setCurrentIndex(kind->findText(QStringLiteral("Agibot")));
    auto* const port = test.dialog->findChild<QSpinBox*>(QStringLiteral("port"));
    test.dialog->findChild<QLineEdit*>(QStringLiteral("address"))->setText(QStringLiteral("192.0.2.7"));
    QVERIFY(test.main()->isEnabled());
    const int usual = port->value();
    port->setFocus();
    port->selectAll();
    QTest::keyClicks(port, QStringLiteral("99999"));
    QVERIFY2(port->text().endsWith(QLatin1String("99999")), qPrintable(port->text()));
    QVERIFY(port->property("beyond").toBool());
    // Nothing is connected to with another port than the one that can be seen.
    auto* const made = test.dialog->findChild<QLabel*>(QStringLiteral("made"));
    QCOMPARE(made->text(), QStringLiteral("A port is a number from 1 to 65535."));
    QVERIFY(!test.main()->isEnabled());
    QTest::keyClick(port, Qt::Key_Tab);
    QCOMPARE(port->value(), usual);
    QCOMPARE(test.dialog->findChild<QLabel*>(QStringLiteral("outOfRange"))->text(),
             QStringLiteral("99999 is too large: at most 65535."));
    QVERIFY2(!made->text().contains(QLatin1String("from 1 to")), qPrintable(made->text()));
    port->setFocus();
    port->selectAll();
    QTest::keyClicks(port, QStringLiteral("0"));
    QTest::keyClick(port, Qt::Key_Tab);
    QCOMPARE(port->value(), usual);
  }

  void aRobotWithoutANameLeadsWithItsHost() {
    Bench bench;
    const QDateTime now(QDate(2024, 5, 1), QTime(12, 0));
    const auto words = [&](const char* address) {
      bench.recents.add(QLatin1String(address), now);
      return wordsOf(bench.recents.list().front(), bench.recents.addresses());
    };
    const RecentWords usual = words("192.0.2.7");
    QCOMPARE(usual.title, QStringLiteral("192.0.2.7"));
    QCOMPARE(usual.detail, QStringLiteral("axbot+http://192.0.2.7:8090"));
    QCOMPARE(words("192.0.2.7:9000").title, QStringLiteral("192.0.2.7:9000"));
  }

  void aSearchIsStoppedByHandByTypingAndByClosing() {
    Looking test;
    test.type("192.0.2.7");
    test.main()->click();
    test.main()->click();
    QVERIFY2(test.state().contains(QLatin1String("Stopped")), qPrintable(test.state()));
    test.main()->click();
    test.type("1");
    QVERIFY(test.found()->isHidden() || !test.found()->isVisible());
    test.main()->click();
    test.dialog.reset();  // what answers later finds nobody: sanitizers would tell
  }

  void goToShowsItsWholeError() {
    GoToDialog dialog({0, 0});
    dialog.show();
    const QSize before = dialog.size();
    dialog.field()->setText(QStringLiteral("here"));
    QCoreApplication::processEvents();
    const QLabel* error = dialog.errorLabel();
    QVERIFY(!error->text().isEmpty());
    QVERIFY2(error->height() >= error->heightForWidth(error->width()), qPrintable(error->text()));
    QVERIFY(dialog.rect().contains(error->geometry()));
    QCOMPARE(dialog.size(), before);  // it does not jump while one types
  }

  void paletteRunsTheBestCommand() {
    loadResources();
    Actions actions;
    int fits = 0, others = 0;
    connect(actions.add(QStringLiteral("View"), QStringLiteral("filter"), QStringLiteral("Filter submaps"),
                        {}, {}, Reach::Everywhere, QStringLiteral("x")),
            &QAction::triggered, this, [&] { ++others; });
    connect(actions.add(QStringLiteral("Map"), QStringLiteral("fit"), QStringLiteral("&Fit"), {},
                        {QKeySequence(Qt::Key_F)}, Reach::Map, QStringLiteral("x")),
            &QAction::triggered, this, [&] { ++fits; });
    actions
        .add(QStringLiteral("Map"), QStringLiteral("off"), QStringLiteral("Fit never"), {}, {}, Reach::Map,
             QStringLiteral("x"))
        ->setEnabled(false);
    CommandPalette palette(actions, Findings(), nullptr);
    palette.show();
    QCOMPARE(palette.list()->count(), 3);
    QTest::keyClicks(palette.field(), QStringLiteral("fit"));
    QCOMPARE(palette.list()->item(0)->text(), QStringLiteral("Fit"));
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QCOMPARE(fits, 1);
    QCOMPARE(others, 0);
    CommandPalette again(actions, Findings(), nullptr);
    again.show();
    QTest::keyClicks(again.field(), QStringLiteral("never"));
    QTest::keyClick(again.field(), Qt::Key_Return);
    QVERIFY(again.isVisible());  // what cannot be done now does not run
  }

  void thePaletteSaysThatMoreWasFound() {
    loadResources();
    Actions actions;
    Findings findings;
    int count = 60;
    findings.add([&count]() -> Findings::Search {
      return [&count](const QString&, const Findings::See& see) {
        for (int i = 0; i < count; ++i)
          see({QStringLiteral("Dock %1").arg(i), QStringLiteral("Waypoint"), {}, {}});
      };
    });
    CommandPalette palette(actions, findings, nullptr);
    palette.show();
    QTest::keyClicks(palette.field(), QStringLiteral("dock"));
    QCOMPARE(palette.list()->count(), 60);
    count = 63;
    palette.field()->setText(QStringLiteral("doc"));
    QCOMPARE(palette.list()->count(), 61);
    const QListWidgetItem* const last = palette.list()->item(60);
    QCOMPARE(last->text(), QStringLiteral("3 more are not listed: type more of the name"));
    QVERIFY(!last->flags().testFlag(Qt::ItemIsEnabled));
  }

  void sheetShowsEveryKey() {
    loadResources();
    Actions actions;
    actions.add(QStringLiteral("Map"), QStringLiteral("fit"), QStringLiteral("&Fit"), {},
                {QKeySequence(Qt::Key_F)}, Reach::Map, QStringLiteral("x"));
    QWidget parent;
    QDialog* sheet = makeShortcutSheet(actions, &parent);
    QStringList texts;
    for (const PlainLabel* label : sheet->findChildren<PlainLabel*>()) texts << label->text();
    QVERIFY(texts.contains(QStringLiteral("Fit")));
    QVERIFY(texts.contains(QStringLiteral("F")));
    QVERIFY(texts.contains(QStringLiteral("Ctrl+wheel")));
  }
};

}  // namespace test_window_dialogs

MAPWRIGHT_TEST(test_window_dialogs, TestWindowDialogs, Widgets)
#include "test_window_dialogs.moc"
