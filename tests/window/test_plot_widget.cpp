// One plot, with mouse and keys.
#include <cmath>

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include "ink.h"
#include "test_program.h"
#include "ui/plots/plot_widget.h"

namespace test_plot_widget {

using namespace mapwright;
using namespace mapwright::ui;
using series::Quantity;

namespace {

constexpr double kStart_s = 1'717'405'200;

/// A sine of a minute, one spike, a gap from 40 to 50 s.
std::shared_ptr<series::Series> wave() {
  auto made = std::make_shared<series::Series>();
  std::vector<series::Sample> samples;
  for (int i = 0; i < 6000; ++i) {
    const double at_s = kStart_s + i / 100.0;
    if (i < 4000 || i >= 5000) samples.push_back({at_s, i == 1234 ? 5.0 : std::sin(i / 300.0)});
  }
  made->insert(kStart_s, kStart_s + 40, samples);
  made->insert(kStart_s + 50, kStart_s + 60, samples);
  return made;
}

struct Shown {
  Shown() {
    plot.resize(640, 240);
    plot.setBounds({kStart_s, kStart_s + 60});
    plot.setSpan({kStart_s, kStart_s + 60});
    plot.setCurves({{Quantity::Speed, wave(), 0}});
    // As the dock does.
    QObject::connect(&plot, &PlotWidget::spanWanted, &plot, [this](double a, double b) {
      plot.setSpan({a, b});
    });
    plot.show();
    plot.setFocus();
  }
  QPoint at(double s, double value) const { return {int(plot.xOf(kStart_s + s)), int(plot.yOf(value))}; }
  void wheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&plot, &event);
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, at, plot.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&plot, &move);
    }
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
  }
  PlotWidget plot;
};

}  // namespace

class TestPlotWidget : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCurveIsPaintedWithItsSpikeAndItsGap();
  void theWheelZoomsAboutThePointer();
  void theWheelOnTheAxisZoomsTheValues();
  void aDragMovesTheTimeAndNeverTakesAllAway();
  void aClickSeeksAndADragDoesNot();
  void aDoubleClickShowsAll();
  void keysZoomMoveAndRemove();
  void theLegendTellsTheValueAtThePointerElseAtTheCursor();
  void withoutACursorTheLegendTellsThePresent();
  void aCurveOfNothingSaysSo();
  void valuesFitOrStay();
  void aRangeOfValuesIsTyped();
};

void TestPlotWidget::aCurveIsPaintedWithItsSpikeAndItsGap() {
  Shown shown;
  const QRect area = shown.plot.area();
  QVERIFY(test::ink(&shown.plot) > 0.01);
  QVERIFY(shown.plot.values().second > 5);
  const auto inked = [&](double s, double least, double greatest) {
    const QImage image = shown.plot.grab().toImage();
    const QPoint a = shown.at(s, greatest), b = shown.at(s, least);
    for (int y = a.y(); y <= b.y(); ++y) {
      const QColor pixel = image.pixelColor(a.x(), y);
      if (pixel.blue() - pixel.red() > 60) return true;
    }
    return false;
  };
  QVERIFY(area.width() > 400);
  QVERIFY(inked(12.34, 2, 4.5));  // one sample of 6000
  QVERIFY(!inked(20, 2, 4.5));
  QVERIFY(inked(30, -1.1, 1.1));
  QVERIFY(!inked(45, -1.1, 1.1));  // no line where nothing is known
}

void TestPlotWidget::theWheelZoomsAboutThePointer() {
  Shown shown;
  const QPoint at = shown.at(20, 0);
  const double time_s = shown.plot.timeAt(at.x());
  shown.wheel(at, 4);
  const auto [from_s, until_s] = shown.plot.span();
  QVERIFY(std::abs((until_s - from_s) - 60 / std::pow(1.25, 4)) < 1e-6);
  QVERIFY(std::abs(shown.plot.timeAt(at.x()) - time_s) < 1e-6);
  shown.wheel(at, -100);  // not endlessly far
  QVERIFY(shown.plot.span().second - shown.plot.span().first <= 60 * 1.1 + 1e-6);
  shown.wheel(at, 100);
  shown.wheel(at, 100);
  QVERIFY(shown.plot.span().second - shown.plot.span().first >= 0.009);
}

void TestPlotWidget::theWheelOnTheAxisZoomsTheValues() {
  Shown shown;
  const auto before = shown.plot.values();
  const auto span = shown.plot.span();
  shown.wheel({5, shown.plot.area().center().y()}, 2);
  QVERIFY(shown.plot.fixedValues());
  QVERIFY(shown.plot.values().second - shown.plot.values().first < (before.second - before.first) * 0.7);
  QCOMPARE(shown.plot.span(), span);
  shown.wheel(shown.at(20, 0), -2, Qt::ControlModifier);
  QVERIFY(std::abs((shown.plot.values().second - shown.plot.values().first) -
                   (before.second - before.first)) < 1e-6);
}

void TestPlotWidget::aDragMovesTheTimeAndNeverTakesAllAway() {
  Shown shown;
  shown.plot.setSpan({kStart_s + 20, kStart_s + 40});
  const QPoint from = shown.plot.area().center();
  const int tenth = shown.plot.area().width() / 10;
  shown.drag(from, from + QPoint(tenth, 0));
  QVERIFY(std::abs(shown.plot.span().first - (kStart_s + 18)) < 0.1);
  for (int i = 0; i < 60; ++i) shown.drag(from, from + QPoint(3 * tenth, 0));
  QVERIFY(shown.plot.span().second >= kStart_s + 1.9);
}

void TestPlotWidget::aClickSeeksAndADragDoesNot() {
  Shown shown;
  QSignalSpy seeks(&shown.plot, &PlotWidget::seekWanted);
  QTest::mouseClick(&shown.plot, Qt::LeftButton, {}, shown.at(15, 0));
  QCOMPARE(seeks.size(), 1);
  QVERIFY(std::abs(seeks[0][0].toDouble() - (kStart_s + 15)) < 0.2);
  shown.drag(shown.at(15, 0), shown.at(25, 0));
  QTest::mouseClick(&shown.plot, Qt::RightButton, {}, shown.at(15, 0));
  QTest::mouseClick(&shown.plot, Qt::LeftButton, {}, {5, 60});  // the axis
  QCOMPARE(seeks.size(), 1);
}

void TestPlotWidget::aDoubleClickShowsAll() {
  Shown shown;
  shown.plot.setFixedValues(PlotWidget::Range{0, 1});
  QSignalSpy all(&shown.plot, &PlotWidget::allWanted);
  QTest::mouseDClick(&shown.plot, Qt::LeftButton, {}, shown.at(15, 0.5));
  QCOMPARE(all.size(), 1);
  QVERIFY(!shown.plot.fixedValues());
}

void TestPlotWidget::keysZoomMoveAndRemove() {
  Shown shown;
  PlotWidget& plot = shown.plot;
  plot.setCurrent(kStart_s + 15);
  const double x = plot.xOf(kStart_s + 15);
  QTest::keyClick(&plot, Qt::Key_Plus);
  QVERIFY(std::abs((plot.span().second - plot.span().first) - 48) < 1e-6);
  QVERIFY(std::abs(plot.xOf(kStart_s + 15) - x) < 1e-3);  // about the cursor
  QTest::keyClick(&plot, Qt::Key_Right);
  QVERIFY(std::abs(plot.xOf(kStart_s + 15) - (x - plot.area().width() / 10.0)) < 1);
  QTest::keyClick(&plot, Qt::Key_Home);
  QVERIFY(std::abs(plot.span().first - kStart_s) < 1e-6);
  QTest::keyClick(&plot, Qt::Key_End);
  QVERIFY(std::abs(plot.span().second - (kStart_s + 60)) < 1e-6);
  QTest::keyClick(&plot, Qt::Key_Up);
  QVERIFY(plot.fixedValues());
  QSignalSpy all(&plot, &PlotWidget::allWanted), gone(&plot, &PlotWidget::curveUnwanted);
  QTest::keyClick(&plot, Qt::Key_F);
  QCOMPARE(all.size(), 1);
  QVERIFY(!plot.fixedValues());
  QTest::keyClick(&plot, Qt::Key_Delete);
  QCOMPARE(gone.size(), 1);
}

void TestPlotWidget::theLegendTellsTheValueAtThePointerElseAtTheCursor() {
  Shown shown;
  QCOMPARE(shown.plot.valueAtCursor(0), QStringLiteral("–"));
  shown.plot.setCurrent(kStart_s + 12.34);
  QCOMPARE(shown.plot.valueAtCursor(0),
           QString(QStringLiteral("5") + QChar(QChar::Nbsp) + QStringLiteral("m/s")));
  shown.plot.setPointed(kStart_s + 45);
  QCOMPARE(shown.plot.valueAtCursor(0), QStringLiteral("–"));
  shown.plot.setPointed(std::nullopt);
  QVERIFY(shown.plot.valueAtCursor(0).startsWith(QLatin1Char('5')));
}

void TestPlotWidget::withoutACursorTheLegendTellsThePresent() {
  Shown shown;
  shown.plot.setPresent(kStart_s + 12.34);
  QVERIFY(shown.plot.valueAtCursor(0).startsWith(QLatin1Char('5')));
  shown.plot.setCurrent(kStart_s + 45);
  QCOMPARE(shown.plot.valueAtCursor(0), QStringLiteral("–"));
}

void TestPlotWidget::aCurveOfNothingSaysSo() {
  Shown shown;
  auto nothing = std::make_shared<series::Series>();
  shown.plot.setCurves({{Quantity::Speed, nothing, 0}});
  QCOMPARE(shown.plot.valueAtCursor(0), QStringLiteral("–"));  // nobody has looked yet
  nothing->cover(kStart_s, kStart_s + 60);
  QCOMPARE(shown.plot.valueAtCursor(0), QStringLiteral("none yet"));
}

void TestPlotWidget::valuesFitOrStay() {
  Shown shown;
  QVERIFY(shown.plot.values().second > 5);
  shown.plot.setSpan({kStart_s + 20, kStart_s + 30});
  QVERIFY(shown.plot.values().second < 1.2);
  shown.plot.setFixedValues(PlotWidget::Range{-3, 3});
  shown.plot.setSpan({kStart_s, kStart_s + 60});
  QCOMPARE(shown.plot.values(), (PlotWidget::Range{-3, 3}));
  shown.plot.setFixedValues(PlotWidget::Range{3, 3});  // no range
  shown.plot.setFixedValues(PlotWidget::Range{0, std::nan("")});
  QCOMPARE(shown.plot.values(), (PlotWidget::Range{-3, 3}));
  // One value, and none.
  auto flat = std::make_shared<series::Series>();
  flat->insert(0, 10, std::vector<series::Sample>{{1, 42}, {2, 42}});
  PlotWidget plot;
  plot.setSpan({0, 10});
  plot.setCurves({{Quantity::X, flat, 0}});
  QVERIFY(plot.values().first < 42 && plot.values().second > 42);
  plot.setSpan({20, 30});
  QVERIFY(plot.values().first < plot.values().second);
}

void TestPlotWidget::aRangeOfValuesIsTyped() {
  Shown shown;
  QMenu menu;
  shown.plot.fillMenu(menu);
  for (QAction* action : menu.actions()) {
    if (action->text().contains(QStringLiteral("range…"))) action->trigger();
  }
  auto* dialog = shown.plot.findChild<QDialog*>();
  QVERIFY(dialog);
  auto* from = dialog->findChild<QLineEdit*>(QStringLiteral("from"));
  auto* until = dialog->findChild<QLineEdit*>(QStringLiteral("until"));
  auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  from->setText(QStringLiteral("-2.5"));
  until->setText(QStringLiteral("word"));
  QVERIFY(!ok->isEnabled());
  until->setText(QStringLiteral("-3"));
  QVERIFY(!ok->isEnabled());
  until->setText(QStringLiteral("7"));
  QVERIFY(ok->isEnabled());
  ok->click();
  QCOMPARE(shown.plot.values(), (PlotWidget::Range{-2.5, 7}));
}

}  // namespace test_plot_widget

MAPWRIGHT_TEST(test_plot_widget, TestPlotWidget, Widgets)
#include "test_plot_widget.moc"
