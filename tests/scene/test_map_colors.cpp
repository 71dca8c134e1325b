// The colours of the map can be told apart: from each other and from the ground, in both themes, by
// everybody.
#include <utility>
#include <vector>

#include <QtTest>

#include "render/grid_palettes.h"
#include "render/sample_grid.h"
#include "seen_color.h"
#include "test_program.h"
#include "ui/scene/map_theme.h"
#include "ui/scene/track.h"

namespace test_map_colors {

using namespace mapwright;
using namespace mapwright::ui::scene;
using test::distance;
using test::Eyes;
using test::Lab;

namespace {

// CIEDE2000. What must be told apart at a glance; a gradient is longer than a point, and lies between its
// neighbours, so it may be nearer; a ring is never taken for a region.
constexpr double kApart = 10, kFromGround = 10, kFromTrack = 7, kNotTheSameRed = 20;

using Named = std::pair<QString, QColor>;

QColor differenceColor(render::Difference what, bool dark) {
  return QColor(QRgb(render::differencePalette(dark)[std::size_t(what)]));
}

/// The robot's ways and plans, sensor data, places, what is measured.
std::vector<Named> thingsOf(const MapTheme& theme) {
  return {{QStringLiteral("trail"), theme.trail},
          {QStringLiteral("path"), theme.path},
          {QStringLiteral("trajectory"), theme.trajectory},
          {QStringLiteral("target"), theme.target},
          {QStringLiteral("lidar points"), theme.cloud},
          {QStringLiteral("waypoints"), theme.place},
          {QStringLiteral("other robots"), theme.other_robot},
          {QStringLiteral("landmarks"), theme.constraint},
          {QStringLiteral("measured line"), theme.measure}};
}

/// Doors, regions of overlays, virtual walls. What is bad has the colour of what is new in a difference.
std::vector<Named> areasOf(const MapTheme& theme) {
  return {{QStringLiteral("good"), theme.good},
          {QStringLiteral("warn"), theme.warn},
          {QStringLiteral("bad, new"), theme.bad},
          {QStringLiteral("other regions"), theme.region}};
}

/// All of them, and what Difference shows.
std::vector<Named> allOf(const MapTheme& theme) {
  std::vector<Named> all = thingsOf(theme);
  for (const Named& area : areasOf(theme)) all.push_back(area);
  all.push_back({QStringLiteral("gone"), differenceColor(render::Difference::Vanished, theme.dark)});
  return all;
}

std::vector<Named> groundsOf(const MapTheme& theme) {
  return {{QStringLiteral("free"), QColor(theme.map.free)},
          {QStringLiteral("unknown"), QColor(theme.map.unknown)},
          {QStringLiteral("occupied"), QColor(theme.map.occupied)}};
}

QColor over(const QColor& above, double opacity, const QColor& ground) {
  const auto mixed = [&](float top, float below) { return float(below + (top - below) * opacity); };
  return QColor::fromRgbF(mixed(above.redF(), ground.redF()), mixed(above.greenF(), ground.greenF()),
                          mixed(above.blueF(), ground.blueF()));
}

void themes() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

MapTheme themeOf(bool dark) { return dark ? darkMapTheme() : lightMapTheme(); }

void atLeast(double least, const Named& one, const Named& other) {
  const double found = distance(one.second, other.second);
  QVERIFY2(found >= least, qPrintable(QStringLiteral("%1 %2, %3 %4: %5")
                                          .arg(one.first, one.second.name(), other.first, other.second.name())
                                          .arg(found)));
}

}  // namespace

class TestMapColors : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  // Sharma, Wu and Dalal 2005, table 1.
  void distancesAreAsPublished() {
    const std::vector<std::tuple<Lab, Lab, double>> published{
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
    for (const auto& [one, other, expected] : published) {
      QVERIFY(std::abs(distance(one, other) - expected) < 1e-4);
      QVERIFY(std::abs(distance(other, one) - expected) < 1e-4);
    }
  }

  void eyesSeeGrayAlikeAndConfuseWhatTheyShould() {
    for (const Eyes eyes : test::kAllEyes) {
      const Lab gray = test::labOf(QColor(128, 128, 128), eyes);
      QVERIFY(std::abs(gray.a) < 0.1 && std::abs(gray.b) < 0.1);
    }
    const auto seen = [](const char* color, Eyes eyes) {
      return test::labOf(QColor(QLatin1String(color)), eyes);
    };
    const auto apart = [&](const char* one, const char* other, Eyes eyes) {
      return distance(seen(one, eyes), seen(other, eyes));
    };
    // Red and green of the traffic light's kind, blue-green and blue.
    QVERIFY(apart("#b04040", "#707000", Eyes::Usual) > 2 * apart("#b04040", "#707000", Eyes::Deutan));
    QVERIFY(apart("#009090", "#0070d0", Eyes::Usual) > 1.5 * apart("#009090", "#0070d0", Eyes::Tritan));
  }

  void whatIsOnScreenTogetherIsToldApart_data() { themes(); }
  void whatIsOnScreenTogetherIsToldApart() {
    QFETCH(bool, dark);
    const std::vector<Named> all = allOf(themeOf(dark));
    QCOMPARE(differenceColor(render::Difference::Appeared, dark), themeOf(dark).bad);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const bool region_and_mark =
            all[k].first == QLatin1String("other regions") && all[i].first == QLatin1String("target");
        atLeast(region_and_mark ? kFromTrack : kApart, all[i], all[k]);
      }
    }
  }

  void everythingStandsOutFromTheGround_data() { themes(); }
  void everythingStandsOutFromTheGround() {
    QFETCH(bool, dark);
    const MapTheme theme = themeOf(dark);
    for (const Named& ground : groundsOf(theme)) {
      for (const Named& thing : allOf(theme)) {
        if (thing.first == QLatin1String("gone")) continue;  // it lies on white
        QCOMPARE(thing.second.alpha(), 255);                 // it is the same on every ground
        atLeast(kFromGround, thing, ground);
      }
      // The local path is a translucent band.
      constexpr double kBandOpacity = 90 / 255.0;
      const QColor band = over(theme.path, kBandOpacity, ground.second);
      atLeast(kFromGround, {QStringLiteral("local path"), band}, ground);
    }
  }

  void submapsOfOtherTrajectoriesAreToldApart() {
    const auto colors = render::classColors(render::ColorMode::Trajectory);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t k = i + 1; k < colors.size(); ++k)
        atLeast(kApart, {QStringLiteral("trajectory"), QColor(colors[i])},
                {QStringLiteral("trajectory"), QColor(colors[k])});
    }
  }

  void theRampOfSubmapsGetsLighter() {
    const auto ramp = render::classColors(render::ColorMode::Age);
    const QColor unknown(render::kUnknownVersionColor);
    for (std::size_t i = 0; i < ramp.size(); ++i) {
      atLeast(kApart, {QStringLiteral("step"), QColor(ramp[i])}, {QStringLiteral("no version"), unknown});
      if (i == 0) continue;
      atLeast(4, {QStringLiteral("step"), QColor(ramp[i - 1])}, {QStringLiteral("step"), QColor(ramp[i])});
      for (const Eyes eyes : test::kAllEyes)
        QVERIFY(test::labOf(QColor(ramp[i]), eyes).l > test::labOf(QColor(ramp[i - 1]), eyes).l);
    }
    atLeast(3 * kApart, {QStringLiteral("first"), QColor(ramp.front())},
            {QStringLiteral("last"), QColor(ramp.back())});
  }

  void classesStandOutFromTheGround_data() { themes(); }
  void classesStandOutFromTheGround() {
    QFETCH(bool, dark);
    const MapTheme theme = themeOf(dark);
    std::vector<std::uint32_t> colors{render::kUnknownVersionColor};
    for (const auto mode : {render::ColorMode::Trajectory, render::ColorMode::Age}) {
      for (const std::uint32_t color : render::classColors(mode)) colors.push_back(color);
    }
    for (const std::uint32_t color : colors) {
      atLeast(kFromTrack, {QStringLiteral("class"), QColor(color)},
              {QStringLiteral("unknown"), QColor(theme.map.unknown)});
      atLeast(3 * kFromGround, {QStringLiteral("class"), QColor(color)},
              {QStringLiteral("occupied"), QColor(theme.map.occupied)});
    }
  }

  void lidarPointsAreNotTakenForWhatIsNew_data() { themes(); }
  void lidarPointsAreNotTakenForWhatIsNew() {
    QFETCH(bool, dark);
    const MapTheme theme = themeOf(dark);
    const QColor added = differenceColor(render::Difference::Appeared, dark);
    QVERIFY(distance(test::labOf(theme.cloud, Eyes::Usual), test::labOf(added, Eyes::Usual)) >=
            kNotTheSameRed);
  }

  void theTrackOfABagIsToldFromOtherLinesAndPointsAndFromWhatIsNew_data() { themes(); }
  void theTrackOfABagIsToldFromOtherLinesAndPointsAndFromWhatIsNew() {
    QFETCH(bool, dark);
    const MapTheme theme = themeOf(dark);
    for (const QColor& color : trackColors(TrackChoice::Time)) {
      const Named step{QStringLiteral("track"), color};
      for (const Named& thing : thingsOf(theme)) atLeast(kFromTrack, step, thing);
      atLeast(kFromTrack, step, {QStringLiteral("new"), theme.bad});
      for (const Named& ground : groundsOf(theme)) atLeast(2 * kFromGround, step, ground);
    }
    for (const QColor& color : trackColors(TrackChoice::Quality))
      atLeast(kFromTrack, {QStringLiteral("quality"), color}, {QStringLiteral("new"), theme.bad});
  }
};

}  // namespace test_map_colors

MAPWRIGHT_TEST(test_map_colors, TestMapColors, Widgets)
#include "test_map_colors.moc"
