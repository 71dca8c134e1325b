// Parts of plots: marks of axes, looks, names of fields in texts of messages.
#include <cmath>

#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

#include "series/fields.h"
#include "test_program.h"
#include "ui/kit/plot_ticks.h"
#include "ui/kit/pretty_json.h"
#include "ui/kit/ui_colors.h"
#include "ui/plots/message_view.h"
#include "ui/plots/plot_selection.h"
#include "ui/plots/plot_widget.h"

namespace test_plot_parts {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

QStringList texts(const std::vector<PlotTick>& ticks) {
  QStringList all;
  for (const PlotTick& tick : ticks) all << tick.text;
  return all;
}

QString fieldText(const QString& text, const QString& at, qsizetype inside = 0) {
  const auto field = fieldAt(text, text.indexOf(at) + inside, QStringLiteral("/t"));
  return field ? QString::fromStdString(field->path.text()) : QString();
}

}  // namespace

class TestPlotParts : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void valuesAreMarkedAtRoundNumbers();
  void timesAreMarkedAtWholePartsOfTheDay();
  void anyRangeHasFewMarks();
  void valuesHaveAsManyDigitsAsSaySomething();
  void curvesAreToldApartInEitherTheme();
  void wishesAreWrittenAndRead();
  void theFieldBelowAPlaceIsNamed();
  void textsThatAreCutStillNameTheirFields();
  void everyFieldOfAMessageIsFoundInItsText();
  void aNumberIsDraggedOutOfAMessage();
  void whatIsDroppedIsAFieldOrNothing();
};

void TestPlotParts::valuesAreMarkedAtRoundNumbers() {
  QCOMPARE(texts(valueTicks(-0.1, 1.05, 6)),
           (QStringList{QStringLiteral("0.0"), QStringLiteral("0.2"), QStringLiteral("0.4"),
                        QStringLiteral("0.6"), QStringLiteral("0.8"), QStringLiteral("1.0")}));
  QCOMPARE(texts(valueTicks(-7, 12, 4)), (QStringList{QStringLiteral("-5"), QStringLiteral("0"),
                                                      QStringLiteral("5"), QStringLiteral("10")}));
}

void TestPlotParts::timesAreMarkedAtWholePartsOfTheDay() {
  const double noon_s = 1'717'416'000;  // 2024-06-03 12:00 UTC
  QCOMPARE(texts(timeTicks(noon_s - 3, noon_s + 32, 5)),
           (QStringList{QStringLiteral("12:00:00"), QStringLiteral("12:00:10"), QStringLiteral("12:00:20"),
                        QStringLiteral("12:00:30")}));
  QCOMPARE(texts(timeTicks(noon_s, noon_s + 0.5, 3)),
           (QStringList{QStringLiteral("12:00:00.000"), QStringLiteral("12:00:00.200"),
                        QStringLiteral("12:00:00.400")}));
  QVERIFY(texts(timeTicks(noon_s, noon_s + 86'400, 4)).contains(QStringLiteral("4 Jun")));
  QCOMPARE(texts(timeTicks(noon_s, noon_s + 40, 5, noon_s - 10)),
           (QStringList{QStringLiteral("10"), QStringLiteral("20"), QStringLiteral("30"),
                        QStringLiteral("40"), QStringLiteral("50")}));
}

void TestPlotParts::anyRangeHasFewMarks() {
  for (const double long_s : {0.001, 0.3, 7.0, 61.0, 4000.0, 1e5, 1e7, 3e9}) {
    for (const int most : {1, 3, 12}) {
      QVERIFY(int(timeTicks(1.7e9, 1.7e9 + long_s, most).size()) <= most + 1);
      QVERIFY(int(timeTicks(1.7e9, 1.7e9 + long_s, most, 1.7e9).size()) <= most + 1);
      QVERIFY(int(valueTicks(-long_s, long_s * 2, most).size()) <= most + 1);
    }
  }
  QVERIFY(valueTicks(1, 1, 5).empty());
  QVERIFY(valueTicks(-1e308, 1e308, 5).empty());
  QVERIFY(valueTicks(1e15, 1e15 + 0.001, 5).empty());
  QVERIFY(timeTicks(5, 4, 5).empty());
}

void TestPlotParts::valuesHaveAsManyDigitsAsSaySomething() {
  QCOMPARE(valueText(0), QStringLiteral("0"));
  QCOMPARE(valueText(10), QStringLiteral("10"));
  QCOMPARE(valueText(1.23456), QStringLiteral("1.235"));
  QCOMPARE(valueText(-0.012345678), QStringLiteral("-0.012346"));
  QCOMPARE(valueText(12345.678), QStringLiteral("12345.68"));
  QCOMPARE(valueText(1e-7), QStringLiteral("1e-07"));
}

void TestPlotParts::curvesAreToldApartInEitherTheme() {
  for (const bool dark : {false, true}) {
    for (int look = 0; look < kPlotLooks; ++look) {
      QVERIFY2(contrastRatio(plotColor(look, dark), uiColors(dark).base) >= 3,
               qPrintable(plotColor(look, dark).name()));
      for (int other = 0; other < look; ++other) {
        const QColor a = plotColor(look, dark), b = plotColor(other, dark);
        QVERIFY(std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                    std::abs(a.blue() - b.blue()) >
                60);
        // The shapes of their marks differ as well.
        const auto mark = [&](int which) {
          QImage image(24, 24, QImage::Format_RGB32);
          image.fill(Qt::white);
          QPainter painter(&image);
          paintPlotMark(painter, which, Qt::black, {12, 12}, 8);
          return image;
        };
        QVERIFY(mark(look) != mark(other));
      }
    }
  }
}

void TestPlotParts::wishesAreWrittenAndRead() {
  for (const series::Quantity quantity : series::kQuantities) {
    QVERIFY(!plotName(quantity).isEmpty());
    QVERIFY(plotFromWord(plotWord(quantity)) == PlotSelection(quantity));
  }
  const PlotSelection field = *series::FieldPath::parse("/t.a[0]");
  QVERIFY(plotFromWord(plotWord(field)) == field);
  QVERIFY(!plotFromWord(QStringLiteral("nonsense")));
  QVERIFY(!plotFromWord({}));
}

void TestPlotParts::theFieldBelowAPlaceIsNamed() {
  const QString text = QStringLiteral(
      "{\n  \"topic\": \"/t\",\n  \"pos\": [1.5, -2],\n  \"odd.name\": {\"a\": true, \"b\": \"word\"},\n  "
      "\"s\": \"12.5\",\n"
      "  \"list\": [\n    {\"x\": 7},\n    {\"x\": 8}\n  ],\n  \"n\": null\n}");
  QCOMPARE(fieldText(text, QStringLiteral("1.5"), 1), QStringLiteral("/t.pos[0]"));
  QCOMPARE(fieldText(text, QStringLiteral("-2")), QStringLiteral("/t.pos[1]"));
  QCOMPARE(fieldText(text, QStringLiteral("true")), QStringLiteral("/t[\"odd.name\"].a"));
  QCOMPARE(fieldText(text, QStringLiteral("\"a\"")), QStringLiteral("/t[\"odd.name\"].a"));
  QCOMPARE(fieldText(text, QStringLiteral("12.5")), QStringLiteral("/t.s"));
  QCOMPARE(fieldText(text, QStringLiteral("8")), QStringLiteral("/t.list[1].x"));
  QCOMPARE(fieldText(text, QStringLiteral("null")), QStringLiteral("/t.n"));
  for (const char* none : {"word", "\"pos\"", "\"list\"", "/t", "{", "topic"})
    QVERIFY2(fieldText(text, QLatin1String(none)).isEmpty(), none);
  for (qsizetype i = -5; i < text.size() + 5; ++i) (void)fieldAt(text, i, QStringLiteral("/t"));
}

void TestPlotParts::textsThatAreCutStillNameTheirFields() {
  const QByteArray json = "{\"long\":\"" + QByteArray(2000, 'x') + "\",\"after\":[3,{\"q\\\"uoted\":4.25}]}";
  const QString text = prettyJson(json);
  QVERIFY(text.contains(QStringLiteral("characters")));
  QCOMPARE(fieldText(text, QStringLiteral("4.25")), QStringLiteral("/t.after[1][\"q\\\"uoted\"]"));
}

void TestPlotParts::everyFieldOfAMessageIsFoundInItsText() {
  const QByteArray json =
      R"({"topic":"/t","pos":[1.5,2.5],"ori":0.25,"deep":{"cov":[[10,11],[12,13]],"flag":false},"text":"a, b] {c","last":{"x":99}})";
  const QString text = prettyJson(json);
  QSet<QString> found;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (const auto field = fieldAt(text, i, QStringLiteral("/t")))
      found << QString::fromStdString(field->path.text());
  }
  QSet<QString> expected;
  for (const series::FieldPath& path : series::numericFields("/t", json.toStdString()))
    expected << QString::fromStdString(path.text());
  QCOMPARE(expected.size(), 9);
  QCOMPARE(found, expected);
}

void TestPlotParts::aNumberIsDraggedOutOfAMessage() {
  MessageView view;
  view.resize(400, 200);
  view.setPlainText(prettyJson("{\"pos\":[1.5,2.5],\"word\":\"hello\"}"));
  view.show();
  QStringList carried;
  view.carry = [&](std::unique_ptr<QMimeData> mime) { carried << mime->text(); };
  const auto positionOf = [&](const QString& word) {
    QTextCursor cursor = view.document()->find(word);
    cursor.setPosition(cursor.selectionStart() + 1);
    return view.cursorRect(cursor).center();
  };
  const auto drag = [&](const QPoint& from) {
    QTest::mousePress(view.viewport(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(60, 0),
                     view.viewport()->mapToGlobal(from + QPoint(60, 0)), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(view.viewport(), &move);
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, from + QPoint(60, 0));
  };
  drag(positionOf(QStringLiteral("2.5")));
  QVERIFY(carried.isEmpty());  // nobody has said of which topic it is
  view.setTopic(QStringLiteral("/t"));
  drag(positionOf(QStringLiteral("2.5")));
  QCOMPARE(carried, QStringList{QStringLiteral("/t.pos[1]")});
  drag(positionOf(QStringLiteral("hello")));
  QCOMPARE(carried.size(), 1);
  QVERIFY(view.textCursor().hasSelection());  // text is chosen as ever
}

void TestPlotParts::whatIsDroppedIsAFieldOrNothing() {
  const PlotSelection field = *series::FieldPath::parse("/t.a[0]");
  QVERIFY(plotFromMime(*mimeOf(field)) == field);
  QMimeData text;
  text.setText(QStringLiteral(" /t.b "));
  QVERIFY(plotFromMime(text) == PlotSelection(*series::FieldPath::parse("/t.b")));
  for (const char* word : {"", "word.other", "/t", "http://x.y/z", "/t..a"}) {
    QMimeData other;
    other.setText(QLatin1String(word));
    QVERIFY2(!plotFromMime(other), word);
  }
  QMimeData broken;
  broken.setData(QLatin1String(kFieldMime), QByteArray("\x80\xff[", 3));
  QVERIFY(!plotFromMime(broken));
}

}  // namespace test_plot_parts

MAPWRIGHT_TEST(test_plot_parts, TestPlotParts, Widgets)
#include "test_plot_parts.moc"
