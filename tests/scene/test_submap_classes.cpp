// How submaps are sorted into the classes by which they are coloured.
#include <limits>
#include <utility>

#include <QTest>

#include "map/submap_version.h"
#include "test_program.h"
#include "ui/scene/submap_classes.h"

namespace test_submap_classes {

using namespace mapwright;
using namespace mapwright::ui::scene;
using render::kClasses;

class SubmapClassesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void trajectoriesTakeTurns() {
    QCOMPARE(trajectoryClass(0), 0);
    QCOMPARE(trajectoryClass(7), 7);
    QCOMPARE(trajectoryClass(8), 0);
    QCOMPARE(trajectoryClass(-1), 7);
    QCOMPARE(trajectoryClass(std::numeric_limits<std::int32_t>::min()), 0);
  }

  void agesFollowTheIndexAndUseAtLeastHalfOfTheSteps() {
    for (std::int32_t newest = 0; newest < 3000; newest += 1 + newest / 7) {
      int before = 0;
      for (std::int32_t index = 0; index <= newest; ++index) {
        const int age = ageClass(index, newest);
        QVERIFY(age >= before && age < kClasses && age <= before + 1);
        before = age;
      }
      QVERIFY(before >= std::min(newest, kClasses / 2));
    }
    const auto most = std::numeric_limits<std::int32_t>::max();
    QCOMPARE(ageClass(most, most), kClasses - 1);
    QCOMPARE(ageClass(-5, -1), 0);
    QCOMPARE(ageClass(9, 3), 4);  // not listed any more
  }

  void agesOnlyChangeWhenTheTrajectoryHasDoubled() {
    int changes = 0;
    for (std::int32_t newest = 1; newest < 1024; ++newest)
      changes += ageShift(newest) != ageShift(newest - 1);
    QCOMPARE(changes, 7);  // at 8, 16 ... 512
  }

  void versionsAreComparedWithFixedSteps() {
    const std::pair<std::int32_t, int> expected[] = {{0, 0},   {4, 0},   {5, 1},   {9, 1},    {10, 2},
                                                     {19, 2},  {20, 3},  {39, 3},  {40, 4},   {80, 5},
                                                     {160, 6}, {319, 6}, {320, 7}, {9'999, 7}};
    for (const auto& [version, of] : expected) QCOMPARE(versionClass(version), of);
    QCOMPARE(versionClass(std::numeric_limits<std::int32_t>::max()), 7);
    QCOMPARE(versionClass(map::kNoVersion), render::kUnknownVersion);
  }
};

}  // namespace test_submap_classes

MAPWRIGHT_TEST(test_submap_classes, SubmapClassesTest, Core)
#include "test_submap_classes.moc"
