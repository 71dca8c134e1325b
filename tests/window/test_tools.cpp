// What holds for every tool that is used by dragging: below the threshold it is a click, Esc takes a drag
// back and keeps the tool, and so do losing the focus and the menu of the right button.
#include <QSignalSpy>
#include <QtTest>

#include "../edit/fake_waypoint_store.h"
#include "grids/grid_pyramid.h"
#include "overlays/overlay_document.h"
#include "test_program.h"
#include "ui/clouds/projection_tool.h"
#include "ui/clouds/region_tool.h"
#include "ui/clouds/section_tool.h"
#include "ui/maps/pose_tool.h"
#include "ui/maps/reference_tool.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/picture/picture_tool.h"
#include "ui/regions/rectangle_tool.h"
#include "ui/view/map_view.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/mirror_tool.h"
#include "ui/waypoints/waypoint_tool.h"

namespace test_tools {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

constexpr int kCells = 100;

QString textOf(const Eigen::Vector2d& at) {
  return QStringLiteral("%1 %2").arg(at.x(), 0, 'f', 3).arg(at.y(), 0, 'f', 3);
}
QString textOf(const geometry::Pose2& pose) {
  return textOf(Eigen::Vector2d(pose.x_m, pose.y_m)) + QStringLiteral(" %1").arg(pose.yaw_rad, 0, 'f', 3);
}

/// A tool in a view of 800 x 600 at 1 cm a pixel around the origin, where waypoint "a" and overlay "p1" are.
struct Hand {
  explicit Hand(const QString& name) : hits(scene), snapping(&scene, &hits) {
    view.setAnimationMs(0);
    view.resize(800, 600);
    view.show();
    (void)QTest::qWaitForWindowActive(&view);
    geometry::ViewTransform camera = scene.view();
    camera.center_m = {0, 0};
    camera.scale_m_per_px = 0.01;
    view.moveTo(camera, false);
    if (name == QLatin1String("region")) {
      use<RectangleTool>(&scene, [](const auto&) { return QString(); });
      count(&RectangleTool::drawn);
    } else if (name == QLatin1String("box of a cloud")) {
      use<RegionTool>(&scene);
      count(&RegionTool::boxDrawn);
    } else if (name == QLatin1String("sphere of a cloud")) {
      use<RegionTool>(&scene)->setShape(RegionShape::Sphere);
      count(&RegionTool::sphereDrawn);
    } else if (name == QLatin1String("section")) {
      auto* const section = use<SectionTool>(&scene);
      came = [section] {
        const auto& line = section->line();
        return line ? textOf(line->from_m) + QStringLiteral(" to ") + textOf(line->to_m) : QString();
      };
    } else if (name.startsWith(QLatin1String("projection"))) {
      if (name == QLatin1String("projection that is moved")) draft.add(map::Projection{{}, {-1, -1}, {2, 2}});
      auto* const tool_of_it = use<ProjectionTool>(&scene, &draft);
      tool_of_it->setEditable(true, true);
      QObject::connect(tool_of_it, &ProjectionTool::drawn, &view, [this](const auto&) {
        draft.add(map::Projection{{}, {0, 0}, {1, 1}});
      });
      QObject::connect(tool_of_it, &ProjectionTool::changedTo, &view,
                       [this](int index, const auto& to) { draft.set(index, to); });
      came = [this] {
        QString all;
        for (const auto& one : draft.wanted()) all += textOf(one.corner_m) + QLatin1Char(';');
        return all;
      };
    } else if (name == QLatin1String("reference map")) {
      auto* const reference = use<ReferenceTool>(&scene);
      QObject::connect(reference, &ReferenceTool::moved, &view, [this, reference](const geometry::Pose2& to) {
        pose = to;
        reference->setState({}, to, {});
      });
      came = [this] { return textOf(pose); };
    } else if (name == QLatin1String("pose")) {
      auto* const tool_of_it = use<PoseTool>(&scene);
      const auto put = [this, tool_of_it](const std::optional<geometry::Pose2>& to) {
        pose = to.value_or(geometry::Pose2{});
        tool_of_it->setPose(to);
      };
      QObject::connect(tool_of_it, &PoseTool::placed, &view, put);
      QObject::connect(tool_of_it, &PoseTool::takenBack, &view, put);
      came = [this] { return textOf(pose); };
    } else if (name.startsWith(QLatin1String("picture"))) {
      openPicture();
      use<PictureTool>(&picture, &scene)
          ->setMode(name == QLatin1String("picture, rectangle") ? PaintMode::Rectangle : PaintMode::Line);
      came = [this] { return QString::number(picture.undoStack().count()); };
    } else if (name == QLatin1String("waypoints along a line")) {
      auto* const line = use<LineTool>(&scene, &snapping);
      came = [line] { return QString::number(line->ready()); };
    } else if (name.startsWith(QLatin1String("waypoint")) || name == QLatin1String("mirror")) {
      // What lies on a mirror stays where it is.
      openWaypoints(name == QLatin1String("mirror") ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(0, 0));
      if (name == QLatin1String("mirror")) {
        use<MirrorTool>(&waypoints, &scene, &snapping);
      } else {
        use<WaypointTool>(&waypoints, &scene, &hits, &snapping);
      }
      came = [this] {
        return textOf(waypoints.find("a")->position_m) +
               QStringLiteral(" held %1").arg(waypoints.preview().size());
      };
    } else {
      overlays.open(*overlays::OverlayDocument::read(
          R"({"type":"FeatureCollection","features":[{"id":"p1","type":"Feature","geometry":{"type":"Point",)"
          R"("coordinates":[0,0]},"properties":{"type":"25"}}]})"));
      on_map.setMap(map::MapKey{map::MapKind::Stored, "1"}, false);
      auto* const tool_of_it = use<OverlayTool>(&overlays, &scene, &on_map, &overlay_snapping);
      if (name == QLatin1String("overlay that is turned")) {
        overlays.select({0});
        from = tool_of_it->handle()->toPoint();
      }
      if (name == QLatin1String("overlay, rectangle")) tool_of_it->setMode(OverlayMode::Rectangle);
      if (name == QLatin1String("overlay, circle")) tool_of_it->setMode(OverlayMode::Circle);
      came = [this] {
        return QStringLiteral("%1 held %2").arg(overlays.undoStack().count()).arg(overlays.preview().size());
      };
    }
    QObject::connect(tool.get(), &MapTool::finished, &view, [this] { ++left; });
    if (auto* const mirror = qobject_cast<MirrorTool*>(tool.get()))
      QObject::connect(mirror, &MirrorTool::ended, &view, [this] { ++left; });
    view.setTool(tool.get());
  }
  ~Hand() { view.setTool(&nothing); }

  template <typename Tool, typename... With>
  Tool* use(With... with) {
    auto made = std::make_unique<Tool>(with...);
    auto* const kept = made.get();
    tool = std::move(made);
    return kept;
  }
  template <typename Signal>
  void count(Signal signal) {
    auto* const from = static_cast<typename QtPrivate::FunctionPointer<Signal>::Object*>(tool.get());
    QObject::connect(from, signal, &view, [this] { ++reported; });
    came = [this] { return QString::number(reported); };
  }
  void openPicture() {
    const auto builder =
        grids::buildGrid(kCells, kCells, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
    for (int y = 0; y < kCells; ++y) builder->pushRow(std::vector<std::uint8_t>(kCells, 0));
    builder->finish();
    map::GridReference place;
    place.width = place.height = kCells;
    place.resolution_m = 0.05;
    place.origin.x_m = place.origin.y_m = -2.5;
    picture.open(builder->pyramid(), place, true);
    picture.setKind(picture::Kind::Occupied);
  }
  void openWaypoints(const Eigen::Vector2d& at_m) {
    document.reset({{"a", test::waypoint("a", at_m.x(), at_m.y(), "Dock")}});
    points.put("a", at_m);
    hits.add(ui::scene::Layer::Waypoints, &points);
    waypoints.setDocument(&document, {});
    waypoints.select({"a"});
  }

  void press(const QPoint& at) { QTest::mousePress(view.viewport(), Qt::LeftButton, Qt::AltModifier, at); }
  void moveTo(const QPoint& at, Qt::MouseButton held = Qt::LeftButton) {
    QMouseEvent move(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, held,
                     Qt::AltModifier);
    QApplication::sendEvent(view.viewport(), &move);
  }
  void release(const QPoint& at) {
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, Qt::AltModifier, at);
  }
  void escape() { QTest::keyClick(&view, Qt::Key_Escape); }
  void loseFocus(Qt::FocusReason why = Qt::ActiveWindowFocusReason) {
    QFocusEvent lost(QEvent::FocusOut, why);
    QApplication::sendEvent(&view, &lost);
  }
  void dragAll() {
    press(from);
    moveTo((from + kTo) / 2);
    moveTo(kTo);
    release(kTo);
  }

  static constexpr QPoint kTo{490, 240};
  QPoint from{400, 300};

  ui::scene::MapScene scene{{}};
  MapView view{&scene};
  PanTool nothing;
  HitList hits;
  PointIndex points;
  WaypointSnapping snapping;
  edit::WaypointDocument document;
  WaypointEditing waypoints;
  ProjectionDraft draft;
  edit::PictureEditing picture{std::make_shared<work::Workers>()};
  edit::OverlayEditing overlays;
  OverlaysOnMap on_map{&overlays, &scene};
  OverlaySnapping overlay_snapping{&overlays, &scene, &on_map};
  std::unique_ptr<MapTool> tool;
  std::function<QString()> came;  // what dragging has changed so far
  geometry::Pose2 pose;
  int reported = 0, left = 0;
};

}  // namespace

class TestTools : public QObject {
  Q_OBJECT

  static void everyTool() {
    QTest::addColumn<QString>("name");
    for (const char* const name :
         {"region", "box of a cloud", "sphere of a cloud", "section", "projection",
          "projection that is moved", "reference map", "pose", "picture, rectangle", "picture, line",
          "waypoints along a line", "mirror", "waypoint that is moved", "overlay that is turned",
          "overlay, rectangle", "overlay, circle"})
      QTest::newRow(name) << QString::fromLatin1(name);
  }
  /// Nothing has come of a drag, and the tool is as ready as before it.
  static void isAsBefore(Hand& hand, const QString& before) {
    QCOMPARE(hand.came(), before);
    QCOMPARE(hand.left, 0);
    const Eigen::Vector2d centre = hand.scene.view().center_m;
    hand.dragAll();
    QVERIFY(hand.came() != before);
    QCOMPARE(hand.scene.view().center_m, centre);
  }

 private Q_SLOTS:
  void aDragComesToSomething_data() { everyTool(); }
  void aDragComesToSomething() {
    QFETCH(QString, name);
    Hand hand(name);
    isAsBefore(hand, hand.came());
  }

  void escTakesADragBackAndKeepsTheTool_data() { everyTool(); }
  void escTakesADragBackAndKeepsTheTool() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.moveTo((hand.from + Hand::kTo) / 2);
    hand.escape();
    // What the hand does until it lets go is ignored.
    const Eigen::Vector2d centre = hand.scene.view().center_m;
    hand.moveTo(Hand::kTo);
    hand.release(Hand::kTo);
    QCOMPARE(hand.scene.view().center_m, centre);
    isAsBefore(hand, before);
  }

  void escTakesAPressBackToo_data() { everyTool(); }
  void escTakesAPressBackToo() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.escape();
    const Eigen::Vector2d centre = hand.scene.view().center_m;
    hand.moveTo(Hand::kTo);
    hand.release(Hand::kTo);
    QCOMPARE(hand.scene.view().center_m, centre);
    isAsBefore(hand, before);
  }

  void losingTheFocusTakesADragBack_data() { everyTool(); }
  void losingTheFocusTakesADragBack() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.moveTo((hand.from + Hand::kTo) / 2);
    hand.loseFocus();
    hand.moveTo(Hand::kTo);
    hand.release(Hand::kTo);
    isAsBefore(hand, before);
  }

  void theMenuTakesADragBack_data() { everyTool(); }
  void theMenuTakesADragBack() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.moveTo((hand.from + Hand::kTo) / 2);
    QTest::mousePress(hand.view.viewport(), Qt::RightButton, {}, Hand::kTo);
    hand.loseFocus(Qt::PopupFocusReason);
    QTest::mouseRelease(hand.view.viewport(), Qt::RightButton, {}, Hand::kTo);
    hand.release(Hand::kTo);
    isAsBefore(hand, before);
  }

  void aPressThatLosesTheFocusIsForgotten_data() { everyTool(); }
  void aPressThatLosesTheFocusIsForgotten() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    const Eigen::Vector2d centre = hand.scene.view().center_m;
    hand.press(hand.from);
    hand.loseFocus();
    hand.moveTo(Hand::kTo);
    hand.release(Hand::kTo);
    QCOMPARE(hand.scene.view().center_m, centre);
    QVERIFY(hand.tool->cursor().shape() != Qt::ClosedHandCursor);
    isAsBefore(hand, before);
  }

  void anotherToolTakesADragBack_data() { everyTool(); }
  void anotherToolTakesADragBack() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.moveTo((hand.from + Hand::kTo) / 2);
    hand.view.setTool(&hand.nothing);
    hand.release(Hand::kTo);
    QCOMPARE(hand.came(), before);
    QCOMPARE(hand.left, 0);
  }

  void escWithoutADragLeavesTheTool_data() { everyTool(); }
  void escWithoutADragLeavesTheTool() {
    QFETCH(QString, name);
    Hand hand(name);
    // What is selected and what is drawn in go first.
    for (int i = 0; i < 2 && hand.left == 0; ++i) hand.escape();
    QCOMPARE(hand.left, 1);
  }

  void aClickIsNoDrag_data() { everyTool(); }
  void aClickIsNoDrag() {
    QFETCH(QString, name);
    Hand hand(name);
    const QString before = hand.came();
    hand.press(hand.from);
    hand.moveTo(hand.from + QPoint(2, 2));  // a hand trembles
    const QString held = hand.came();
    const bool previews = name.contains(QLatin1String("waypoint")) || name.contains(QLatin1String("overlay"));
    if (!previews) QCOMPARE(held, before);
    hand.release(hand.from + QPoint(2, 2));
    QVERIFY(hand.tool->cursor().shape() != Qt::ClosedHandCursor);
  }

  void aClickLeavesTheSectionThatIsThere() {
    Hand hand(QStringLiteral("section"));
    hand.dragAll();
    const QString drawn = hand.came();
    hand.press(Hand::kTo);
    hand.release(Hand::kTo);
    QCOMPARE(hand.came(), drawn);
    // A drag that is taken back leaves it, too.
    hand.press(hand.from);
    hand.moveTo(Hand::kTo);
    hand.escape();
    hand.release(Hand::kTo);
    QCOMPARE(hand.came(), drawn);
    hand.escape();
    QCOMPARE(hand.came(), QString());
  }

  void aBrushThatIsTakenBackKeepsWhatItPainted() {
    Hand hand(QStringLiteral("picture, line"));
    static_cast<PictureTool*>(hand.tool.get())->setMode(PaintMode::Brush);
    for (const bool moved : {true, false}) {
      hand.press(hand.from + QPoint(0, moved ? 0 : 50));
      if (moved) hand.moveTo(Hand::kTo);
      hand.loseFocus();
      QVERIFY(!hand.picture.stroking());
      hand.release(Hand::kTo);
      QCOMPARE(hand.came(), QString::number(moved ? 1 : 2));  // one step to undo
    }
  }

  void aDoubleClickNeverMovesTheMapWhileALineIsDrawn() {
    Hand hand(QStringLiteral("waypoints along a line"));
    const double scale = hand.scene.view().scale_m_per_px;
    QTest::mouseClick(hand.view.viewport(), Qt::LeftButton, {}, hand.from);
    QTest::mouseDClick(hand.view.viewport(), Qt::LeftButton, {}, hand.from);
    QCOMPARE(hand.scene.view().scale_m_per_px, scale);
  }
};

}  // namespace test_tools

MAPWRIGHT_TEST(test_tools, TestTools, Widgets)
#include "test_tools.moc"
