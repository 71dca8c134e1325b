// Something is left out of a state file: that goes, and nothing else changes.
#include <QTest>

#include "pbstream/drop.h"
#include "pbstream/record_stream.h"
#include "state_bytes.h"
#include "test_program.h"

namespace test_drop {

using namespace mapwright;
using namespace mapwright::pbstream;
using namespace mapwright::pbstream::tests;

namespace {

std::string bytesOf(const std::string& path) {
  QFile file(QString::fromStdString(path));
  (void)file.open(QIODevice::ReadOnly);
  return file.readAll().toStdString();
}

/// The records as they lie in a file, with their sizes.
std::vector<std::string> recordsIn(const std::string& bytes) {
  std::vector<std::string> records;
  for (std::size_t at = 8; at < bytes.size();) {
    std::uint64_t size = 0;
    for (std::size_t i = 8; i-- > 0;) size = size << 8 | std::uint8_t(bytes[at + i]);
    records.push_back(bytes.substr(at, 8 + size));
    at += 8 + size;
  }
  return records;
}

}  // namespace

class DropTest : public QObject {
  Q_OBJECT
  Folder folder_;
  int made_ = 0;

  struct Result {
    tl::expected<DropReceipt, Fault> receipt;
    std::vector<std::string> before, after;
    StateFile file;
  };
  Result dropped(const Dropped& what, const std::string& bytes = wholeFile()) {
    const std::string from = folder_.write(bytes),
                      to = folder_.path(qPrintable(QStringLiteral("%1.pbstream").arg(++made_)));
    Result result{drop(from, what, to), recordsIn(bytes), {}, {}};
    [&] {
      QVERIFY2(result.receipt, result.receipt ? "" : inEnglish(result.receipt.error()).c_str());
      QCOMPARE(bytesOf(from), bytes);
      result.after = recordsIn(bytesOf(to));
      result.file = *readStateFile(to);
    }();
    return result;
  }
  std::string refusal(const Dropped& what, const std::string& bytes = wholeFile(),
                      const char* name = "new.pbstream") {
    const std::string to = folder_.path(name);
    const bool there = QFileInfo::exists(QString::fromStdString(to));
    const auto receipt = drop(folder_.write(bytes), what, to);
    if (receipt || QFileInfo::exists(QString::fromStdString(to)) != there) return "no refusal";
    return inEnglish(receipt.error());
  }

 private Q_SLOTS:
  void howFarItIsOnlyGrowsAndItCanBeCancelledAnywhere() {
    Dropped what;
    what.submaps = {{0, 1}};
    std::string bytes = wholeFile();
    for (int i = 0; i < 3000; ++i) bytes += record(imuRecord(0));
    const std::string from = folder_.write(bytes);
    std::vector<double> told;
    QVERIFY(drop(from, what, folder_.path("told.pbstream"), {}, [&](double done) { told.push_back(done); }));
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    QVERIFY(told.front() < 0.1 && told.back() > 0.9 && told.back() <= 1);
    for (const double at : {0.1, 0.4, 0.6, 0.9}) {
      const std::string to = folder_.path("cancelled.pbstream");
      double now = 0;
      const auto receipt = drop(
          from, what, to, [&] { return now >= at; }, [&](double done) { now = done; });
      QVERIFY(!receipt);
      QCOMPARE(inEnglish(receipt.error()), std::string("it was cancelled"));
      QVERIFY(!QFileInfo::exists(QString::fromStdString(to)));
    }
  }

  void aClosureGoesAndOnlyThePoseGraphIsWrittenAnew() {
    Dropped what;
    what.closures = {{{0, 0}, {0, 3}}};
    const Result result = dropped(what);
    QCOMPARE(result.receipt->inter, std::size_t(1));
    QCOMPARE(result.receipt->intra, std::size_t(0));
    QCOMPARE(result.receipt->records, std::size_t(0));
    QCOMPARE(result.after.size(), result.before.size());
    for (std::size_t i = 0; i < result.before.size(); ++i)
      QCOMPARE(result.after[i] == result.before[i], i != 1);
    auto expected = *readStateFile(folder_.write(wholeFile()))->graph;
    std::erase_if(expected.constraints, [](const auto& one) {
      return one.submap == map::SubmapId{0, 0} && one.node == map::NodeId{0, 3};
    });
    QVERIFY(*result.file.graph == expected);
  }

  void aPoseThatIsNoNumberStaysAsItIs() {
    auto data = graphRecord();
    data.mutable_pose_graph()
        ->mutable_trajectory(0)
        ->mutable_submap(0)
        ->mutable_pose()
        ->mutable_translation()
        ->set_z(std::numeric_limits<double>::quiet_NaN());
    Dropped what;
    what.closures = {{{0, 0}, {0, 3}}};
    (void)dropped(what, header() + record(data) + record(optionsRecord(2)) + record(submapRecord(0, 0)) +
                            record(submapRecord(0, 1)) + record(submapRecord(1, 0)));
  }

  void aSubmapGoesWithItsRecordItsPlaceAndItsConstraints() {
    Dropped what;
    what.submaps = {{0, 1}};
    const Result result = dropped(what);
    QCOMPARE(result.receipt->submaps, std::size_t(1));
    QCOMPARE(result.receipt->inter, std::size_t(1));
    QCOMPARE(result.receipt->intra, std::size_t(2));
    QCOMPARE(result.after.size(), result.before.size() - 1);
    QVERIFY(!result.file.find({0, 1}) && !result.file.poseOf({0, 1}));
    QCOMPARE(result.file.graph->constraints.size(), std::size_t(5));
    QCOMPARE(result.file.graph->trajectories[0].nodes.size(), std::size_t(4));
    // Record 4 is that of the submap.
    for (std::size_t i = 2; i < result.after.size(); ++i)
      QCOMPARE(result.after[i], result.before[i < 4 ? i : i + 1]);
  }

  void aTrajectoryGoesWithAllThatIsOfIt() {
    for (const int gone : {0, 1}) {
      Dropped what;
      what.trajectories = {gone};
      const Result result = dropped(what);
      QCOMPARE(result.receipt->trajectories, std::size_t(1));
      QCOMPARE(result.receipt->nodes, std::size_t(gone == 0 ? 4 : 2));
      QCOMPARE(result.file.graph->trajectories.size(), std::size_t(1));
      QCOMPARE(result.file.graph->trajectories[0].id, 1 - gone);
      QCOMPARE(result.file.option_lists, std::optional<std::size_t>(1));
      QCOMPARE(result.file.recordsOf(RecordKind::Submap), quint64(gone == 0 ? 1 : 2));
      QCOMPARE(result.file.recordsOf(RecordKind::Node), quint64(gone == 0 ? 2 : 4));
      QCOMPARE(result.file.recordsOf(RecordKind::Imu), quint64(gone == 0 ? 2 : 3));
      for (const map::Constraint& one : result.file.graph->constraints)
        QVERIFY(one.submap.trajectory != gone && one.node.trajectory != gone);
    }
  }

  void theOptionsOfTheOtherTrajectoriesStay() {
    auto options = optionsRecord(2);
    const std::string names[] = {"first", "second"};
    for (int i = 0; i < 2; ++i) {
      auto& one = *options.mutable_all_trajectory_builder_options()->mutable_options_with_sensor_ids(i);
      one.GetReflection()->MutableUnknownFields(&one)->AddLengthDelimited(2, names[i]);
    }
    // Trajectory 1 comes first in the pose graph, so the first options are its.
    auto graph = graphRecord();
    graph.mutable_pose_graph()->mutable_trajectory()->SwapElements(0, 1);
    const std::string bytes = header() + record(options) + record(graph) + record(submapRecord(0, 0)) +
                              record(submapRecord(0, 1)) + record(submapRecord(1, 0));
    Dropped what;
    what.trajectories = {1};
    const Result result = dropped(what, bytes);
    auto left = optionsRecord(1);
    auto& one = *left.mutable_all_trajectory_builder_options()->mutable_options_with_sensor_ids(0);
    one.GetReflection()->MutableUnknownFields(&one)->AddLengthDelimited(2, "second");
    QCOMPARE(result.after[1].size() > 8, true);
    FileWindow window(*result.file.file);
    RecordStream stream(window);
    stream.start({1, 8 + result.after[0].size(), result.after[1].size() - 8});
    cartographer_state::SerializedData read;
    QVERIFY(read.ParseFromZeroCopyStream(&stream));
    QCOMPARE(read.SerializeAsString(), left.SerializeAsString());
  }

  void whatIsNotKnownSurvives() {
    auto data = graphRecord();
    for (google::protobuf::Message* const message : std::initializer_list<google::protobuf::Message*>{
             data.mutable_pose_graph(), data.mutable_pose_graph()->mutable_constraint(0),
             data.mutable_pose_graph()->mutable_trajectory(0),
             data.mutable_pose_graph()->mutable_trajectory(0)->mutable_node(1)})
      message->GetReflection()->MutableUnknownFields(message)->AddLengthDelimited(500, "kept");
    std::string bytes = header() + record(data) + record(submapRecord(0, 0)) + record(submapRecord(0, 1)) +
                        record(submapRecord(1, 0));
    Dropped what;
    what.submaps = {{0, 1}};
    const Result result = dropped(what, bytes);
    FileWindow window(*result.file.file);
    RecordStream stream(window);
    stream.start({1, 8 + result.after[0].size(), result.after[1].size() - 8});
    cartographer_state::SerializedData read;
    QVERIFY(read.ParseFromZeroCopyStream(&stream));
    const std::string text = read.SerializeAsString();
    std::size_t kept = 0;
    for (std::size_t at = 0; (at = text.find("kept", at)) != std::string::npos; ++at) ++kept;
    QCOMPARE(kept, std::size_t(4));
  }

  void severalThingsGoAtOnce() {
    Dropped what;
    what.trajectories = {1};
    what.submaps = {{0, 0}, {1, 0}};
    what.closures = {{{0, 0}, {0, 3}}};
    const Result result = dropped(what);
    QCOMPARE(result.file.submaps.size(), std::size_t(1));
    QCOMPARE(result.file.graph->constraints.size(), std::size_t(2));
  }

  void whatIsNotThereIsRefused() {
    Dropped what;
    what.trajectories = {7};
    QCOMPARE(refusal(what), std::string("There is no trajectory 7 in it."));
    what = {};
    what.submaps = {{0, 9}};
    QCOMPARE(refusal(what), std::string("There is no submap 0-9 in it."));
    what = {};
    what.closures = {{{0, 1}, {0, 0}}};
    QCOMPARE(refusal(what), std::string("There is no constraint between submap 0-1 and node 0-0 in it."));
    what.closures = {{{0, 0}, {0, 0}}};
    QVERIFY(refusal(what).find("are no loop closure") != std::string::npos);
    what = {};
    what.trajectories = {0, 1};
    QVERIFY(refusal(what).find("nothing would be left") != std::string::npos);
  }

  void whatWouldNotBeWholeIsRefused() {
    Dropped what;
    what.trajectories = {1};
    const std::string whole = wholeFile();
    QVERIFY(refusal(what, whole.substr(0, whole.size() - 5)).find("The file is damaged") !=
            std::string::npos);
    const std::string other_options = header() + record(graphRecord()) + record(optionsRecord(3)) +
                                      record(submapRecord(0, 0)) + record(submapRecord(0, 1)) +
                                      record(submapRecord(1, 0));
    QVERIFY(refusal(what, other_options).find("options for 3 trajectories and holds 2") != std::string::npos);
    auto dangling = graphRecord();
    dangling.mutable_pose_graph()->mutable_constraint(0)->mutable_node_id()->set_node_index(99);
    const std::string dangles = header() + record(dangling) + record(optionsRecord(2)) +
                                record(submapRecord(0, 0)) + record(submapRecord(0, 1)) +
                                record(submapRecord(1, 0));
    QVERIFY(refusal(what, dangles).find("would refer to what is not there") != std::string::npos);
  }

  void aDamagedRecordThatIsCopiedIsTold() {
    const std::string whole = wholeFile();
    std::string damaged = record(imuRecord(0));
    damaged[damaged.size() - 5] = char(~damaged[damaged.size() - 5]);  // the checksum
    Dropped what;
    what.closures = {{{0, 0}, {0, 3}}};
    const Result result = dropped(what, whole + damaged + record(imuRecord(1)));
    QCOMPARE(result.after[result.after.size() - 2], damaged);
    QCOMPARE(result.receipt->damaged.size(), std::size_t(1));
    const std::string said = inEnglish(result.receipt->damaged[0]);
    QVERIFY2(said.find("Record 17 at byte ") == 0, said.c_str());
    QVERIFY2(said.find("its gzip stream is damaged") != std::string::npos, said.c_str());
    QVERIFY(dropped(what, whole).receipt->damaged.empty());
    std::string many = whole;
    for (int i = 0; i < 15; ++i) many += damaged;
    const Result most = dropped(what, many);
    QCOMPARE(most.receipt->damaged.size() + most.receipt->more_damaged, std::size_t(15));
    QVERIFY(most.receipt->more_damaged > 0);
  }

  void theOrderOfFieldsDoesNotMatter() {
    Dropped what;
    what.trajectories = {1};
    what.submaps = {{0, 1}};
    std::string odd = header() + record(backwards(graphRecord())) + record(backwards(optionsRecord(2)));
    for (const auto& data : {submapRecord(0, 0), submapRecord(0, 1), submapRecord(1, 0), nodeRecord(0, 0),
                             nodeRecord(1, 0), imuRecord(0), imuRecord(1)})
      odd += record(backwards(data));
    const Result result = dropped(what, odd), usual = dropped(what);
    QVERIFY(*result.file.graph == *usual.file.graph);
    QCOMPARE(result.file.submaps.size(), std::size_t(1));
    QCOMPARE(result.file.recordsOf(RecordKind::Node), quint64(1));
    QCOMPARE(result.file.recordsOf(RecordKind::Imu), quint64(1));
  }

  void whatCannotBeWrittenIsCalledAsItWasAskedFor() {
    Dropped what;
    what.submaps = {{0, 1}};
    const std::string to = folder_.path("no folder/new.pbstream");
    const auto receipt = drop(folder_.write(wholeFile()), what, to);
    QVERIFY(!receipt);
    QVERIFY2(inEnglish(receipt.error()).starts_with(to + " cannot be written"),
             inEnglish(receipt.error()).c_str());
  }

  void nothingIsWrittenOver() {
    Dropped what;
    what.submaps = {{0, 1}};
    QVERIFY(refusal(what, wholeFile(), "map.pbstream").find("exists already") != std::string::npos);
    QCOMPARE(bytesOf(folder_.path("map.pbstream")), wholeFile());
    (void)QFile::link(QString::fromStdString(folder_.path("map.pbstream")),
                      QString::fromStdString(folder_.path("link.pbstream")));
    QVERIFY(refusal(what, wholeFile(), "link.pbstream").find("exists already") != std::string::npos);
    QCOMPARE(bytesOf(folder_.path("map.pbstream")), wholeFile());
    // Somebody takes the name meanwhile.
    const std::string from = folder_.write(wholeFile());
    const std::string taken = folder_.path("taken.pbstream"), kept = folder_.path("taken-1.pbstream");
    const auto receipt = drop(from, what, taken, {}, [&](double done) {
      if (done > 0.9) (void)folder_.write("mine", "taken.pbstream");
    });
    QVERIFY(!receipt && inEnglish(receipt.error()).find(kept) != std::string::npos);
    QCOMPARE(bytesOf(taken), std::string("mine"));
    QCOMPARE(readStateFile(kept)->submaps.size(), std::size_t(2));
  }
};

}  // namespace test_drop

MAPWRIGHT_TEST(test_drop, DropTest, Nothing)
#include "test_drop.moc"
