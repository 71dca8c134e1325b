// Maps reduced to walls and free ground.
#include <QtTest>

#include "align/plan_of.h"
#include "buildings.h"
#include "grids/grid_pyramid.h"
#include "test_program.h"

namespace test_plan {

using namespace mapwright;
using namespace mapwright::testing;

namespace {

/// Rows from the top: '#' wall, '.' free, ' ' unknown.
render::PlacedGrid gridOf(const std::vector<std::string>& rows, double resolution_m, const Pose2& origin) {
  const int width = int(rows.front().size()), height = int(rows.size());
  const auto builder =
      grids::buildGrid(width, height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  for (const std::string& row : rows) {
    std::vector<std::uint8_t> cells;
    for (const char c : row) cells.push_back(c == '#' ? 100 : c == '.' ? 0 : grids::kUnknownOccupancy);
    builder->pushRow(cells);
  }
  builder->finish();
  return {builder->pyramid(), {width, height, resolution_m, origin}};
}

std::vector<std::string> rowsOf(const Plan& plan) {
  std::vector<std::string> rows;
  for (int row = plan.height - 1; row >= 0; --row) {
    std::string text;
    for (int column = 0; column < plan.width; ++column) {
      const Ground ground = plan.at(column, row);
      text += ground == Ground::Wall ? '#' : ground == Ground::Free ? '.' : ' ';
    }
    rows.push_back(text);
  }
  return rows;
}

}  // namespace

class TestPlan : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anUprightMapKeepsItsCells() {
    const std::vector<std::string> rows{"## ", "#..", "#.#"};
    const Plan plan = *align::planOf(gridOf(rows, 0.05, {2, 3, 0}), 0.05);
    QCOMPARE(rowsOf(plan), rows);
    QVERIFY(plan.centreOf(0, 0).isApprox(Eigen::Vector2d(2.025, 3.025)));
  }

  void aHairDoesNotPutAWallIntoTwoCells() {
    std::vector<std::string> rows{std::string(400, '.'), std::string(400, '.')};
    for (std::size_t column = 10; column < 400; column += 10) rows[column / 10 % 2][column] = '#';
    QCOMPARE(rowsOf(*align::planOf(gridOf(rows, 0.05, {2, 3, 0}), double(0.05F))), rows);
  }

  void aWallWinsInALargerCell() {
    const std::vector<std::string> rows{"#...", "....", "..  ", "..  "};
    QCOMPARE(rowsOf(*align::planOf(gridOf(rows, 0.05, {}), 0.1)), (std::vector<std::string>{"#.", ". "}));
  }

  void aMapTurnedByARightAngleIsRead() {
    const Plan plan = *align::planOf(gridOf({"#. ", "..."}, 0.05, {0, 0, M_PI / 2}), 0.05);
    QCOMPARE(rowsOf(plan), (std::vector<std::string>{" .", "..", "#."}));
  }

  void unknownGroundAroundTheMapIsLeftOut() {
    const Plan plan = align::trimmed(*align::planOf(gridOf({"    ", " #. ", "    "}, 0.05, {1, 1, 0}), 0.05));
    QCOMPARE(rowsOf(plan), (std::vector<std::string>{"#."}));
    QVERIFY(plan.corner_m.isApprox(Eigen::Vector2d(1.05, 1.05)));
    QCOMPARE(align::trimmed(*align::planOf(gridOf({"  "}, 0.05, {}), 0.05)).width, 0);
  }

  void wallsThatNobodySawAreLeftOut() {
    const Plan plan = *align::planOf(gridOf({"######.#"}, 0.05, {}), 0.05);
    QCOMPARE(rowsOf(align::seenOnly(plan, 0.1)), (std::vector<std::string>{"    ##.#"}));
    const Plan walls_only = *align::planOf(gridOf({"## #"}, 0.05, {}), 0.05);
    QCOMPARE(align::seenOnly(walls_only, 0.1), walls_only);
  }

  void coarserCellsHoldWhatTheyCover() {
    const Plan plan = *align::planOf(gridOf({".#.", "...", "  ."}, 0.05, {}), 0.05);
    QCOMPARE(rowsOf(align::coarser(plan, 2)), (std::vector<std::string>{"#.", ".."}));
  }

  void cellsAreNoFinerThanThoseOfEitherMap() {
    const auto fine = gridOf({"#"}, 0.02, {}), coarse = gridOf({"#"}, 0.1, {});
    QCOMPARE(align::cellsFor(fine, fine), 0.05);
    QCOMPARE(align::cellsFor(fine, coarse), 0.1);
  }
};

}  // namespace test_plan

MAPWRIGHT_TEST(test_plan, TestPlan, Core)
#include "test_plan.moc"
