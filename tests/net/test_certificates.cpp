// Encrypted connections, HTTP and WebSocket alike: which certificates are accepted, and that nothing is sent
// to a server whose certificate is not.
#include <QTemporaryDir>
#include <QtTest>

#include "fault_arguments.h"
#include "net/http_client.h"
#include "net/web_socket_link.h"
#include "secure_server.h"
#include "test_program.h"

namespace test_certificates {

using namespace mapwright;
using namespace mapwright::net;
using testing::SecureServer;

namespace {

/// How one try to connect ended.
struct Ending {
  bool connected = false;
  std::optional<CertificateFault> fault;
  Fault reason;
};

Ending overHttp(const SecureServer& server, const Trust& trust, const QByteArray& secret) {
  HttpClient client(server.url(QStringLiteral("https")), secret, nullptr);
  client.setTrust(trust);
  HttpRequest request;
  request.url = server.url(QStringLiteral("https"));
  std::optional<HttpAnswer> answer;
  client.send(request, [&](HttpAnswer given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, 20'000)) return {};
  if ((answer->kind == HttpAnswer::Kind::Certificate) != answer->certificate.has_value()) return {};
  return {answer->ok(), answer->certificate, answer->reason};
}

Ending overWebSocket(const SecureServer& server, const Trust& trust, const QByteArray& secret) {
  WebSocketLink link({server.url(QStringLiteral("wss"))}, secret, {});
  link.setTrust(trust);
  link.open();
  using State = WebSocketLink::State;
  if (!QTest::qWaitFor([&] { return link.state() != State::Connecting; }, 20'000)) return {};
  if ((link.failure() == WebSocketLink::Failure::Certificate) != link.certificate().has_value()) return {};
  return {link.state() == State::Open, link.certificate(), link.reason()};
}

}  // namespace

class TestCertificates : public QObject {
  Q_OBJECT

  static void addTransports(const char* name, const std::function<void(const char*, bool)>& row) {
    row(qPrintable(QStringLiteral("https, ") + QLatin1String(name)), false);
    row(qPrintable(QStringLiteral("wss, ") + QLatin1String(name)), true);
  }
  static Ending connectTo(bool web_socket, const SecureServer& server, const Trust& trust) {
    return web_socket ? overWebSocket(server, trust, "hush") : overHttp(server, trust, "hush");
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(QSslSocket::supportsSsl());
    QVERIFY(!testing::certificate(QStringLiteral("authority")).isNull());
  }

  void whatIsNotTrustedIsToldWithItsReasonAndSeesNothing_data() {
    QTest::addColumn<bool>("web_socket");
    QTest::addColumn<QString>("certificate");
    QTest::addColumn<bool>("authority_known");
    QTest::addColumn<QStringList>("reasons");
    QTest::addColumn<QStringList>("words");
    const auto add = [](const char* certificate, bool known, std::initializer_list<FaultCode> reasons,
                        const QStringList& words) {
      addTransports(certificate, [&](const char* name, bool web_socket) {
        QStringList texts;
        for (const FaultCode& reason : reasons) texts << QLatin1String(reason.text);
        QTest::addRow("%s, %s", name, known ? "authority known" : "authority unknown")
            << web_socket << QString::fromLatin1(certificate) << known << texts << words;
      });
    };
    add("self_signed", false, {net::fault::SelfSigned}, {});
    add("self_signed", true, {net::fault::SelfSigned}, {});
    add("signed", false, {net::fault::AuthorityUnknown}, {QStringLiteral("Fleet authority")});
    add("expired", true, {net::fault::CertificateExpired}, {QStringLiteral("2021-03-04")});
    add("not_yet_valid", true, {net::fault::CertificateNotYetValid}, {QStringLiteral("2119-05-06")});
    add("signed_other_name", true, {net::fault::CertificateOfOtherName}, {QStringLiteral("robot8.example")});
    add("other_name", false, {net::fault::CertificateOfOtherName, net::fault::SelfSigned},
        {QStringLiteral("robot8.example")});
  }
  void whatIsNotTrustedIsToldWithItsReasonAndSeesNothing() {
    QFETCH(bool, web_socket);
    QFETCH(QString, certificate);
    QFETCH(bool, authority_known);
    QFETCH(QStringList, reasons);
    QFETCH(QStringList, words);
    SecureServer server(certificate);
    Trust trust;
    if (authority_known) trust.authorities = {testing::certificate(QStringLiteral("authority"))};
    const Ending ending = connectTo(web_socket, server, trust);
    QVERIFY(!ending.connected);
    QVERIFY2(ending.fault, qPrintable(argumentsOf(ending.reason).join(QLatin1Char('|'))));
    for (const Fault& why : ending.fault->whys) QVERIFY(reasons.contains(QLatin1String(why.code.text)));
    QCOMPARE(ending.fault->whys.size(), std::size_t(reasons.size()));
    QCOMPARE(ending.fault->sha256, testing::sha256(certificate));
    QVERIFY(ending.fault->trustable());
    QCOMPARE(ending.reason.code, net::fault::CertificateUntrusted);
    QCOMPARE(ending.reason.because.size(), std::size_t(reasons.size()));
    QStringList details;
    for (const Fault& why : ending.reason.because) details << argumentsOf(why);
    QCOMPARE(details, words);
    QCOMPARE(argumentsOf(ending.reason), (QStringList{QStringLiteral("127.0.0.1:%1").arg(server.port()),
                                                      fingerprintText(testing::sha256(certificate))}));
    QVERIFY(server.seen.isEmpty());
  }

  void anAuthorityFromAFileIsBelieved_data() { transports(); }
  void anAuthorityFromAFileIsBelieved() {
    QFETCH(bool, web_socket);
    SecureServer server(QStringLiteral("signed"));
    const auto authorities = readAuthorities(QStringLiteral(MAPWRIGHT_TEST_DATA "/tls/authority.pem"));
    QVERIFY(authorities);
    Trust trust;
    trust.authorities = *authorities;
    const Ending ending = connectTo(web_socket, server, trust);
    QVERIFY2(ending.connected, qPrintable(argumentsOf(ending.reason).value(0)));
    QCOMPARE(server.seen.size(), 1);
    QVERIFY(server.seen[0].contains("hush"));
  }

  void aSelfSignedCertificateInTheFileIsBelieved_data() { transports(); }
  void aSelfSignedCertificateInTheFileIsBelieved() {
    QFETCH(bool, web_socket);
    SecureServer server(QStringLiteral("self_signed"));
    Trust trust;
    trust.authorities = {testing::certificate(QStringLiteral("self_signed"))};
    QVERIFY(connectTo(web_socket, server, trust).connected);
  }

  void thePinnedCertificateIsAcceptedWhateverIsWrongWithIt_data() {
    QTest::addColumn<bool>("web_socket");
    QTest::addColumn<QString>("certificate");
    for (const char* certificate : {"self_signed", "other_name", "expired", "not_yet_valid", "signed"}) {
      addTransports(certificate, [&](const char* name, bool web_socket) {
        QTest::addRow("%s", name) << web_socket << QString::fromLatin1(certificate);
      });
    }
  }
  void thePinnedCertificateIsAcceptedWhateverIsWrongWithIt() {
    QFETCH(bool, web_socket);
    QFETCH(QString, certificate);
    SecureServer server(certificate);
    Trust trust;
    trust.pinned_sha256 = testing::sha256(certificate);
    const Ending ending = connectTo(web_socket, server, trust);
    QVERIFY2(ending.connected, qPrintable(argumentsOf(ending.reason).value(0)));
    QVERIFY(server.seen.value(0).contains("hush"));
  }

  void anotherCertificateThanThePinnedOneIsRefusedWhoeverVouchesForIt_data() {
    QTest::addColumn<bool>("web_socket");
    QTest::addColumn<QString>("certificate");
    for (const char* certificate : {"other_self_signed", "signed", "expired"}) {
      addTransports(certificate, [&](const char* name, bool web_socket) {
        QTest::addRow("%s", name) << web_socket << QString::fromLatin1(certificate);
      });
    }
  }
  void anotherCertificateThanThePinnedOneIsRefusedWhoeverVouchesForIt() {
    QFETCH(bool, web_socket);
    QFETCH(QString, certificate);
    SecureServer server(certificate);
    Trust trust;
    trust.pinned_sha256 = testing::sha256(QStringLiteral("self_signed"));
    trust.authorities = {testing::certificate(QStringLiteral("authority"))};
    const Ending ending = connectTo(web_socket, server, trust);
    QVERIFY(!ending.connected);
    QVERIFY(ending.fault);
    QCOMPARE(ending.fault->whys, std::vector<Fault>{net::fault::CertificateIsAnother});
    QCOMPARE(ending.reason.code, net::fault::CertificateChanged);
    QVERIFY(argumentsOf(ending.reason).contains(fingerprintText(trust.pinned_sha256)));
    QVERIFY(argumentsOf(ending.reason).contains(fingerprintText(testing::sha256(certificate))));
    QVERIFY(server.seen.isEmpty());
  }

  void aPinMayBeSetOnAClientThatWasRefused() {
    SecureServer server(QStringLiteral("self_signed"));
    WebSocketLink link({server.url(QStringLiteral("wss"))}, {}, {});
    link.open();
    QTRY_COMPARE(link.state(), WebSocketLink::State::Closed);
    QCOMPARE(link.failure(), WebSocketLink::Failure::Certificate);
    Trust trust;
    trust.pinned_sha256 = link.certificate()->sha256;
    link.setTrust(trust);
    link.open();
    QTRY_COMPARE(link.state(), WebSocketLink::State::Open);
    QCOMPARE(link.failure(), WebSocketLink::Failure::None);
    QVERIFY(!link.certificate());
  }

  void aWithdrawnCertificateIsNotForTheUserToTrust() {
    Trust trust;
    const QSslCertificate leaf = testing::certificate(QStringLiteral("signed"));
    trust.pinned_sha256 = leaf.digest(QCryptographicHash::Sha256);
    const QUrl url(QStringLiteral("https://h:8443"));
    const auto fault = faultOf(trust, leaf, {QSslError(QSslError::CertificateRevoked, leaf)}, url);
    QVERIFY(fault);
    QVERIFY(!fault->trustable());
    QVERIFY(!faultOf(trust, leaf, {QSslError(QSslError::CertificateExpired, leaf)}, url));
    QVERIFY(faultOf(trust, QSslCertificate(), {QSslError(QSslError::NoPeerCertificate)}, url));
  }

  void namesInCertificatesArePlainTextAndBounded() {
    for (const char* name : {"self_signed", "signed", "other_name"}) {
      const QSslCertificate leaf = testing::certificate(QString::fromLatin1(name));
      const auto fault = faultOf({}, leaf, {QSslError(QSslError::HostNameMismatch, leaf)},
                                 QUrl(QStringLiteral("https://h")));
      QVERIFY(fault);
      QVERIFY(fault->subject.size() <= 40);
      for (const Fault& why : fault->whys)
        QVERIFY(!argumentsOf(why).join(QLatin1Char(' ')).contains(QLatin1Char('<')));
    }
  }

  void fingerprintsAreTextAndBack() {
    const QByteArray bytes = testing::sha256(QStringLiteral("signed"));
    const QString text = fingerprintText(bytes);
    QCOMPARE(text.size(), 95);
    QCOMPARE(fingerprintFrom(text), bytes);
    QCOMPARE(fingerprintFrom(text.toLower()), bytes);
    QVERIFY(fingerprintFrom(text.left(90)).isEmpty());
    QVERIFY(fingerprintFrom(QString()).isEmpty());
  }

  void aFileWithoutCertificatesIsRefused_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addRow("empty") << QByteArray();
    QTest::addRow("text") << QByteArray("hello");
    QTest::addRow("a key") << testing::tlsFile(QStringLiteral("robot.key"));
    QTest::addRow("torn") << testing::tlsFile(QStringLiteral("signed.pem")).left(200);
  }
  void aFileWithoutCertificatesIsRefused() {
    QFETCH(QByteArray, content);
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("ca.pem")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const auto authorities = readAuthorities(file.fileName());
    QVERIFY(!authorities);
    QCOMPARE(argumentsOf(authorities.error()).value(0), file.fileName());
    QVERIFY(!readAuthorities(folder.filePath(QStringLiteral("none.pem"))));
  }

  void aServerThatDoesNotEncryptIsSaidToBeSo_data() { transports(); }
  void aServerThatDoesNotEncryptIsSaidToBeSo() {
    QFETCH(bool, web_socket);
    QTcpServer plain;
    QVERIFY(plain.listen(QHostAddress::LocalHost));
    connect(&plain, &QTcpServer::newConnection, &plain, [&] {
      QTcpSocket* socket = plain.nextPendingConnection();
      connect(socket, &QTcpSocket::readyRead, socket, [socket] {
        socket->write("HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
        socket->disconnectFromHost();
      });
    });
    Fault reason;
    if (web_socket) {
      WebSocketLink link({QUrl(QStringLiteral("wss://127.0.0.1:%1/").arg(plain.serverPort()))}, "hush", {});
      link.open();
      QTRY_COMPARE(link.state(), WebSocketLink::State::Waiting);
      reason = link.reason();
      QCOMPARE(link.failure(), WebSocketLink::Failure::Unreachable);
    } else {
      HttpClient client(QUrl(), {}, nullptr);
      HttpRequest request;
      request.url = QUrl(QStringLiteral("https://127.0.0.1:%1/").arg(plain.serverPort()));
      std::optional<HttpAnswer> answer;
      client.send(request, [&](HttpAnswer given) { answer = std::move(given); });
      QTRY_VERIFY(answer.has_value());
      QCOMPARE(answer->kind, HttpAnswer::Kind::Unreachable);
      reason = answer->reason;
    }
    QCOMPARE(reason.code, net::fault::ConnectionNotSecure);
  }

 private:
  static void transports() {
    QTest::addColumn<bool>("web_socket");
    QTest::addRow("https") << false;
    QTest::addRow("wss") << true;
  }
};

}  // namespace test_certificates

MAPWRIGHT_TEST(test_certificates, TestCertificates, Core)
#include "test_certificates.moc"
