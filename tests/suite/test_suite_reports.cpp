// What came of a run, as servers and people read it.
#include <QBuffer>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "suite/junit.h"
#include "suite/suite_page.h"
#include "test_program.h"

namespace test_suite_reports {

using namespace mapwright;
using suite::Verdict;
using suite::ViewOutcome;

namespace {

const QString kOdd = QString::fromUtf8("door <b>\"&' \U0001F6AA");

std::vector<ViewOutcome> outcomes(const QString& folder) {
  QImage picture(8, 8, QImage::Format_RGB32);
  picture.fill(Qt::red);
  const QString file = folder + QStringLiteral("/p.png");
  picture.save(file);
  ViewOutcome good, differs, fresh, failed;
  good.name = QStringLiteral("hall");
  good.verdict = Verdict::AsExpected;
  good.seconds = 1.5;
  differs.name = kOdd;
  differs.verdict = Verdict::Differs;
  differs.sentence = QStringLiteral("1 cluster: move wall <script>alert(1)</script> by 0.40 m.");
  differs.expected = differs.actual = differs.difference = file;
  differs.clusters = {
      {QStringLiteral("8 × 8 + 0 + 0"), QStringLiteral("64"), QStringLiteral("(1.0, 2.0)"), kOdd}};
  differs.elsewhere = {QStringLiteral("submap 0-1 is new")};
  fresh.name = QStringLiteral("new");
  fresh.verdict = Verdict::NotExpectedYet;
  fresh.actual = file;
  failed.name = QStringLiteral("gone");
  failed.sentence = QString::fromUtf8("no robot\x01 there");
  return {good, differs, fresh, failed};
}

}  // namespace

class SuiteReportsTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;

  template <typename Write>
  QByteArray written(Write write, double seconds = 1.5) const {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    std::vector<ViewOutcome> all = outcomes(folder_.path());
    all.front().seconds = seconds;
    if (!write(QStringLiteral("office"), all, buffer)) qFatal("not written");
    return buffer.data();
  }

 private Q_SLOTS:
  void junitReadsBack() {
    QXmlStreamReader xml(written(suite::writeJunit));
    QStringList cases, ends;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      const auto attribute = [&](const char* name) {
        return xml.attributes().value(QLatin1String(name)).toString();
      };
      if (xml.name() == QLatin1String("testsuite")) {
        QCOMPARE(attribute("name"), QStringLiteral("office"));
        QCOMPARE(attribute("tests"), QStringLiteral("4"));
        QCOMPARE(attribute("failures"), QStringLiteral("2"));
        QCOMPARE(attribute("errors"), QStringLiteral("1"));
      }
      if (xml.name() == QLatin1String("testcase")) cases << attribute("name");
      if (xml.name() == QLatin1String("failure") || xml.name() == QLatin1String("error"))
        ends << cases.last() + QLatin1Char('|') + xml.name().toString() + QLatin1Char('|') +
                    attribute("type");
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(cases,
             (QStringList{QStringLiteral("hall"), kOdd, QStringLiteral("new"), QStringLiteral("gone")}));
    QCOMPARE(ends, (QStringList{kOdd + QStringLiteral("|failure|differs"),
                                QStringLiteral("new|failure|not expected yet"),
                                QStringLiteral("gone|error|failed")}));
  }

  void thePageHoldsItsPicturesAndNothingOfItIsFetched() {
    const QString html = QString::fromUtf8(written(suite::writePage));
    QCOMPARE(html.count(QStringLiteral("data:image/png;base64,")), 4);
    QVERIFY(html.contains(QStringLiteral("type=\"range\"")));
    QVERIFY(!html.contains(QStringLiteral("http://")) && !html.contains(QStringLiteral("https://")));
    QVERIFY(!html.contains(QStringLiteral("src=\"/")) && !html.contains(QStringLiteral("<link")));
    QVERIFY(html.contains(QStringLiteral("prefers-color-scheme:dark")));
  }
  void namesAreTextWhateverIsInThem() {
    const QString html = QString::fromUtf8(written(suite::writePage));
    QVERIFY(!html.contains(QStringLiteral("<b>")));
    QVERIFY(!html.contains(QStringLiteral("<script>alert")));
    QVERIFY(html.contains(QString::fromUtf8("door &lt;b&gt;&quot;&amp;' \U0001F6AA")) ||
            html.contains(QString::fromUtf8("door &lt;b&gt;&quot;&amp;&#39; \U0001F6AA")));
  }
  void allViewsStandAboveThemWithThoseThatFailedFirst() {
    const QString html = QString::fromUtf8(written(suite::writePage));
    const auto at = [&](const char* text) { return html.indexOf(QLatin1String(text)); };
    QVERIFY(at("<td><a href=\"#view2\">door ") > 0);
    QVERIFY(at("<td><a href=\"#view2\">door ") < at("<td><a href=\"#view3\">new</a></td>"));
    QVERIFY(at("<td><a href=\"#view4\">gone</a></td>") < at("<td>hall</td>"));
    QVERIFY(at("<td>hall</td>") < at("<section id=\"view2\">"));
    QCOMPARE(html.count(QStringLiteral("<section id=")), 3);
  }
  void figuresAndPlacesOfTheSessionAreInBothReports() {
    ViewOutcome held, over;
    held.name = QStringLiteral("held");
    held.verdict = Verdict::AsExpected;
    held.figures = {{QStringLiteral("share"), QStringLiteral("0.8 %"), QStringLiteral("2.4 %"), {}}};
    over.name = QStringLiteral("over");
    over.verdict = Verdict::OverLimit;
    over.sentence = QStringLiteral("More than 0.5 m.");
    over.worst_closures = {QStringLiteral("1.2 m: submap <0-4>")};
    over.worst_squares = {QStringLiteral("3 cells at (1.5, 2.5)")};
    QBuffer junit, page;
    junit.open(QIODevice::WriteOnly);
    page.open(QIODevice::WriteOnly);
    QVERIFY(suite::writeJunit(QStringLiteral("s"), {held, over}, junit));
    QVERIFY(suite::writePage(QStringLiteral("s"), {held, over}, page));
    const QString xml = QString::fromUtf8(junit.data()), html = QString::fromUtf8(page.data());
    QVERIFY2(xml.contains(QStringLiteral("<system-out>share 0.8 % -&gt; 2.4 %\n</system-out>")),
             qPrintable(xml));
    QVERIFY2(
        xml.contains(QStringLiteral("<failure type=\"over a limit\" message=\"More than 0.5 m.\">More than "
                                    "0.5 m.\n1.2 m: submap &lt;0-4&gt;\n3 cells at (1.5, 2.5)</failure>")),
        qPrintable(xml));
    QVERIFY(xml.contains(QStringLiteral("failures=\"1\"")));
    for (const char* text : {"0.8 %", "2.4 %", "submap &lt;0-4&gt;", "3 cells at (1.5, 2.5)", "Limit"})
      QVERIFY2(html.contains(QLatin1String(text)), text);
    const suite::Tally tally = suite::tallyOf({held, over});
    QVERIFY(!tally.good());
    QCOMPARE(suite::tallyText(tally), QStringLiteral("1 view as expected, 1 view is over a limit."));
  }
  void clustersThatAreLeftOutAreCounted() {
    ViewOutcome outcome;
    outcome.name = QStringLiteral("many");
    outcome.verdict = Verdict::Differs;
    outcome.clusters = {{QStringLiteral("1 × 1 at 0, 0"), QStringLiteral("1"), {}, {}}};
    const auto page = [&] {
      QBuffer made;
      made.open(QIODevice::WriteOnly);
      suite::writePage(QStringLiteral("s"), {outcome}, made);
      return QString::fromUtf8(made.data());
    };
    QVERIFY(!page().contains(QLatin1String("not listed")));
    outcome.clusters_in_all = 1'235;
    QVERIFY(page().contains(QLatin1String("1,234 more are not listed.")));
  }
  void theSameRunGivesTheSameBytes() {
    QCOMPARE(written(suite::writePage), written(suite::writePage, 5));
    QCOMPARE(written(suite::writeJunit), written(suite::writeJunit));
  }
  void countsAreSaid() {
    const suite::Tally tally = suite::tallyOf(outcomes(folder_.path()));
    QVERIFY(!tally.good());
    QCOMPARE(
        suite::tallyText(tally),
        QStringLiteral("1 view as expected, 1 view differs, 1 view has no expected picture, 1 view failed."));
  }
};

}  // namespace test_suite_reports

MAPWRIGHT_TEST(test_suite_reports, SuiteReportsTest, Core)
#include "test_suite_reports.moc"
