// The sentences and numbers of the window, the filter, the colours.
#include <QDoubleSpinBox>
#include <QTimeZone>
#include <QtTest>

#include "jobs/set_pose.h"
#include "test_program.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/pretty_json.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/maps_model.h"
#include "ui/robot/problems_model.h"
#include "ui/slam/submap_filter.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_view.h"
#include "ui/view/measure_tool.h"
#include "ui/view/notice_bar.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/window/command_palette.h"
#include "ui/window/go_to_dialog.h"
#include "words/fixed.h"
#include "words/qt_plain.h"

namespace test_window_text {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

robot::ConnectionState link(robot::ConnectionPhase phase) {
  robot::ConnectionState state;
  state.phase = phase;
  return state;
}

}  // namespace

class TestWindowText : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { loadResources(); }

  void tellsTheConnection() {
    auto online = link(robot::ConnectionPhase::Online);
    online.round_trip_ms = 12;
    QCOMPARE(connectionText(online).text, QStringLiteral("connected 12 ms"));
    const QDateTime heard(QDate(2026, 5, 1), QTime(12, 3, 34));
    const StateText nothing = linkText(online, heard, 0, heard.addMSecs(3'200));
    QCOMPARE(nothing.text, QStringLiteral("nothing for 3 s"));
    QVERIFY(nothing.mark == Mark::Warning);
    QCOMPARE(linkText(online, std::nullopt).text, QStringLiteral("connected 12 ms"));
    QCOMPARE(linkWord(online, heard), QStringLiteral("silent"));
    QCOMPARE(linkWord(online, std::nullopt), QStringLiteral("connected"));
    auto away = link(robot::ConnectionPhase::Interrupted);
    away.attempt = 2;
    away.retry_in_ms = 3000;
    away.reason = fault::said("connection refused");
    QCOMPARE(connectionText(away).text,
             QStringLiteral("reconnecting in 3 s (attempt 2): connection refused"));
    QCOMPARE(connectionText(away, 1001).text,
             QStringLiteral("reconnecting in 2 s (attempt 2): connection refused"));
    QCOMPARE(connectionText(away, 9000).text,
             QStringLiteral("reconnecting now (attempt 2): connection refused"));
    auto refused = link(robot::ConnectionPhase::Refused);
    refused.reason = fault::said("wrong secret");
    QCOMPARE(connectionText(refused).text, QStringLiteral("refused: wrong secret"));
    // Every state has a shape of its own, so that colour is never alone.
    QVERIFY(connectionText(online).mark != connectionText(away).mark);
    QVERIFY(connectionText(away).mark != connectionText(refused).mark);
  }

  void tellsTheLoading() {
    session::SubmapCounts counts;
    QCOMPARE(loadingText(counts), QString());
    counts.list_received = true;
    QCOMPARE(loadingText(counts), QStringLiteral("no submaps"));
    counts.listed = 480;
    counts.shown = 312;
    counts.missing = 2;
    counts.fetching = 4;
    QCOMPARE(loadingText(counts), QStringLiteral("312 of 480 submaps, 2 missing"));
    QCOMPARE(trafficText(counts), QStringLiteral("4 to come"));
    counts.queued = 1200;
    counts.corrupt = 1;
    QCOMPARE(loadingText(counts), QStringLiteral("312 of 480 submaps, 2 missing, 1 corrupt"));
    QCOMPARE(trafficText(counts), QStringLiteral("1,204 to come"));
    counts.hidden = 100;
    QCOMPARE(loadingText(counts), QStringLiteral("312 of 480 submaps, 100 hidden, 2 missing, 1 corrupt"));
  }

  void tellsCoordinatesAsFineAsAPixelMeansThem() {
    const Eigen::Vector2d point(12.3449, -3.2104);
    QCOMPARE(coordinatesText(point, 0.001), QStringLiteral("x 12.345 y -3.210 m"));
    QCOMPARE(coordinatesText(point, 0.002), QStringLiteral("x 12.345 y -3.210 m"));
    QCOMPARE(coordinatesText(point, 0.05), QStringLiteral("x 12.34 y -3.21 m"));
    QCOMPARE(coordinatesText(point, 0.5), QStringLiteral("x 12.3 y -3.2 m"));
    QCOMPARE(coordinatesText(point, 5), QStringLiteral("x 12 y -3 m"));
    QCOMPARE(coordinatesText({-0.0001, 0.0}, 0.05), QStringLiteral("x 0.00 y 0.00 m"));
    QCOMPARE(coordinatesText({std::nan(""), 0}, 0.05), QStringLiteral("x ? y ? m"));
    QCOMPARE(coordinatesForClipboard(point), QStringLiteral("12.345, -3.210"));
  }

  void tellsOccupancy() {
    QCOMPARE(occupancyText(std::nullopt), QStringLiteral("unknown"));
    QCOMPARE(occupancyText(97), QStringLiteral("occupied 97 %"));
    QCOMPARE(occupancyText(12), QStringLiteral("free 88 %"));
  }

  void tellsScaleAndRotation() {
    QCOMPARE(scaleText(0.05, 96), QStringLiteral("1:189  5 cm/px"));
    QCOMPARE(scaleText(0.002, 96), QStringLiteral("1:8  2 mm/px"));
    QCOMPARE(scaleText(1, 96), QStringLiteral("1:3,780  1 m/px"));
    QCOMPARE(rotationText(geometry::radiansFromDegrees(38)), QStringLiteral("38°"));
    QCOMPARE(rotationText(geometry::radiansFromDegrees(-12.5)), QStringLiteral("-12.5°"));
    QCOMPARE(rotationText(geometry::radiansFromDegrees(-180)), QStringLiteral("180°"));
    QCOMPARE(rotationText(0), QStringLiteral("0°"));
  }

  void tellsSizes() {
    QCOMPARE(bytesText(0), QStringLiteral("0 B"));
    QCOMPARE(bytesText(1500), QStringLiteral("1.5 KB"));
    QCOMPARE(bytesText(42'100'000), QStringLiteral("42.1 MB"));
    QCOMPARE(bytesText(999'999), QStringLiteral("1.0 MB"));
    QCOMPARE(problemsText(1), QStringLiteral("1 problem"));
    QCOMPARE(problemsText(0), QStringLiteral("0 problems"));
    QCOMPARE(submapsText(12480), QStringLiteral("12,480 submaps"));
  }

  void filtersByWhatPeopleType_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("fits");
    const std::pair<const char*, bool> cases[] = {
        {"", true},
        {"12-3", true},
        {"12-35", true},
        {"12-", true},
        {"12-5", false},
        {"1-3", false},
        {"2-3", false},
        {"35", true},
        {"#35", true},
        {"#5", false},
        {"v70", true},
        {"v7", false},
        {"frozen", true},
        {"FRO", true},
        {"active", false},
        {"inc", true},
        {"nearby", false},
        {"failed", true},
        {"missing", false},
        {"hidden", true},
        {"visible", false},
        {"frozen failed", true},
        {"frozen missing", false},
        {"gibberish", false},
        {"-", false},
        {"#", true},
    };
    for (const auto& [text, fits] : cases)
      QTest::newRow(*text ? text : "empty") << QString::fromLatin1(text) << fits;
  }
  void filtersByWhatPeopleType() {
    QFETCH(QString, text);
    QFETCH(bool, fits);
    SubmapFacts facts;
    facts.id = {12, 35};
    facts.version = 70;
    facts.frozen = facts.incremental = true;
    facts.visible = false;
    facts.status = session::SubmapStatus::Waiting;
    QCOMPARE(SubmapFilter(text).matches(facts), fits);
  }

  void namesBadges() {
    SubmapFacts facts;
    QCOMPARE(badges(facts), QStringList{QStringLiteral("ACTIVE")});
    facts.frozen = facts.nearby = facts.incremental = true;
    QCOMPARE(badges(facts),
             (QStringList{QStringLiteral("FROZEN"), QStringLiteral("INC"), QStringLiteral("NEARBY")}));
  }

  void readsPoints() {
    QCOMPARE(*parsePoint(QStringLiteral("12.5, -3.2")), Eigen::Vector2d(12.5, -3.2));
    QCOMPARE(*parsePoint(QStringLiteral("12.5 -3.2")), Eigen::Vector2d(12.5, -3.2));
    QCOMPARE(*parsePoint(QStringLiteral("x 12.345 y -3.210 m")), Eigen::Vector2d(12.345, -3.21));
    QCOMPARE(*parsePoint(QStringLiteral("12,5; -3,2")), Eigen::Vector2d(12.5, -3.2));
    QCOMPARE(*parsePoint(QStringLiteral("388096.123, 5572094.155")),
             Eigen::Vector2d(388096.123, 5572094.155));
    for (const char* bad : {"", "12", "a b", "1 2 3", "nan nan", "1e99 0", "2000000000 0"}) {
      QVERIFY2(!parsePoint(QLatin1String(bad)), bad);
    }
  }

  void findsCommandsByLetters() {
    QVERIFY(fuzzyScore(QStringLiteral("ftr"), QStringLiteral("Follow the robot")));
    QVERIFY(!fuzzyScore(QStringLiteral("xyz"), QStringLiteral("Follow the robot")));
    QVERIFY(*fuzzyScore(QStringLiteral("fit"), QStringLiteral("Fit")) >
            *fuzzyScore(QStringLiteral("fit"), QStringLiteral("Filter it")));
    QVERIFY(fuzzyScore({}, QStringLiteral("Fit")));
    const QString report = QStringLiteral("Replay: Report of this moment");
    for (const char* typed :
         {"report of", "rep", "of this", "port", "rtm", "Report of this moment", "replay report"})
      QVERIFY2(fuzzyScore(QLatin1String(typed), report), typed);
    // From better to worse.
    std::optional<int> last;
    for (const char* text : {"Redo", "Redo all", "The redo list", "Predominant", "Read the whole bag"}) {
      const auto score = fuzzyScore(QStringLiteral("redo"), QLatin1String(text));
      QVERIFY2(score && (!last || *score < *last), text);
      last = score;
    }
  }

  void findsEveryPlaceOfLettersInOrder() {
    // Against the plain rule: the letters stand in the text in this order.
    QRandomGenerator random(7);
    const QString letters = QStringLiteral("ab c");
    const auto word = [&](int most) {
      QString made;
      for (int i = random.bounded(1, most); i > 0; --i) made += letters[random.bounded(4)];
      return made;
    };
    for (int i = 0; i < 3000; ++i) {
      const QString typed = word(5), text = word(12);
      qsizetype at = 0;
      bool there = true;
      for (const QChar letter : typed.simplified()) {
        if (letter.isSpace()) continue;
        at = text.indexOf(letter, at) + 1;
        there = there && at > 0;
        if (!there) break;
      }
      QVERIFY2(fuzzyScore(typed, text).has_value() == there, qPrintable(typed + QLatin1Char('|') + text));
    }
  }

  void tellsWhatToDoOnAnEmptyMap() {
    using Kind = EmptyState::Kind;
    const QString address = QStringLiteral("axbot+http://192.0.2.7:8090");
    const auto none = emptyState({}, {}, nullptr);
    QCOMPARE(none->kind, Kind::NoRobot);
    QVERIFY(none->offers.contains(CardOffer::Connect) && none->offers.contains(CardOffer::Demo));
    session::SubmapCounts counts;
    QCOMPARE(emptyState(address, link(robot::ConnectionPhase::Connecting), &counts)->kind, Kind::Connecting);
    auto away = link(robot::ConnectionPhase::Interrupted);
    away.reason = fault::said("connection refused");
    const auto failed = emptyState(address, away, &counts);
    QCOMPARE(failed->kind, Kind::Failed);
    QVERIFY(failed->offers.contains(CardOffer::Retry));
    QVERIFY(failed->text.contains(QLatin1String("connection refused")));
    const auto online = link(robot::ConnectionPhase::Online);
    QCOMPARE(emptyState(address, online, &counts)->kind, Kind::WaitingForList);
    counts.list_received = true;
    QCOMPARE(emptyState(address, online, &counts)->kind, Kind::NoSubmaps);
    counts.listed = counts.pending = 5;
    QCOMPARE(emptyState(address, online, &counts)->kind, Kind::Loading);
    counts.pending = 0;
    counts.missing = 5;
    QCOMPARE(emptyState(address, online, &counts)->kind, Kind::NothingDrawable);
    QVERIFY(emptyState(address, online, &counts)->text.contains(QLatin1String("See Problems")));
    // What is no problem stands in no list of them.
    counts.missing = 0;
    counts.without_slice = 5;
    QVERIFY(emptyState(address, online, &counts)->title.contains(QLatin1String("slice")));
    QVERIFY(!emptyState(address, online, &counts)->text.contains(QLatin1String("Problems")));
    counts.without_slice = 0;
    counts.held = counts.hidden = 5;
    QVERIFY(emptyState(address, online, &counts)->title.contains(QLatin1String("hidden")));
    QVERIFY(!emptyState(address, online, &counts)->text.contains(QLatin1String("Problems")));
    counts.shown = 1;
    QVERIFY(!emptyState(address, online, &counts));
    QVERIFY(!emptyState(address, away, &counts));  // what was received stays
  }

  void zeroHasNoSign() {
    QCOMPARE(words::fixed(-0.04, 1), QStringLiteral("0.0"));
    QCOMPARE(words::fixed(-0.06, 1), QStringLiteral("-0.1"));
    QCOMPARE(words::fixed(-0.4, 0), QStringLiteral("0"));
    QCOMPARE(jobs::poseWords({-0.001, -0.006, -0.0004}), QStringLiteral("x 0.00 m, y -0.01 m, 0.0°"));
    QCOMPARE(yawText(-0.0004), QStringLiteral("0.0°"));
    QCOMPARE(rotationText(-0.0004), QStringLiteral("0°"));
    const std::unique_ptr<QDoubleSpinBox> box(numberField(nullptr, {-360, 360, 1, 5, QStringLiteral("°")}));
    box->setValue(-0.04);
    QCOMPARE(box->text(), QStringLiteral("0.0°"));
  }

  void tellsSinceWhenTheLinkIsLost() {
    const QDateTime now(QDate(2024, 5, 1), QTime(14, 5, 0));
    QCOMPARE(lostConnectionSentence(QDateTime(QDate(2024, 5, 1), QTime(14, 3, 12)), now),
             QStringLiteral("No connection since 14:03:12, 1 min 48 s. Showing the last data received."));
    QVERIFY(lostConnectionSentence(QDateTime(QDate(2024, 4, 30), QTime(14, 3, 12)), now)
                .contains(QLatin1String("2024-04-30")));
    QCOMPARE(lostConnectionSentence(QDateTime(QDate(2024, 5, 1), QTime(14, 3, 12)), now,
                                    QStringLiteral("hall.geojson")),
             QStringLiteral("hall.geojson has not been readable since 14:03:12, 1 min 48 s. Showing what was "
                            "read last."));
  }

  void climbsTheLadder() {
    QCOMPARE(ladderScale(0.05, 1), 0.04);
    QCOMPARE(ladderScale(0.04, -1), 0.05);
    QCOMPARE(ladderScale(0.045, 1), 0.04);  // from between two rungs to the next
    QCOMPARE(ladderScale(0.045, -1), 0.05);
    QVERIFY(ladderScale(geometry::kMinScaleMPerPx, 5) >= geometry::kMinScaleMPerPx);
  }

  void keepsTheAnchorAllTheWay() {
    geometry::ViewTransform from;
    from.width_px = 800;
    from.height_px = 600;
    const Eigen::Vector2d anchor(123, 456);
    const Eigen::Vector2d world = from.worldFromPixel(anchor);
    const CameraMotion motion{from, from.zoomedAt(anchor, 3.7), anchor};
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      QVERIFY((motion.at(t).worldFromPixel(anchor) - world).norm() < 1e-9);
    }
    QCOMPARE(motion.at(1), motion.to);
  }

  void isReadableInBothThemes() {
    for (const bool dark : {false, true}) {
      const UiColors c = uiColors(dark);
      for (const QColor& ground : {c.window, c.base}) {
        for (const QColor& ink :
             {c.text, c.secondary_text, c.accent_text, c.ok_text, c.warning_text, c.error_text}) {
          QVERIFY2(contrastRatio(ink, ground) >= 4.5,
                   qPrintable(ink.name() + QLatin1String(" on ") + ground.name()));
        }
      }
      QVERIFY(contrastRatio(Qt::white, c.accent) >= 4.5);
      QCOMPARE(uiColors(themePalette(c)).dark, dark);
    }
  }

  void hasAnIconForEveryName() {
    QVERIFY(iconNames().size() > 40);
    for (const QString& name : iconNames()) {
      const QImage image = iconPixmap(name, 24, 1, Qt::red).toImage();
      bool inked = false;
      for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 24; ++x) inked = inked || qAlpha(image.pixel(x, y)) > 100;
      }
      QVERIFY2(inked, qPrintable(name));
    }
    for (int status = 0; status <= int(session::SubmapStatus::Unplaced); ++status) {
      QVERIFY(iconNames().contains(statusIcon(session::SubmapStatus(status))));
    }
  }

  void obeysNoNames() {
    const QString evil = QStringLiteral("a\x1b[31m\x7f") + QChar(0x9b) + QStringLiteral("2J") +
                         QChar(0x202e) + QStringLiteral("b") + QChar(0x2066);
    const auto harmless = [](const QString& text) {
      QVERIFY2(!text.isEmpty(), "there is something to look at");
      QCOMPARE(text, words::plainText(text));
    };
    QVERIFY(words::plainText(evil) != evil);
    harmless(PlainLabel(evil).text());
    harmless(plainToolTip(evil));
    harmless(mapTitle(evil.toStdString()));
    map::CatalogueEntry entry;
    entry.key.id = entry.state = evil.toStdString();
    harmless(mapDetail(entry));
    harmless(prettyJson("{\"x\":\"" + evil.toUtf8() + "\"}"));
    harmless(prettyJson(evil.toUtf8()));
    session::ProblemLog log;
    const QDateTime now = QDateTime::currentDateTime();
    log.add({map::Severity::Error, evil.toStdString(), fault::said(evil.toStdString())}, now);
    harmless(log.toText(now));
    harmless(problemLine(log.rows()[0]));
    ProblemsModel model;
    model.sync(log.rows());
    for (int column = 0; column < ProblemsModel::kColumns; ++column) {
      if (column == ProblemsModel::DurationColumn) continue;  // it lasts
      harmless(model.index(0, column).data().toString());
      harmless(model.index(0, column).data(Qt::ToolTipRole).toString());
    }
  }

  void problemsAreFollowedRowByRow() {
    session::ProblemLog log;
    ProblemsModel model;
    const QDateTime noon = QDateTime(QDate(2026, 1, 2), QTime(12, 0), QTimeZone::utc()).toUTC();
    const map::Subject topic(map::SubjectKind::Topic, "/x"), other(map::SubjectKind::Topic, "/y");
    log.add({map::Severity::Error, topic, fault::said("7 bytes.")}, noon);
    log.add({map::Severity::Error, other, fault::said("Odd.")}, noon);
    model.sync(log.rows());
    const QPersistentModelIndex first(model.index(0, ProblemsModel::SentenceColumn));
    QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    log.add({map::Severity::Error, topic, fault::said("8 bytes.")}, noon.addSecs(5));
    model.sync(log.rows());
    QCOMPARE(removed.size(), 0);
    QCOMPARE(changed.size(), 1);
    QCOMPARE(first.data().toString(), QStringLiteral("8 bytes."));
    QCOMPARE(model.index(0, ProblemsModel::CountColumn).data().toString(), QStringLiteral("2×"));
    QVERIFY(model.index(0, ProblemsModel::DurationColumn).data().toString().isEmpty());
    log.resolve({topic}, noon.addSecs(65));
    model.sync(log.rows());
    QCOMPARE(model.index(0, ProblemsModel::DurationColumn).data().toString(), QStringLiteral("1 min 5 s"));
    const QString tip = first.data(Qt::ToolTipRole).toString();
    QVERIFY(tip.contains(QLatin1String("12:00:00")) && tip.contains(QLatin1String("12:00:05")) &&
            tip.contains(QLatin1String("12:01:05")));
    log.clear();
    log.add({map::Severity::Error, topic, fault::said("9 bytes.")}, noon.addSecs(70));
    model.sync(log.rows());
    QCOMPARE(model.rowCount(), 1);
    QVERIFY(!first.isValid());
  }

  void showsMarkupAsItIs() {
    QVERIFY(!plainToolTip(QStringLiteral("<b>x</b>")).contains(QLatin1String("<b>")));
    QVERIFY(plainToolTip(QStringLiteral("<b>x</b>")).contains(QLatin1String("&lt;b&gt;")));
  }
};

}  // namespace test_window_text

MAPWRIGHT_TEST(test_window_text, TestWindowText, Widgets)
#include "test_window_text.moc"
