// The way through a whole bag on the map, and what its colours mean.
#include <cmath>
#include <limits>
#include <set>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/track.h"

namespace test_track_layer {

using namespace mapwright;
using namespace mapwright::ui::scene;

namespace {

constexpr int kWidth = 400, kHeight = 300;

/// From left to right through the middle, a metre a second; a pixel is 5 cm.
std::shared_ptr<Track> straight(int seconds) {
  auto track = std::make_shared<Track>();
  for (int i = 0; i <= seconds * 10; ++i)
    track->push_back({{-double(seconds) / 2 + i / 10.0, 0}, i / 10.0, 1, 10, i == 0});
  return track;
}

class Desk {
 public:
  Desk() : scene(exact()) {
    for (const Layer layer : allLayers()) scene.setLayerVisible(layer, layer == Layer::Track);
    geometry::ViewTransform view;
    view.width_px = kWidth;
    view.height_px = kHeight;
    scene.setView(view);
  }
  static render::TileRenderer::Options exact() {
    render::TileRenderer::Options options;
    options.previews = false;
    return options;
  }
  QImage painted() {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    QPainter painter(&image);
    const QRectF whole(0, 0, kWidth, kHeight);
    scene.render(&painter, whole, whole);
    return image;
  }
  void choose(TrackChoice choice) {
    LayerStyle style = scene.layerStyle(Layer::Track);
    style.choice = int(choice);
    scene.setLayerStyle(Layer::Track, style);
  }
  MapScene scene;
};

}  // namespace

class TrackLayerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void timeGoesFromTheFirstColourToTheLast() {
    Desk desk;
    const QRgb ground = desk.painted().pixel(200, 150);
    desk.scene.setTrack(straight(16));
    const QImage image = desk.painted();
    const auto colors = trackColors(TrackChoice::Time);
    QCOMPARE(image.pixel(45, 150), colors.front().rgb());
    QCOMPARE(image.pixel(355, 150), colors.back().rgb());
    QCOMPARE(image.pixel(200, 130), ground);
    desk.scene.setTrack(nullptr);
    QCOMPARE(desk.painted().pixel(200, 150), ground);
  }

  void itsColoursAreSeenWhileItIsChosen() {
    Desk desk;
    const auto track = straight(16);
    desk.scene.setTrack(track);
    const QImage before = desk.painted();
    ui::scene::MapObject line;
    line.form = ui::scene::ObjectForm::Line;
    line.parts.emplace_back();
    for (const TrackSample& sample : *track) line.parts[0].push_back(sample.position_m);
    desk.scene.setMarked(line);
    const QImage chosen = desk.painted();
    for (const int x : {100, 200, 300}) {
      QCOMPARE(chosen.pixel(x, 150), before.pixel(x, 150));
      QVERIFY(chosen.pixel(x, 145) != before.pixel(x, 145));
      QVERIFY(chosen.pixel(x, 155) != before.pixel(x, 155));
    }
  }

  void acrossAPieceNothingIsDrawn() {
    Desk desk;
    const QRgb ground = desk.painted().pixel(200, 150);
    auto track = straight(16);
    track->erase(track->begin() + 70, track->begin() + 90);
    (*track)[70].begins = true;
    desk.scene.setTrack(track);
    QCOMPARE(desk.painted().pixel(200, 150), ground);
    QVERIFY(desk.painted().pixel(100, 150) != ground);
  }

  void qualitiesHaveTheirColours() {
    Desk desk;
    desk.choose(TrackChoice::Quality);
    auto track = straight(16);
    for (std::size_t i = 0; i < 80; ++i) (*track)[i].quality = 1;
    desk.scene.setTrack(track);
    const auto colors = trackColors(TrackChoice::Quality);
    QCOMPARE(desk.painted().pixel(100, 150), colors[1].rgb());
    QCOMPARE(desk.painted().pixel(300, 150), colors[3].rgb());
    const TrackScale scale{TrackChoice::Quality, 0};
    const auto index = [&](int quality) { return colorIndexOf({{0, 0}, 0, 0, quality, false}, scale); };
    QCOMPARE((std::vector<int>{index(0), index(1), index(3), index(5), index(8), index(10)}),
             (std::vector<int>{0, 1, 1, 2, 3, 3}));
  }

  void theScaleOfSpeedsEndsAtARoundNumberThatHoldsThemAll() {
    for (const double speed : {0.03, 0.1, 0.11, 0.19, 0.2, 0.49, 0.7, 1.0, 1.2, 4.9, 7.0}) {
      const Track track{{{0, 0}, 0, speed, 0, true}};
      const double most = scaleOf(track, TrackChoice::Speed).most;
      QVERIFY2(most >= speed && most <= speed * 2.6, std::to_string(speed).c_str());
      const double digit = most / std::pow(10, std::floor(std::log10(most) + 1e-9));
      QVERIFY(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6);
    }
    QCOMPARE(colorIndexOf({{0, 0}, 0, 99, 0, false}, {TrackChoice::Speed, 1}), kTrackColors - 1);
    QCOMPARE(colorIndexOf({{0, 0}, 0, 1, 0, false}, {TrackChoice::Speed, 0}), 0);
  }

  void placesThatAreNoneAreLeftOut() {
    Desk desk;
    auto track = straight(16);
    (*track)[40].position_m = {std::numeric_limits<double>::quiet_NaN(), 0};
    (*track)[50].position_m = {1e300, -1e300};
    desk.scene.setTrack(track);
    QVERIFY(!desk.painted().isNull());
  }

  void coloursOfAChoiceDiffer() {
    for (const TrackChoice choice : {TrackChoice::Time, TrackChoice::Speed, TrackChoice::Quality}) {
      std::set<QRgb> different;
      const auto colors = trackColors(choice);
      for (const QColor& color : colors) different.insert(color.rgb());
      QCOMPARE(different.size(), colors.size());
    }
  }
};

}  // namespace test_track_layer

MAPWRIGHT_TEST(test_track_layer, TrackLayerTest, Widgets)
#include "test_track_layer.moc"
