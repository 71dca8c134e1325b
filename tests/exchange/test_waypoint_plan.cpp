// What it takes to make a list of waypoints another one, and the file that holds it.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include "exchange/waypoint_plan.h"
#include "test_program.h"

namespace test_waypoint_plan {

using namespace mapwright;

namespace {

map::Waypoint point(const std::string& id, const std::string& name, double x, double y) {
  map::Waypoint made;
  made.id = id;
  made.name = name;
  made.position_m = {x, y};
  return made;
}

exchange::WaypointItems two() {
  return exchange::itemsOf({point("1", "Door", 1, 1), point("2", "Dock", 2, 2)});
}

exchange::WantedWaypoint wanted(const std::string& id, std::optional<std::string> name,
                                std::optional<Eigen::Vector2d> at) {
  exchange::WantedWaypoint made{1, id};
  made.name = std::move(name);
  made.position_m = at;
  return made;
}

/// "move 1 Door | delete 2 Dock"
QString told(const std::vector<exchange::WaypointEdit>& edits) {
  QStringList lines;
  for (const exchange::WaypointStep& step : exchange::stepsOf(edits))
    lines << QStringLiteral("%1 %2 %3")
                 .arg(exchange::wordOf(step.kind), QString::fromStdString(step.id()),
                      QString::fromStdString(step.name()));
  return lines.join(QStringLiteral(" | "));
}

std::string withChanges(const QByteArray& plan, const std::function<void(QJsonArray&)>& change) {
  QJsonObject json = QJsonDocument::fromJson(plan).object();
  QJsonArray changes = json[QStringLiteral("changes")].toArray();
  change(changes);
  json[QStringLiteral("changes")] = changes;
  return QJsonDocument(json).toJson().toStdString();
}

}  // namespace

class WaypointPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsNotKeptIsLeftOutWithAWord() {
    map::Waypoint typed = point("", "New", 1, 1);
    typed.type = "shelf";
    map::Waypoint door = point("1", "Door", 1, 1);
    door.yaw_rad = 0;
    map::Waypoint as_typed = door;
    as_typed.type = "door";
    const robot::KeptFields keeps{.type = false, .no_heading = false};
    const auto fitted = exchange::fitted({{"k", std::nullopt, typed}, {"1", door, as_typed}}, keeps);
    QCOMPARE(fitted.edits.size(), std::size_t(1));  // the type alone was another one
    QCOMPARE(fitted.edits.front().after->type, std::string());
    QCOMPARE(fitted.edits.front().after->yaw_rad, std::optional(0.0));
    QCOMPARE(fitted.notes,
             (QStringList{
                 QStringLiteral("Waypoint types cannot be stored here: those of 2 waypoints are left out."),
                 QStringLiteral("Every waypoint needs a heading here: 1 waypoint without one gets 0°.")}));
    QVERIFY(exchange::fitted({{"k", std::nullopt, typed}}, {}).notes.isEmpty());
  }

  void whatCannotBeHadIsNoChange() {
    const robot::KeptFields keeps{.pixel_m = 0.05};
    const map::Waypoint door = point("1", "Door", 1, 1);
    const auto movedBy = [&](double by_m) {
      map::Waypoint moved = door;
      moved.position_m.x() += by_m;
      return exchange::fitted({{"1", door, moved}}, keeps);
    };
    for (const double by_m : {0.02, -0.02}) {
      QVERIFY(movedBy(by_m).edits.empty());
      QCOMPARE(
          movedBy(by_m).notes,
          QStringList{QStringLiteral("Waypoints are kept on pixels of 0.05 m here: 1 waypoint stays where it "
                                     "is, less than half a pixel from where it should be.")});
    }
    QCOMPARE(movedBy(0.03).edits.size(), std::size_t(1));
    QVERIFY(movedBy(0.03).notes.isEmpty());
    map::Waypoint named = door;
    named.name = "Gate";
    named.position_m.y() += 0.01;
    const auto renamed = exchange::fitted({{"1", door, named}}, keeps);
    QCOMPARE(exchange::stepsOf(renamed.edits).size(), std::size_t(1));  // no move besides
    map::Waypoint tagged = door;
    tagged.tags = {"a"};
    const auto untagged = exchange::fitted({{"1", door, tagged}}, {.tags = false});
    QVERIFY(untagged.edits.empty());
    QCOMPARE(untagged.notes,
             QStringList{QStringLiteral("Tags cannot be stored here: those of 1 waypoint are left out.")});
    const auto stays = exchange::fitted({{"1", door, std::nullopt}}, {.removal = false});
    QVERIFY(stays.edits.empty());
    QCOMPARE(
        stays.notes,
        QStringList{QStringLiteral("Waypoints cannot be deleted here: 1 waypoint that should go stays.")});
  }

  void aPlanKeepsItsOrder() {
    const auto edits = exchange::editsFor(
        two(),
        {wanted("", "Corr 3", Eigen::Vector2d(3, 0)), wanted("2", "Dock", Eigen::Vector2d(3, 3)),
         wanted("", "Corr 1", Eigen::Vector2d(1, 0)), wanted("1", "Gate", Eigen::Vector2d(1, 1))},
        exchange::Others::Go);
    QVERIFY(edits.has_value());
    const auto plan = exchange::planFromBytes(
        exchange::planBytes({QStringLiteral("file:///m"), "1", two(), *edits}, {}).toStdString());
    QVERIFY(plan.has_value());
    QCOMPARE(told(plan->edits)
                 .replace(QRegularExpression(QStringLiteral("create \\S*")), QStringLiteral("create")),
             QStringLiteral("create Corr 3 | move 2 Dock | create Corr 1 | rename 1 Door"));
  }

  void anImportAddsAndChangesAndLeavesTheOthers() {
    const auto edits = exchange::editsFor(
        two(),
        {wanted("1", "Gate", Eigen::Vector2d(1, 5)), wanted("", "Dock", Eigen::Vector2d(3, 3)),
         wanted("", "New", Eigen::Vector2d(0, 0))},
        exchange::Others::Stay);
    QVERIFY2(edits.has_value(), edits ? "" : qPrintable(edits.error()));
    QCOMPARE(told(*edits), QStringLiteral("rename 1 Door | move 1 Door | move 2 Dock | create  New"));
    QVERIFY(exchange::editsFor(two(), {wanted("1", "Door", std::nullopt)}, exchange::Others::Stay)->empty());
  }

  void aWholeListDeletesWhatItDoesNotHold() {
    const auto edits = exchange::editsFor(
        two(), {wanted("1", {}, {}), wanted("", "Dock", Eigen::Vector2d(3, 3))}, exchange::Others::Go);
    QVERIFY2(edits.has_value(), edits ? "" : qPrintable(edits.error()));
    QCOMPARE(told(*edits), QStringLiteral("create  Dock | delete 2 Dock"));
  }

  void whatCannotBeMeantIsRefused() {
    const auto refused = [](const exchange::WaypointItems& kept,
                            const std::vector<exchange::WantedWaypoint>& rows) {
      const auto edits = exchange::editsFor(kept, rows, exchange::Others::Stay);
      return edits ? QString() : edits.error();
    };
    QVERIFY(refused(two(), {wanted("1", {}, {}), wanted("1", {}, {})}).contains(QStringLiteral("same")));
    QVERIFY(refused(two(), {wanted("", "Shelf", {})}).contains(QStringLiteral("position")));
    QVERIFY(refused(two(), {wanted("9", {}, Eigen::Vector2d(0, 0))}).contains(QStringLiteral("name")));
    QVERIFY(refused(two(), {wanted("1", "a\nb", {})}).contains(QStringLiteral("one line")));
    QVERIFY(refused(two(), {wanted("1", {}, Eigen::Vector2d(1e9, 0))}).contains(QStringLiteral("origin")));
    auto twins = two();
    twins.emplace("3", point("3", "Dock", 0, 0));
    const QString twice = refused(twins, {wanted("", "Dock", {})});
    QVERIFY2(twice.contains(QStringLiteral("2, 3")), qPrintable(twice));
  }

  void aPlanComesBackFromItsFile() {
    exchange::WaypointPlan plan{QStringLiteral("file:/maps"), "hall.yaml", two(), {}};
    auto changed = plan.base.at("1");
    changed.name = "Gate";
    changed.yaw_rad = 1.5;
    changed.tags = {"a"};
    plan.edits = {{"1", plan.base.at("1"), changed},
                  {"2", plan.base.at("2"), std::nullopt},
                  {"fresh", std::nullopt, point("", "New", 7, 8)}};
    const QByteArray bytes = exchange::planBytes(plan, {});
    const auto read = exchange::planFromBytes(bytes.toStdString());
    QVERIFY2(read.has_value(), read ? "" : qPrintable(read.error()));
    QCOMPARE(read->robot, plan.robot);
    QCOMPARE(read->map, plan.map);
    QVERIFY(read->base == plan.base);
    for (const exchange::WaypointEdit& edit : plan.edits) {
      const bool found = std::any_of(read->edits.begin(), read->edits.end(), [&](const auto& one) {
        return (one.key == edit.key || !edit.before) && one.before == edit.before && one.after == edit.after;
      });
      QVERIFY2(found, edit.key.c_str());
    }
    // Somebody does not want the deletion.
    const auto less = exchange::planFromBytes(withChanges(bytes, [](QJsonArray& changes) {
      for (qsizetype i = changes.size() - 1; i >= 0; --i) {
        if (changes[i].toObject()[QStringLiteral("kind")].toString() == QStringLiteral("delete"))
          changes.removeAt(i);
      }
    }));
    QVERIFY2(less.has_value(), less ? "" : qPrintable(less.error()));
    QCOMPARE(less->edits.size(), std::size_t(2));
  }

  void whatIsNoPlanIsRefused() {
    exchange::WaypointPlan plan{QStringLiteral("file:/maps"), "hall.yaml", two(), {}};
    plan.edits = {{"2", plan.base.at("2"), std::nullopt}};
    const QByteArray bytes = exchange::planBytes(plan, {});
    for (const char* text : {"", "{", "[]", "{\"mapwright\":\"waypoint-plan\",\"version\":1}"})
      QVERIFY(!exchange::planFromBytes(text).has_value());
    const auto refused = [&](const char* row) {
      return !exchange::planFromBytes(withChanges(bytes, [&](QJsonArray& changes) {
                changes << QJsonDocument::fromJson(row).object();
              })).has_value();
    };
    QVERIFY(refused(R"({"id":"7","kind":"delete"})"));
    QVERIFY(refused(R"({"id":"1","kind":"paint"})"));
    QVERIFY(refused(R"({"id":"1","kind":"move"})"));
    QVERIFY(refused(R"({"id":"1","kind":"rename","to":""})"));
    QVERIFY(refused(R"({"id":"2","kind":"rename","to":"Dock 2"})"));  // it is deleted
    QVERIFY(refused(R"({"id":null,"kind":"create","name":"New"})"));
    QVERIFY(!refused(R"({"id":null,"kind":"create","name":"New","x":1,"y":2})"));
  }

  void whatOthersChangedIsMergedOrAConflict() {
    auto moved = two().at("1");
    moved.position_m = {9, 9};
    const std::vector<exchange::WaypointEdit> edits{{"1", two().at("1"), moved},
                                                    {"2", two().at("2"), std::nullopt}};
    auto theirs = two();
    theirs.at("1").name = "Gate";
    const exchange::MergedEdits together = exchange::merged(edits, theirs);
    QVERIFY(together.conflicts.empty());
    QCOMPARE(told(together.edits), QStringLiteral("move 1 Gate | delete 2 Dock"));
    theirs.at("1").position_m = {4, 4};
    theirs.at("2").name = "Pier";
    const exchange::MergedEdits apart = exchange::merged(edits, theirs);
    QVERIFY(apart.edits.empty());
    QCOMPARE(apart.conflicts.size(), std::size_t(2));
    QCOMPARE(exchange::conflictLines(apart.conflicts).size(), 2);
    QCOMPARE(
        exchange::conflictsJson(apart.conflicts, "1").first().toObject()[QStringLiteral("kind")].toString(),
        QStringLiteral("both-changed"));
  }

  void whatIsKeptMayDifferByWhatIsLostOnTheWay() {
    const map::Waypoint asked = point("", "New", 7, 8);
    map::Waypoint kept = point("r-1", "New", 7.00001, 8);
    const exchange::WaypointStep create{exchange::StepKind::Create, "fresh", std::nullopt, asked};
    QVERIFY(exchange::isDone(create, &kept));
    kept.yaw_rad = 0;  // a robot to which everything is turned somehow
    QVERIFY(exchange::isDone(create, &kept));
    kept.yaw_rad = 0.5;
    QVERIFY(!exchange::isDone(create, &kept));
    kept = point("r-1", "New", 7.01, 8);
    QVERIFY(!exchange::isDone(create, &kept));
    QVERIFY(!exchange::isDone(create, nullptr));
    map::Waypoint turned = asked;
    turned.yaw_rad = 0;
    kept = point("r-1", "New", 7, 8);
    QVERIFY(!exchange::isDone({exchange::StepKind::Move, "r-1", kept, turned}, &kept));
  }

  void whatIsThereAlreadyIsNotCreatedTwice() {
    exchange::WaypointPlan plan{{}, "1", two(), {{"fresh", std::nullopt, point("", "New", 7, 8)}}};
    QCOMPARE(exchange::withoutCreated(plan, two()).size(), std::size_t(1));
    auto now = two();
    now.emplace("r-1", point("r-1", "New", 7, 8));
    QVERIFY(exchange::withoutCreated(plan, now).empty());
    // Some robots give what they create tags of their own: it gets those of the plan, and is not created
    // again.
    now.at("r-1").tags = {"map_entry"};
    const auto retagged = exchange::withoutCreated(plan, now);
    QCOMPARE(retagged.size(), std::size_t(1));
    QVERIFY(retagged.front().before && retagged.front().after->tags.empty());
    QCOMPARE(retagged.front().key, std::string("r-1"));
    now.at("r-1").tags.clear();
    // Two alike are two.
    plan.edits.push_back({"fresh too", std::nullopt, point("", "New", 7, 8)});
    QCOMPARE(exchange::withoutCreated(plan, now).size(), std::size_t(1));
  }
};

}  // namespace test_waypoint_plan

MAPWRIGHT_TEST(test_waypoint_plan, WaypointPlanTest, Core)
#include "test_waypoint_plan.moc"
