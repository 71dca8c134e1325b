// Every layer, held to the same statements about its description.
#include <algorithm>
#include <array>
#include <memory>

#include <QRegularExpression>
#include <QTest>

#include "test_program.h"
#include "ui/scene/label_ink.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "ui/scene/track.h"

namespace test_layers {

using namespace mapwright;
using namespace mapwright::ui::scene;

namespace {

constexpr std::array kForms{ObjectForm::Point, ObjectForm::Line, ObjectForm::Area};

/// One thing of a layer, found in its sample.
struct Found {
  std::size_t number = 0;
  FeaturesOf of = FeaturesOf::Robot;
  ObjectForm form = ObjectForm::Point;
  std::vector<map::Polyline> parts;
};

std::vector<Found> thingsIn(const LegendSample& sample, const LayerObjects& objects) {
  std::vector<Found> all;
  for (const FeaturesOf of : {FeaturesOf::Robot, FeaturesOf::WholeMap}) {
    objects.visit(sample.context, of, [&](std::size_t number, ObjectForm form, ObjectParts parts) {
      Found one{number, of, form, {}};
      for (const auto& part : parts) one.parts.emplace_back(part.begin(), part.end());
      all.push_back(std::move(one));
    });
  }
  return all;
}

/// What a legend is made of.
struct Desk {
  Desk() {
    context.theme = lightMapTheme();
    context.ink = &ink;
    context.track = std::make_shared<Track>(Track{{{0, 0}, 0, 0, 0, true}});
  }
  Legend legendOf(Layer layer) { return {layer, Legend::Source{context}}; }
  LabelInk ink;
  LayerContext context;
};

}  // namespace

class LayersTest : public QObject {
  Q_OBJECT

  static void addLayers(bool (*those)(const LayerSpec& spec)) {
    QTest::addColumn<Layer>("layer");
    for (const Layer layer : allLayers()) {
      if (those(specOf(layer))) QTest::newRow(specOf(layer).name) << layer;
    }
  }

 private Q_SLOTS:
  void hasANameThatIsReadBackAndATitle_data() {
    addLayers([](const LayerSpec&) { return true; });
  }
  void hasANameThatIsReadBackAndATitle() {
    QFETCH(Layer, layer);
    static const QRegularExpression word(QStringLiteral("^[a-z]+(-[a-z]+)*$"));
    QVERIFY(word.match(layerName(layer)).hasMatch());
    QVERIFY(layerName(layer) != QLatin1String("all") && layerName(layer) != QLatin1String("none"));
    QVERIFY(layerNamed(layerName(layer)) == layer);
    QVERIFY(!layerNamed(layerName(layer) + QLatin1Char('x')));
    QVERIFY(!layerTitle(layer).isEmpty());
    for (const Layer other : allLayers()) QVERIFY(other == layer || layerTitle(other) != layerTitle(layer));
  }

  void isInASetOrLeftAloneByIt_data() {
    addLayers([](const LayerSpec&) { return true; });
  }
  void isInASetOrLeftAloneByIt() {
    QFETCH(Layer, layer);
    const LayerSpec& spec = specOf(layer);
    QVERIFY(!(spec.sets & spec.left_alone));
    for (const LayerSet set :
         {LayerSet::Navigation, LayerSet::Mapping, LayerSet::MapOnly, LayerSet::Report, LayerSet::Snapshot})
      QCOMPARE(layersIn(set).contains(layer), spec.sets.testFlag(set));
    QVERIFY(!spec.in_all || !spec.not_in_all_reason);
  }

  void hasOneKindOfDataIfItsTopicIsChosen_data() {
    addLayers([](const LayerSpec& spec) { return spec.topic_chosen || spec.grid; });
  }
  void hasOneKindOfDataIfItsTopicIsChosen() {
    QFETCH(Layer, layer);
    QCOMPARE(specOf(layer).streams.size(), std::size_t(1));
  }

  void isExplainedInTheLegend_data() {
    // What costs look like depends on the robot: nothing is said before some have come.
    addLayers([](const LayerSpec& spec) { return spec.legend && !(spec.grid && spec.topic_chosen); });
  }
  void isExplainedInTheLegend() {
    QFETCH(Layer, layer);
    Desk desk;
    Legend legend = desk.legendOf(layer);
    specOf(layer).legend(legend);
    QVERIFY(!legend.rows().empty());
    for (const LegendRow& row : legend.rows()) {
      QVERIFY(!row.text.isEmpty() || (!row.low.isEmpty() && !row.high.isEmpty()));
      QVERIFY(!row.symbol.isNull());
    }
  }

  void thingsHaveASampleThatIsSeen_data() {
    addLayers([](const LayerSpec& spec) { return spec.objects || spec.sample; });
  }
  void thingsHaveASampleThatIsSeen() {
    QFETCH(Layer, layer);
    QVERIFY(specOf(layer).sample);
    Desk desk;
    Legend legend = desk.legendOf(layer);
    legend.add({}, [](QPainter&, const QRectF&) {});
    QVERIFY(std::any_of(kForms.begin(), kForms.end(),
                        [&](ObjectForm form) { return legend.lookOf(form, 0) != legend.rows()[0].symbol; }));
  }

  void thingsAreFoundAndDescribed_data() {
    addLayers([](const LayerSpec& spec) { return spec.objects != nullptr; });
  }
  void thingsAreFoundAndDescribed() {
    QFETCH(Layer, layer);
    const LayerObjects& objects = *specOf(layer).objects;
    LegendSample sample;
    sample.context.live = &sample.live;
    sample.context.view.width_px = Legend::kSymbol.width();
    sample.context.view.height_px = Legend::kSymbol.height();
    QVERIFY(thingsIn(sample, objects).empty());
    for (const ObjectForm form : kForms) {
      specOf(layer).sample(sample, form, 0);
      const std::vector<Found> found = thingsIn(sample, objects);
      QVERIFY(!found.empty());
      const Found& first = found.front();
      const std::vector<std::span<const Eigen::Vector2d>> parts(first.parts.begin(), first.parts.end());
      Eigen::Vector2d middle(0, 0);
      for (const Eigen::Vector2d& point : first.parts[0]) middle += point / double(first.parts[0].size());
      QVERIFY(fitOf(first.form, parts, middle, 0.1 * LegendSample::kMPerPx));
      const MapObject object = objects.describe(sample.context, first.of, first.number);
      QVERIFY(!object.kind.isEmpty());
      for (const ObjectProperty& property : object.properties)
        QVERIFY(!property.name.isEmpty() && !property.value.isEmpty());
    }
  }
};

}  // namespace test_layers

MAPWRIGHT_TEST(test_layers, LayersTest, Widgets)
#include "test_layers.moc"
