// Grids as textures, against a reading of docs/protocols/pbstream.md that is as plain as can be.
#include <cmath>
#include <map>
#include <random>

#include <QTest>

#include "cells/decode_cells.h"
#include "pbstream/submap_texture.h"
#include "state_bytes.h"
#include "test_program.h"

namespace test_submap_texture {

using namespace mapwright;
using namespace mapwright::pbstream;
using namespace mapwright::pbstream::tests;

namespace {

struct Pair {
  int value = 0, alpha = 0;
  bool operator==(const Pair&) const = default;
};

double logit(double p) { return std::log(p / (1 - p)); }

Pair pairOf(long delta) {
  if (delta > 0) return {int(delta), 0};
  if (delta < 0) return {0, int(-delta)};
  return {0, 1};
}
Pair pairOfProbability(double p) {
  const long k = std::lround((logit(p) - logit(0.1)) * 254 / (logit(0.9) - logit(0.1))) + 1;
  return pairOf(128 - k);
}

/// What the cells of a slice mean: one byte (LOG_ODDS) or two each.
std::vector<Pair> pairsOf(const map::RawSlice& slice) {
  const std::size_t cells = std::size_t(slice.width) * std::size_t(slice.height);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < cells; ++i) {
    if (slice.cells.size() == cells) {
      const int v = std::uint8_t(slice.cells[i]);
      pairs.push_back(v == 0 ? Pair{} : pairOf(128 - v));
    } else {
      pairs.push_back({std::uint8_t(slice.cells[2 * i]), std::uint8_t(slice.cells[2 * i + 1])});
    }
  }
  return pairs;
}

bool canBeDecoded(const map::RawSlice& slice) {
  return cells::decodeCells({reinterpret_cast<const std::uint8_t*>(slice.cells.data()), slice.cells.size()},
                            slice.width, slice.height, slice.resolution_m, slice.cell_format)
      .has_value();
}

geometry::Pose3 poseOf(const cartographer_state::Rigid3d& pose) {
  return {pose.translation().x(), pose.translation().y(), pose.translation().z(), pose.rotation().x(),
          pose.rotation().y(),    pose.rotation().z(),    pose.rotation().w()};
}

Eigen::Isometry3d transformOf(const geometry::Pose3& pose) { return *geometry::toIsometry(pose); }

geometry::Pose3 somePose(std::mt19937& random, bool tilted) {
  std::uniform_real_distribution<double> metres(-20, 20), part(-1, 1);
  const double a = tilted ? 0.1 : 0;
  return {metres(random),    metres(random),   tilted ? metres(random) / 10 : 0,
          a * part(random),  a * part(random), part(random),
          part(random) + 1.5};
}

}  // namespace

class SubmapTextureTest : public QObject {
  Q_OBJECT
  Folder folder_;

  tl::expected<Textures, Fault> texturesOf(const cartographer_state::SerializedData& data,
                                           const geometry::Pose3& pose = {}) const {
    const auto file = readStateFile(folder_.write(header() + record(data)));
    if (!file) return tl::unexpected(file.error());
    if (file->submaps.empty()) return tl::unexpected(file->warnings.front());
    return readTextures(*file->file, file->submaps.front(), pose);
  }

 private Q_SLOTS:
  void aGridOfProbabilitiesIsWhatTheSpecificationSays() {
    std::mt19937 random(1);
    for (int round = 0; round < 60; ++round) {
      cartographer_state::SerializedData data;
      auto& submap = *data.mutable_submap()->mutable_submap_2d();
      data.mutable_submap()->mutable_submap_id();
      const geometry::Pose3 local = somePose(random, false);
      place(*submap.mutable_local_pose(), local.x, local.y, 2 * std::atan2(local.qz, local.qw));
      submap.set_num_range_data(round);
      auto& grid = *submap.mutable_grid();
      const int nx = 1 + int(random() % 30), ny = 1 + int(random() % 30);
      const double resolution = 0.05, max_x = double(random() % 100) / 7, max_y = double(random() % 100) / 7;
      grid.mutable_limits()->set_resolution(resolution);
      grid.mutable_limits()->mutable_max()->set_x(max_x);
      grid.mutable_limits()->mutable_max()->set_y(max_y);
      grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(nx);
      grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(ny);
      // Unknown, known, with the mark of an update, and the negative ones of converted files.
      for (int i = 0; i < nx * ny; ++i) {
        const int v = int(random() % 32768);
        grid.add_cells(random() % 3 == 0   ? 0
                       : random() % 4 == 0 ? v | 0x8000
                       : random() % 4 == 0 ? v - 65536
                                           : v);
      }
      auto& box = *grid.mutable_known_cells_box();
      box.set_min_x(int(random() % unsigned(nx)));
      box.set_min_y(int(random() % unsigned(ny)));
      box.set_max_x(box.min_x() + int(random() % unsigned(nx - box.min_x())));
      box.set_max_y(box.min_y() + int(random() % unsigned(ny - box.min_y())));
      grid.mutable_probability_grid_2d();
      const bool usual = round % 3 == 0;
      const float least = round % 2 == 0 ? 0.1f : 0.12f, most = round % 2 == 0 ? 0.9f : 0.88f;
      if (!usual) {
        grid.set_min_correspondence_cost(least);
        grid.set_max_correspondence_cost(most);
      }
      const auto textures = texturesOf(data);
      QVERIFY2(textures, textures ? "" : inEnglish(textures.error()).c_str());
      QCOMPARE(textures->version, round);
      QCOMPARE(textures->slices.size(), std::size_t(1));
      const map::RawSlice& slice = textures->slices.front();
      QCOMPARE(slice.width, box.max_x() - box.min_x() + 1);
      QCOMPARE(slice.height, box.max_y() - box.min_y() + 1);
      QVERIFY(canBeDecoded(slice));
      const double low = usual ? 0.1 : double(least), high = usual ? 0.9 : double(most);
      const std::vector<Pair> pairs = pairsOf(slice);
      for (int row = 0; row < slice.height; ++row) {
        for (int column = 0; column < slice.width; ++column) {
          const int v = std::uint16_t(grid.cells(nx * (box.min_y() + row) + box.min_x() + column)) & 0x7FFF;
          const Pair expected =
              v == 0 ? Pair{} : pairOfProbability(1 - (low + (v - 1) * (high - low) / 32766));
          QCOMPARE(pairs[std::size_t(row * slice.width + column)], expected);
        }
      }
      const Eigen::Isometry3d at =
          transformOf(poseOf(submap.local_pose())).inverse() *
          Eigen::Translation3d(max_x - resolution * box.min_y(), max_y - resolution * box.min_x(), 0);
      QVERIFY(transformOf(slice.slice_pose).isApprox(at, 1e-9));
    }
  }

  void everyProbabilityBecomesTheByteOfItsLogOdds() {
    Grid2D grid;
    grid.resolution_m = 0.05;
    grid.size_x = 32'767;
    grid.size_y = 1;
    for (int v = 1; v <= 32'767; ++v) grid.cells.push_back(std::uint16_t(v));
    grid.known = {0, 0, 32'766, 0};
    const auto slice = sliceOf(grid, {});
    QVERIFY(slice);
    for (int v = 1; v <= 32'767; ++v) {
      const double p = 1 - (0.1 + (v - 1) * 0.8 / 32766);
      const long k = std::lround((logit(p) - logit(0.1)) * 254 / (logit(0.9) - logit(0.1))) + 1;
      QCOMPARE(long(std::uint8_t(slice->cells[std::size_t(v - 1)])), k);
    }
  }

  void aGridOfDistancesIsWhatTheSpecificationSays() {
    std::mt19937 random(2);
    for (int round = 0; round < 30; ++round) {
      Grid2D grid;
      grid.resolution_m = 0.1;
      grid.size_x = 1 + int(random() % 40);
      grid.size_y = 1 + int(random() % 40);
      grid.tsdf.emplace();
      const bool usual = round % 2 == 0;
      const double t = usual ? 0.3 : 0.5, most = usual ? 10 : 128;
      if (!usual) grid.tsdf->truncation_m = float(t), grid.tsdf->max_weight = float(most);
      for (int i = 0; i < grid.size_x * grid.size_y; ++i) {
        grid.cells.push_back(std::uint16_t(random() % 5 == 0   ? 0
                                           : random() % 7 == 0 ? 16384
                                                               : 1 + random() % 32767));
        grid.tsdf->weights.push_back(std::uint16_t(random() % 5 == 0   ? 0
                                                   : random() % 7 == 0 ? 32767
                                                                       : 1 + random() % 32767));
      }
      grid.known = {0, 0, grid.size_x - 1, grid.size_y - 1};
      const auto slice = sliceOf(grid, {});
      QVERIFY(slice && canBeDecoded(*slice));
      const std::vector<Pair> pairs = pairsOf(*slice);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        Pair expected;
        if (grid.cells[i] != 0 && grid.tsdf->weights[i] != 0) {
          const double tsd = -t + (grid.cells[i] - 1) * 2 * t / 32766;
          const double weight = (grid.tsdf->weights[i] - 1) * most / 32766;
          expected = pairOf(std::lround(weight / most * (std::sqrt(std::abs(tsd) / t) * 255 - 128)));
        }
        // The same number, but for one that lies between two.
        QVERIFY(pairs[i] == expected ||
                std::abs(pairs[i].value - pairs[i].alpha - expected.value + expected.alpha) <= 1);
        QCOMPARE(pairs[i] == Pair{}, expected == Pair{});
      }
    }
  }

  void aGridOf3DIsSeenFromAbove() {
    std::mt19937 random(3);
    for (int round = 0; round < 30; ++round) {
      HybridGrid grid;
      grid.resolution_m = round % 2 == 0 ? 0.1f : 0.45f;
      for (int i = 0; i < 3000; ++i) {
        grid.x.push_back(int(random() % 40) - 20);
        grid.y.push_back(int(random() % 30) - 15);
        grid.z.push_back(int(random() % 20) - 5);
        grid.values.push_back(std::uint16_t(random() % 32768));
      }
      const geometry::Pose3 pose = somePose(random, round % 3 == 0);
      const auto sliced = sliceOf(grid, pose);
      QVERIFY(sliced && *sliced);
      const map::RawSlice& slice = **sliced;
      QVERIFY(canBeDecoded(slice));

      struct Column {
        int count = 0, low = 0, high = 0;
        float sum = 0, largest = 0.5f;
      };
      std::map<std::pair<int, int>, Column> columns;
      int max_x = -1'000'000, max_y = max_x, min_x = 1'000'000, min_y = min_x;
      const Eigen::Isometry3f world = transformOf(pose).cast<float>();
      const Eigen::Quaternionf turn = Eigen::Quaterniond(transformOf(pose).linear()).cast<float>();
      for (std::size_t i = 0; i < grid.values.size(); ++i) {
        const float p = 0.1f + (float(grid.values[i]) - 1) * 0.8f / 32766;
        if (p < 0.501f) continue;
        const Eigen::Vector3f center =
            Eigen::Vector3i(grid.x[i], grid.y[i], grid.z[i]).cast<float>() * grid.resolution_m;
        const Eigen::Vector3f there = (turn * center + world.translation()) * (1 / grid.resolution_m);
        const int x = int(std::lround(there.x())), y = int(std::lround(there.y())),
                  z = int(std::lround(there.z()));
        max_x = std::max(max_x, x), max_y = std::max(max_y, y), min_x = std::min(min_x, x),
        min_y = std::min(min_y, y);
        Column& column = columns[{x, y}];
        column.low = column.count == 0 ? z : std::min(column.low, z);
        column.high = column.count == 0 ? z : std::max(column.high, z);
        ++column.count;
        column.sum += p;
        column.largest = std::max(column.largest, p);
      }
      QCOMPARE(slice.width, max_y - min_y + 1);
      QCOMPARE(slice.height, max_x - min_x + 1);
      const std::vector<Pair> pairs = pairsOf(slice);
      int known = 0;
      for (int row = 0; row < slice.height; ++row) {
        for (int column = 0; column < slice.width; ++column) {
          const Pair& pair = pairs[std::size_t(row * slice.width + column)];
          const auto found = columns.find({max_x - row, max_y - column});
          if (found == columns.end() || found->second.high - found->second.low < 3) {
            QCOMPARE(pair, Pair{});
            continue;
          }
          const Column& seen = found->second;
          const double w = 0.15 * std::max(seen.high - seen.low - seen.count, 0);
          const double p = std::clamp((seen.sum + (1 - seen.largest) * w) / (seen.count + w), 0.1, 0.9);
          const Pair expected = pairOfProbability(p);
          QVERIFY(std::abs(pair.value - pair.alpha - expected.value + expected.alpha) <= 1);
          ++known;
        }
      }
      QVERIFY(known > 10);
      const Eigen::Isometry3d at =
          transformOf(pose).inverse() *
          Eigen::Translation3d(double(max_x) * grid.resolution_m, double(max_y) * grid.resolution_m, pose.z);
      QVERIFY(transformOf(slice.slice_pose).isApprox(at, 1e-9));
    }
  }

  void both3DGridsAreReadAndAnEmptyOneIsAbsent() {
    cartographer_state::SerializedData data;
    auto& submap = *data.mutable_submap()->mutable_submap_3d();
    place(*submap.mutable_local_pose(), 0, 0);
    submap.set_num_range_data(12);
    submap.add_rotational_scan_matcher_histogram(1);
    const auto tower = [](cartographer_state::HybridGrid& grid, float resolution) {
      grid.set_resolution(resolution);
      for (int z = 0; z < 8; ++z) {
        grid.add_x_indices(-3);
        grid.add_y_indices(4);
        grid.add_z_indices(z);
        grid.add_values(32000);
      }
    };
    geometry::Pose3 pose;
    QVERIFY(texturesOf(data, pose)->slices.empty());
    tower(*submap.mutable_low_resolution_hybrid_grid(), 0.45f);
    auto textures = texturesOf(data, pose);
    QCOMPARE(textures->slices.size(), std::size_t(2));  // the second one keeps its number
    QCOMPARE(pairsOf(textures->slices[0]), std::vector<Pair>(1));
    QCOMPARE(textures->slices[1].resolution_m, double(0.45f));
    tower(*submap.mutable_high_resolution_hybrid_grid(), 0.1f);
    textures = texturesOf(data, pose);
    QCOMPARE(textures->version, 12);
    QCOMPARE(textures->slices.size(), std::size_t(2));
    QCOMPARE(textures->slices[0].resolution_m, double(0.1f));
    QVERIFY(pairsOf(textures->slices[0])[0].alpha > 100);
  }

  void aGridWithoutKnownCellsIsOneUnknownCell() {
    auto data = submapRecord(0, 0);
    data.mutable_submap()->mutable_submap_2d()->mutable_grid()->clear_known_cells_box();
    const auto textures = texturesOf(data);
    QVERIFY(textures);
    QCOMPARE(textures->slices[0].width, 1);
    QCOMPARE(pairsOf(textures->slices[0])[0].value, 0);
  }

  void aGridThatCannotBeIsRefused_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QByteArray>("words");
    int which = 0;
    for (const char* words :
         {"its grid of 21 x 20 cells holds 400 values", "its grid of 19 x 20 cells holds",
          "it has more values than", "its grid claims to have", "its grid claims to have",
          "the box of its known cells is not within its grid",
          "the box of its known cells is not within its grid",
          "the box of its known cells is not within its grid", "it holds no grid", "its pose is not one",
          "its pose is not one", "is not a number of metres", "the bounds of its probabilities",
          "its grid of 20 x 20 cells holds 0 values"}) {
      QTest::newRow(qPrintable(QStringLiteral("%1 %2").arg(which).arg(QLatin1String(words))))
          << which << QByteArray(words);
      ++which;
    }
  }
  void aGridThatCannotBeIsRefused() {
    QFETCH(int, which);
    QFETCH(QByteArray, words);
    auto data = submapRecord(0, 0);
    auto& submap = *data.mutable_submap()->mutable_submap_2d();
    auto& grid = *submap.mutable_grid();
    auto& limits = *grid.mutable_limits()->mutable_cell_limits();
    auto& box = *grid.mutable_known_cells_box();
    if (which == 0) limits.set_num_x_cells(21);
    if (which == 1) limits.set_num_x_cells(19), grid.mutable_cells()->Truncate(300), box.set_max_x(18);
    if (which == 2) limits.set_num_x_cells(2);
    if (which == 3) limits.set_num_x_cells(-1);
    if (which == 4) limits.set_num_x_cells(100'000), limits.set_num_y_cells(100'000);
    if (which == 5) box.set_max_x(20);
    if (which == 6) box.set_min_y(-1);
    if (which == 7) box.set_min_x(5), box.set_max_x(4);
    if (which == 8) submap.clear_grid();
    if (which == 9) submap.mutable_local_pose()->mutable_rotation()->set_w(0);
    if (which == 10) submap.mutable_local_pose()->mutable_translation()->set_x(std::nan(""));
    if (which == 11) grid.mutable_limits()->set_resolution(0);
    if (which == 12) grid.set_max_correspondence_cost(1.5f);
    if (which == 13) grid.mutable_tsdf_2d();
    const auto textures = texturesOf(data);
    QVERIFY(!textures);
    const std::string said = inEnglish(textures.error());
    QVERIFY2(said.find(words.toStdString()) != std::string::npos, said.c_str());
    QVERIFY2(said.find("Record 1 at byte ") != std::string::npos, said.c_str());
  }

  void voxelsFarApartAreRefusedBeforeThereIsMemoryForThem() {
    HybridGrid grid;
    grid.resolution_m = 0.1f;
    for (const int x : {-400'000, 400'000}) {
      grid.x.push_back(x);
      grid.y.push_back(x);
      grid.z.push_back(0);
      grid.values.push_back(32000);
    }
    QVERIFY(!sliceOf(grid, {}));
    grid.x = grid.y = {-2'000'000'000, 2'000'000'000};
    QVERIFY(!sliceOf(grid, {}));
    grid.x.pop_back();
    QVERIFY(!sliceOf(grid, {}));
  }

  void moreCellsThanDeclaredAreNotKept() {
    // 20 million cells of one byte each, in 20 KB, of which 400 are declared.
    auto data = submapRecord(0, 0);
    data.mutable_submap()->mutable_submap_2d()->mutable_grid()->mutable_cells()->Resize(20'000'000, 0);
    const auto textures = texturesOf(data);
    QVERIFY(!textures && inEnglish(textures.error()).find("more values") != std::string::npos);
  }
};

}  // namespace test_submap_texture

MAPWRIGHT_TEST(test_submap_texture, SubmapTextureTest, Nothing)
#include "test_submap_texture.moc"
