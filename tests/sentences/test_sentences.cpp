// What people read about a request that failed and about what a robot lacks.
#include <QRegularExpression>
#include <QTest>

#include "map/catalogue.h"
#include "map/safety.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/overlay_name.h"
#include "sentences/problem_sentence.h"
#include "sentences/reason_sentence.h"
#include "sentences/subject_name.h"

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

Q_DECLARE_METATYPE(mapwright::map::Failure)

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
    row("It cannot be had: connection refused by 10.0.0.7:8090.",
        {.kind = FailureKind::Unreachable, .subject = map, .detail = "connection refused by 10.0.0.7:8090"});
    row("The list cannot be had: the robot answered 404 (not found): No such list.",
        {.kind = FailureKind::RejectedByRobot,
         .subject = list,
         .robot_code = "404",
         .detail = "No such list."});
    row("The list cannot be had: the robot answered 401 (not authorised).",
        {.kind = FailureKind::Refused, .subject = list, .robot_code = "401"});
    row("It cannot be had: the robot refuses (code -3): busy.",
        {.kind = FailureKind::RejectedByRobot, .subject = map, .robot_code = "-3", .detail = "busy"});
    row("It cannot be had: the robot refuses.", {.kind = FailureKind::RejectedByRobot, .subject = map});
    row("The list cannot be read: its answer is not a list.",
        {.kind = FailureKind::MalformedAnswer, .subject = list, .detail = "its answer is not a list"});
    row("Its resolution is 0.", {.kind = FailureKind::MalformedAnswer,
                                 .subject = map,
                                 .detail = "its resolution is 0",
                                 .reason = FailureReason::Unfit});
    row("Its small picture is empty.", {.kind = FailureKind::MalformedAnswer,
                                        .subject = map,
                                        .asked_for = AskedFor::SmallPicture,
                                        .reason = FailureReason::Empty});
    row("Its picture cannot be had: it was cancelled.",
        {.kind = FailureKind::Cancelled, .subject = map, .asked_for = AskedFor::Picture});
    row("There is no such map.",
        {.kind = FailureKind::RejectedByRobot, .subject = map, .reason = FailureReason::NotThere});
    row("It cannot be asked for by this id. Ids look like 12, mapping:48.",
        {.kind = FailureKind::Unsupported,
         .subject = map,
         .arguments = {"12, mapping:48"},
         .reason = FailureReason::NoSuchId});
    const auto change = [&](Applied applied) {
      return Failure{.kind = FailureKind::TimedOut,
                     .subject = map,
                     .applied = applied,
                     .detail = "no answer for 30 s",
                     .asked_for = AskedFor::Change};
    };
    row("It has not been changed: no answer for 30 s.", change(Applied::No));
    row("Whether it has been changed is not known: no answer for 30 s.", change(Applied::Maybe));
    row("It has been changed, but the robot's answer is lost: no answer for 30 s.", change(Applied::Yes));
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

  void everyReasonHasASentenceThatTellsAllOfIt() {
    static const QRegularExpression place(QStringLiteral("%([1-9])"));
    int told = 0;
    for (int code = 0; code <= int(map::kLastReasonCode); ++code) {
      const auto reason_code = map::ReasonCode(code);
      const bool put_together = reason_code == map::ReasonCode::None ||
                                reason_code == map::ReasonCode::Slices ||
                                reason_code == map::ReasonCode::CapabilityLacking;
      for (const int count : {1, 2}) {
        const QString text = sentences::templateOf(reason_code, count);
        QVERIFY2(text.isEmpty() == put_together, qPrintable(QString::number(code)));
        // As many arguments as the sentence has places for, each once, none left out in between.
        QStringList places;
        for (auto it = place.globalMatch(text); it.hasNext();) places << it.next().captured(1);
        places.sort();
        map::Reason reason(reason_code);
        for (qsizetype i = 0; i < places.size(); ++i) {
          QCOMPARE(places[i].toInt(), int(i) + 1);
          reason.arguments.push_back("argument " + std::to_string(i + 1));
        }
        reason.because = {map::said("this is why")};
        reason.then = map::Consequence::AskedAgain;
        const QString sentence = sentences::wordsOf(reason);
        for (const map::Argument& argument : reason.arguments)
          QCOMPARE(sentence.count(QString::fromStdString(std::get<std::string>(argument))), 1);
        QVERIFY2(!sentence.contains(QLatin1Char('%')), qPrintable(sentence));
        QVERIFY2(sentence.contains(QLatin1String("his is why")), qPrintable(sentence));
        QVERIFY2(sentence.endsWith(QLatin1String(". It will be asked for again.")), qPrintable(sentence));
        told += !put_together;
      }
    }
    QVERIFY(told > 150);
  }

  void everyConsequenceIsASentence() {
    QVERIFY(sentences::consequenceOf(map::Consequence::None).isEmpty());
    for (int then = 1; then <= int(map::kLastConsequence); ++then) {
      const QString text = sentences::consequenceOf(map::Consequence(then));
      QVERIFY2(text.endsWith(QLatin1Char('.')) && !text.contains(QLatin1Char('%')), qPrintable(text));
    }
  }

  void whatWasFoundReadsAsOneText_data() {
    using map::Consequence;
    using map::Reason;
    using map::ReasonCode;
    QTest::addColumn<map::Problem>("problem");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* text, const map::Subject& subject, const Reason& reason) {
      QTest::newRow(text) << map::Problem{map::Severity::Error, subject, reason} << QString::fromUtf8(text);
    };
    const Subject submap(SubjectKind::Submap, "1-593");
    row("Submap 1-593: Version 5 cannot be placed: its orientation is a zero quaternion. Shown without it.",
        submap,
        {ReasonCode::VersionCannotBePlaced, {5}, {ReasonCode::TurnIsZero}, Consequence::ShownWithoutIt});
    row("Submap 1-593: Version 5 is broken: slice 0: 7 bytes; slice 3: its slice pose is not usable (a "
        "number "
        "that is not finite, or a zero quaternion). Shown without it. It will be asked for again at the next "
        "version.",
        submap,
        {ReasonCode::VersionBroken,
         {5},
         {{ReasonCode::OneSlice, {0}, {map::said("7 bytes")}},
          {ReasonCode::OneSlice, {3}, {ReasonCode::SlicePoseUnusable}}},
         Consequence::ShownWithoutItUntilTheNext});
    row("Submap 1-593: Version 5: The robot answered NOT_FOUND: %1 is gone. It will be asked for again.",
        submap,
        {ReasonCode::VersionNotHad,
         {5},
         {{ReasonCode::RobotAnswered, {"NOT_FOUND"}, {map::said("%1 is gone.")}}},
         Consequence::AskedAgain});
    row("Submap 1-593: Version 5: The robot answered NOT_FOUND. It will be asked for again.", submap,
        {ReasonCode::VersionNotHad,
         {5},
         {{ReasonCode::RobotAnswered, {"NOT_FOUND"}, {map::said("")}}},
         Consequence::AskedAgain});
    row("Topic /x: A message of 51200 bytes is not a JSON object. It was left out.",
        {SubjectKind::Topic, "/x"}, {ReasonCode::MessageNotJson, {51'200}});
    row("Topic /m: Its picture /a%2.png cannot be had: the answer is empty. The picture before stays.",
        {SubjectKind::Topic, "/m"},
        {ReasonCode::PictureNotHad,
         {"/a%2.png"},
         {ReasonCode::AnswerIsEmpty},
         Consequence::PictureBeforeStays});
    row("Map \"Hall\": Its resolution is -0.05, which is no size of a cell.",
        {SubjectKind::Map, "12", "Hall"}, {ReasonCode::ResolutionNotPositive, {-0.05}});
    row("File a.yaml: Its picture cannot be read. There is no file /b.pgm.",
        map::subjectOf({map::MapKind::File, "a.yaml"}),
        {ReasonCode::PictureNotReadable, {}, {{ReasonCode::NoSuchFile, {"/b.pgm"}}}});
    row("Waypoints of Mapping 48: 1 point without a place was left out.",
        map::placesOf({map::MapKind::Mapping, "48"}), {ReasonCode::PointsUnplaced, {1}});
    row("Live map: Shown without a.json: no answer.", map::subjectOf({map::MapKind::Live, {}}),
        {ReasonCode::FileNotHad, {"a.json"}, {map::said("no answer")}});
    row("Mappings: 2 rows without an id were left out.", {SubjectKind::Catalogue, map::kMappingsPart},
        {ReasonCode::RowsWithoutId, {2}});
    row("Alert 6004: Hot <b>", {SubjectKind::Condition, "alert:6004"}, map::said("Hot <b>"));
    row("Map 12: It says that it is 60,000 x 60,000 pixels, but its data ends after 1 row. The rest is shown "
        "as unknown.",
        {SubjectKind::Map, "12"},
        {ReasonCode::PictureEndsEarly, {"1", "60,000 x 60,000"}, {ReasonCode::DataEnds}});
    row("Map 12: It says that it is 60 x 60 pixels, but its data is damaged after 1,212 rows. The rest is "
        "shown as unknown.",
        {SubjectKind::Map, "12"},
        {ReasonCode::PictureEndsEarly, {"1,212", "60 x 60"}, {ReasonCode::DataDamaged}});
    row("Submap 1-593: Version 5 is broken: slice 0: 1 byte where 3,200 (or 6,400) were expected.", submap,
        {ReasonCode::VersionBroken,
         {5},
         {{ReasonCode::OneSlice, {0}, {{ReasonCode::BytesUnexpected, {"1", "3,200", "6,400"}}}}}});
    row("Robot: something answers at 10.0.0.7:80, but not as an Autoxing robot: the robot refused the "
        "connection: 404 (not found). Check the address and the port.",
        SubjectKind::Robot,
        {ReasonCode::NoAutoxingRobotThere, {"10.0.0.7:80"}, {{ReasonCode::ConnectionRejected, {404}}}});
    row("Robot: the certificate of 10.0.0.7:8443 is not trusted: it is self-signed; it has expired on "
        "2021-03-04. Its SHA-256 fingerprint: AB:CD",
        SubjectKind::Robot,
        {ReasonCode::CertificateUntrusted,
         {"10.0.0.7:8443", "AB:CD"},
         {ReasonCode::SelfSigned, {ReasonCode::CertificateExpired, {"2021-03-04"}}}});
    row("Topic /m: Its picture /a.png cannot be had: the robot answered 500 (internal error): boom. The "
        "picture before stays.",
        {SubjectKind::Topic, "/m"},
        {ReasonCode::PictureNotHad,
         {"/a.png"},
         {{ReasonCode::AnsweredWithStatusSaying, {500, "boom"}}},
         Consequence::PictureBeforeStays});
    row("Waypoints of Map 7: /b.json cannot be written: no file can be made in / (Permission denied).",
        map::placesOf({map::MapKind::Stored, "7"}),
        {ReasonCode::FileNotWritten,
         {"/b.json"},
         {{ReasonCode::NoFileInFolder, {"/", "Permission denied"}}}});
    row("Map 7: This robot gives no whole map.", map::subjectOf({map::MapKind::Stored, "7"}),
        sentences::lackOf(Capability::WholeMaps, {}));
  }
  void whatWasFoundReadsAsOneText() {
    QFETCH(map::Problem, problem);
    QFETCH(QString, text);
    QCOMPARE(sentences::nameOf(problem.subject) + QStringLiteral(": ") + sentences::sentenceOf(problem),
             text);
  }

  void theNameOfAFileStaysAsItIsWritten() {
    const map::Reason reason{
        map::ReasonCode::FileNotWritten, {"out/part.mcap"}, {map::said("No space left on device")}};
    QCOMPARE(sentences::sentenceOf(reason),
             QStringLiteral("out/part.mcap cannot be written: No space left on device."));
    QCOMPARE(sentences::sentenceOf(map::said("timed out")), QStringLiteral("Timed out."));
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
    using Reason = Absence::Reason;
    QCOMPARE(sentences::whyAbsent(Capability::Submaps, {}),
             QStringLiteral("There are no submaps here, only whole maps."));
    QCOMPARE(sentences::whyAbsent(Capability::Administration, {Reason::ReadOnly, {"Agibot"}}),
             QStringLiteral("Read only: Agibot's interface offers no editing."));
    QCOMPARE(sentences::whyAbsent(Capability::Overview, {Reason::FirmwareLacks, {"404"}}),
             QStringLiteral("This robot offers no overview of its map. Its firmware does not know the "
                            "question (404)."));
    QCOMPARE(sentences::whyAbsent(Capability::Live, {Reason::LocalFiles, {}}),
             QStringLiteral("A local map: there is no robot, so nothing moves on it."));
    QCOMPARE(sentences::whyAbsent(Capability::Administration, {Reason::LocalFiles, {}}),
             QStringLiteral("Local maps are called like their files, and no robot works with them."));
    QCOMPARE(sentences::whyAbsent(Capability::Submaps, {Reason::LocalFiles, {}}),
             QStringLiteral("There are no submaps here, only whole maps."));
    for (const Capability changing :
         {Capability::WaypointEditing, Capability::Administration, Capability::PictureEditing})
      QCOMPARE(sentences::whyAbsent(changing, {Reason::LocalFiles, {"drive.bag"}}),
               QStringLiteral("This is a replay of drive.bag: nothing can be changed."));
  }
};

QTEST_GUILESS_MAIN(SentencesTest)
#include "test_sentences.moc"
