// What people read about a request that failed and about what a robot lacks.
#include <QRegularExpression>
#include <QTest>

#include "cells/faults.h"
#include "disk/faults.h"
#include "grids/faults.h"
#include "map/catalogue.h"
#include "map/faults.h"
#include "map/safety.h"
#include "net/faults.h"
#include "robot/axbot/faults.h"
#include "robot/faults.h"
#include "robot/files/faults.h"
#include "robot/wire/faults.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/overlay_name.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/faults.h"
#include "submap/faults.h"
#include "test_program.h"

namespace test_sentences {

using namespace mapwright;
using map::Applied;
using map::AskedFor;
using map::Failure;
using map::FailureKind;
using map::FailureReason;
using map::Subject;
using map::SubjectKind;
using robot::Absence;
using robot::Capability;

class SentencesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFailureSaysWhatFailedAndWhy_data() {
    QTest::addColumn<Failure>("failure");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* sentence, const Failure& failure) {
      QTest::newRow(sentence) << failure << QString::fromLatin1(sentence);
    };
    const Subject map(SubjectKind::Map, "12"), list(SubjectKind::Catalogue, map::kMapsPart);
    row("It cannot be loaded: connection refused by 10.0.0.7:8090.",
        {.kind = FailureKind::Unreachable, .subject = map, .detail = "connection refused by 10.0.0.7:8090"});
    row("The list cannot be loaded: the robot answered 404 (not found): No such list.",
        {.kind = FailureKind::RejectedByRobot,
         .subject = list,
         .robot_code = "404",
         .detail = "No such list."});
    row("The list cannot be loaded: the robot answered 401 (not authorised).",
        {.kind = FailureKind::Refused, .subject = list, .robot_code = "401"});
    row("It cannot be loaded: the robot refused (code -3): busy.",
        {.kind = FailureKind::RejectedByRobot, .subject = map, .robot_code = "-3", .detail = "busy"});
    row("It cannot be loaded: the robot refused.", {.kind = FailureKind::RejectedByRobot, .subject = map});
    row("The list cannot be read: its answer is not a list.",
        {.kind = FailureKind::MalformedAnswer, .subject = list, .detail = "its answer is not a list"});
    row("Its resolution is 0.", {.kind = FailureKind::MalformedAnswer,
                                 .subject = map,
                                 .detail = "its resolution is 0",
                                 .reason = FailureReason::Unfit});
    row("Its thumbnail is empty.", {.kind = FailureKind::MalformedAnswer,
                                    .subject = map,
                                    .asked_for = AskedFor::SmallPicture,
                                    .reason = FailureReason::Empty});
    row("Its picture cannot be loaded: it was cancelled.",
        {.kind = FailureKind::Cancelled, .subject = map, .asked_for = AskedFor::Picture});
    row("There is no such map.",
        {.kind = FailureKind::RejectedByRobot, .subject = map, .reason = FailureReason::NotThere});
    row("This is not a valid id. Ids look like 12, mapping:48.", {.kind = FailureKind::Unsupported,
                                                                  .subject = map,
                                                                  .arguments = {"12, mapping:48"},
                                                                  .reason = FailureReason::NoSuchId});
    const auto change = [&](Applied applied) {
      return Failure{.kind = FailureKind::TimedOut,
                     .subject = map,
                     .applied = applied,
                     .detail = "no answer within 30 s",
                     .asked_for = AskedFor::Change};
    };
    row("It was not changed: no answer within 30 s.", change(Applied::No));
    row("Whether it was changed is unknown: no answer within 30 s.", change(Applied::Maybe));
    row("It was changed, but the robot's answer was lost: no answer within 30 s.", change(Applied::Yes));
  }
  void aFailureSaysWhatFailedAndWhy() {
    QFETCH(Failure, failure);
    QFETCH(QString, sentence);
    QCOMPARE(QString::fromStdString(sentences::sentenceOf(failure)), sentence);
    const map::Problem problem = map::problemOf(failure, map::Severity::Warning);
    QCOMPARE(sentences::sentenceOf(problem), sentence);
    QVERIFY(problem.subject == failure.subject);
    QCOMPARE(problem.failure, failure.kind);
    QCOMPARE(problem.severity, map::Severity::Warning);
  }

  void whatLiesBehindAndWhatFollowsIsTold() {
    for (const FaultCode& code :
         {cells::fault::GzipDamaged, robot::files::fault::PictureNotReadable, submap::fault::VersionBroken,
          session::fault::VersionNotHad, submap::fault::OneSlice, disk::fault::FileNotWritten}) {
      const QString sentence =
          sentences::wordsOf(Fault(code, {"first"}, {fault::said("this is why")}, Consequence::AskedAgain));
      QVERIFY2(!sentence.contains(QLatin1Char('%')), qPrintable(sentence));
      QVERIFY2(sentence.contains(QLatin1String("his is why")), qPrintable(sentence));
      QVERIFY2(sentence.endsWith(QLatin1String(". It will be requested again.")), qPrintable(sentence));
    }
  }

  void everyConsequenceIsASentence() {
    QVERIFY(sentences::consequenceOf(Consequence::None).isEmpty());
    for (int then = 1; then <= int(kLastConsequence); ++then) {
      const QString text = sentences::consequenceOf(Consequence(then));
      QVERIFY2(text.endsWith(QLatin1Char('.')) && !text.contains(QLatin1Char('%')), qPrintable(text));
    }
  }

  void whatWasFoundReadsAsOneText_data() {
    QTest::addColumn<map::Problem>("problem");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* text, const map::Subject& subject, const Fault& reason) {
      QTest::newRow(text) << map::Problem{map::Severity::Error, subject, reason} << QString::fromUtf8(text);
    };
    const Subject submap(SubjectKind::Submap, "1-593");
    row("Submap 1-593: The position of version 5 is unknown: its orientation is a zero quaternion. Shown "
        "without it.",
        submap,
        {submap::fault::VersionCannotBePlaced,
         {5},
         {submap::fault::TurnIsZero},
         Consequence::ShownWithoutIt});
    row("Submap 1-593: Version 5 is broken: slice 0: 7 bytes; slice 3: its slice pose is not valid (a number "
        "that is not finite, or a zero quaternion). Shown without it. It will be requested again with the "
        "next version.",
        submap,
        {submap::fault::VersionBroken,
         {5},
         {{submap::fault::OneSlice, {0}, {fault::said("7 bytes")}},
          {submap::fault::OneSlice, {3}, {submap::fault::SlicePoseUnusable}}},
         Consequence::ShownWithoutItUntilTheNext});
    row("Submap 1-593: Version 5: The robot answered NOT_FOUND: %1 is gone. It will be requested again.",
        submap,
        {session::fault::VersionNotHad,
         {5},
         {{robot::axbot::fault::RobotAnswered, {"NOT_FOUND"}, {fault::said("%1 is gone.")}}},
         Consequence::AskedAgain});
    row("Submap 1-593: Version 5: The robot answered NOT_FOUND. It will be requested again.", submap,
        {session::fault::VersionNotHad,
         {5},
         {{robot::axbot::fault::RobotAnswered, {"NOT_FOUND"}, {fault::said("")}}},
         Consequence::AskedAgain});
    row("Topic /x: A message of 51200 bytes is not a JSON object. It was left out.",
        {SubjectKind::Topic, "/x"}, {robot::axbot::fault::MessageNotJson, {51'200}});
    row("Topic /m: Its picture /a%2.png cannot be loaded: the answer is empty. The previous picture stays.",
        {SubjectKind::Topic, "/m"},
        {robot::axbot::fault::PictureNotHad,
         {"/a%2.png"},
         {robot::axbot::fault::AnswerIsEmpty},
         Consequence::PictureBeforeStays});
    row("Map \"Hall\": Its resolution is -0.05, which is not a valid cell size.",
        {SubjectKind::Map, "12", "Hall"}, {map::fault::ResolutionNotPositive, {-0.05}});
    row("File a.yaml: Its picture cannot be read. There is no file /b.pgm.",
        map::subjectOf({map::MapKind::File, "a.yaml"}),
        {robot::files::fault::PictureNotReadable, {}, {{robot::files::fault::NoSuchFile, {"/b.pgm"}}}});
    row("Waypoints of Mapping 48: 1 point without a position was left out.",
        map::placesOf({map::MapKind::Mapping, "48"}), {robot::wire::fault::PointsUnplaced, {1}});
    row("Live map: Shown without a.json: no answer.", map::subjectOf({map::MapKind::Live, {}}),
        {robot::axbot::fault::FileNotHad, {"a.json"}, {fault::said("no answer")}});
    row("Mappings: 2 rows without an id were left out.", {SubjectKind::Catalogue, map::kMappingsPart},
        {robot::wire::fault::RowsWithoutId, {2}});
    row("Alert 6004: Hot <b>", {SubjectKind::Condition, "alert:6004"}, fault::said("Hot <b>"));
    row("Map 12: Its header says 60,000 x 60,000 pixels, but its data ends after 1 row. The rest is shown as "
        "unknown.",
        {SubjectKind::Map, "12"},
        {grids::fault::PictureEndsEarly, {"1", "60,000 x 60,000"}, {grids::fault::DataEnds}});
    row("Map 12: Its header says 60 x 60 pixels, but its data is damaged after 1,212 rows. The rest is shown "
        "as unknown.",
        {SubjectKind::Map, "12"},
        {grids::fault::PictureEndsEarly, {"1,212", "60 x 60"}, {grids::fault::DataDamaged}});
    row("Submap 1-593: Version 5 is broken: slice 0: 1 byte where 3,200 (or 6,400) were expected.", submap,
        {submap::fault::VersionBroken,
         {5},
         {{submap::fault::OneSlice, {0}, {{cells::fault::BytesUnexpected, {"1", "3,200", "6,400"}}}}}});
    row("Robot: there is a server at 10.0.0.7:80, but not an Autoxing robot: the robot refused the "
        "connection: 404 (not found). Check the address and the port.",
        SubjectKind::Robot,
        {robot::axbot::fault::NoAutoxingRobotThere,
         {"10.0.0.7:80"},
         {{net::fault::ConnectionRejected, {HttpStatus{404}}}}});
    row("Robot: the certificate of 10.0.0.7:8443 is not trusted: it is self-signed; it expired on "
        "2021-03-04. Its SHA-256 fingerprint: AB:CD",
        SubjectKind::Robot,
        {net::fault::CertificateUntrusted,
         {"10.0.0.7:8443", "AB:CD"},
         {net::fault::SelfSigned, {net::fault::CertificateExpired, {"2021-03-04"}}}});
    row("Topic /m: Its picture /a.png cannot be loaded: the robot answered 500 (internal error): boom. The "
        "previous picture stays.",
        {SubjectKind::Topic, "/m"},
        {robot::axbot::fault::PictureNotHad,
         {"/a.png"},
         {{net::fault::AnsweredWithStatusSaying, {HttpStatus{500}, "boom"}}},
         Consequence::PictureBeforeStays});
    row("Waypoints of Map 7: /b.json cannot be written: no file can be created in / (Permission denied).",
        map::placesOf({map::MapKind::Stored, "7"}),
        {disk::fault::FileNotWritten,
         {"/b.json"},
         {{disk::fault::NoFileInFolder, {"/", "Permission denied"}}}});
    row("Map 7: This robot provides no whole map.", map::subjectOf({map::MapKind::Stored, "7"}),
        sentences::lackOf(Capability::WholeMaps, {}));
  }
  void whatWasFoundReadsAsOneText() {
    QFETCH(map::Problem, problem);
    QFETCH(QString, text);
    QCOMPARE(sentences::nameOf(problem.subject) + QStringLiteral(": ") + sentences::sentenceOf(problem),
             text);
  }

  void theNameOfAFileStaysAsItIsWritten() {
    const Fault reason{
        disk::fault::FileNotWritten, {"out/part.mcap"}, {fault::said("No space left on device")}};
    QCOMPARE(sentences::sentenceOf(reason),
             QStringLiteral("out/part.mcap cannot be written: No space left on device."));
    QCOMPARE(sentences::sentenceOf(fault::said("timed out")), QStringLiteral("Timed out."));
  }

  void kindsOfOverlaysHaveNames() {
    using map::OverlayShape;
    QCOMPARE(sentences::nameOf(OverlayShape::Line, 2), QStringLiteral("Virtual wall"));
    QCOMPARE(sentences::nameOf(OverlayShape::Point, 9), QStringLiteral("Charger"));
    QCOMPARE(sentences::nameOf(OverlayShape::Polygon, 99), QStringLiteral("Region 99"));
    QCOMPARE(sentences::nameOf(OverlayShape::Point, 0), QStringLiteral("Point"));
  }

  void everyConditionHasAName() {
    QStringList names;
    for (int kind = 0; kind <= int(map::SafetyKind::WheelsSlipping); ++kind) {
      map::SafetyCondition condition;
      condition.kind = map::SafetyKind(kind);
      const Subject subject = map::problemOf(condition).subject;
      names << sentences::nameOf(subject);
      QVERIFY2(names.last() != QString::fromStdString(subject.id), qPrintable(names.last()));
    }
    QCOMPARE(names.removeDuplicates(), 0);
  }

  void whatARobotLacksIsSaidWithItsReason() {
    QCOMPARE(sentences::absenceReason(Capability::Submaps, {}),
             QStringLiteral("There are no submaps here, only whole maps."));
    QCOMPARE(sentences::absenceReason(Capability::Administration, {Absence::Reason::ReadOnly, {"Agibot"}}),
             QStringLiteral("Read only: Agibot's interface offers no editing."));
    QCOMPARE(
        sentences::absenceReason(Capability::Overview, {Absence::Reason::FirmwareLacks, {"404"}}),
        QStringLiteral(
            "This robot provides no overview of its map. Its firmware does not support this request (404)."));
    QCOMPARE(sentences::absenceReason(Capability::Live, {Absence::Reason::LocalFiles, {}}),
             QStringLiteral("This is a local map: there is no robot, so nothing moves on it."));
    QCOMPARE(sentences::absenceReason(Capability::Administration, {Absence::Reason::LocalFiles, {}}),
             QStringLiteral("Local maps are named after their files, and no robot uses them."));
    QCOMPARE(sentences::absenceReason(Capability::Submaps, {Absence::Reason::LocalFiles, {}}),
             QStringLiteral("There are no submaps here, only whole maps."));
    for (const Capability changing : {Capability::WaypointEditing, Capability::Administration,
                                      Capability::PictureEditing, Capability::OverlayEditing})
      QCOMPARE(sentences::absenceReason(changing, {Absence::Reason::LocalFiles, {"drive.bag"}}),
               QStringLiteral("This is a replay of drive.bag: nothing can be changed."));
  }

  void noRobotIsBlamedForWhatAFileLacks() {
    for (int capability = 0; capability <= int(Capability::PoseGraph); ++capability) {
      const QString said =
          sentences::absenceReason(Capability(capability), {Absence::Reason::LocalFiles, {}});
      QVERIFY2(!said.isEmpty() && !said.contains(QStringLiteral("this robot"), Qt::CaseInsensitive),
               qPrintable(said));
    }
  }
};

}  // namespace test_sentences

MAPWRIGHT_TEST(test_sentences, SentencesTest, Core)
#include "test_sentences.moc"
