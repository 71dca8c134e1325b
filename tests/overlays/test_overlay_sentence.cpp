// What people read about changes of overlays.
#include <QTest>

#include "overlays/overlay_sentence.h"
#include "test_program.h"

namespace test_overlay_sentence {

using namespace mapwright;

class OverlaySentenceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatChangesOfOverlaysIsToldWithItsValues() {
    const auto told = [](const char* was, const char* is) {
      const auto collection = [](const std::string& features) {
        return *overlays::OverlayDocument::read(R"({"type":"FeatureCollection","features":[)" + features +
                                                "]}");
      };
      const auto before = collection(was), after = collection(is);
      QStringList sentences;
      for (const auto& change : overlays::changesBetween(before, after))
        sentences << overlays::changeText(change, before, after);
      return sentences.join(QLatin1Char('|'));
    };
    const char* const wall =
        R"({"id":"w","geometry":{"type":"LineString","coordinates":[[0,0],[4,0]]},"properties":{"lineType":"2","name":"W17"}})";
    QCOMPARE(
        told(
            wall,
            R"({"id":"w","geometry":{"type":"LineString","coordinates":[[0,0.4],[4,0.4]]},"properties":{"lineType":"2","name":"W17"}})"),
        QStringLiteral("Move virtual wall W17 by 0.40 m"));
    QCOMPARE(
        told(
            wall,
            R"({"id":"w","geometry":{"type":"LineString","coordinates":[[0,0],[4,1]]},"properties":{"lineType":1,"name":"W17"}})"),
        QStringLiteral("Reshape virtual wall W17; Make virtual wall W17 a virtual track"));
    QCOMPARE(told("", wall), QStringLiteral("Add virtual wall W17"));
    QCOMPARE(told(wall, ""), QStringLiteral("Delete virtual wall W17"));
    const std::string point = R"({"id":"p","geometry":{"type":"Point","coordinates":[1,2]},"properties":{)";
    const auto with = [&](const char* properties) { return point + properties + "}}"; };
    QCOMPARE(
        told(with(R"("type":9,"yaw":"90","a":1)").c_str(), with(R"("type":9,"yaw":"9e1","b":2)").c_str()),
        QStringLiteral("Remove a of charger at 1.00, 2.00 m (was 1); Turn charger at 1.00, 2.00 m to "
                       "9e1° (was 90°); Set b of charger at 1.00, 2.00 m to 2"));
  }
};

}  // namespace test_overlay_sentence

MAPWRIGHT_TEST(test_overlay_sentence, OverlaySentenceTest, Nothing)
#include "test_overlay_sentence.moc"
