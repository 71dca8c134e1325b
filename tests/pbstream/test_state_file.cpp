// What a state file holds, and what is said of one that is damaged or hostile.
#include <algorithm>

#include <QTest>

#include "map/closures.h"
#include "pbstream/faults.h"
#include "pbstream/state_file.h"
#include "pbstream/submap_texture.h"
#include "state_bytes.h"
#include "test_program.h"

namespace test_state_file {

using namespace mapwright;
using namespace mapwright::pbstream;
using namespace mapwright::pbstream::tests;

namespace {

/// Protobuf of one field, whatever the message ought to be.
std::string field(int number, int type, const std::string& value) {
  return varint(std::uint64_t(number) << 3 | std::uint64_t(type)) + value;
}
std::string within(int number, const std::string& message) {
  return field(number, 2, varint(message.size()) + message);
}

bool contains(const std::vector<Fault>& faults, const char* words) {
  return std::any_of(faults.begin(), faults.end(),
                     [&](const Fault& one) { return inEnglish(one).find(words) != std::string::npos; });
}

}  // namespace

class StateFileTest : public QObject {
  Q_OBJECT
  Folder folder_;

  tl::expected<StateFile, Fault> read(const std::string& bytes) const {
    return readStateFile(folder_.write(bytes));
  }

 private Q_SLOTS:
  void allThatIsInAFileIsCounted() {
    const auto file = read(wholeFile());
    QVERIFY(file);
    QCOMPARE(file->format_version, 2u);
    QVERIFY(file->losses().empty());
    QCOMPARE(file->recordsOf(RecordKind::PoseGraph), quint64(1));
    QCOMPARE(file->recordsOf(RecordKind::Submap), quint64(3));
    QCOMPARE(file->recordsOf(RecordKind::Node), quint64(6));
    QCOMPARE(file->recordsOf(RecordKind::Imu), quint64(5));
    QCOMPARE(file->option_lists, std::optional<std::size_t>(2));
    QCOMPARE(file->nodes_without_pose, std::size_t(0));
    QCOMPARE(file->submaps.size(), std::size_t(3));
    const StoredSubmap& submap = file->submaps[1];
    QVERIFY(submap.id == (map::SubmapId{0, 1}) && submap.version == 40 && submap.finished && !submap.three_d);
    QCOMPARE(submap.resolution_m, std::optional(0.05));
    QCOMPARE(file->graph->trajectories.size(), std::size_t(2));
    QCOMPARE(file->graph->trajectories[0].nodes[2].stamp_s, std::optional(1'700'000'002.5));
    QCOMPARE(file->graph->trajectories[1].nodes[1].pose.y, 1.0);
    QCOMPARE(file->poseOf({0, 1})->x, 2.0);
    const map::Closures closures = map::rankClosures(*file->graph);
    QCOMPARE(closures.inter, std::size_t(2));
    QCOMPARE(closures.intra, std::size_t(6));
    QCOMPARE(closures.ranked.front().residual_m, 2.0);
  }

  void theOrderOfRecordsDoesNotMatter() {
    const std::string file = header() + record(imuRecord(0)) + record(submapRecord(1, 0)) +
                             record(nodeRecord(1, 0)) + record(submapRecord(0, 1)) +
                             record(submapRecord(0, 0)) + record(graphRecord());
    const auto read_back = read(file);
    QVERIFY(read_back && read_back->losses().empty());
    QVERIFY(read_back->submaps[0].id == (map::SubmapId{0, 0}));
    QVERIFY(read_back->submaps[2].id == (map::SubmapId{1, 0}));
    QVERIFY(*read_back->graph == *read(wholeFile())->graph);
  }

  void theOrderOfFieldsDoesNotMatter() {
    auto unfinished = submapRecord(0, 1);
    unfinished.mutable_submap()->mutable_submap_2d()->set_finished(false);
    cartographer_state::SerializedData solid;
    solid.mutable_submap()->mutable_submap_id()->set_trajectory_id(1);
    auto& submap = *solid.mutable_submap()->mutable_submap_3d();
    place(*submap.mutable_local_pose(), 0, 0);
    submap.set_num_range_data(12);
    submap.set_finished(true);
    const auto fill = [](cartographer_state::HybridGrid& grid, float resolution) {
      grid.set_resolution(resolution);
      for (int z = 0; z < 8; ++z) {
        grid.add_x_indices(-3);
        grid.add_y_indices(4);
        grid.add_z_indices(z);
        grid.add_values(32000);
      }
    };
    fill(*submap.mutable_high_resolution_hybrid_grid(), 0.1f);
    fill(*submap.mutable_low_resolution_hybrid_grid(), 0.45f);
    std::string usual = header(), odd = header();
    for (const auto& data :
         {graphRecord(), optionsRecord(2), submapRecord(0, 0), unfinished, solid, nodeRecord(1, 1)}) {
      usual += record(data);
      odd += record(backwards(data));
    }
    const auto one = readStateFile(folder_.write(usual, "usual.pbstream")),
               other = readStateFile(folder_.write(odd, "odd.pbstream"));
    QVERIFY(one && other);
    QVERIFY(one->losses().empty());
    QVERIFY2(other->losses().empty(), other->losses().empty() ? "" : inEnglish(other->losses()[0]).c_str());
    QVERIFY(*one->graph == *other->graph && one->nodes == other->nodes);
    QCOMPARE(one->submaps.size(), std::size_t(3));
    QCOMPARE(other->submaps.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
      const StoredSubmap &a = one->submaps[i], &b = other->submaps[i];
      QVERIFY(a.id == b.id && a.version == b.version && a.finished == b.finished && a.three_d == b.three_d);
      QVERIFY(a.resolution_m && a.resolution_m == b.resolution_m);
      const geometry::Pose3 pose = *one->poseOf(a.id);
      const auto seen = readTextures(*one->file, a, pose), seen_odd = readTextures(*other->file, b, pose);
      QVERIFY(seen && seen_odd);
      QCOMPARE(seen->version, seen_odd->version);
      QCOMPARE(seen->slices.size(), seen_odd->slices.size());
      for (std::size_t slice = 0; slice < seen->slices.size(); ++slice) {
        QVERIFY(seen->slices[slice].cells == seen_odd->slices[slice].cells);
        QVERIFY(seen->slices[slice].slice_pose == seen_odd->slices[slice].slice_pose);
      }
    }
    QCOMPARE(one->submaps[2].resolution_m, std::optional(double(0.1f)));
  }

  void trajectoriesAndNodesComeInTheOrderOfTheirIds() {
    auto data = graphRecord();
    auto& graph = *data.mutable_pose_graph();
    graph.mutable_trajectory()->SwapElements(0, 1);
    graph.mutable_trajectory(1)->mutable_node()->SwapElements(0, 3);
    const auto file = read(header() + record(data));
    QCOMPARE(file->graph->trajectories[0].id, 0);
    QVERIFY(*file->graph == *read(header() + record(graphRecord()))->graph);
  }

  void theSameContentHasTheSameUuidWhereverItLies() {
    const auto one = readStateFile(folder_.write(wholeFile(), "a.pbstream"));
    const auto other = readStateFile(folder_.write(wholeFile(), "b.pbstream"));
    QCOMPARE(one->uuid, other->uuid);
    QVERIFY(!one->uuid.empty());
    QVERIFY(read(wholeFile() + record(imuRecord(0)))->uuid != one->uuid);
    auto moved = graphRecord();
    moved.mutable_pose_graph()
        ->mutable_trajectory(0)
        ->mutable_submap(0)
        ->mutable_pose()
        ->mutable_translation()
        ->set_x(1);
    QVERIFY(read(header() + record(moved))->uuid != read(header() + record(graphRecord()))->uuid);
  }

  void zerosAreOneLossHoweverManyThereAre() {
    const std::string whole = wholeFile();
    const auto zeros = read(whole + std::string(std::size_t(1) << 24, '\0'));
    QVERIFY(zeros);
    QCOMPARE(zeros->submaps.size(), read(whole)->submaps.size());
    QCOMPARE(zeros->warnings.size(), std::size_t(1));
    QVERIFY2(contains(zeros->warnings, "on 16,777,216 bytes are zero"),
             inEnglish(zeros->warnings[0]).c_str());
    const auto between = read(whole + std::string(16, '\0') + record(imuRecord(0)));
    QVERIFY(between && between->warnings.size() == 1 && !between->cut);
  }

  void whatComesBeforeACutIsKept() {
    const std::string whole = wholeFile();
    const std::string until_submap_1 =
        header() + record(graphRecord()) + record(optionsRecord(2)) + record(submapRecord(0, 0));
    const auto clean = read(until_submap_1);
    QVERIFY(clean && !clean->cut);  // between two records; that submaps are missing is said all the same
    QVERIFY(contains(clean->losses(), "gives them a place: 2 (0-1, 1-0)."));
    for (const std::size_t more : {std::size_t(1), std::size_t(7), std::size_t(8), std::size_t(100)}) {
      const auto cut = read(whole.substr(0, until_submap_1.size() + more));
      QVERIFY(cut && cut->cut);
      QCOMPARE(cut->submaps.size(), std::size_t(1));
      const std::string said =
          "The file is cut off in record 4 at byte " + std::to_string(until_submap_1.size());
      QVERIFY2(contains(cut->warnings, said.c_str()) || until_submap_1.size() > 999,
               inEnglish(cut->warnings[0]).c_str());
    }
    // Wherever it is cut: refused or read, never more than it holds.
    for (std::size_t size = 0; size < whole.size(); size += 61) (void)read(whole.substr(0, size));
  }

  void aFileOfAnotherKindIsRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char* name, const std::string& bytes, const char* words) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << QByteArray(words);
    };
    row("empty", "", "is not a Cartographer state file");
    row("text", "hello, this is a text and no map at all", "is not a Cartographer state file");
    row("signature alone", signature(), "It holds no records.");
    row("before 1.0", signature() + record(graphRecord().pose_graph()), "of version 0");
    row("version 3", header(3), "of version 3");
    row("no header", signature() + record(std::string()), "it is not the header of a state file");
    row("no gzip", signature() + sized("hello", 5), "Record 0 at byte 8: its gzip stream is damaged");
    row("size beyond the file", signature() + sized("", 0x7FFFFFFFFFFFFFFF),
        "The file is cut off in record 0 at byte 8");
    row("size of all bits", signature() + sized("", ~std::uint64_t(0)),
        "The file is cut off in record 0 at byte 8");
    row("pointer of Git LFS", "version https://git-lfs.github.com/spec/v1\noid sha256:0123456789\nsize 12\n",
        "Git LFS");
  }
  void aFileOfAnotherKindIsRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, words);
    const auto file = read(bytes.toStdString());
    QVERIFY(!file);
    QVERIFY2(inEnglish(file.error()).find(words.toStdString()) != std::string::npos,
             inEnglish(file.error()).c_str());
  }

  void whatIsNotThereOrNoFileIsRefused() {
    QVERIFY(!readStateFile(folder_.path("nowhere.pbstream")));
    QVERIFY(!readStateFile(folder_.path(".")));
  }

  void aDamagedRecordIsLeftOutAndSaid_data() {
    QTest::addColumn<QByteArray>("record");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char* name, const std::string& bytes, const char* words) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << QByteArray(words);
    };
    std::string cut = gzipped(submapRecord(0, 7).SerializeAsString());
    cut.resize(30);
    row("gzip cut within", sized(cut, cut.size()), "its gzip stream ends too early");
    row("no gzip", sized("hello", 5), "its gzip stream is damaged");
    row("empty", sized("", 0), "8 bytes are zero");
    row("not a message", record("\x1a\xff\xff\xff\xff\x0f"), "it is not the message that it should be");
    row("of no kind", record(within(77, "x")), "it is of a kind that is not known");
    row("another wire type", record(field(3, 0, "\x01")), "field 3 has another type");
    row("another wire type within", record(within(3, within(1, within(1, "x")))), "field 1 has another type");
    row("version as text", record(within(3, within(2, within(2, "x")))), "field 2 has another type");
    row("twice", record(submapRecord(0, 0)), "submap 0-0 is in the file before it");
    row("another graph", record(graphRecord()), "there is another pose graph before it");
  }
  void aDamagedRecordIsLeftOutAndSaid() {
    QFETCH(QByteArray, record);
    QFETCH(QByteArray, words);
    const std::string whole = wholeFile();
    const auto file = read(whole + record.toStdString() + pbstream::tests::record(imuRecord(0)));
    QVERIFY(file);
    QCOMPARE(file->warnings.size(), std::size_t(1));
    const std::string said = inEnglish(file->warnings[0]);
    QVERIFY2(said.find(words.toStdString()) != std::string::npos, said.c_str());
    QVERIFY2(said.find("Record 17 at byte ") != std::string::npos, said.c_str());
    QCOMPARE(file->submaps.size(), std::size_t(3));
    QCOMPARE(file->recordsOf(RecordKind::Imu), quint64(6));
  }

  void unknownFieldsAreSkipped() {
    auto data = graphRecord();
    auto& constraint = *data.mutable_pose_graph()->mutable_constraint(0);
    constraint.GetReflection()->MutableUnknownFields(&constraint)->AddVarint(99, 7);
    auto& graph = *data.mutable_pose_graph();
    graph.GetReflection()->MutableUnknownFields(&graph)->AddLengthDelimited(1000, "anything");
    const auto file = read(header() + record(data));
    QVERIFY(file && file->warnings.empty());
    QVERIFY(*file->graph == *read(header() + record(graphRecord()))->graph);
  }

  void aForkThatChangesAMessageIsRefused() {
    auto data = graphRecord();
    auto& constraint = *data.mutable_pose_graph()->mutable_constraint(0);
    constraint.clear_translation_weight();
    constraint.GetReflection()->MutableUnknownFields(&constraint)->AddFixed32(6, 7);
    const auto file = read(header() + record(data));
    QVERIFY(file);
    QVERIFY2(contains(file->warnings, "field 6 has another type"), inEnglish(file->warnings[0]).c_str());
  }

  void withoutAPoseGraphNothingHasAPlace() {
    const auto file = read(header() + record(submapRecord(0, 0)));
    QVERIFY(file);
    QVERIFY(contains(file->losses(), "It holds no pose graph"));
    QVERIFY(contains(file->losses(), "without a place in the pose graph: 1 (0-0)."));
    QVERIFY(!file->poseOf({0, 0}));
  }

  void nodesWithoutSubmapsAreAFileLikeAnyOther() {
    auto data = graphRecord();
    for (auto& trajectory : *data.mutable_pose_graph()->mutable_trajectory()) trajectory.clear_submap();
    data.mutable_pose_graph()->clear_constraint();
    std::string bytes = header() + record(data);
    for (int n = 0; n < 6; ++n) bytes += record(nodeRecord(0, n));
    const auto file = read(bytes);
    QVERIFY(file && file->losses().empty());
    QCOMPARE(file->nodes_without_pose, std::size_t(2));
  }

  void aBombIsUnpackedInLittleMemory() {
    // 50 MB of a field that nobody knows, in 50 KB.
    const std::string zeros(std::size_t(50) << 20, '\0');
    std::string bomb = within(77, zeros);
    const std::string packed = record(bomb);
    bomb.clear();
    bomb.shrink_to_fit();
    const auto file = read(wholeFile() + packed);
    QVERIFY(file);
    QVERIFY(contains(file->warnings, "it is of a kind that is not known"));
  }

  void manyWarningsAreCounted() {
    std::string bytes = wholeFile();
    for (int i = 0; i < 250; ++i) bytes += sized("hello", 5);
    const auto file = read(bytes);
    QVERIFY(file);
    QCOMPARE(file->warnings.size(), StateFile::kMostWarnings);
    QCOMPARE(file->further_warnings, quint64(150));
    QVERIFY(contains(file->losses(), "There are more of these: 150."));
  }

  void readingCanBeCancelled() {
    const auto file = readStateFile(folder_.write(wholeFile()), [] { return true; });
    QVERIFY(!file && file.error().code == pbstream::fault::Cancelled);
  }

  void noBytesBreakIt() {
    const std::string whole = wholeFile();
    std::uint32_t seed = 1;
    for (int round = 0; round < 150; ++round) {
      std::string bytes = whole;
      for (int i = 0; i < 3; ++i) {
        seed = seed * 1664525u + 1013904223u;
        bytes[8 + seed % (bytes.size() - 8)] = char(seed >> 24);
      }
      const auto file = read(bytes);
      if (!file) continue;
      for (const StoredSubmap& submap : file->submaps) {
        if (const auto* const pose = file->poseOf(submap.id)) (void)readTextures(*file->file, submap, *pose);
      }
    }
  }
};

}  // namespace test_state_file

MAPWRIGHT_TEST(test_state_file, StateFileTest, Nothing)
#include "test_state_file.moc"
