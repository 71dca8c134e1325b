// A certificate that is not trusted, in the window: said, shown, decided on, remembered for that robot alone.
#include <QLabel>
#include <QPushButton>

#include "net/faults.h"
#include "test_program.h"
#include "ui/robot/certificate_dialog.h"
#include "ui/robot/recent_robots.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_certificates {

using namespace mapwright;
using namespace mapwright::test;
using ui::CertificateDialog;
using ui::TrustedCertificates;

namespace {

const QString kFirst = QStringLiteral("AA:").repeated(31) + QStringLiteral("AA");
const QString kSecond = QStringLiteral("BB:").repeated(31) + QStringLiteral("BB");
const QString kHost = QStringLiteral("192.0.2.7:8090");

robot::ConnectionState refused(const QString& sha256, const QString& pinned = {}) {
  robot::ConnectionState state;
  state.phase = robot::ConnectionPhase::Refused;
  state.failure = map::FailureKind::Certificate;
  state.reason = fault::said("the certificate of 192.0.2.7:8090 is not trusted: it is self-signed");
  robot::UntrustedCertificate certificate;
  certificate.host = kHost;
  certificate.why = {net::fault::SelfSigned};
  certificate.sha256 = sha256;
  certificate.pinned_sha256 = pinned;
  certificate.subject = QStringLiteral("<b>Robot</b> 7");
  certificate.trustable = true;
  state.certificate = certificate;
  return state;
}

QString textOf(const QWidget& widget) {
  QString text;
  for (const QLabel* label : widget.findChildren<QLabel*>()) text += label->text() + QLatin1Char('\n');
  return text;
}

QPushButton* button(QWidget& widget, const QString& text) {
  for (QPushButton* found : widget.findChildren<QPushButton*>()) {
    if (found->text() == text && found->isVisibleTo(&widget)) return found;
  }
  return nullptr;
}

}  // namespace

class WindowCertificatesTest : public QObject {
  Q_OBJECT

  /// A window whose robot shows a certificate in its first connection.
  static void openOn(Bench& bench, const robot::ConnectionState& state) {
    bench.prepare = [](FakeRobot& made) { made.auto_online = false; };
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    bench.robot->setState(state);
  }
  static CertificateDialog* look(Bench& bench) {
    auto* card = bench.window->findChild<ui::EmptyStateCard*>();
    QPushButton* const offer = card ? button(*card, QStringLiteral("Certificate…")) : nullptr;
    if (offer) offer->click();
    return bench.window->findChild<CertificateDialog*>();
  }

 private Q_SLOTS:
  void isSaidInTheMiddleOfTheMapAndShownInFull() {
    Bench bench;
    openOn(bench, refused(kFirst));
    auto* card = bench.window->findChild<ui::EmptyStateCard*>();
    QVERIFY(card && card->isVisible());
    QVERIFY(textOf(*card).contains(QStringLiteral("not trusted")));
    QVERIFY(textOf(*card).contains(QStringLiteral("it is self-signed")));
    CertificateDialog* const dialog = look(bench);
    QVERIFY(dialog);
    QTRY_VERIFY(dialog->isVisible());
    const QString shown = textOf(*dialog).remove(QLatin1Char('\n'));
    QVERIFY(shown.contains(kFirst));
    QVERIFY2(shown.contains(QStringLiteral("<b>Robot</b> 7")), "names are plain text");
    for (const QLabel* label : dialog->findChildren<QLabel*>()) {
      if (label->text().contains(QStringLiteral("Robot"))) QCOMPARE(label->textFormat(), Qt::PlainText);
    }
    QVERIFY2(!dialog->trustButton()->isDefault(), "Return must not trust");
  }

  void isTrustedOnlyWhenTheUserSaysSo() {
    Bench bench;
    openOn(bench, refused(kFirst));
    CertificateDialog* dialog = look(bench);
    QVERIFY(dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    QTRY_VERIFY(!bench.window->findChild<CertificateDialog*>());
    QVERIFY(bench.robot->trusted.isEmpty());
    QVERIFY(TrustedCertificates(bench.settings).of(kHost).isEmpty());

    dialog = look(bench);
    QVERIFY(dialog);
    dialog->trustButton()->click();
    QCOMPARE(bench.robot->trusted, QStringList{kFirst});
    QCOMPARE(TrustedCertificates(bench.settings).of(kHost), kFirst);
    QVERIFY2(TrustedCertificates(bench.settings).of(QStringLiteral("192.0.2.7:8091")).isEmpty(),
             "for this robot alone");
  }

  void aChangedOneShowsBothFingerprints() {
    Bench bench;
    openOn(bench, refused(kSecond, kFirst));
    CertificateDialog* const dialog = look(bench);
    QVERIFY(dialog);
    const QString shown = textOf(*dialog);
    QVERIFY(shown.contains(QStringLiteral("has changed")));
    const QString together = QString(shown).remove(QLatin1Char('\n'));
    QVERIFY(together.contains(kFirst));
    QVERIFY(together.contains(kSecond));
    dialog->trustButton()->click();
    QCOMPARE(TrustedCertificates(bench.settings).of(kHost), kSecond);
  }

  void aDecisionIsAboutTheCertificateThatWasShown() {
    Bench bench;
    openOn(bench, refused(kFirst));
    CertificateDialog* const dialog = look(bench);
    QVERIFY(dialog);
    bench.robot->setState(refused(kSecond));  // meanwhile
    dialog->trustButton()->click();
    QVERIFY(bench.robot->trusted.isEmpty());
    QVERIFY(TrustedCertificates(bench.settings).of(kHost).isEmpty());
  }

  void aWithdrawnOneCannotBeTrusted() {
    Bench bench;
    robot::ConnectionState state = refused(kFirst);
    state.certificate->trustable = false;
    openOn(bench, state);
    CertificateDialog* const dialog = look(bench);
    QVERIFY(dialog);
    QVERIFY(!dialog->trustButton()->isEnabled());
  }

  void isOfferedAboveAMapThatIsOnScreen() {
    Bench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    bench.load();
    bench.robot->setState(refused(kSecond, kFirst));
    ui::NoticeBar* const notice = ui::part<ui::MapOverlay>(*bench.window)->notice();
    QVERIFY(notice);
    QTRY_VERIFY(notice->isVisible());
    QPushButton* const offer = button(*notice, QStringLiteral("Certificate…"));
    QVERIFY(offer);
    offer->click();
    QVERIFY(bench.window->findChild<CertificateDialog*>());
  }

  void thatOfAServerBesideTheRobotIsDecidedOnToo() {
    Bench bench;
    bench.open();
    QVERIFY(!bench.window->connectTo(kAddress));
    bench.load();
    ui::NoticeBar* const notice = ui::part<ui::MapOverlay>(*bench.window)->notice();
    robot::UntrustedCertificate beside = *refused(kSecond).certificate;
    beside.host = QStringLiteral("192.0.2.7:9090");
    bench.robot->beside = beside;
    Q_EMIT bench.robot->connectionChanged();
    QTRY_VERIFY(notice->isVisible());
    QVERIFY2(notice->sentence().contains(beside.host), qPrintable(notice->sentence()));
    QPushButton* const offer = button(*notice, QStringLiteral("Certificate…"));
    QVERIFY(offer);
    offer->click();
    auto* const dialog = bench.window->findChild<CertificateDialog*>();
    QVERIFY(dialog && textOf(*dialog).contains(beside.host));
    dialog->trustButton()->click();
    QCOMPARE(bench.robot->trusted_beside, QStringList{kSecond});
    QVERIFY2(bench.robot->trusted.isEmpty(), "the robot's own is another one");
    QCOMPARE(TrustedCertificates(bench.settings).of(beside.host), kSecond);
    QVERIFY(TrustedCertificates(bench.settings).of(kHost).isEmpty());
    bench.robot->beside.reset();
    Q_EMIT bench.robot->connectionChanged();
    QTRY_VERIFY(!notice->isVisible());
  }

  void aForgottenRobotIsNotTrustedAnyMore() {
    Bench bench;
    TrustedCertificates trusted(bench.settings);
    const QString address = QStringLiteral("axbot+https://192.0.2.7:8090");
    ui::RecentRobots recents(bench.settings, knownAddresses());
    recents.add(address, QDateTime::currentDateTime());
    trusted.trust(kHost, kFirst);
    trusted.trust(QStringLiteral("192.0.2.8:8090"), kSecond);
    recents.remove(address);
    QVERIFY(trusted.of(kHost).isEmpty());
    QCOMPARE(trusted.of(QStringLiteral("192.0.2.8:8090")), kSecond);
  }
};

}  // namespace test_window_certificates

MAPWRIGHT_TEST(test_window_certificates, WindowCertificatesTest, Widgets)
#include "test_window_certificates.moc"
