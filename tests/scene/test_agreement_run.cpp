// A survey in the background says what one says that is waited for.
#include <QSignalSpy>
#include <QTest>

#include "submaps.h"
#include "test_program.h"
#include "ui/scene/agreement_run.h"

namespace test_agreement_run {

using namespace mapwright;
using testing::kFree;
using testing::kWall;
using testing::plain;
using ui::scene::AgreementRun;

namespace {

/// Walls of 1 m on free ground, 20 m apart: two submaps contradict at each.
std::vector<render::PlacedTexture> walls(int count) {
  std::vector<render::PlacedTexture> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(plain(2 * i, i * 20.0, 0, 40, 40, kFree));
    all.push_back(plain(2 * i + 1, i * 20.0 + 0.5, 0.5, 20, 20, kWall));
  }
  return all;
}

bool ended(AgreementRun& run) {
  QSignalSpy progressed(&run, &AgreementRun::progressed);
  while (run.running()) {
    if (!progressed.wait()) return false;
  }
  return true;
}

}  // namespace

class AgreementRunTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void itFindsWhatASurveyFinds() {
    AgreementRun run(std::make_shared<work::Workers>(2));
    auto submaps = walls(9);
    QVERIFY(!run.setSubmaps(submaps, 0));
    QVERIFY(!run.running() && !run.survey().complete());
    run.go();
    QVERIFY(ended(run));
    QVERIFY(run.survey().complete());
    const agreement::Disagreement found = run.survey().disagreement();
    QCOMPARE(found.contradicted_cells, std::uint64_t(9 * 400));
    QCOMPARE(found.occupied_cells, std::uint64_t(9 * 400));
    // Only what has changed is looked at again.
    submaps.back().world_from_texture.x_m += 100;
    QVERIFY(!run.setSubmaps(submaps, 0));
    QVERIFY(run.survey().stale() > 0 && run.survey().stale() <= 4);
    run.go();
    QVERIFY(ended(run));
    QCOMPARE(run.survey().disagreement().contradicted_cells, std::uint64_t(8 * 400));
  }

  void itsFindingsAreRankedInTheBackground() {
    AgreementRun run(std::make_shared<work::Workers>(2));
    QVERIFY(run.foundAll() && run.found()->places.empty());
    auto submaps = walls(9);
    QVERIFY(!run.setSubmaps(submaps, 0));
    QVERIFY(!run.foundAll());
    run.go();
    while (!run.survey().complete()) QCoreApplication::processEvents();
    QTRY_VERIFY(run.foundAll());
    QCOMPARE(run.found()->contradicted_cells, std::uint64_t(9 * 400));
    const auto before = run.found();
    QVERIFY(!run.setSubmaps(submaps, 0));  // nothing has changed
    QVERIFY(run.foundAll());
    submaps.resize(2);
    QVERIFY(!run.setSubmaps(submaps, 0));
    QVERIFY(!run.foundAll());
    QCOMPARE(run.found(), before);  // until they are ranked
    run.go();
    QTRY_VERIFY(run.foundAll());
    QCOMPARE(run.found()->contradicted_cells, std::uint64_t(400));
    run.forget();
    QVERIFY(run.found()->places.empty() && run.found()->tiles.empty());
  }

  void aRankingOfWhatWasForgottenIsNotTaken() {
    AgreementRun run(std::make_shared<work::Workers>(1));
    QVERIFY(!run.setSubmaps(walls(3), 0));
    run.go();
    QVERIFY(ended(run));  // the ranking has begun
    run.forget();
    QVERIFY(!run.setSubmaps(walls(1), 4));
    run.go();
    QSignalSpy progressed(&run, &AgreementRun::progressed);
    while (!run.foundAll()) {
      QVERIFY(progressed.wait());
      QVERIFY(run.found()->contradicted_cells <= 400);
    }
    QCOMPARE(run.found()->tolerance_cells, 4);
  }

  void stoppedItGoesOnWhereItWas() {
    AgreementRun run(std::make_shared<work::Workers>(1));
    QVERIFY(!run.setSubmaps(walls(50), 0));
    run.go();
    run.stop();
    QVERIFY(!run.running() && !run.survey().complete());
    run.go();
    QVERIFY(ended(run));
    QCOMPARE(run.survey().disagreement().contradicted_cells, std::uint64_t(50 * 400));
  }

  void anotherToleranceBeginsAnew() {
    AgreementRun run(std::make_shared<work::Workers>(1));
    QVERIFY(!run.setSubmaps(walls(1), 0));
    run.go();
    QVERIFY(ended(run));
    QVERIFY(!run.setSubmaps(walls(1), 4));
    QVERIFY(!run.survey().complete());
    QCOMPARE(run.survey().rules().tolerance_cells, 4);
  }

  void moreThanCanBeLookedAtIsLookedAtInLargerCells() {
    AgreementRun run(std::make_shared<work::Workers>(1));
    // 1.8 km square: too many tiles of 12.8 m.
    const auto large = testing::submap(0, 0, 0, 30, 30, std::vector<cells::CellPair>(900, kFree), 60);
    QVERIFY(!run.setSubmaps({large}, 4));
    QCOMPARE(run.survey().rules().cell_m, 0.1);
    const auto endless = testing::submap(0, 0, 0, 30, 30, std::vector<cells::CellPair>(900, kFree), 60'000);
    QVERIFY(run.setSubmaps({endless}, 4).has_value());
    QCOMPARE(run.survey().rules().cell_m, 0.1);
    run.forget();
    QCOMPARE(run.survey().rules().cell_m, agreement::Rules().cell_m);
  }

  void itMayEndWhileItRuns() {
    auto run = std::make_unique<AgreementRun>(std::make_shared<work::Workers>(2));
    QVERIFY(!run->setSubmaps(walls(50), 0));
    run->go();
    run.reset();
    QCoreApplication::processEvents();
  }
};

}  // namespace test_agreement_run

MAPWRIGHT_TEST(test_agreement_run, AgreementRunTest, Widgets)
#include "test_agreement_run.moc"
