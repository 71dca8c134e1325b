// Plots beside the map: of a bag and of a robot that speaks.
#include <cmath>

#include <QApplication>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

#include "fake_robot.h"
#include "ink.h"
#include "session/session_options.h"
#include "test_program.h"
#include "text_bag.h"
#include "ui/plots/plot_selection.h"
#include "ui/plots/plots_dock.h"

namespace test_window_plots {

using namespace mapwright;
using namespace mapwright::ui;
using series::Quantity;

namespace {

constexpr double kStart_s = 1'717'405'200;

PlotSelection field(const char* text) { return *series::FieldPath::parse(text); }

/// Ten minutes: poses at 10 Hz along x with 0.5 m/s, a counter, and a battery.
void fill(test::TextBag& bag) {
  for (int i = 0; i < 6000; ++i) {
    const double at_s = kStart_s + i / 10.0;
    bag.add(at_s, map::TrackedPose{{i * 0.05, 1, 0.5}});
    bag.add(at_s, "/count",
            "{\"n\":" + std::to_string(i) + ",\"list\":[0," + std::to_string(2 * i) + "],\"word\":\"x\"}");
    if (i % 100 == 0) {
      map::BatteryState battery;
      battery.level = 1 - i / 10'000.0;
      bag.add(at_s, battery);
    }
  }
}

/// A bag that is open, its feed and the dock, as the controller ties them together.
struct Desk {
  explicit Desk(replay::ChunksOptions chunks = {}) {
    fill(bag);
    reading = std::make_unique<replay::Reading>(bag, robot::BagKey{robot::BagKind::Bag, "b"},
                                                replay::Reading::Options{chunks, {}});
    dock.resize(700, 400);
    dock.show();
  }
  void open() {
    QSignalSpy opened(reading.get(), &replay::Reading::opened);
    reading->open();
    QVERIFY(opened.wait());
    feed.setReading(reading.get());
    dock.openBag(reading->chunks().start_s(), reading->chunks().end_s());
  }
  double value(const PlotSelection& wish, double s) {
    for (const PlotWidget* plot : dock.plots()) {
      for (const PlotCurve& curve : plot->curves()) {
        const auto sample = curve.selection == wish ? curve.series->at(kStart_s + s) : std::nullopt;
        if (sample) return sample->value;
      }
    }
    return -1;
  }
  test::TextBag bag;
  std::unique_ptr<replay::Reading> reading;
  PlotFeed feed{nullptr};
  PlotsDock dock{feed};
};

replay::ChunksOptions narrow() {
  replay::ChunksOptions options;
  options.messages_per_cell = 200;
  options.ahead_s = 10;
  options.behind_s = 5;
  options.held_bytes = 20'000;
  return options;
}

}  // namespace

class TestWindowPlots : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nothingToShowSaysWhatToDo();
  void theMenuRemovesCurves();
  void aFieldIsDropped();
  void curvesOfTheBagCome();
  void aFieldThatIsAddedLateIsReadOnceMore();
  void theWholeBagCanBeRead();
  void theOrderInWhichRangesComeDoesNotMatter();
  void aTypedFieldIsPlottedOrSaysWhyNot();
  void quantitiesFindAPlotOfTheirUnit();
  void plotsShareTimePointerAndCursor();
  void whatIsPlottedIsRemembered();
  void fieldsOfAnEarlierRobotGo();
  void thereAreNoMoreThanCanBeToldApart();
  void aRobotThatSpeaksIsPlottedAsItComes();
  void closingTheBagLeavesNothingOfIt();
};

void TestWindowPlots::nothingToShowSaysWhatToDo() {
  PlotWidget plot;
  plot.resize(500, 200);
  plot.show();
  const double before = test::ink(&plot, plot.area());
  plot.setHint(QStringLiteral("Drop something here."));
  QVERIFY(test::ink(&plot, plot.area()) > before + 0.002);
  PlotFeed feed{nullptr};
  PlotsDock dock(feed);
  dock.resize(500, 300);
  dock.show();
  QCOMPARE(dock.plots().size(), std::size_t(1));
  QVERIFY(test::ink(dock.plots().front(), dock.plots().front()->area()) > 0.005);
}

void TestWindowPlots::theMenuRemovesCurves() {
  Desk desk;
  PlotWidget* plot = desk.dock.plots().front();
  QVERIFY(desk.dock.addCurve(plot, Quantity::X));
  QVERIFY(desk.dock.addCurve(plot, Quantity::Y));
  QMenu menu;
  plot->fillMenu(menu);
  menu.actions().front()->trigger();
  QCOMPARE(plot->curves().size(), std::size_t(1));
  QVERIFY(plot->curves()[0].selection == PlotSelection(Quantity::Y));
  QCOMPARE(plot->curves()[0].look, 1);  // it looks as before
  QVERIFY(desk.dock.addCurve(plot, Quantity::X));
  QCOMPARE(plot->curves()[1].look, 0);
}

void TestWindowPlots::aFieldIsDropped() {
  Desk desk;
  PlotWidget* plot = desk.dock.plots().front();
  const auto mime = mimeOf(field("/count.n"));
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
  QApplication::sendEvent(plot, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop({50, 50}, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
  QApplication::sendEvent(plot, &drop);
  QCOMPARE(plot->curves().size(), std::size_t(1));
  QMimeData other;
  other.setText(QStringLiteral("something else"));
  QDragEnterEvent no({50, 50}, Qt::CopyAction, &other, Qt::LeftButton, {});
  no.ignore();
  QApplication::sendEvent(plot, &no);
  QVERIFY(!no.isAccepted());
}

void TestWindowPlots::curvesOfTheBagCome() {
  Desk desk(narrow());
  PlotWidget* plot = desk.dock.plots().front();
  for (const PlotSelection& wish : {PlotSelection(Quantity::X), PlotSelection(Quantity::Speed),
                                    PlotSelection(Quantity::Battery), field("/count.list[1]")})
    QVERIFY(desk.dock.addCurve(plot, wish));
  desk.open();
  desk.reading->want(kStart_s + 300);
  QTRY_VERIFY(desk.reading->chunks().readUntil(kStart_s + 300));
  QTRY_COMPARE(desk.value(field("/count.list[1]"), 100), 2000.0);
  QTRY_COMPARE(desk.value(field("/count.list[1]"), 0), 0.0);
  QVERIFY(std::abs(desk.value(Quantity::X, 200) - 100) < 1e-9);
  QVERIFY(std::abs(desk.value(Quantity::Speed, 200) - 0.5) < 1e-6);
  QCOMPARE(desk.value(Quantity::Battery, 155), 85.0);
  QCOMPARE(desk.value(field("/count.list[1]"), 500), -1.0);  // nobody has asked for that yet
}

void TestWindowPlots::aFieldThatIsAddedLateIsReadOnceMore() {
  Desk desk(narrow());
  desk.open();
  desk.reading->want(kStart_s + 300);
  QTRY_VERIFY(desk.reading->chunks().readUntil(kStart_s + 300));
  QVERIFY(!desk.reading->chunks().cellAt(kStart_s + 100)->held);
  const int asked = desk.bag.asked;
  // Poses are known of every range that was read.
  QVERIFY(desk.dock.addCurve(desk.dock.plots().front(), Quantity::Speed));
  QTRY_VERIFY(std::abs(desk.value(Quantity::Speed, 100) - 0.5) < 1e-6);
  QVERIFY(desk.bag.asked <= asked + 5);  // what lies ahead is read meanwhile
  QVERIFY(desk.dock.addCurve(desk.dock.plots().front(), field("/count.n")));
  QTRY_COMPARE(desk.value(field("/count.n"), 100), 1000.0);
  QTRY_COMPARE(desk.value(field("/count.n"), 5), 50.0);
  QVERIFY(desk.bag.asked > asked);
  // And not again and again.
  QTRY_COMPARE(desk.value(field("/count.n"), 290), 2900.0);
  const int done = desk.bag.asked;
  desk.reading->want(kStart_s + 300.1);
  QCoreApplication::processEvents();
  QVERIFY(desk.bag.asked <= done + 2);
}

void TestWindowPlots::theWholeBagCanBeRead() {
  Desk desk(narrow());
  QVERIFY(desk.dock.addCurve(desk.dock.plots().front(), field("/count.n")));
  desk.open();
  connect(&desk.dock, &PlotsDock::wholeWanted, desk.reading.get(), &replay::Reading::setWhole);
  desk.reading->want(kStart_s + 10);
  QTRY_COMPARE(desk.value(field("/count.n"), 9), 90.0);
  QVERIFY(desk.dock.wholeButton()->isEnabled());
  desk.dock.wholeButton()->click();
  QTRY_COMPARE(desk.value(field("/count.n"), 590), 5900.0);
  QTRY_COMPARE(desk.value(field("/count.n"), 300), 3000.0);
}

void TestWindowPlots::theOrderInWhichRangesComeDoesNotMatter() {
  std::vector<std::vector<series::Sample>> all;
  for (const std::vector<double>& wants : {std::vector<double>{599}, {10, 500, 200, 599}, {300, 100, 599}}) {
    Desk desk(narrow());
    for (const PlotSelection& wish : {PlotSelection(Quantity::Speed), field("/count.n")})
      QVERIFY(desk.dock.addCurve(desk.dock.plots().front(), wish));
    desk.open();
    for (const double s : wants) {
      desk.reading->want(kStart_s + s);
      QTRY_VERIFY(desk.reading->chunkAt(desk.reading->chunks().cellAt(kStart_s + s)->from));
    }
    QTRY_VERIFY(desk.reading->chunks().readUntil(kStart_s + 599));
    for (const PlotCurve& curve : desk.dock.plots().front()->curves()) {
      QTRY_VERIFY(curve.series->isCovered(kStart_s, kStart_s + 599));
      all.push_back(curve.series->samples(kStart_s, kStart_s + 599));
    }
  }
  QCOMPARE(all.size(), std::size_t(6));
  for (std::size_t i = 2; i < all.size(); ++i) {
    QCOMPARE(all[i].size(), all[i % 2].size());
    for (std::size_t k = 0; k < all[i].size(); ++k) {
      const double a = all[i][k].value, b = all[i % 2][k].value;
      QVERIFY(a == b || (std::isnan(a) && std::isnan(b)));
    }
  }
}

void TestWindowPlots::aTypedFieldIsPlottedOrSaysWhyNot() {
  Desk desk;
  desk.open();
  desk.reading->want(kStart_s + 1);
  QTRY_VERIFY(!desk.feed.fields().isEmpty());
  QCOMPARE(desk.feed.fields(), (QStringList{QStringLiteral("/count.n"), QStringLiteral("/count.list[0]"),
                                            QStringLiteral("/count.list[1]")}));
  QLineEdit* edit = desk.dock.pathEdit();
  QVERIFY(!desk.dock.addButton()->isEnabled());
  QTest::keyClicks(edit, QStringLiteral("/count"));
  QTest::keyClick(edit, Qt::Key_Escape);
  QTest::keyClick(edit, Qt::Key_Return);
  QVERIFY(desk.dock.saidText().contains(QStringLiteral("/count")));
  QVERIFY(desk.dock.plots().front()->curves().empty());
  edit->setText(QStringLiteral(" /count.n "));
  QVERIFY(desk.dock.saidText().isEmpty());
  QTest::mouseClick(desk.dock.addButton(), Qt::LeftButton);
  QCOMPARE(desk.dock.plots().front()->curves().size(), std::size_t(1));
  QVERIFY(edit->text().isEmpty());
  edit->setText(QStringLiteral("/count.n"));
  desk.dock.addTyped();
  QVERIFY(!desk.dock.saidText().isEmpty());  // it is there already
  edit->setText(QStringLiteral("/count.m"));
  desk.dock.addTyped();
  QVERIFY(desk.dock.saidText().contains(QStringLiteral("a number /count.m")));
  desk.dock.removeCurve(desk.dock.plots().front(), 1);
  QCOMPARE(desk.dock.plots().front()->curves().size(), std::size_t(1));
}

void TestWindowPlots::quantitiesFindAPlotOfTheirUnit() {
  Desk desk;
  desk.dock.quantitiesButton()->menu()->actions().front()->trigger();  // the pose
  QCOMPARE(desk.dock.plots().size(), std::size_t(2));
  QCOMPARE(desk.dock.plots()[0]->curves().size(), std::size_t(2));
  QCOMPARE(desk.dock.plots()[1]->curves().size(), std::size_t(1));
  desk.dock.addQuantity(Quantity::Battery);
  QCOMPARE(desk.dock.plots().size(), std::size_t(3));
}

void TestWindowPlots::plotsShareTimePointerAndCursor() {
  Desk desk;
  desk.open();
  desk.dock.addQuantity(Quantity::X);
  desk.dock.addQuantity(Quantity::Speed);
  PlotWidget *a = desk.dock.plots()[0], *b = desk.dock.plots()[1];
  QCOMPARE(a->span(), (PlotWidget::Range{desk.reading->chunks().start_s(), desk.reading->chunks().end_s()}));
  const QPoint at = a->area().center();
  QWheelEvent wheel(at, a->mapToGlobal(at), {}, {0, 360}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(a, &wheel);
  QCOMPARE(a->span(), b->span());
  QVERIFY(b->span().second - b->span().first < 400);
  desk.reading->want(kStart_s + 300);
  QTRY_VERIFY(desk.reading->chunks().readUntil(kStart_s + 300));
  const double time_s = a->timeAt(at.x());
  QTest::mouseMove(a, at);
  QMouseEvent move(QEvent::MouseMove, at, a->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(a, &move);
  QVERIFY(!b->valueAtCursor(0).isEmpty());
  QCOMPARE(b->valueAtCursor(0) == QStringLiteral("–"), !b->curves()[0].series->at(time_s).has_value());
  QSignalSpy seeks(&desk.dock, &PlotsDock::seekWanted);
  QTest::mouseClick(b, Qt::LeftButton, {}, b->area().center());
  QCOMPARE(seeks.size(), 1);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(a, &leave);
  desk.dock.setCurrent(kStart_s + 100);
  QTRY_VERIFY(b->valueAtCursor(0).startsWith(QStringLiteral("0.5")));
}

void TestWindowPlots::whatIsPlottedIsRemembered() {
  Desk desk;
  desk.dock.addQuantity(Quantity::X);
  desk.dock.addQuantity(Quantity::Speed);
  QVERIFY(desk.dock.addCurve(desk.dock.plots()[1], field("/odd[\"a b\"]")));
  const QString layout = desk.dock.layout();
  Desk other;
  QVERIFY(other.dock.restoreLayout(layout));
  QCOMPARE(other.dock.layout(), layout);
  for (const char* garbage : {"", "{", "[]", "7", "{\"a\":1}"})
    QVERIFY2(!other.dock.restoreLayout(QLatin1String(garbage)), garbage);
  QCOMPARE(other.dock.layout(), layout);
  QVERIFY(other.dock.restoreLayout(QStringLiteral("[[1,\"nonsense\",null],{},[\"speed\"]]")));
  QCOMPARE(other.dock.plots().size(), std::size_t(3));
  other.dock.clearPlots();
  QCOMPARE(other.dock.layout(), QStringLiteral("[[]]"));
}

void TestWindowPlots::fieldsOfAnEarlierRobotGo() {
  Desk desk;
  desk.dock.addQuantity(Quantity::X);
  QVERIFY(desk.dock.addCurve(desk.dock.plots()[0], field("/odd.a")));
  desk.dock.addQuantity(Quantity::Speed);
  const QString before = desk.dock.layout();
  QVERIFY(before.contains(QLatin1String("/odd")));
  desk.dock.removeFields();
  QVERIFY(!desk.dock.layout().contains(QLatin1String("/odd")));
  QVERIFY(desk.dock.layout().contains(QLatin1String("speed")));
}

void TestWindowPlots::thereAreNoMoreThanCanBeToldApart() {
  Desk desk;
  PlotWidget* plot = desk.dock.plots().front();
  for (int i = 0; i < 8; ++i)
    QVERIFY(desk.dock.addCurve(plot, *plotFromWord(QStringLiteral("/t.a[%1]").arg(i))));
  QVERIFY(!desk.dock.addCurve(plot, Quantity::X));
  QVERIFY(!desk.dock.saidText().isEmpty());
  while (desk.dock.addPlot()) {
  }
  QCOMPARE(int(desk.dock.plots().size()), PlotsDock::kMostPlots);
  QVERIFY(!desk.dock.newPlotButton()->isEnabled());
  desk.dock.removePlot(desk.dock.plots().back());
  QVERIFY(desk.dock.newPlotButton()->isEnabled());
}

void TestWindowPlots::aRobotThatSpeaksIsPlottedAsItComes() {
  double now_s = kStart_s;
  auto made = std::make_unique<test::FakeRobot>(QStringLiteral("axbot+http://192.0.2.7:8090"));
  made->has_live = true;
  test::FakeRobot* const robot = made.get();
  session::Session session(std::move(made), {});
  session.open();
  PlotFeed feed(nullptr, [&] { return now_s; });
  PlotsDock dock(feed);
  QSignalSpy raw(&feed, &PlotFeed::rawWanted);
  feed.setSession(&session);
  QTRY_COMPARE(robot->connection().phase, robot::ConnectionPhase::Online);
  PlotWidget* plot = dock.plots().front();
  QVERIFY(dock.addCurve(plot, Quantity::Speed));
  QVERIFY(dock.addCurve(plot, field("/t.a")));
  QCOMPARE(raw.size(), 1);
  QVERIFY(robot->wanted.contains(QStringLiteral("/t")));
  for (int i = 0; i < 50; ++i) {
    now_s = kStart_s + i * 0.1;
    Q_EMIT robot->topicReceived({map::TrackedPose{{i * 0.1, 0, 0}}, now_s, {}, "/p"});
    robot::RawMessage message;
    message.topic = QStringLiteral("/t");
    message.received = QDateTime::fromMSecsSinceEpoch(qint64(now_s * 1000));
    message.text = "{\"a\":" + QByteArray::number(i) + "}";
    Q_EMIT robot->rawReceived(message);
  }
  QTRY_VERIFY(plot->curves()[0].series->at(kStart_s + 4));
  QVERIFY(std::abs(plot->curves()[0].series->at(kStart_s + 4)->value - 1) < 1e-6);
  QCOMPARE(plot->curves()[1].series->at(kStart_s + 4.95)->value, 49.0);
  // Half an hour later the first ones are gone.
  now_s = kStart_s + 4.9 + PlotFeed::kLive_s;
  QTRY_VERIFY(plot->curves()[1].series->size() <= 20);
  QCOMPARE(feed.fields(), QStringList{QStringLiteral("/t.a")});
  // Behind those of a long list that are offered there are others.
  robot::RawMessage long_one;
  long_one.topic = QStringLiteral("/t");
  long_one.received = QDateTime::fromMSecsSinceEpoch(qint64(now_s * 1000));
  long_one.text = "{\"a\":1,\"list\":[" + QByteArray("0,").repeated(19) + "0]}";
  Q_EMIT robot->rawReceived(long_one);
  QVERIFY(!feed.fields().contains(QStringLiteral("/t.list[19]")));
  for (const int index : {19, 20}) {
    dock.pathEdit()->setText(QStringLiteral("/t.list[%1]").arg(index));
    dock.addTyped();
    QCOMPARE(dock.saidText().contains(QStringLiteral("No message so far")), index == 20);
    dock.removeCurve(plot, 2);
  }
  dock.removeCurve(plot, 1);
  QCOMPARE(raw.size(), 2);
  QCOMPARE(raw[1][0].toBool(), false);
  QVERIFY(!robot->wanted.contains(QStringLiteral("/t")));
  feed.setSession(nullptr);
}

void TestWindowPlots::closingTheBagLeavesNothingOfIt() {
  Desk desk;
  QVERIFY(desk.dock.addCurve(desk.dock.plots().front(), field("/count.n")));
  desk.open();
  desk.reading->want(kStart_s + 10);
  QTRY_COMPARE(desk.value(field("/count.n"), 5), 50.0);
  desk.feed.setReading(nullptr);
  desk.dock.closeBag();
  desk.reading.reset();
  QVERIFY(desk.dock.plots().front()->curves()[0].series->empty());
  QVERIFY(!desk.dock.wholeButton()->isEnabled());
  QSignalSpy seeks(&desk.dock, &PlotsDock::seekWanted);
  QTest::mouseClick(desk.dock.plots().front(), Qt::LeftButton, {},
                    desk.dock.plots().front()->area().center());
  QCOMPARE(seeks.size(), 0);
}

}  // namespace test_window_plots

MAPWRIGHT_TEST(test_window_plots, TestWindowPlots, Widgets)
#include "test_window_plots.moc"
